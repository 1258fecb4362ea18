//! What a tile shows in the light of one lamp alone: small pictures, kept in 16 bits a number.
//!
//! Light is linear, so the picture under all lamps is the sum of the pictures under each, times the lamps' colours. A
//! lamp that flashes is a factor here and nothing else. Of bare floor, what arrives is kept in one plane, since all
//! lamps meet the same paint; of anything else, three planes of colours. Numbers are kept as square roots, in 65,535
//! steps up to the plane's largest: an error of 1.6e-5 of a bright value, and less of a dark one. This module refuses
//! to know what made the light.

use crate::Rgb;
use crate::irradiance::Light;
use crate::lanes::{LANES, Lanes, Path, clones, max};
use crate::penumbra::Rows;
use crate::points::{AREA, Plane, TILE};

/// Cells of [`CELL`] x [`CELL`] pixels in a tile.
pub(crate) const CELLS: usize = (TILE / CELL) * (TILE / CELL);

/// Pixels along the side of a cell: what the glare's finest level is made of.
pub(crate) const CELL: usize = 4;

/// Cells in a row of a tile.
const ROW: usize = TILE / CELL;

/// Three numbers for every cell of a tile, row by row.
pub(crate) type Means = [[f32; CELLS]; 3];

/// What a tile's floor reflects: red, green, blue, in 65,535ths.
pub(crate) type Paint = [[u16; AREA]; 3];

/// Rows of a tile that are summed up in registers.
const ROWS: usize = 4;

/// The same where a plane gives all three channels.
const GRAY_ROWS: usize = 2;

/// Parts that are summed up together.
const BATCH: usize = 8;

/// The steps from dark to a plane's largest number.
const STEPS: f32 = 65_535.0;

/// Less light than this is none: squares of roots so small would lose their digits.
const FAINTEST: f32 = 1e-20;

/// A plane of a tile, row by row, as square roots.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Texels([u16; AREA]);

/// Darkness.
pub(crate) static DARK: Texels = Texels([0; AREA]);

impl Texels {
    /// Whether all of it is dark.
    pub fn is_dark(&self) -> bool {
        self.0.iter().fold(0, |all, texel| all | texel) == 0
    }
}

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

    /// Keeps the means of those cells of a floor that have any of some rows: see [`Part`].
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

/// Planes, with what their squares are to be multiplied by.
pub(crate) struct Part<'a, T: ?Sized> {
    /// One plane, or three.
    pub texels: &'a T,
    /// The light's colour, times the planes' own factor.
    pub gain: Rgb,
}

impl<T: ?Sized> Copy for Part<'_, T> {}

impl<T: ?Sized> Clone for Part<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

/// What squares of texels are to be multiplied by if these planes, finite, 0 or more, are kept; 0 if all is dark.
pub(crate) fn scale_of(path: Path, planes: &[Plane]) -> f32 {
    let mut largest = 0.0;
    find_largest(path, planes, &mut largest);
    let per_step = largest.sqrt() / STEPS;
    if largest < FAINTEST { 0.0 } else { per_step * per_step }
}

/// Adds colours onto what is in `out`.
pub(crate) fn add_colors<'a>(path: Path, parts: impl Iterator<Item = Part<'a, [Texels]>>, out: &mut Light) {
    in_batches(parts, |batch| sum_colors(path, batch, out));
}

/// Adds what is the same for all channels onto what is in `out`.
pub(crate) fn add_grays<'a>(path: Path, parts: impl Iterator<Item = Part<'a, Texels>>, out: &mut Light) {
    in_batches(parts, |batch| sum_grays(path, batch, out));
}

/// Adds what arrives at a floor, times its paint, onto what is in `out`.
pub(crate) fn add_floor<'a>(path: Path, paint: &Paint, parts: impl Iterator<Item = Part<'a, Texels>>, out: &mut Light) {
    in_batches(parts, |batch| sum_floor(path, paint, batch, [0.0; 3], true, out));
}

/// The floor in light that is `everywhere` the same, and in what arrives besides, into `out`.
pub(crate) fn put_floor<'a>(
    path: Path,
    paint: &Paint,
    everywhere: Rgb,
    parts: impl Iterator<Item = Part<'a, Texels>>,
    out: &mut Light,
) {
    let mut rest = false;
    in_batches(parts, |batch| {
        sum_floor(path, paint, batch, if rest { [0.0; 3] } else { everywhere }, rest, out);
        rest = true;
    });
    if !rest {
        sum_floor(path, paint, &[], everywhere, false, out);
    }
}

