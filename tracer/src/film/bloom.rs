//! Bloom: light that the eye scatters from bright lamps over their neighbourhood.
//!
//! A mip chain, as in J. Jimenez, "Next generation post processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014,
//! with the cheapest filters that show no blocks:
//! 1. Down: the finest level is the mean of 4 x 4 pixels, each further level the mean of 2 x 2 cells.
//! 2. Each level is smoothed by the binomial filter 1 2 1 in both directions.
//! 3. Up: from the coarsest level on, a level is stretched to twice its size, bilinearly (9/16, 3/16, 3/16, 1/16), and
//!    added to the next finer one.
//!
//! Bloom is linear, and the weights of the levels sum to 1: it moves light and makes none. The levels together have a
//! twelfth of the picture's pixels.

use crate::simd::dispatch::{LANES, SimdLevel, max, multiversion};
use crate::tile::planes::TILE;
use rayon::prelude::*;

/// How many pixels of the picture, across and down, make one of the finest level.
pub(crate) const CELL_PX: usize = 4;

/// Cells that can be read from any tile's first on, though the last tiles' rows end sooner.
pub(crate) const READ_AHEAD_CELLS: usize = 8;

/// Rows of cells that one task makes.
const ROWS_PER_TASK: usize = 32;

/// Levels, the finest first.
const LEVELS: usize = 5;

/// The weight of each level, the finest first; their sum is 1. Art direction: a narrow core, a long tail.
const WEIGHTS: [f32; LEVELS] = [0.34, 0.26, 0.19, 0.13, 0.08];

/// The bloom of a picture.
#[derive(Clone, Debug, Default)]
pub(crate) struct BloomPyramid {
    levels: Vec<MipLevel>,
    /// Red, green, blue: the planes of every level.
    channels: [Vec<MipPlanes>; 3],
    /// The bloom that was taken before this one.
    previous: [Vec<f32>; 3],
}

/// The same bloom, whatever was there before.
impl PartialEq for BloomPyramid {
    fn eq(&self, other: &BloomPyramid) -> bool {
        self.levels == other.levels && self.channels == other.channels
    }
}

/// The size of a level, whose planes have one cell of border on every side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MipLevel {
    /// Cells across.
    pub width: usize,
    /// Cells down.
    pub height: usize,
    /// Numbers from row to row.
    pub stride: usize,
}

/// One channel of a level.
#[derive(Clone, Debug, PartialEq)]
struct MipPlanes {
    /// The picture's light, kept where the picture does not change.
    means: Vec<f32>,
    /// The bloom of this level and of all that are coarser.
    bloom: Vec<f32>,
}

impl MipPlanes {
    fn new(level: &MipLevel) -> MipPlanes {
        let plane = || vec![0.0; level.stride * (level.height + 2)];
        MipPlanes { means: plane(), bloom: plane() }
    }
}

impl BloomPyramid {
    /// Makes room for the bloom of a picture of this size.
    pub fn resize(&mut self, width: usize, height: usize) {
        let mut size = (width.div_ceil(CELL_PX).max(1), height.div_ceil(CELL_PX).max(1));
        self.levels.clear();
        for _ in 0..LEVELS {
            let (width, height) = size;
            self.levels.push(MipLevel {
                width,
                height,
                stride: (width + 2 + READ_AHEAD_CELLS).next_multiple_of(LANES),
            });
            size = (width.div_ceil(2), height.div_ceil(2));
        }
        self.channels = [0; 3].map(|_| self.levels.iter().map(MipPlanes::new).collect());
        self.previous = [0; 3].map(|_| self.channels[0].first().map_or(Vec::new(), |finest| finest.bloom.clone()));
    }

    /// The finest level, which holds the sum.
    pub fn finest(&self) -> Option<(&MipLevel, [&[f32]; 3])> {
        let [red, green, blue] = &self.channels;
        let planes = [red.first()?, green.first()?, blue.first()?];
        Some((self.levels.first()?, planes.map(|planes| planes.bloom.as_slice())))
    }

    /// The picture's own light in the finest level, with its border.
    pub fn means(&self) -> Option<(&MipLevel, [&[f32]; 3])> {
        let [red, green, blue] = &self.channels;
        let planes = [red.first()?, green.first()?, blue.first()?];
        Some((self.levels.first()?, planes.map(|planes| planes.means.as_slice())))
    }

    /// The same, to be written: rows of [`MipLevel::stride`] cells, the first cell of each being border.
    pub fn means_mut(&mut self) -> Option<(MipLevel, [&mut [f32]; 3])> {
        let level = *self.levels.first()?;
        let [red, green, blue] = &mut self.channels;
        let planes = [red.first_mut()?, green.first_mut()?, blue.first_mut()?];
        let rows = level.stride..(level.height + 1) * level.stride;
        Some((level, planes.map(|planes| &mut planes.means[rows.clone()])))
    }

