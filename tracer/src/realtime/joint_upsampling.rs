//! Joint upsampling: light that was found at half the resolution, brought to the full one without bleeding over edges.
//!
//! What a surface sends on is its own reflectance times what arrives, and only that is smooth. So light is divided by a
//! guide (what the pixel shows under a white sky), filtered, and multiplied by the guide of the full resolution: art and
//! print stay as sharp as they are. A second guide tells one surface from another, and half-resolution pixels of another
//! surface count next to nothing: joint bilateral upsampling (J. Kopf, M. Cohen, D. Lischinski, M. Uyttendaele, 2007).
//!
//! All but the light stands still where nothing moves, so a tile keeps the weights of each pixel's four neighbours and
//! the guides' quotient ([`UpsampleKernel`]). This module refuses to know where light, guide and ids come from.

use crate::Radiance;
use crate::simd::dispatch::{LANES, Lanes, SimdLevel, max, min, multiversion, round_to_u16};
use crate::tile::planes::{AREA, Plane, RgbTile, TILE};

/// Half-resolution pixels along the side of what a tile needs: its own and one beyond on each side.
const HALF_TILE_SIDE: usize = TILE / 2 + 2;

/// The square of the difference of two surface ids that halves a pixel's weight.
const LIKENESS: f32 = 1.0 / 1024.0;

/// Half of the lanes. In this module the pixels of a row are sorted, the even ones first: so their neighbours lie side by
/// side, as they lie in memory.
const HALF: usize = LANES / 2;

/// The largest weight that is kept.
const MAX_WEIGHT: f32 = 255.0;

/// Quotients are kept as square roots, in these parts of 1: up to 64, beyond which a pixel would be a few times as bright
/// as paper that nobody prints on, to a four-thousandth of 1.
const QUOTIENT_STEPS: f32 = 8192.0;

/// A plane of the half resolution around a tile, for each of its rows and each (sorted) pixel across: the half-resolution
/// pixel that it is in, and the next nearest beside it.
type Spread = [[Lanes; 2]; HALF_TILE_SIDE];

/// Nothing around a tile.
const BLACK_SPREAD: Spread = [[[0.0; LANES]; 2]; HALF_TILE_SIDE];

/// What turns the light around a tile into the tile's own.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct UpsampleKernel {
    /// How much the four nearest half-resolution pixels count, for each (sorted) pixel: the largest 255.
    weights: [[u8; AREA]; 4],
    /// The guide over the weighted sum of the guides around it, red, green and blue, times [`MAX_WEIGHT`].
    quotients: [[u16; AREA]; 3],
}

/// Guide image and surface ids of a picture at half the resolution, and at the full one; an id is the first channel.
#[derive(Clone, Copy)]
pub(crate) struct Guides<'a> {
    pub half_guide: &'a Radiance,
    pub half_surface_ids: &'a Radiance,
    pub guide: &'a Radiance,
    pub surface_ids: &'a Radiance,
}

impl UpsampleKernel {
    /// Nothing.
    pub fn none() -> UpsampleKernel {
        UpsampleKernel { weights: [[0; AREA]; 4], quotients: [[0; AREA]; 3] }
    }

    /// Becomes that of the tile whose upper left pixel, at the full resolution, is (`x`, `y`).
    pub fn take(&mut self, simd: SimdLevel, guides: Guides, x: usize, y: usize) {
        let (mut around, mut plane) = (BLACK_SPREAD, [[0.0; LANES]; TILE]);
        read(guides.half_surface_ids, 0, x, y, &mut around);
        guides.surface_ids.read_plane(0, x, y, &mut plane);
        weigh(simd, &plane, &around, &mut self.weights);
        for channel in 0..3 {
            read(guides.half_guide, channel, x, y, &mut around);
            guides.guide.read_plane(channel, x, y, &mut plane);
            divide(simd, &self.weights, &around, &plane, &mut self.quotients[channel]);
        }
    }

    /// The tile in this light, found at half the resolution; its upper left pixel is (`x`, `y`).
    pub fn apply(&self, simd: SimdLevel, light: &Radiance, x: usize, y: usize, out: &mut RgbTile) {
        let mut around = BLACK_SPREAD;
        for channel in 0..3 {
            read(light, channel, x, y, &mut around);
            multiply(simd, &self.weights, &around, &self.quotients[channel], &mut out[channel]);
        }
    }
}

/// Reads one channel around a tile; beyond the picture's edge is what is at the edge.
fn read(half: &Radiance, channel: usize, x: usize, y: usize, out: &mut Spread) {
    let (stride, first) = (half.stride(), x / 2);
    for (row, [near, far]) in out.iter_mut().enumerate() {
        let line = (y / 2 + row).saturating_sub(1).min(half.height() - 1);
        let line = &half.planes[channel][line * stride..][..stride];
        let mut edge = [0.0; HALF_TILE_SIDE];
        let inside = first.checked_sub(1).and_then(|before| line[before..].first_chunk());
        let cells: &[f32; HALF_TILE_SIDE] = inside.unwrap_or_else(|| {
            for (at, cell) in edge.iter_mut().enumerate() {
                *cell = line[(first + at).saturating_sub(1).min(stride - 1)];
            }
            &edge
        });
        near[..HALF].copy_from_slice(&cells[1..=HALF]);
        near[HALF..].copy_from_slice(&cells[1..=HALF]);
        far[..HALF].copy_from_slice(&cells[..HALF]);
        far[HALF..].copy_from_slice(&cells[2..HALF + 2]);
    }
}

