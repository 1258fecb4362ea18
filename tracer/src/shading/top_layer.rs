//! The part of one top that a tile shows, and how its pixels are found.

use crate::shading::albedo_map::Albedo;
use crate::shading::coverage::SignedDistance;
use crate::shading::surface::Surface;
use crate::simd::dispatch::{LANES, clamp, max};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{Plane, TILE};

/// Below this much of a pixel, nobody sees it.
pub(crate) const MIN_COVERAGE: f32 = 1.0 / 1024.0;

/// The part of one top that a tile shows.
pub(crate) struct TopLayer {
    pub slot: usize,
    pub samples: PackedSamples,
    /// Whether art is printed on it.
    pub printed: bool,
    pub surface: Surface,
}

impl TopLayer {
    /// Nothing yet.
    pub fn new() -> TopLayer {
        TopLayer { slot: 0, samples: PackedSamples::none(), printed: false, surface: Surface::none() }
    }

    /// Packs the pixels that the outline covers and nothing above hides.
    pub fn pack(&mut self, edge: &SignedDistance, bevel_mm: f32, opacity: f32, mm_per_px: f32, remaining: &mut Plane) {
        self.samples.count = 0;
        let per_mm = 1.0 / mm_per_px;
        let Surface { weight, normals, .. } = &mut self.surface;
        for row in 0..TILE {
            for i in 0..LANES {
                let distance = edge.distance[row][i];
                let coverage = clamp(0.5 - distance * per_mm, 0.0, 1.0) * opacity;
                let rest = remaining[row][i];
                if coverage * rest < MIN_COVERAGE {
                    continue;
                }
                remaining[row][i] = rest * (1.0 - coverage);
                let at = self.samples.count;
                self.samples.push_pixel(row * LANES + i, mm_per_px);
                let (block, lane) = (at / LANES, at % LANES);
                // A quarter of a circle: upright at the edge, level at the bevel's inner end.
                let lean = 0.96 * clamp(1.0 + distance / bevel_mm, 0.0, 1.0);
                weight[block][lane] = coverage * rest;
                normals.x[block][lane] = edge.away_x[row][i] * lean;
                normals.y[block][lane] = edge.away_y[row][i] * lean;
                normals.z[block][lane] = max(1.0 - lean * lean, 0.0).sqrt();
            }
        }
        self.samples.pad();
    }

    /// Packs the art at the layer's samples: white where nothing is printed.
    pub fn pack_print(&mut self, printed: &Albedo) {
        self.printed = true;
        for sample in 0..self.samples.count {
            let pixel = usize::from(self.samples.pixel[sample]);
            let (row, i) = (pixel / LANES, pixel % LANES);
            let alpha = printed.alpha[row][i];
            for (print, color) in self.surface.albedo.iter_mut().zip(&printed.color) {
                print[sample / LANES][sample % LANES] = 1.0 + (color[row][i] - 1.0) * alpha;
            }
        }
    }
}
