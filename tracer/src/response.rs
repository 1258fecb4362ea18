//! What a tile shows in the light of one lamp alone: a small picture, kept in 16 bits a channel.
//!
//! Light is linear, so the picture under all lamps is the sum of the pictures under each, times the lamps' colours. A
//! lamp that flashes is a factor here and nothing else. Channels are kept as square roots, in 65,535 steps up to the
//! tile's brightest: an error of 1.6e-5 of a bright value, and less of a dark one. This module refuses to know what
//! made the light.

use crate::irradiance::Light;
use crate::lanes::{LANES, Lanes, Path, clones, max};
use crate::points::{AREA, TILE};

/// Cells of [`CELL`] x [`CELL`] pixels in a tile.
pub(crate) const CELLS: usize = (TILE / CELL) * (TILE / CELL);

/// Pixels along the side of a cell: what the glare's finest level is made of.
pub(crate) const CELL: usize = 4;

/// Three numbers for every cell of a tile, row by row.
pub(crate) type Means = [[f32; CELLS]; 3];

/// Rows of a tile that are summed up in registers.
const ROWS: usize = 4;

/// Parts that are summed up together.
const BATCH: usize = 16;

/// The steps from dark to the tile's brightest.
const STEPS: f32 = 65_535.0;

/// A picture of a tile.
#[derive(Clone, Debug)]
pub(crate) struct Response {
    /// Whether there is any light in it.
    pub lit: bool,
    /// What a texel's square is multiplied by.
    scale: f32,
    /// Red, green, blue, row by row: square roots.
    texels: Texels,
    /// The means of the cells, over `scale`.
    means: Means,
}

/// Three channels of a tile, each beginning on a cache line of its own.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct Texels([[u16; AREA]; 3]);

/// A response with the colour of what lights it.
#[derive(Clone, Copy)]
pub(crate) struct Part<'a> {
    response: &'a Response,
    gain: [f32; 3],
}

impl Response {
    /// Darkness.
    pub fn dark() -> Response {
        Response {
            lit: false,
            scale: 0.0,
            texels: Texels([[0; AREA]; 3]),
            means: [[0.0; CELLS]; 3],
        }
    }

    /// Keeps a picture: finite, 0 or more.
    pub fn keep(&mut self, path: Path, light: &Light) {
        let mut brightest = 0.0;
        find_brightest(path, light, &mut brightest);
        self.lit = brightest > 0.0;
        if self.lit {
            let per_step = brightest.sqrt() / STEPS;
            self.scale = per_step * per_step;
            encode(path, light, 1.0 / per_step, &mut self.texels, &mut self.means);
        }
    }

    /// The picture in light of this colour.
    pub fn under(&self, color: [f32; 3]) -> Part<'_> {
        Part { response: self, gain: color.map(|channel| channel * self.scale) }
    }
}

/// Adds parts up, onto what is in `out`.
pub(crate) fn combine<'a>(path: Path, mut parts: impl Iterator<Item = Part<'a>>, out: &mut Light) {
    // Some at a time, so that sums stay in registers and nothing is allocated.
    while let Some(first) = parts.next() {
        let mut batch = [first; BATCH];
        let mut count = 1;
        for (place, part) in batch[1..].iter_mut().zip(&mut parts) {
            *place = part;
            count += 1;
        }
        sum(path, &batch[..count], out);
    }
}

/// Adds up the parts' means, onto what is in `out`.
pub(crate) fn combine_means<'a>(parts: impl Iterator<Item = Part<'a>>, out: &mut Means) {
    for part in parts {
        for channel in 0..3 {
            for cell in 0..CELLS {
                out[channel][cell] += part.response.means[channel][cell] * part.gain[channel];
            }
        }
    }
}

/// The means of the cells of a picture.
pub(crate) fn means_of(light: &Light) -> Means {
    let mut means = [[0.0; CELLS]; 3];
    for (plane, means) in light.iter().zip(&mut means) {
        for (row, line) in plane.iter().enumerate() {
            add_row(row, line, means);
        }
        means.iter_mut().for_each(|mean| *mean *= 1.0 / (CELL * CELL) as f32);
    }
    means
}

#[inline(always)]
fn add_row(row: usize, line: &Lanes, means: &mut [f32; CELLS]) {
    let cells = &mut means[row / CELL * (TILE / CELL)..][..TILE / CELL];
    for (at, cell) in cells.iter_mut().enumerate() {
        *cell += (line[at * CELL] + line[at * CELL + 1]) + (line[at * CELL + 2] + line[at * CELL + 3]);
    }
}

clones! {
    fn find_brightest(light: &Light, brightest: &mut f32) = brightest_lanes;
}

#[inline(always)]
fn brightest_lanes(light: &Light, brightest: &mut f32) {
    let mut most = [0.0; LANES];
    for line in light.iter().flatten() {
        for i in 0..LANES {
            most[i] = max(line[i], most[i]);
        }
    }
    *brightest = most.iter().fold(0.0, |a, &b| max(a, b));
}

clones! {
    fn encode(light: &Light, steps: f32, texels: &mut Texels, means: &mut Means) = encode_lanes;
}

#[inline(always)]
fn encode_lanes(light: &Light, steps: f32, texels: &mut Texels, means: &mut Means) {
    for channel in 0..3 {
        means[channel] = [0.0; CELLS];
        for row in 0..TILE {
            let (line, out) = (&light[channel][row], &mut texels.0[channel][row * LANES..][..LANES]);
            let mut squares = [0.0; LANES];
            for i in 0..LANES {
                // 2^23 leaves no room for a fraction: adding it rounds, and the number is in the lowest bits.
                let step = ((max(line[i], 0.0).sqrt() * steps + 8_388_608.0).to_bits() & 0xffff) as u16;
                out[i] = step;
                squares[i] = f32::from(step) * f32::from(step);
            }
            add_row(row, &squares, &mut means[channel]);
        }
        for mean in &mut means[channel] {
            *mean *= 1.0 / (CELL * CELL) as f32;
        }
    }
}

clones! {
    fn sum(parts: &[Part], out: &mut Light) = sum_lanes;
}

#[inline(always)]
fn sum_lanes(parts: &[Part], out: &mut Light) {
    for channel in 0..3 {
        for rows in (0..TILE).step_by(ROWS) {
            let mut sums = [[0.0; LANES]; ROWS];
            sums.copy_from_slice(&out[channel][rows..rows + ROWS]);
            for part in parts {
                let gain = part.gain[channel];
                let texels = &part.response.texels.0[channel][rows * LANES..][..ROWS * LANES];
                for row in 0..ROWS {
                    for i in 0..LANES {
                        let root = f32::from(texels[row * LANES + i]);
                        sums[row][i] += root * root * gain;
                    }
                }
            }
            out[channel][rows..rows + ROWS].copy_from_slice(&sums);
        }
    }
}
