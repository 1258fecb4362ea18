//! Where a tile is: on the screen, and on the table.

use crate::tile::planes::{Plane, TILE};
use crate::{Lamp, Mask, View};
use geometry::{Bounds, DVec2};

/// Where a tile is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TileRect {
    /// Its leftmost pixel.
    pub x: usize,
    /// Its topmost pixel.
    pub y: usize,
    /// Its middle on the table, mm.
    pub middle_mm: DVec2,
    /// Half of its side, mm.
    pub half_mm: f64,
    /// From its middle to its corners, mm.
    pub radius_mm: f64,
    /// A box around it, mm.
    pub bounds: Bounds,
    /// How many of its columns and rows are in the picture.
    pub visible_px: (usize, usize),
}

impl TileRect {
    /// The tile whose upper left pixel is (`x`, `y`).
    pub fn new(view: &View, x: usize, y: usize) -> TileRect {
        let half = TILE as f64 * 0.5;
        let middle_mm = view.origin_mm + (DVec2::new(x as f64, y as f64) + DVec2::splat(half)) * view.mm_per_px;
        let radius_mm = half * std::f64::consts::SQRT_2 * view.mm_per_px;
        let bounds = Bounds::of(middle_mm, middle_mm).grown((half + 1.0) * view.mm_per_px);
        let half_mm = half * view.mm_per_px;
        TileRect {
            x,
            y,
            middle_mm,
            half_mm,
            radius_mm,
            bounds,
            visible_px: (TILE.min(view.width - x), TILE.min(view.height - y)),
        }
    }

    /// Beyond the picture's edge a tile shows what is at the edge, so that the bloom there is the picture's own.
    pub fn clamp_to_edge(&self, planes: &mut [&mut Plane]) {
        let (columns, rows) = self.visible_px;
        if self.is_unclipped() {
            return;
        }
        for plane in planes {
            for row in 0..TILE {
                plane[row] = plane[row.min(rows - 1)];
                let last = plane[row][columns - 1];
                plane[row][columns..].fill(last);
            }
        }
    }

    /// Whether all of it is in the picture.
    pub fn is_unclipped(&self) -> bool {
        self.visible_px == (TILE, TILE)
    }

    /// Whether a lamp's light may come here.
    pub fn is_reached_by(&self, lamp: &Lamp) -> bool {
        let reach = lamp.far_mm() + self.radius_mm + 0.01;
        lamp.center_mm.distance_squared(self.middle_mm) <= reach * reach
    }

    /// Whether a mask covers any of the tile's pixels.
    pub fn overlaps_mask(&self, mask: &Mask) -> bool {
        let (right, bottom) = (mask.x + mask.width, mask.y + mask.height());
        mask.x < self.x + TILE && right > self.x && mask.y < self.y + TILE && bottom > self.y
    }
}
