//! Cell means: the means of a tile's cells, which is all that bloom, and a ball's mirror, need of a tile.
//!
//! They are kept beside every layer of a tile and sum up as the layers do, so the bloom of a frame is known before
//! the frame is put together.

use crate::cache::packed_planes::{PLANE_MAX, PackedPlanes, PlaneSlot};
use crate::cache::weighted_sum::MIN_LIGHT;
use crate::simd::dispatch::{LANES, Lanes, SimdLevel, max, min, multiversion, round_to_u16};
use crate::tile::planes::{RgbTile, RowMask, TILE};

/// Cells of [`CELL_PX`] x [`CELL_PX`] pixels in a tile.
pub(crate) const CELLS_PER_TILE: usize = (TILE / CELL_PX) * (TILE / CELL_PX);

/// Pixels along the side of a cell: what the bloom's finest level is made of.
pub(crate) const CELL_PX: usize = 4;

/// Cells in a row of a tile.
const CELLS_PER_ROW: usize = TILE / CELL_PX;

/// Three numbers for every cell of a tile, row by row.
pub(crate) type TileMeans = [[f32; CELLS_PER_TILE]; 3];

/// Sums of means in whole numbers.
pub(crate) type IntegerMeans = [[i32; CELLS_PER_TILE]; 3];

/// The means of a layer's cells, quantized as the layer itself.
#[derive(Clone, Debug, Default)]
pub(crate) struct CellMeans {
    /// The quantization step.
    pub step: f32,
    cells: [[u16; CELLS_PER_TILE]; 3],
}

impl CellMeans {
    /// Keeps means: finite, 0 or more.
    pub fn of(means: &TileMeans) -> CellMeans {
        let most = means.as_flattened().iter().fold(0.0, |a, &b| max(a, b));
        let mut quantized = CellMeans::default();
        quantized.keep_rows(means, if most < MIN_LIGHT { 0.0 } else { most * (1.0 / PLANE_MAX) }, !0);
        quantized
    }

    /// Keeps the means of those cells of a floor that have any of some rows: of its irradiance and of its
    /// specular plane, whose quantization steps are `scales`.
    pub fn keep_floor(
        &mut self,
        simd: SimdLevel,
        albedo: &RgbTile,
        planes: [(&PackedPlanes, PlaneSlot); 2],
        scales: [f32; 2],
        rows: RowMask,
    ) {
        let mut means = [[0.0; CELLS_PER_TILE]; 3];
        floor_means(simd, albedo, planes, scales, rows, &mut means);
        // No cell is brighter than white where all arrives.
        self.keep_rows(&means, scales[0] + scales[1], rows);
    }

    /// Keeps the means of those cells of radiance that have any of some rows.
    pub fn keep_rgb(
        &mut self,
        simd: SimdLevel,
        planes: &[PackedPlanes; 3],
        slot: PlaneSlot,
        scale: f32,
        rows: RowMask,
    ) {
        let mut means = [[0.0; CELLS_PER_TILE]; 3];
        rgb_means(simd, planes, slot, scale, rows, &mut means);
        self.keep_rows(&means, scale, rows);
    }

    fn keep_rows(&mut self, means: &TileMeans, scale: f32, rows: RowMask) {
        self.step = scale;
        let steps = if scale > 0.0 { 1.0 / scale } else { 0.0 };
        for (cells, means) in self.cells.iter_mut().zip(means) {
            for at in cells_of(rows).flat_map(|row| row * CELLS_PER_ROW..(row + 1) * CELLS_PER_ROW) {
                cells[at] = round_to_u16(min(means[at] * steps, PLANE_MAX));
            }
        }
    }

    /// Adds them, in light of a colour.
    pub fn add_light(&self, color: [f32; 3], means: &mut TileMeans) {
        for ((means, cells), color) in means.iter_mut().zip(&self.cells).zip(color) {
            let gain = self.step * color;
            means.iter_mut().zip(cells).for_each(|(mean, cell)| *mean += f32::from(*cell) * gain);
        }
    }
}

/// How many are summed up together.
const BATCH: usize = 8;

/// Adds cell means, each so many times, onto `sums`.
pub(crate) fn add_cell_means<'a>(
    simd: SimdLevel,
    mut cell_means: impl Iterator<Item = (&'a CellMeans, [u32; 3])>,
    sums: &mut IntegerMeans,
) {
    while let Some(first) = cell_means.next() {
        let mut batch = [first; BATCH];
        let mut count = 1;
        while let Some(next) = (count < BATCH).then(|| cell_means.next()).flatten() {
            batch[count] = next;
            count += 1;
        }
        sum_cell_means(simd, &batch[..count], sums);
    }
}

