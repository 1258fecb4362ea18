//! Glare: what a bright lamp spills over its neighbourhood in the eye.
//!
//! The picture is taken down to a quarter and from there by halves; every level is smoothed and added to the level
//! above on the way back. Wide, soft and cheap: the levels together are a twelfth of the picture.

use crate::lanes::{LANES, Path, clones, max};
use crate::points::TILE;
use rayon::prelude::*;

/// How many pixels of the picture, across and down, make one of the finest level.
pub(crate) const STEP: usize = 4;

/// Levels, the finest first.
const LEVELS: usize = 5;

/// What the finest level, the next, ... add to the glare.
const WEIGHTS: [f32; LEVELS] = [0.34, 0.26, 0.19, 0.13, 0.08];

/// The glare of a picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Pyramid {
    levels: Vec<Level>,
    /// Red, green, blue: the planes of every level.
    channels: [Vec<Planes>; 3],
}

/// The size of a level, whose planes have one cell of border on every side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Level {
    /// Cells across.
    pub width: usize,
    /// Cells down.
    pub height: usize,
    /// Numbers from row to row.
    pub stride: usize,
}

/// One channel of a level.
#[derive(Clone, Debug, PartialEq)]
struct Planes {
    /// The picture's light, kept where the picture does not change.
    means: Vec<f32>,
    scratch: Vec<f32>,
    /// The glare of this level and of all that are coarser.
    glare: Vec<f32>,
}

impl Planes {
    fn new(level: &Level) -> Planes {
        let plane = || vec![0.0; level.stride * (level.height + 2)];
        Planes { means: plane(), scratch: plane(), glare: plane() }
    }
}

/// The picture that the glare is taken of.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    /// Red, green, blue.
    pub planes: &'a [Vec<f32>; 3],
    /// Numbers from row to row.
    pub stride: usize,
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
}

impl Pyramid {
    /// Makes room for the glare of a picture of this size.
    pub fn resize(&mut self, width: usize, height: usize) {
        let mut size = (width.div_ceil(STEP).max(1), height.div_ceil(STEP).max(1));
        self.levels.clear();
        for _ in 0..LEVELS {
            let (width, height) = size;
            self.levels.push(Level { width, height, stride: (width + 2).next_multiple_of(LANES) });
            size = (width.div_ceil(2), height.div_ceil(2));
        }
        self.channels = [0; 3].map(|_| self.levels.iter().map(Planes::new).collect());
    }

    /// The finest level, which holds the sum.
    pub fn finest(&self) -> Option<(&Level, [&[f32]; 3])> {
        let [red, green, blue] = &self.channels;
        let planes = [red.first()?, green.first()?, blue.first()?];
        Some((self.levels.first()?, planes.map(|planes| planes.glare.as_slice())))
    }

    /// Takes the glare of a picture, in which only those tiles are new that `is_fresh`, asked for their row and column,
    /// says to be.
    pub fn gather(&mut self, path: Path, source: Source, is_fresh: impl Fn(usize, usize) -> bool + Sync) {
        let levels = &self.levels;
        self.channels.par_iter_mut().zip(source.planes).for_each(|(channel, light)| {
            if let (Some(level), Some(planes)) = (levels.first(), channel.first_mut()) {
                shrink(path, light, source, &mut planes.means, level, &is_fresh);
            }
            for at in 1..levels.len() {
                let (finer, coarser) = channel.split_at_mut(at);
                descend(&finer[at - 1].means, &levels[at - 1], &mut coarser[0].means, &levels[at]);
            }
            for at in (0..levels.len()).rev() {
                let (finer, coarser) = channel.split_at_mut(at + 1);
                let Planes { means, scratch, glare } = &mut finer[at];
                smooth(path, means, scratch, glare, &levels[at], WEIGHTS[at]);
                if let Some(coarse) = coarser.first() {
                    ascend(glare, &levels[at], &coarse.glare, &levels[at + 1]);
                }
                border(glare, &levels[at]);
            }
        });
    }
}

/// Takes the means of the new tiles of one channel.
fn shrink(
    path: Path,
    light: &[f32],
    source: Source,
    means: &mut [f32],
    level: &Level,
    is_fresh: impl Fn(usize, usize) -> bool + Sync,
) {
    let Source { stride, width, height, .. } = source;
    let cells = &mut means[level.stride..(level.height + 1) * level.stride];
    cells.par_chunks_mut(level.stride * (TILE / STEP)).enumerate().for_each(|(tile_row, cells)| {
        let columns = width.div_ceil(TILE);
        let mut column = 0;
        while column < columns {
            let from = column;
            while column < columns && is_fresh(tile_row, column) {
                column += 1;
            }
            let pixels = from * TILE..(column * TILE).min(width);
            if pixels.is_empty() {
                column += 1;
                continue;
            }
            for (row, cells) in cells.chunks_mut(level.stride).enumerate() {
                let top = tile_row * TILE + row * STEP;
                let rows = [0, 1, 2, 3].map(|k| {
                    let y = (top + k).min(height - 1);
                    &light[y * stride..y * stride + stride][pixels.clone()]
                });
                quarter(path, rows, &mut cells[1 + from * (TILE / STEP)..]);
            }
            column += 1;
        }
    });
    border(means, level);
}

