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
const BATCH: usize = 8;

/// The steps from dark to the tile's brightest.
const STEPS: f32 = 65_535.0;

/// Less light than this is none: squares of roots so small would lose their digits.
const FAINTEST: f32 = 1e-20;

/// A picture of a tile: red, green, blue, row by row, as square roots, each channel beginning on a cache line.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Texels([[u16; AREA]; 3]);

/// The means of a picture's cells, in the unit of the texels' squares over 2^16.
pub(crate) type Gist = [[u16; CELLS]; 3];

/// A picture with the colour of what lights it.
#[derive(Clone, Copy)]
pub(crate) struct Part<'a> {
    /// The picture.
    pub texels: &'a Texels,
    /// The light's colour, times what squares of texels are to be multiplied by.
    pub gain: [f32; 3],
}

impl Texels {
    /// Darkness.
    pub fn dark() -> Texels {
        Texels([[0; AREA]; 3])
    }

    /// Keeps a picture: finite, 0 or more. Returns what squares of texels are to be multiplied by, 0 if it is dark.
    pub fn keep(&mut self, path: Path, light: &Light, gist: &mut Gist) -> f32 {
        let mut brightest = 0.0;
        find_brightest(path, light, &mut brightest);
        if brightest < FAINTEST {
            return 0.0;
        }
        let per_step = brightest.sqrt() / STEPS;
        encode(path, light, 1.0 / per_step, self, gist);
        per_step * per_step
    }
}

/// Adds parts up, onto what is in `out` if that is to be `kept`.
pub(crate) fn combine<'a>(path: Path, parts: impl Iterator<Item = Part<'a>>, mut kept: bool, out: &mut Light) {
    in_batches(parts, |batch| {
        sum(path, batch, kept, out);
        kept = true;
    });
    if !kept {
        for plane in out {
            plane.fill([0.0; LANES]);
        }
    }
}

/// Calls `work` with some parts at a time, so that sums stay in registers and nothing is allocated.
#[inline(always)]
fn in_batches<'a>(mut parts: impl Iterator<Item = Part<'a>>, mut work: impl FnMut(&[Part])) {
    while let Some(first) = parts.next() {
        let mut batch = [first; BATCH];
        let mut count = 1;
        while count < BATCH {
            let Some(part) = parts.next() else { break };
            batch[count] = part;
            count += 1;
        }
        work(&batch[..count]);
    }
}

clones! {
    /// Adds the means of a picture that is multiplied by `gain`.
    pub(crate) fn add_gist(gist: &Gist, gain: [f32; 3], means: &mut Means) = add_gist_lanes;
}

#[inline(always)]
fn add_gist_lanes(gist: &Gist, gain: [f32; 3], means: &mut Means) {
    let [red, green, blue] = means;
    add_channel(&gist[0], gain[0], red);
    add_channel(&gist[1], gain[1], green);
    add_channel(&gist[2], gain[2], blue);
}

#[inline(always)]
fn add_channel(gist: &[u16; CELLS], gain: f32, means: &mut [f32; CELLS]) {
    let gain = gain * 65_536.0;
    for cell in 0..CELLS {
        means[cell] += f32::from(gist[cell]) * gain;
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
    fn encode(light: &Light, steps: f32, texels: &mut Texels, gist: &mut Gist) = encode_lanes;
}

#[inline(always)]
fn encode_lanes(light: &Light, steps: f32, texels: &mut Texels, gist: &mut Gist) {
    for channel in 0..3 {
        let mut means = [0.0; CELLS];
        for row in 0..TILE {
            let (line, out) = (&light[channel][row], &mut texels.0[channel][row * LANES..][..LANES]);
            let mut squares = [0.0; LANES];
            for i in 0..LANES {
                // 2^23 leaves no room for a fraction: adding it rounds, and the number is in the lowest bits.
                let step = ((max(line[i], 0.0).sqrt() * steps + 8_388_608.0).to_bits() & 0xffff) as u16;
                out[i] = step;
                squares[i] = f32::from(step) * f32::from(step);
            }
            add_row(row, &squares, &mut means);
        }
        for (gist, mean) in gist[channel].iter_mut().zip(means) {
            // A square is under 2^32, so what is kept of a mean is under 2^16.
            *gist = (mean * (1.0 / ((CELL * CELL) as f32 * 65_536.0))) as u16;
        }
    }
}

clones! {
    fn sum(parts: &[Part], kept: bool, out: &mut Light) = sum_lanes;
}

#[inline(always)]
fn sum_lanes(parts: &[Part], kept: bool, out: &mut Light) {
    for channel in 0..3 {
        for rows in (0..TILE).step_by(ROWS) {
            let mut sums = [[0.0; LANES]; ROWS];
            if kept {
                sums.copy_from_slice(&out[channel][rows..rows + ROWS]);
            }
            for part in parts {
                let gain = part.gain[channel];
                let texels = &part.texels.0[channel][rows * LANES..][..ROWS * LANES];
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
