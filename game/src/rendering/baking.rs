//! The baked part of a picture: all light but the straight one.

use super::Settings;
use geometry::{Bounds, DVec2};
use rayon::prelude::*;
use tracer::View;
use tracer::transport::bake::{Bake, BakeOptions, bake};
use tracer::transport::spectrum::Weights;
use tracer::transport::{MOST_SURFACES, Scene};

/// Pixels along a side of a cell.
const CELL_PX: f64 = 4.0;

/// A bake in the making.
pub struct Baking<'a> {
    scene: &'a Scene,
    view: View,
    weights: Weights,
    options: BakeOptions,
    baked: Option<Bake>,
}

impl<'a> Baking<'a> {
    /// Of this scene, in cells of this view's pixels.
    pub fn new(scene: &'a Scene, view: View, weights: Weights, settings: &Settings) -> Baking<'a> {
        let size = DVec2::new(view.width as f64, view.height as f64) * view.mm_per_px;
        let cell_mm = CELL_PX * view.mm_per_px;
        let cells = (size.x / cell_mm) * (size.y / cell_mm);
        let packets = cells * f64::from(settings.samples) / scene.sources.len().max(1) as f64;
        let options = BakeOptions {
            region: Bounds { min: view.origin_mm, max: view.origin_mm + size },
            cell_mm,
            bounces: settings.depth.unwrap_or(MOST_SURFACES),
            packets: packets.ceil() as u64,
            seed: settings.seed,
        };
        Baking { scene, view, weights, options, baked: None }
    }

    /// Packets from each lamp.
    pub fn packets(&self) -> u64 {
        self.options.packets
    }

    /// Makes it, unless that is cancelled.
    pub fn bake(&mut self, is_cancelled: &(dyn Fn() -> bool + Sync)) {
        self.baked = bake(self.scene, &self.weights, &self.options, &|_, _| !is_cancelled());
    }

    /// Whether it is made.
    pub fn is_done(&self) -> bool {
        self.baked.is_some()
    }

    /// The straight light and the baked one together.
    pub fn added_to(&self, mut straight: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
        let Some(baked) = &self.baked else { return straight };
        let mixed = baked.mixed(&vec![[1.0; 3]; baked.layers()]);
        let rows = straight.par_chunks_mut(self.view.width).enumerate();
        rows.for_each(|(y, row)| {
            for (x, light) in row.iter_mut().enumerate() {
                let more = mixed.fluence(self.view.table_from_pixel(x, y));
                (0..3).for_each(|channel| light[channel] += more[channel]);
            }
        });
        straight
    }
}