clones! {
    fn quarter(rows: [&[f32]; 4], target: &mut [f32]) = quarter_row;
}

/// Means of 4 x 4 pixels.
#[inline(always)]
fn quarter_row(rows: [&[f32]; 4], target: &mut [f32]) {
    let width = rows[0].len();
    let cells = width / STEP;
    let whole = |row: &[f32], at: usize| (row[at] + row[at + 1]) + (row[at + 2] + row[at + 3]);
    for cell in 0..cells {
        let at = cell * STEP;
        let sum = (whole(rows[0], at) + whole(rows[1], at)) + (whole(rows[2], at) + whole(rows[3], at));
        target[cell] = sum * (1.0 / 16.0);
    }
    if !width.is_multiple_of(STEP) {
        let columns = cells * STEP..width;
        let count = (columns.len() * 4) as f32;
        target[cells] = rows.iter().map(|row| row[columns.clone()].iter().sum::<f32>()).sum::<f32>() / count;
    }
}

/// Halves a level.
fn descend(source: &[f32], finer: &Level, target: &mut [f32], coarser: &Level) {
    for y in 0..coarser.height {
        for x in 0..coarser.width {
            let top = (1 + 2 * y) * finer.stride + 1 + 2 * x;
            // The border repeats the edge, so an odd size needs no case of its own.
            let sum = (source[top] + source[top + 1]) + (source[top + finer.stride] + source[top + finer.stride + 1]);
            target[(1 + y) * coarser.stride + 1 + x] = sum * 0.25;
        }
    }
    border(target, coarser);
}

/// Repeats the edge cells outwards.
fn border(plane: &mut [f32], &Level { width, height, stride }: &Level) {
    for y in 1..=height {
        plane[y * stride] = plane[y * stride + 1];
        plane[y * stride + width + 1] = plane[y * stride + width];
    }
    plane.copy_within(stride..2 * stride, 0);
    plane.copy_within(height * stride..(height + 1) * stride, (height + 1) * stride);
}

clones! {
    fn smooth(
        source: &[f32], scratch: &mut [f32], target: &mut [f32], level: &Level, weight: f32,
    ) = smooth_plane;
}

/// A 1 2 1 filter both ways, times `weight`.
#[inline(always)]
fn smooth_plane(source: &[f32], scratch: &mut [f32], target: &mut [f32], level: &Level, weight: f32) {
    let &Level { width, height, stride } = level;
    for y in 0..height + 2 {
        let row = &source[y * stride..(y + 1) * stride];
        let out = &mut scratch[y * stride..(y + 1) * stride];
        for x in 1..=width {
            out[x] = row[x - 1] + 2.0 * row[x] + row[x + 1];
        }
    }
    let weight = weight / 16.0;
    for y in 1..=height {
        let above = &scratch[(y - 1) * stride..y * stride];
        let here = &scratch[y * stride..(y + 1) * stride];
        let below = &scratch[(y + 1) * stride..(y + 2) * stride];
        let out = &mut target[y * stride..(y + 1) * stride];
        for x in 1..=width {
            out[x] = max(weight * (above[x] + 2.0 * here[x] + below[x]), 0.0);
        }
    }
}

/// Adds the coarser level, stretched to twice its size.
fn ascend(plane: &mut [f32], &Level { width, height, stride }: &Level, source: &[f32], coarse: &Level) {
    for y in 0..height {
        let (near, far) = neighbours(y);
        let (near, far) = (&source[near * coarse.stride..], &source[far * coarse.stride..]);
        let out = &mut plane[(y + 1) * stride + 1..][..width];
        for (x, out) in out.iter_mut().enumerate() {
            let (a, b) = neighbours(x);
            *out += 0.5625 * near[a] + 0.1875 * (near[b] + far[a]) + 0.0625 * far[b];
        }
    }
}

/// The cell that holds a cell of the finer level, and the next nearest, both counted with the border.
fn neighbours(at: usize) -> (usize, usize) {
    let near = at / 2 + 1;
    (near, if at.is_multiple_of(2) { near - 1 } else { near + 1 })
}