multiversion! {
    fn sum_cell_means(cell_means: &[(&CellMeans, [u32; 3])], sums: &mut IntegerMeans) = sum_cell_means_lanes;
}

#[inline(always)]
fn sum_cell_means_lanes(cell_means: &[(&CellMeans, [u32; 3])], [red, green, blue]: &mut IntegerMeans) {
    let (mut r, mut g, mut b) = (*red, *green, *blue);
    for (means, gains) in cell_means {
        add_channel(&means.cells[0], gains[0], &mut r);
        add_channel(&means.cells[1], gains[1], &mut g);
        add_channel(&means.cells[2], gains[2], &mut b);
    }
    (*red, *green, *blue) = (r, g, b);
}

#[inline(always)]
fn add_channel(cells: &[u16; CELLS_PER_TILE], gain: u32, sums: &mut [i32; CELLS_PER_TILE]) {
    for cell in 0..CELLS_PER_TILE {
        sums[cell] += i32::from(cells[cell]) * gain as i32;
    }
}

multiversion! {
    /// The means of the cells of a tile.
    pub(crate) fn means_of(light: &RgbTile, means: &mut TileMeans) = means_lanes;
}

#[inline(always)]
fn means_lanes(light: &RgbTile, means: &mut TileMeans) {
    for cells in 0..CELLS_PER_ROW {
        let rows = cells * CELL_PX..(cells + 1) * CELL_PX;
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

multiversion! {
    /// The means of those cells of a floor that have any of some rows: its reflectance times what arrives, and what
    /// shines on it.
    fn floor_means(
        albedo: &RgbTile, planes: [(&PackedPlanes, PlaneSlot); 2], scales: [f32; 2], rows: RowMask, means: &mut TileMeans,
    ) = floor_means_lanes;
}

#[inline(always)]
fn floor_means_lanes(
    albedo: &RgbTile,
    [irradiance_plane, specular_plane]: [(&PackedPlanes, PlaneSlot); 2],
    scales: [f32; 2],
    rows: RowMask,
    means: &mut TileMeans,
) {
    for cells in cells_of(rows) {
        let mut sums = [[0.0; LANES]; 3];
        for row in cells * CELL_PX..(cells + 1) * CELL_PX {
            let (irradiance, specular) =
                (irradiance_plane.0.row(irradiance_plane.1, row), specular_plane.0.row(specular_plane.1, row));
            for i in 0..LANES {
                let (irradiance, specular) = (irradiance[i] * scales[0], specular[i] * scales[1]);
                sums[0][i] += albedo[0][row][i] * irradiance + specular;
                sums[1][i] += albedo[1][row][i] * irradiance + specular;
                sums[2][i] += albedo[2][row][i] * irradiance + specular;
            }
        }
        put_means(cells, &sums, means);
    }
}

multiversion! {
    /// The means of those cells of colours that have any of some rows.
    fn rgb_means(planes: &[PackedPlanes; 3], slot: PlaneSlot, scale: f32, rows: RowMask, means: &mut TileMeans) = rgb_means_lanes;
}

#[inline(always)]
fn rgb_means_lanes(planes: &[PackedPlanes; 3], slot: PlaneSlot, scale: f32, rows: RowMask, means: &mut TileMeans) {
    for cells in cells_of(rows) {
        let mut sums = [[0.0; LANES]; 3];
        for (sums, plane) in sums.iter_mut().zip(planes) {
            for row in cells * CELL_PX..(cells + 1) * CELL_PX {
                let line = plane.row(slot, row);
                for i in 0..LANES {
                    sums[i] += line[i] * scale;
                }
            }
        }
        put_means(cells, &sums, means);
    }
}

/// The rows of cells that have any of some rows of pixels.
#[inline(always)]
fn cells_of(rows: RowMask) -> impl Iterator<Item = usize> {
    (0..CELLS_PER_ROW).filter(move |cells| rows >> (cells * CELL_PX) & ((1 << CELL_PX) - 1) != 0)
}

/// Writes the means of a row of cells, whose columns were summed up.
#[inline(always)]
fn put_means(row: usize, sums: &[Lanes; 3], means: &mut TileMeans) {
    for (sums, means) in sums.iter().zip(means) {
        for (at, mean) in means[row * CELLS_PER_ROW..][..CELLS_PER_ROW].iter_mut().enumerate() {
            let [a, b, c, d] =
                [sums[at * CELL_PX], sums[at * CELL_PX + 1], sums[at * CELL_PX + 2], sums[at * CELL_PX + 3]];
            *mean = ((a + b) + (c + d)) * (1.0 / (CELL_PX * CELL_PX) as f32);
        }
    }
}
