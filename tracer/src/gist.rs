//! The means of a tile's cells: what the glare, and a ball's mirror, need of a picture.
//!
//! They are kept beside every picture of a tile and sum up as the pictures do, so the glare of a frame is known before
//! the frame is put together.

use crate::Rgb;
use crate::irradiance::Light;
use crate::lanes::{LANES, Lanes, Path, clones, max, rounded};
use crate::penumbra::Rows;
use crate::points::TILE;
use crate::response::{FAINTEST, STEPS, Texels};

/// Cells of [`CELL`] x [`CELL`] pixels in a tile.
pub(crate) const CELLS: usize = (TILE / CELL) * (TILE / CELL);

/// Pixels along the side of a cell: what the glare's finest level is made of.
pub(crate) const CELL: usize = 4;

/// Cells in a row of a tile.
const ROW: usize = TILE / CELL;

/// Three numbers for every cell of a tile, row by row.
pub(crate) type Means = [[f32; CELLS]; 3];

/// The means of a picture's cells.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gist {
    scale: f32,
    cells: [[u16; CELLS]; 3],
}

impl Gist {
    /// Keeps means: finite, 0 or more.
    pub fn of(means: &Means) -> Gist {
        let most = means.as_flattened().iter().fold(0.0, |a, &b| max(a, b));
        let steps = if most < FAINTEST { 0.0 } else { STEPS / most };
        let mut cells = [[0; CELLS]; 3];
        for (cell, mean) in cells.as_flattened_mut().iter_mut().zip(means.as_flattened()) {
            *cell = rounded(mean * steps);
        }
        Gist { scale: most / STEPS, cells }
    }

    /// Keeps the means of those cells of a floor that have any of some rows: of what arrives at it, and of what
    /// shines there.
    pub fn keep_floor(&mut self, path: Path, albedo: &Light, planes: [&Texels; 2], scales: [f32; 2], rows: Rows) {
        let mut means = [[0.0; CELLS]; 3];
        floor_means(path, albedo, planes, scales, rows, &mut means);
        // No cell is brighter than white where all arrives.
        self.keep_rows(&means, (scales[0] + scales[1]) * STEPS, rows);
    }

    /// Keeps the means of those cells of a picture in colours that have any of some rows.
    pub fn keep_colors(&mut self, path: Path, planes: &[Texels], scale: f32, rows: Rows) {
        let mut means = [[0.0; CELLS]; 3];
        color_means(path, planes, scale, rows, &mut means);
        self.keep_rows(&means, scale * STEPS, rows);
    }

    fn keep_rows(&mut self, means: &Means, scale: f32, rows: Rows) {
        self.scale = scale;
        let steps = if scale > 0.0 { 1.0 / scale } else { 0.0 };
        for (cells, means) in self.cells.iter_mut().zip(means) {
            for at in cells_of(rows).flat_map(|row| row * ROW..(row + 1) * ROW) {
                cells[at] = rounded(means[at] * steps);
            }
        }
    }

    /// Adds them, in light of a colour.
    pub fn add(&self, path: Path, color: Rgb, means: &mut Means) {
        add_gist(path, &self.cells, color.map(|channel| channel * self.scale), means);
    }
}

clones! {
    fn add_gist(cells: &[[u16; CELLS]; 3], gain: Rgb, means: &mut Means) = add_gist_lanes;
}

#[inline(always)]
fn add_gist_lanes(cells: &[[u16; CELLS]; 3], gain: Rgb, means: &mut Means) {
    let [red, green, blue] = means;
    add_channel(&cells[0], gain[0], red);
    add_channel(&cells[1], gain[1], green);
    add_channel(&cells[2], gain[2], blue);
}

#[inline(always)]
fn add_channel(cells: &[u16; CELLS], gain: f32, means: &mut [f32; CELLS]) {
    for cell in 0..CELLS {
        means[cell] += f32::from(cells[cell]) * gain;
    }
}

clones! {
    /// The means of the cells of a picture.
    pub(crate) fn means_of(light: &Light, means: &mut Means) = means_lanes;
}

#[inline(always)]
fn means_lanes(light: &Light, means: &mut Means) {
    for cells in 0..ROW {
        let rows = cells * CELL..(cells + 1) * CELL;
        let mut sums = [[0.0; LANES]; 3];
        for row in rows {
            for i in 0..LANES {
                sums[0][i] += light[0][row][i];
                sums[1][i] += light[1][row][i];
                sums[2][i] += light[2][row][i];
            }
        }
        put_means(cells, &sums, means);
    }
}

clones! {
    /// The means of those cells of a floor that have any of some rows: its reflectance times what arrives, and what
    /// shines on it.
    fn floor_means(
        albedo: &Light, planes: [&Texels; 2], scales: [f32; 2], rows: Rows, means: &mut Means,
    ) = floor_means_lanes;
}

#[inline(always)]
fn floor_means_lanes(albedo: &Light, [matt, gloss]: [&Texels; 2], scales: [f32; 2], rows: Rows, means: &mut Means) {
    for cells in cells_of(rows) {
        let mut sums = [[0.0; LANES]; 3];
        for row in cells * CELL..(cells + 1) * CELL {
            let (matt, gloss) = (&matt.0[row * LANES..][..LANES], &gloss.0[row * LANES..][..LANES]);
            for i in 0..LANES {
                let (arriving, shine) = (f32::from(matt[i]), f32::from(gloss[i]));
                let (arriving, shine) = (arriving * arriving * scales[0], shine * shine * scales[1]);
                sums[0][i] += albedo[0][row][i] * arriving + shine;
                sums[1][i] += albedo[1][row][i] * arriving + shine;
                sums[2][i] += albedo[2][row][i] * arriving + shine;
            }
        }
        put_means(cells, &sums, means);
    }
}

clones! {
    /// The means of those cells of colours that have any of some rows.
    fn color_means(planes: &[Texels], scale: f32, rows: Rows, means: &mut Means) = color_means_lanes;
}

#[inline(always)]
fn color_means_lanes(planes: &[Texels], scale: f32, rows: Rows, means: &mut Means) {
    for cells in cells_of(rows) {
        let mut sums = [[0.0; LANES]; 3];
        for (sums, plane) in sums.iter_mut().zip(planes) {
            for row in cells * CELL..(cells + 1) * CELL {
                let line = &plane.0[row * LANES..][..LANES];
                for i in 0..LANES {
                    let root = f32::from(line[i]);
                    sums[i] += root * root * scale;
                }
            }
        }
        put_means(cells, &sums, means);
    }
}

/// The rows of cells that have any of some rows of pixels.
#[inline(always)]
fn cells_of(rows: Rows) -> impl Iterator<Item = usize> {
    (0..ROW).filter(move |cells| rows >> (cells * CELL) & ((1 << CELL) - 1) != 0)
}

/// Writes the means of a row of cells, whose columns were summed up.
#[inline(always)]
fn put_means(row: usize, sums: &[Lanes; 3], means: &mut Means) {
    for (sums, means) in sums.iter().zip(means) {
        for (at, mean) in means[row * ROW..][..ROW].iter_mut().enumerate() {
            let [a, b, c, d] = [sums[at * CELL], sums[at * CELL + 1], sums[at * CELL + 2], sums[at * CELL + 3]];
            *mean = ((a + b) + (c + d)) * (1.0 / (CELL * CELL) as f32);
        }
    }
}