/// Calls `work` with some parts at a time, so that sums stay in registers and nothing is allocated.
#[inline(always)]
fn in_batches<'a, T: ?Sized + 'a>(mut parts: impl Iterator<Item = Part<'a, T>>, mut work: impl FnMut(&[Part<T>])) {
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

clones! {
    fn find_largest(planes: &[Plane], largest: &mut f32) = largest_lanes;
}

#[inline(always)]
fn largest_lanes(planes: &[Plane], largest: &mut f32) {
    let mut most = [0.0; LANES];
    for line in planes.as_flattened() {
        for i in 0..LANES {
            most[i] = max(line[i], most[i]);
        }
    }
    *largest = most.iter().fold(0.0, |a, &b| max(a, b));
}

/// The nearest whole number, for a value from 0 to 65,535: 2^23 leaves no room for a fraction, so adding it rounds, and
/// the number is in the lowest bits.
#[inline(always)]
fn rounded(value: f32) -> u16 {
    ((value + 8_388_608.0).to_bits() & 0xffff) as u16
}

clones! {
    /// Keeps some rows of a plane, times what is seen of it.
    pub(crate) fn encode_rows(
        plane: &Plane, seen: &Plane, rows: Rows, scale: f32, texels: &mut Texels,
    ) = encode_lanes;
}

#[inline(always)]
fn encode_lanes(plane: &Plane, seen: &Plane, rows: Rows, scale: f32, texels: &mut Texels) {
    let steps = if scale > 0.0 { 1.0 / scale.sqrt() } else { 0.0 };
    for row in (0..TILE).filter(|row| rows >> row & 1 == 1) {
        let (line, seen, out) = (&plane[row], &seen[row], &mut texels.0[row * LANES..][..LANES]);
        for i in 0..LANES {
            out[i] = rounded((max(line[i], 0.0) * seen[i]).sqrt() * steps);
        }
    }
}

clones! {
    fn sum_colors(parts: &[Part<[Texels]>], out: &mut Light) = sum_colors_lanes;
}

#[inline(always)]
fn sum_colors_lanes(parts: &[Part<[Texels]>], out: &mut Light) {
    for channel in 0..3 {
        for rows in (0..TILE).step_by(ROWS) {
            let mut sums = [[0.0; LANES]; ROWS];
            sums.copy_from_slice(&out[channel][rows..rows + ROWS]);
            for part in parts {
                let gain = part.gain[channel];
                let texels = &part.texels[channel].0[rows * LANES..][..ROWS * LANES];
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

/// The sums of two rows of planes that are the same for all channels, onto `sums`.
#[inline(always)]
fn add_rows(parts: &[Part<Texels>], rows: usize, sums: &mut [[Lanes; GRAY_ROWS]; 3]) {
    let [red, green, blue] = sums;
    for part in parts {
        let [r, g, b] = part.gain;
        let texels = &part.texels.0[rows * LANES..][..GRAY_ROWS * LANES];
        for row in 0..GRAY_ROWS {
            for i in 0..LANES {
                let root = f32::from(texels[row * LANES + i]);
                let square = root * root;
                red[row][i] += square * r;
                green[row][i] += square * g;
                blue[row][i] += square * b;
            }
        }
    }
}

clones! {
    fn sum_grays(parts: &[Part<Texels>], out: &mut Light) = sum_grays_lanes;
}

#[inline(always)]
fn sum_grays_lanes(parts: &[Part<Texels>], out: &mut Light) {
    for rows in (0..TILE).step_by(GRAY_ROWS) {
        let mut sums = [[[0.0; LANES]; GRAY_ROWS]; 3];
        add_rows(parts, rows, &mut sums);
        for (sums, out) in sums.iter().zip(&mut *out) {
            for row in 0..GRAY_ROWS {
                for i in 0..LANES {
                    out[rows + row][i] += sums[row][i];
                }
            }
        }
    }
}

clones! {
    fn sum_floor(
        paint: &Paint, parts: &[Part<Texels>], everywhere: Rgb, kept: bool, out: &mut Light,
    ) = sum_floor_lanes;
}

#[inline(always)]
fn sum_floor_lanes(paint: &Paint, parts: &[Part<Texels>], everywhere: Rgb, kept: bool, out: &mut Light) {
    for rows in (0..TILE).step_by(GRAY_ROWS) {
        let mut sums = everywhere.map(|everywhere| [[everywhere; LANES]; GRAY_ROWS]);
        add_rows(parts, rows, &mut sums);
        for ((sums, paint), out) in sums.iter().zip(paint).zip(&mut *out) {
            for row in 0..GRAY_ROWS {
                let (paint, out) = (&paint[(rows + row) * LANES..][..LANES], &mut out[rows + row]);
                for i in 0..LANES {
                    let light = f32::from(paint[i]) * (1.0 / 65_535.0) * sums[row][i];
                    out[i] = if kept { out[i] + light } else { light };
                }
            }
        }
    }
}
