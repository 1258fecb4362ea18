//! The cached G-buffer of one tile: which pixels of the floor and of every top are seen, how much of them, and their
//! normals. It is valid until a top moves in the tile.

use crate::cache::validity::Validity;
use crate::shading::surface::{Normals, Surface};
use crate::shading::top_layer::TopLayer;
use crate::simd::dispatch::{LANES, Lanes};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{Plane, TILE};

/// The surfaces of one tile.
#[derive(Clone, Debug, Default)]
pub(crate) struct CachedGBuffer {
    pub validity: Validity,
    /// Whether the floor's samples are every pixel of the tile.
    pub is_dense: bool,
    /// The floor's pixels, if they are not all.
    pub floor: Vec<u8>,
    /// How much of each pixel of the tile is floor; empty if all of all.
    pub floor_weight: Vec<Lanes>,
    /// The tops, the highest first; there may be more, which are not there any more.
    tops: Vec<CachedTop>,
    layers: usize,
}

impl CachedGBuffer {
    /// What the tile shows of tops.
    pub fn tops(&self) -> &[CachedTop] {
        &self.tops[..self.layers]
    }

    /// Keeps what layers show.
    pub fn keep_tops(&mut self, layers: &[TopLayer]) {
        self.layers = layers.len();
        if self.tops.len() < layers.len() {
            self.tops.resize_with(layers.len(), CachedTop::empty);
        }
        for (top, layer) in self.tops.iter_mut().zip(layers) {
            top.keep(layer);
        }
    }
}

/// Gives a list new contents in its old place.
fn refill<T: Copy>(list: &mut Vec<T>, contents: &[T]) {
    list.clear();
    list.extend_from_slice(contents);
}

/// What a tile shows of a top.
#[derive(Clone, Debug)]
pub(crate) struct CachedTop {
    slot: usize,
    pixel: Vec<u8>,
    weight: Vec<Lanes>,
    normals: [Vec<Lanes>; 3],
    /// What is printed on it; empty if nothing is.
    print: [Vec<Lanes>; 3],
}

impl CachedTop {
    /// Nothing.
    fn empty() -> CachedTop {
        let planes = [const { Vec::new() }; 3];
        CachedTop { slot: 0, pixel: Vec::new(), weight: Vec::new(), normals: planes.clone(), print: planes }
    }

    /// Keeps what a layer shows.
    fn keep(&mut self, layer: &TopLayer) {
        let TopLayer { slot, samples, printed, surface: Surface { weight, normals, albedo, .. } } = layer;
        self.slot = *slot;
        refill(&mut self.pixel, &samples.pixel[..samples.count]);
        let planes: [&Plane; 4] = [weight, &normals.x, &normals.y, &normals.z];
        for (kept, plane) in [&mut self.weight].into_iter().chain(&mut self.normals).zip(planes) {
            refill(kept, &plane[..samples.blocks()]);
        }
        for (kept, plane) in self.print.iter_mut().zip(albedo) {
            refill(kept, &plane[..if *printed { samples.blocks() } else { 0 }]);
        }
    }

    /// Makes a layer show it again.
    pub fn unpack(&self, mm_per_px: f32, layer: &mut TopLayer) {
        let TopLayer { slot, samples, printed, surface: Surface { weight, normals, albedo, .. } } = layer;
        let Normals { x, y, z } = normals;
        *slot = self.slot;
        samples.take(&self.pixel, mm_per_px);
        for (plane, packed) in [weight, x, y, z].into_iter().zip([&self.weight].into_iter().chain(&self.normals)) {
            plane[..packed.len()].copy_from_slice(packed);
        }
        *printed = !self.print[0].is_empty();
        for (plane, packed) in albedo.iter_mut().zip(&self.print) {
            match *printed {
                true => plane[..packed.len()].copy_from_slice(packed),
                false => plane[..samples.blocks()].fill([1.0; LANES]),
            }
        }
    }
}

impl PackedSamples {
    /// Becomes these pixels of a tile.
    pub fn take(&mut self, pixels: &[u8], mm_per_px: f32) {
        self.count = pixels.len();
        self.pixel[..pixels.len()].copy_from_slice(pixels);
        let middle = TILE as f32 * 0.5 - 0.5;
        for block in 0..self.blocks() {
            let pixels = &self.pixel[block * LANES..][..LANES];
            for i in 0..LANES {
                let (column, row) = (f32::from(pixels[i] % TILE as u8), f32::from(pixels[i] / TILE as u8));
                self.x[block][i] = (column - middle) * mm_per_px;
                self.y[block][i] = (row - middle) * mm_per_px;
            }
        }
        self.pad();
    }
}
