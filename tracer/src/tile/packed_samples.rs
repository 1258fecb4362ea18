//! Packed samples: those pixels of a tile that some surface needs light at.

use crate::simd::dispatch::{LANES, set_bits};
use crate::tile::planes::{AREA, Plane, RgbTile, TILE};

/// Some pixels of a tile, packed: samples in mm from the tile's middle.
#[derive(Clone, Debug)]
pub(crate) struct PackedSamples {
    /// How many samples there are.
    pub count: usize,
    /// Across, mm.
    pub x: Plane,
    /// Down, mm.
    pub y: Plane,
    /// Which pixel of the tile each sample is.
    pub pixel: [u8; AREA],
}

impl PackedSamples {
    /// No sample.
    pub fn none() -> PackedSamples {
        PackedSamples { count: 0, x: [[0.0; LANES]; TILE], y: [[0.0; LANES]; TILE], pixel: [0; AREA] }
    }

    /// Every pixel of a tile, in order.
    pub fn full_tile(mm_per_px: f64) -> PackedSamples {
        let mut samples = PackedSamples::none();
        for pixel in 0..AREA {
            samples.push_pixel(pixel, mm_per_px as f32);
        }
        samples
    }

    /// Adds a pixel of the tile.
    pub fn push_pixel(&mut self, pixel: usize, mm_per_px: f32) {
        let middle = TILE as f32 * 0.5 - 0.5;
        let (column, row) = ((pixel % TILE) as f32, (pixel / TILE) as f32);
        let (block, lane) = (self.count / LANES, self.count % LANES);
        self.x[block][lane] = (column - middle) * mm_per_px;
        self.y[block][lane] = (row - middle) * mm_per_px;
        self.pixel[self.count] = pixel as u8;
        self.count += 1;
    }

    /// Fills the last block with copies of the last sample, so that the blocks can be taken whole.
    pub fn pad(&mut self) {
        if self.count == 0 {
            return;
        }
        let last = self.count - 1;
        let (x, y) = (self.x[last / LANES][last % LANES], self.y[last / LANES][last % LANES]);
        for at in self.count..self.blocks() * LANES {
            self.x[at / LANES][at % LANES] = x;
            self.y[at / LANES][at % LANES] = y;
        }
    }

    /// The blocks that hold any of the samples in some rows of the tile; those that were pushed in order.
    pub fn blocks_in(&self, rows: u16) -> u16 {
        let row = |at: usize| u32::from(self.pixel[at]) / LANES as u32;
        let meets = |block: &usize| {
            let (first, last) = (row(block * LANES), row((block * LANES + LANES).min(self.count) - 1));
            u32::from(rows) >> first & ((2 << (last - first)) - 1) != 0
        };
        (0..self.blocks()).filter(meets).fold(0, |blocks, block| blocks | 1 << block)
    }

    /// Adds light at the samples of some blocks to the pixels that the samples are.
    pub fn scatter(&self, blocks: u16, light: &RgbTile, out: &mut RgbTile) {
        let [red, green, blue] = out.each_mut().map(|plane| plane.as_flattened_mut());
        for block in set_bits(blocks).take_while(|&block| block < self.blocks()) {
            let pixels = &self.pixel[block * LANES..(block * LANES + LANES).min(self.count)];
            for (at, &pixel) in pixels.iter().enumerate() {
                red[usize::from(pixel)] += light[0][block][at];
                green[usize::from(pixel)] += light[1][block][at];
                blue[usize::from(pixel)] += light[2][block][at];
            }
        }
    }

    /// How many blocks of [`LANES`] hold the samples.
    pub fn blocks(&self) -> usize {
        self.count.div_ceil(LANES)
    }
}