    /// Takes the bloom of the picture whose means were written.
    pub fn compute(&mut self, simd: SimdLevel) {
        let levels = &self.levels;
        self.channels.par_iter_mut().zip(&mut self.previous).for_each(|(channel, previous)| {
            if let (Some(level), Some(planes)) = (levels.first(), channel.first_mut()) {
                replicate_border(&mut planes.means, level);
                std::mem::swap(previous, &mut planes.bloom);
            }
            for at in 1..levels.len() {
                let (finer, coarser) = channel.split_at_mut(at);
                downsample(simd, &finer[at - 1].means, &levels[at - 1], &mut coarser[0].means, &levels[at]);
                replicate_border(&mut coarser[0].means, &levels[at]);
            }
            for at in (0..levels.len()).rev() {
                let (finer, coarser) = channel.split_at_mut(at + 1);
                let MipPlanes { means, bloom } = &mut finer[at];
                let level = &levels[at];
                let coarse = coarser.first().map(|planes| (planes.bloom.as_slice(), &levels[at + 1]));
                let rows = &mut bloom[level.stride..(level.height + 1) * level.stride];
                rows.par_chunks_mut(level.stride * ROWS_PER_TASK).enumerate().for_each(|(chunk, rows)| {
                    for (row, out) in rows.chunks_mut(level.stride).enumerate() {
                        let y = chunk * ROWS_PER_TASK + row;
                        let around = &means[y * level.stride..(y + 3) * level.stride];
                        tent_filter(simd, around, level, WEIGHTS[at], out);
                        if let Some((coarse, size)) = coarse {
                            upsample(simd, coarse, size, y, level.width, out);
                        }
                    }
                });
                replicate_border(bloom, level);
            }
        });
    }

    /// Whether the bloom of a tile, given by its upper left pixel, is another than before it was taken last.
    pub fn has_changed_at(&self, x: usize, y: usize) -> bool {
        let Some(level) = self.levels.first() else { return false };
        let columns = x / CELL_PX..(x / CELL_PX + TILE / CELL_PX + 2).min(level.width + 2);
        (y / CELL_PX..(y / CELL_PX + TILE / CELL_PX + 2).min(level.height + 2)).any(|row| {
            let cells = row * level.stride + columns.start..row * level.stride + columns.end;
            let same = |(channel, previous): (&Vec<MipPlanes>, &Vec<f32>)| {
                channel.first().is_some_and(|finest| finest.bloom[cells.clone()] == previous[cells.clone()])
            };
            !self.channels.iter().zip(&self.previous).all(same)
        })
    }
}

multiversion! {
    /// Halves a level.
    fn downsample(source: &[f32], finer: &MipLevel, target: &mut [f32], coarser: &MipLevel) = downsample_plane;
}

#[inline(always)]
fn downsample_plane(source: &[f32], finer: &MipLevel, target: &mut [f32], coarser: &MipLevel) {
    for y in 0..coarser.height {
        for x in 0..coarser.width {
            let top = (1 + 2 * y) * finer.stride + 1 + 2 * x;
            // The border repeats the edge, so an odd size needs no case of its own.
            let sum = (source[top] + source[top + 1]) + (source[top + finer.stride] + source[top + finer.stride + 1]);
            target[(1 + y) * coarser.stride + 1 + x] = sum * 0.25;
        }
    }
}

/// Repeats the edge cells outwards.
fn replicate_border(plane: &mut [f32], &MipLevel { width, height, stride }: &MipLevel) {
    for y in 1..=height {
        plane[y * stride] = plane[y * stride + 1];
        plane[y * stride + width + 1] = plane[y * stride + width];
    }
    plane.copy_within(stride..2 * stride, 0);
    plane.copy_within(height * stride..(height + 1) * stride, (height + 1) * stride);
}

multiversion! {
    /// A 1 2 1 filter both ways, times `weight`, of the middle one of three rows.
    fn tent_filter(around: &[f32], level: &MipLevel, weight: f32, out: &mut [f32]) = tent_filter_row;
}

#[inline(always)]
fn tent_filter_row(around: &[f32], &MipLevel { width, stride, .. }: &MipLevel, weight: f32, out: &mut [f32]) {
    let weight = weight / 16.0;
    let column = |shift: usize| {
        let row = |at: usize| &around[at * stride + shift..][..width];
        (row(0), row(1), row(2))
    };
    let (left, here, right) = (column(0), column(1), column(2));
    let sum = |(above, here, below): (&[f32], &[f32], &[f32]), x: usize| above[x] + 2.0 * here[x] + below[x];
    let out = &mut out[1..=width];
    for x in 0..width {
        out[x] = max(weight * (sum(left, x) + 2.0 * sum(here, x) + sum(right, x)), 0.0);
    }
}

/// Bilinear weights of stretching by two: a cell's centre lies a quarter of a coarse cell from the nearest coarse
/// centre, so the weights are 3/4 and 1/4 in each direction.
const NEAR_NEAR: f32 = 9.0 / 16.0;
/// One direction near, the other far.
const NEAR_FAR: f32 = 3.0 / 16.0;
/// Both far.
const FAR_FAR: f32 = 1.0 / 16.0;

multiversion! {
    /// Adds the coarser level, stretched to twice its size, to row `y`.
    fn upsample(source: &[f32], coarse: &MipLevel, y: usize, width: usize, out: &mut [f32]) = upsample_row;
}

#[inline(always)]
fn upsample_row(source: &[f32], coarse: &MipLevel, y: usize, width: usize, out: &mut [f32]) {
    let (near, far) = neighbours(y);
    let (near, far) = (&source[near * coarse.stride..], &source[far * coarse.stride..]);
    for (x, out) in out[1..=width].iter_mut().enumerate() {
        let (a, b) = neighbours(x);
        *out += NEAR_NEAR * near[a] + NEAR_FAR * (near[b] + far[a]) + FAR_FAR * far[b];
    }
}

/// The cell that holds a cell of the finer level, and the next nearest, both counted with the border.
#[inline(always)]
fn neighbours(at: usize) -> (usize, usize) {
    let near = at / 2 + 1;
    (near, if at.is_multiple_of(2) { near - 1 } else { near + 1 })
}
