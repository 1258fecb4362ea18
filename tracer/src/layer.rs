//! The part of one top that a tile shows, and how its pixels are found.

use crate::coverage::Edge;
use crate::irradiance::{DARKNESS, Light, Normals};
use crate::lanes::{LANES, clamp, max};
use crate::points::{Plane, Points, TILE};

/// Below this much of a pixel, nobody sees it.
pub(crate) const UNSEEN: f32 = 1.0 / 1024.0;

/// The part of one top that a tile shows.
pub(crate) struct TopLayer {
    pub form: usize,
    pub points: Points,
    pub coverage: Plane,
    pub normals: Normals,
    pub diffuse: Light,
    pub mirrored: Light,
    /// The art printed on it.
    pub print: Light,
}

impl TopLayer {
    /// Nothing yet.
    pub fn new() -> TopLayer {
        let zero = [[0.0; LANES]; TILE];
        TopLayer {
            form: 0,
            points: Points::none(),
            coverage: zero,
            normals: Normals { x: zero, y: zero, z: zero },
            diffuse: DARKNESS,
            mirrored: DARKNESS,
            print: DARKNESS,
        }
    }

    /// Packs the pixels that the outline covers and nothing above hides.
    pub fn pack(&mut self, edge: &Edge, bevel_mm: f32, opacity: f32, mm_per_px: f32, remaining: &mut Plane) {
        self.points.count = 0;
        let per_mm = 1.0 / mm_per_px;
        for row in 0..TILE {
            for i in 0..LANES {
                let distance = edge.distance[row][i];
                let coverage = clamp(0.5 - distance * per_mm, 0.0, 1.0) * opacity;
                let rest = remaining[row][i];
                if coverage * rest < UNSEEN {
                    continue;
                }
                remaining[row][i] = rest * (1.0 - coverage);
                let at = self.points.count;
                self.points.push_pixel(row * LANES + i, mm_per_px);
                let (block, lane) = (at / LANES, at % LANES);
                // A quarter of a circle: upright at the edge, level at the bevel's inner end.
                let lean = 0.96 * clamp(1.0 + distance / bevel_mm, 0.0, 1.0);
                self.coverage[block][lane] = coverage;
                self.normals.x[block][lane] = edge.away_x[row][i] * lean;
                self.normals.y[block][lane] = edge.away_y[row][i] * lean;
                self.normals.z[block][lane] = max(1.0 - lean * lean, 0.0).sqrt();
            }
        }
        self.points.pad();
    }
}
