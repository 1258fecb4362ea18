//! The assets that depend on the frame's size and zoom: placement, rasterized art, and the playfield's display buffer.

use crate::scene_builder::{RasterizedArt, rasterize_floor};
use crate::screen::{Placement, Rect, ScreenFromTable, Size};
use crate::{Failure, Table};
use geometry::DVec2;
use std::sync::Arc;
use tracer::{DisplayBuffer, Floor, View};

/// What depends on the size of the frame and on the zoom.
pub struct SizeDependentAssets {
    pub placement: Placement,
    pub zoom: f64,
    /// All of the playfield, of which the window may show a part.
    pub view: View,
    pub art: Arc<RasterizedArt>,
    /// The floor's art at half the resolution, once it has been asked for.
    pub half_floor: Option<Arc<Floor>>,
    /// The playfield's pixels.
    pub display_buffer: DisplayBuffer,
    /// How far the playfield was moved by a push when it was last drawn, pixels.
    pub shift: (i32, i32),
}

impl SizeDependentAssets {
    /// Prints `table` for a frame of this size, `zoom` times as large as fits into it.
    ///
    /// # Errors
    /// If the table's art cannot be rasterized at this size.
    pub fn new(table: &Table, width: usize, height: usize, zoom: f64) -> Result<SizeDependentAssets, Failure> {
        let placement = Placement::new(width, height, table.size_mm);
        let canvas = canvas(&placement.table, zoom);
        let view = View::fit(canvas.width, canvas.height, table.size_mm);
        let art = Arc::new(RasterizedArt::new(table, &view)?);
        Ok(SizeDependentAssets {
            placement,
            zoom,
            view,
            art,
            half_floor: None,
            display_buffer: DisplayBuffer::default(),
            shift: (0, 0),
        })
    }

    /// The same assets, with nothing drawn from them.
    pub fn undrawn(&self) -> SizeDependentAssets {
        SizeDependentAssets {
            art: self.art.clone(),
            half_floor: self.half_floor.clone(),
            display_buffer: DisplayBuffer::default(),
            shift: (0, 0),
            ..*self
        }
    }

    /// Whether they are for a frame of this size.
    pub fn fits(&self, width: usize, height: usize, zoom: f64) -> bool {
        (self.placement.width, self.placement.height) == (width, height) && self.zoom == zoom
    }

    /// Prints the art at half the resolution, unless that has been done.
    ///
    /// # Errors
    /// If it cannot be rasterized at this size.
    pub fn rasterize_half(&mut self, table: &Table) -> Result<(), Failure> {
        if self.half_floor.is_none() {
            self.half_floor = Some(Arc::new(rasterize_floor(table, &self.view.halved())?));
        }
        Ok(())
    }

    /// What the window shows of the table, mm.
    pub fn shown_mm(&self) -> DVec2 {
        let Rect { width, height, .. } = self.placement.table;
        DVec2::new(f64::from(width), f64::from(height)) * self.view.mm_per_px
    }

    /// The first column and row of the playfield that are shown, if `middle_mm` is in the middle.
    pub fn corner(&self, middle_mm: DVec2) -> (usize, usize) {
        let Rect { width, height, .. } = self.placement.table;
        let middle = self.view.screen_from_table(middle_mm);
        let first = |middle: f64, shown: i32, all: usize| {
            let room = all.saturating_sub(shown as usize);
            (middle - f64::from(shown) * 0.5).round().clamp(0.0, room as f64) as usize
        };
        (first(middle.x, width, self.view.width), first(middle.y, height, self.view.height))
    }

    /// Where points of the table are on the screen, if the playfield is shown from this corner on.
    pub fn screen_from_table(&self, corner: (usize, usize)) -> ScreenFromTable {
        let Rect { x, y, .. } = self.placement.table;
        let origin = self.view.screen_from_table(DVec2::ZERO) - DVec2::new(corner.0 as f64, corner.1 as f64);
        ScreenFromTable {
            origin: DVec2::new(f64::from(x), f64::from(y)) + origin,
            px_per_m: 1000.0 / self.view.mm_per_px,
        }
    }
}

/// The playfield `zoom` times as large as `table`, or as large as a frame may be.
fn canvas(table: &Rect, zoom: f64) -> Size {
    let (width, height) = (f64::from(table.width), f64::from(table.height));
    let most = (Size::MAX_PIXELS as f64 / (width * height)).sqrt().min(Size::MAX as f64 / width.max(height));
    let zoom = zoom.min(most).max(1.0);
    // Rounded down where it is more than it was: two roundings up could be a pixel too many.
    let side = |side: f64| ((side * zoom).floor() as usize).max(side as usize);
    Size { width: side(width), height: side(height) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_zoom_makes_more_pixels_than_a_picture_may_have() {
        for (width, height) in [(1, 1), (540, 1080), (4000, 8000), (4096, 8192), (16384, 2048), (3, 16384)] {
            for zoom in [1.0, 1.3, 4.0] {
                let size = canvas(&Rect::new(0, 0, width, height), zoom);
                assert!(size.is_drawable(), "{width} {height} {zoom}: {size:?}");
                assert!(size.width >= width as usize && size.height >= height as usize);
            }
        }
        assert_eq!(canvas(&Rect::new(5, 5, 100, 200), 2.5), Size { width: 250, height: 500 });
    }
}
