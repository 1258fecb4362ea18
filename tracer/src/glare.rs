//! Glare: what a bright lamp spills over its neighbourhood in the eye.
//!
//! The picture is taken down to a quarter and from there by halves; every level is smoothed and added to the level
//! above on the way back. Wide, soft and cheap: the levels together are a twelfth of the picture.

use crate::lanes::{LANES, Path, clones, max};
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
}

/// One level: three planes with one cell of border on every side.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Level {
    /// Cells across.
    pub width: usize,
    /// Cells down.
    pub height: usize,
    /// Numbers from row to row.
    pub stride: usize,
    /// Red, green, blue.
    pub planes: [Vec<f32>; 3],
    scratch: [Vec<f32>; 3],
}

impl Level {
    fn new(width: usize, height: usize) -> Level {
        let stride = (width + 2).next_multiple_of(LANES);
        let plane = || vec![0.0; stride * (height + 2)];
        Level { width, height, stride, planes: [plane(), plane(), plane()], scratch: [plane(), plane(), plane()] }
    }
}

impl Pyramid {
    /// Makes room for the glare of a picture of this size.
    pub fn resize(&mut self, width: usize, height: usize) {
        let mut size = (width.div_ceil(STEP).max(1), height.div_ceil(STEP).max(1));
        self.levels.clear();
        for _ in 0..LEVELS {
            self.levels.push(Level::new(size.0, size.1));
            size = (size.0.div_ceil(2), size.1.div_ceil(2));
        }
    }

    /// The finest level, which holds the sum.
    pub fn finest(&self) -> Option<&Level> {
        self.levels.first()
    }

    /// Takes the glare of a picture of `width` x `height` pixels.
    pub fn gather(&mut self, path: Path, planes: &[Vec<f32>; 3], stride: usize, width: usize, height: usize) {
        let Some(finest) = self.levels.first_mut() else { return };
        let row_stride = finest.stride;
        for (source, target) in planes.iter().zip(&mut finest.planes) {
            target.par_chunks_mut(row_stride).with_min_len(16).enumerate().for_each(|(row, target)| {
                let top = row.saturating_sub(1) * STEP;
                let top = top.min(height.saturating_sub(1) / STEP * STEP);
                let rows = [0, 1, 2, 3].map(|k| {
                    let y = (top + k).min(height - 1);
                    &source[y * stride..y * stride + stride]
                });
                quarter(path, rows, width, target);
            });
        }
        for at in 1..LEVELS {
            let (finer, coarser) = self.levels.split_at_mut(at);
            descend(path, &finer[at - 1], &mut coarser[0]);
        }
        for at in (0..LEVELS).rev() {
            let weight = WEIGHTS[at];
            let (finer, coarser) = self.levels.split_at_mut(at + 1);
            let level = &mut finer[at];
            let Level { width, height, stride, planes, scratch } = level;
            planes.par_iter_mut().zip(scratch.par_iter_mut()).enumerate().for_each(|(channel, (plane, scratch))| {
                smooth(path, plane, scratch, *width, *height, *stride, weight);
                if let Some(coarse) = coarser.first() {
                    ascend(plane, *width, *height, *stride, &coarse.planes[channel], coarse);
                }
                border(plane, *width, *height, *stride);
            });
        }
    }
}

clones! {
    fn quarter(rows: [&[f32]; 4], width: usize, target: &mut [f32]) = quarter_row;
}

/// Means of 4 x 4 pixels, with a cell of border on either side.
#[inline(always)]
fn quarter_row(rows: [&[f32]; 4], width: usize, target: &mut [f32]) {
    let cells = width / STEP;
    let whole = |row: &[f32], at: usize| (row[at] + row[at + 1]) + (row[at + 2] + row[at + 3]);
    for cell in 0..cells {
        let at = cell * STEP;
        let sum = (whole(rows[0], at) + whole(rows[1], at)) + (whole(rows[2], at) + whole(rows[3], at));
        target[cell + 1] = sum * (1.0 / 16.0);
    }
    let mut end = cells + 1;
    if !width.is_multiple_of(STEP) {
        let columns = cells * STEP..width;
        let count = (columns.len() * 4) as f32;
        target[end] = rows.iter().map(|row| row[columns.clone()].iter().sum::<f32>()).sum::<f32>() / count;
        end += 1;
    }
    target[0] = target[1];
    target[end] = target[end - 1];
}

/// Halves a level.
fn descend(_path: Path, finer: &Level, coarser: &mut Level) {
    let (width, height, stride) = (coarser.width, coarser.height, coarser.stride);
    for (source, target) in finer.planes.iter().zip(&mut coarser.planes) {
        for y in 0..height {
            for x in 0..width {
                let top = (1 + 2 * y) * finer.stride + 1 + 2 * x;
                // The border repeats the edge, so an odd size needs no case of its own.
                let sum =
                    (source[top] + source[top + 1]) + (source[top + finer.stride] + source[top + finer.stride + 1]);
                target[(1 + y) * stride + 1 + x] = sum * 0.25;
            }
        }
        border(target, width, height, stride);
    }
}

/// Repeats the edge cells outwards.
fn border(plane: &mut [f32], width: usize, height: usize, stride: usize) {
    for y in 1..=height {
        plane[y * stride] = plane[y * stride + 1];
        plane[y * stride + width + 1] = plane[y * stride + width];
    }
    plane.copy_within(stride..2 * stride, 0);
    plane.copy_within(height * stride..(height + 1) * stride, (height + 1) * stride);
}

clones! {
    fn smooth(
        plane: &mut [f32], scratch: &mut [f32], width: usize, height: usize, stride: usize, weight: f32,
    ) = smooth_plane;
}

/// A 1 2 1 filter both ways, times `weight`.
#[inline(always)]
fn smooth_plane(plane: &mut [f32], scratch: &mut [f32], width: usize, height: usize, stride: usize, weight: f32) {
    for y in 0..height + 2 {
        let row = &plane[y * stride..(y + 1) * stride];
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
        let out = &mut plane[y * stride..(y + 1) * stride];
        for x in 1..=width {
            out[x] = max(weight * (above[x] + 2.0 * here[x] + below[x]), 0.0);
        }
    }
}

/// Adds the coarser level, stretched to twice its size.
fn ascend(plane: &mut [f32], width: usize, height: usize, stride: usize, source: &[f32], coarse: &Level) {
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
