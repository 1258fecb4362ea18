//! What a tile shows, kept from picture to picture: which pixels of the floor and of every top, how much of them, and
//! which way they lean. It holds until a top moves in the tile.

use crate::irradiance::{Normals, Surface};
use crate::lanes::{LANES, Lanes};
use crate::layer::TopLayer;
use crate::points::{Plane, Points, TILE};

/// The surfaces of one tile.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surfaces {
    /// Whether they are known.
    pub holds: bool,
    /// Whether the floor's points are every pixel of the tile.
    pub whole: bool,
    /// The floor's pixels, if they are not all.
    pub floor: Vec<u8>,
    /// How much of each pixel of the tile is floor; empty if all of all.
    pub floor_weight: Vec<Lanes>,
    /// The tops, the highest first.
    pub tops: Vec<Patch>,
}

/// What a tile shows of a top.
#[derive(Clone, Debug)]
pub(crate) struct Patch {
    form: usize,
    pixel: Vec<u8>,
    weight: Vec<Lanes>,
    normals: [Vec<Lanes>; 3],
}

impl Patch {
    /// Keeps what a layer shows.
    pub fn new(layer: &TopLayer) -> Patch {
        let TopLayer { form, points, surface: Surface { weight, normals, .. } } = layer;
        let packed = |plane: &Plane| plane[..points.blocks()].to_vec();
        Patch {
            form: *form,
            pixel: points.pixel[..points.count].to_vec(),
            weight: packed(weight),
            normals: [packed(&normals.x), packed(&normals.y), packed(&normals.z)],
        }
    }

    /// Makes a layer show it again.
    pub fn unpack(&self, mm_per_px: f32, layer: &mut TopLayer) {
        let TopLayer { form, points, surface: Surface { weight, normals, .. } } = layer;
        let Normals { x, y, z } = normals;
        *form = self.form;
        points.take(&self.pixel, mm_per_px);
        for (plane, packed) in [weight, x, y, z].into_iter().zip([&self.weight].into_iter().chain(&self.normals)) {
            plane[..packed.len()].copy_from_slice(packed);
        }
    }
}

impl Points {
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
