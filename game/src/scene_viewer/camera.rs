//! The camera: which part of the page the window shows.

use crate::screen::Size;
use geometry::DVec2;
use tracer::View;

/// The nearest and the farthest, in parts of the view that shows the page whole.
const ZOOMS: std::ops::RangeInclusive<f64> = 0.25..=64.0;

/// Which part of the page is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The page's size, mm.
    pub page_mm: DVec2,
    /// The place in the window's middle, mm.
    center_mm: DVec2,
    /// How much larger than the whole page.
    zoom: f64,
}

impl Camera {
    /// All of a page.
    pub fn whole(page_mm: DVec2) -> Camera {
        Camera { page_mm, center_mm: page_mm * 0.5, zoom: 1.0 }
    }

    /// What a window of this size shows.
    pub fn view(&self, size: Size) -> View {
        let mm_per_px = View::fit(size.width, size.height, self.page_mm).mm_per_px / self.zoom;
        let half = DVec2::new(size.width as f64, size.height as f64) * (0.5 * mm_per_px);
        View { width: size.width, height: size.height, origin_mm: self.center_mm - half, mm_per_px }
    }

    /// Nearer by a factor; what is at `at`, pixels, stays there.
    #[must_use]
    pub fn zoomed(self, factor: f64, at: DVec2, size: Size) -> Camera {
        let zoom = (self.zoom * factor).clamp(*ZOOMS.start(), *ZOOMS.end());
        let nearer = Camera { zoom, ..self };
        let place = |camera: &Camera| {
            let view = camera.view(size);
            view.origin_mm + at * view.mm_per_px
        };
        nearer.moved(place(&self) - place(&nearer))
    }

    /// Moved over the page, mm; the window's middle stays on it.
    #[must_use]
    pub fn moved(self, by_mm: DVec2) -> Camera {
        Camera { center_mm: (self.center_mm + by_mm).clamp(DVec2::ZERO, self.page_mm), ..self }
    }
}