multiversion! {
    /// Weighs the four nearest half-resolution pixels: bilinear, over how far their ids are from the pixel's own.
    fn weigh(surface_id: &Plane, surface_ids: &Spread, weights: &mut [[u8; AREA]; 4]) = weigh_lanes;
}
multiversion! {
    /// Divides the guide by the weighted sum of those around it.
    fn divide(
        weights: &[[u8; AREA]; 4], around: &Spread, guide: &Plane, quotients: &mut [u16; AREA],
    ) = divide_lanes;
}
multiversion! {
    /// Multiplies the weighted sum of the light around each pixel.
    fn multiply(
        weights: &[[u8; AREA]; 4], around: &Spread, quotients: &[u16; AREA], out: &mut Plane,
    ) = multiply_lanes;
}

/// The row of half-resolution pixels that a row of a tile is in, and the next nearest.
#[inline(always)]
fn nearest(row: usize) -> (usize, usize) {
    (1 + row / 2, row / 2 + 2 * (row % 2))
}

/// The pixels of a row, sorted.
#[inline(always)]
fn sorted(line: &Lanes) -> Lanes {
    let mut out = [0.0; LANES];
    for i in 0..HALF {
        out[i] = line[2 * i];
        out[HALF + i] = line[2 * i + 1];
    }
    out
}

/// All four weights are multiplied by all four distances, which saves divisions: only their proportions count.
#[inline(always)]
fn weigh_lanes(surface_id: &Plane, surface_ids: &Spread, weights: &mut [[u8; AREA]; 4]) {
    for row in 0..TILE {
        let (near, far) = nearest(row);
        let surface_id = sorted(&surface_id[row]);
        let ([a, b], [c, d]) = (&surface_ids[near], &surface_ids[far]);
        for i in 0..LANES {
            let (da, db, dc, dd) =
                (surface_id[i] - a[i], surface_id[i] - b[i], surface_id[i] - c[i], surface_id[i] - d[i]);
            let (qa, qb) = (LIKENESS + da * da, LIKENESS + db * db);
            let (qc, qd) = (LIKENESS + dc * dc, LIKENESS + dd * dd);
            let (ab, cd) = (qa * qb, qc * qd);
            let (wa, wb, wc, wd) = (9.0 * (qb * cd), 3.0 * (qa * cd), 3.0 * (qd * ab), qc * ab);
            let scale = MAX_WEIGHT / max(max(wa, wb), max(wc, wd));
            let at = row * LANES + i;
            weights[0][at] = round_to_u16(wa * scale) as u8;
            weights[1][at] = round_to_u16(wb * scale) as u8;
            weights[2][at] = round_to_u16(wc * scale) as u8;
            weights[3][at] = round_to_u16(wd * scale) as u8;
        }
    }
}

/// What is around the pixels of a row, each neighbour as often as it counts.
#[inline(always)]
fn sum(row: usize, weights: &[[u8; AREA]; 4], around: &Spread) -> Lanes {
    let (near, far) = nearest(row);
    let ([a, b], [c, d]) = (&around[near], &around[far]);
    let weights = |neighbour: usize| &weights[neighbour][row * LANES..][..LANES];
    let (wa, wb, wc, wd) = (weights(0), weights(1), weights(2), weights(3));
    let mut out = [0.0; LANES];
    for i in 0..LANES {
        out[i] =
            (f32::from(wa[i]) * a[i] + f32::from(wb[i]) * b[i]) + (f32::from(wc[i]) * c[i] + f32::from(wd[i]) * d[i]);
    }
    out
}

#[inline(always)]
fn divide_lanes(weights: &[[u8; AREA]; 4], around: &Spread, guide: &Plane, quotients: &mut [u16; AREA]) {
    for row in 0..TILE {
        let (guide, sum) = (sorted(&guide[row]), sum(row, weights, around));
        let out = &mut quotients[row * LANES..][..LANES];
        for i in 0..LANES {
            let quotient = MAX_WEIGHT * max(guide[i], 0.0) / max(sum[i], 1e-20);
            out[i] = round_to_u16(min(quotient.sqrt() * QUOTIENT_STEPS, 65_535.0));
        }
    }
}

#[inline(always)]
fn multiply_lanes(weights: &[[u8; AREA]; 4], around: &Spread, quotients: &[u16; AREA], out: &mut Plane) {
    const GAIN: f32 = 1.0 / (MAX_WEIGHT * QUOTIENT_STEPS * QUOTIENT_STEPS);
    for row in 0..TILE {
        let sum = sum(row, weights, around);
        let kept = &quotients[row * LANES..][..LANES];
        let mut lit = [0.0; LANES];
        for i in 0..LANES {
            let root = f32::from(kept[i]);
            lit[i] = sum[i] * (root * root * GAIN);
        }
        for i in 0..HALF {
            out[row][2 * i] = lit[i];
            out[row][2 * i + 1] = lit[HALF + i];
        }
    }
}
