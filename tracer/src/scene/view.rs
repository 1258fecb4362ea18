//! Where the table is on the screen.

use geometry::DVec2;

/// A window of pixels on the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Pixels across, 1 or more.
    pub width: usize,
    /// Pixels down, 1 or more.
    pub height: usize,
    /// The point of the table at the upper left corner of the upper left pixel, mm.
    pub origin_mm: DVec2,
    /// Millimetres a pixel.
    pub mm_per_px: f64,
}

impl View {
    /// The view of `width` x `height` pixels that shows all of a table of `size_mm`, centred.
    pub fn fit(width: usize, height: usize, size_mm: DVec2) -> View {
        let pixels = DVec2::new(width as f64, height as f64);
        let mm_per_px = (size_mm / pixels).max_element();
        View { width, height, origin_mm: (size_mm - pixels * mm_per_px) * 0.5, mm_per_px }
    }

    /// The same view at half the resolution; of an odd size, the last pixels reach half over the edge.
    pub fn halved(&self) -> View {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        View { width, height, mm_per_px: 2.0 * self.mm_per_px, ..*self }
    }

    /// The point of the table at the middle of a pixel, mm.
    pub fn table_from_pixel(&self, x: usize, y: usize) -> DVec2 {
        self.origin_mm + DVec2::new(x as f64 + 0.5, y as f64 + 0.5) * self.mm_per_px
    }

    /// The place on the screen, in pixels from its upper left corner, of a point of the table.
    pub fn screen_from_table(&self, point_mm: DVec2) -> DVec2 {
        (point_mm - self.origin_mm) / self.mm_per_px
    }
}
