//! Light that was found at half the resolution, brought to a full one without bleeding over edges.
//!
//! What a surface sends on is its own reflectance times what arrives, and only that is smooth. So light is divided by a
//! guide (what the pixel shows under a white sky), filtered, and multiplied by the guide of the full resolution: art and
//! print stay as sharp as they are. A second guide tells one surface from another, and half-resolution pixels of another
//! surface count next to nothing: joint bilateral upsampling (J. Kopf, M. Cohen, D. Lischinski, M. Uyttendaele, 2007).
//! This module refuses to know where light, guide and mark come from.

use crate::Radiance;
use crate::irradiance::Light;
use crate::lanes::{LANES, Lanes, clones, max};
use crate::points::{Plane, TILE};

/// Half-resolution pixels along the side of what a tile needs: its own and one beyond on each side.
const SIDE: usize = TILE / 2 + 2;

/// The square of the difference of two marks that halves a pixel's weight.
const LIKENESS: f32 = 1.0 / 1024.0;

/// A plane of the half resolution around a tile, each row at the full resolution twice: the pixel that a full pixel is
/// in, and the next nearest beside it.
type Spread = [[Lanes; 2]; SIDE];

/// What one tile is brought to the full resolution from.
pub(crate) struct Neighbourhood {
    light: [Spread; 3],
    guide: [Spread; 3],
    mark: Spread,
}

/// Light, guide and mark of a picture at half the resolution.
#[derive(Clone, Copy)]
pub(crate) struct Halves<'a> {
    pub light: &'a Radiance,
    pub guide: &'a Radiance,
    /// Its first channel is the mark.
    pub marks: &'a Radiance,
}

impl Neighbourhood {
    /// Nothing yet.
    pub fn new() -> Neighbourhood {
        let dark = [[[0.0; LANES]; 2]; SIDE];
        Neighbourhood { light: [dark; 3], guide: [dark; 3], mark: dark }
    }

    /// Reads what the tile needs whose upper left pixel, at the full resolution, is (`x`, `y`).
    pub fn read(&mut self, halves: Halves, x: usize, y: usize) {
        for channel in 0..3 {
            spread(halves.light, channel, x, y, &mut self.light[channel]);
            spread(halves.guide, channel, x, y, &mut self.guide[channel]);
        }
        spread(halves.marks, 0, x, y, &mut self.mark);
    }
}

/// Reads one channel around a tile; beyond the picture's edge is what is at the edge.
fn spread(half: &Radiance, channel: usize, x: usize, y: usize, out: &mut Spread) {
    let (stride, first) = (half.stride(), x / 2);
    for (row, [near, far]) in out.iter_mut().enumerate() {
        let line = (y / 2 + row).saturating_sub(1).min(half.height() - 1);
        let line = &half.planes[channel][line * stride..][..stride];
        let mut cells = [line[stride - 1]; SIDE];
        cells[0] = line[first.saturating_sub(1)];
        match line[first..].first_chunk::<{ SIDE - 1 }>() {
            Some(whole) => cells[1..].copy_from_slice(whole),
            None => cells[1..][..stride - first].copy_from_slice(&line[first..]),
        }
        for i in 0..LANES {
            near[i] = cells[1 + i / 2];
            far[i] = cells[i / 2 + 2 * (i % 2)];
        }
    }
}

clones! {
    /// The light of a tile, whose guide and mark at the full resolution are given.
    pub(crate) fn upscale(from: &Neighbourhood, guide: &Light, mark: &Plane, out: &mut Light) = upscale_lanes;
}

#[inline(always)]
fn upscale_lanes(from: &Neighbourhood, guide: &Light, mark: &Plane, out: &mut Light) {
    for row in 0..TILE {
        let (near, far) = (1 + row / 2, row / 2 + 2 * (row % 2));
        let weights = weigh(&mark[row], &from.mark[near], &from.mark[far]);
        for channel in 0..3 {
            let (light, own) = (&from.light[channel], &from.guide[channel]);
            let light = sum(&weights, &light[near], &light[far]);
            let own = sum(&weights, &own[near], &own[far]);
            for i in 0..LANES {
                out[channel][row][i] = guide[channel][row][i] * (light[i] / max(own[i], 1e-30));
            }
        }
    }
}

/// The weights of the four nearest half-resolution pixels: bilinear, over how far their marks are from the pixel's own.
///
/// All four are multiplied by the four distances, which saves the divisions: only their proportions count.
#[inline(always)]
fn weigh(mark: &Lanes, near: &[Lanes; 2], far: &[Lanes; 2]) -> [Lanes; 4] {
    let mut weights = [[0.0; LANES]; 4];
    for i in 0..LANES {
        let unlike = |other: f32| LIKENESS + (mark[i] - other) * (mark[i] - other);
        let (a, b) = (unlike(near[0][i]), unlike(near[1][i]));
        let (c, d) = (unlike(far[0][i]), unlike(far[1][i]));
        let (ab, cd) = (a * b, c * d);
        weights[0][i] = 9.0 * (b * cd);
        weights[1][i] = 3.0 * (a * cd);
        weights[2][i] = 3.0 * (d * ab);
        weights[3][i] = c * ab;
    }
    weights
}

#[inline(always)]
fn sum(weights: &[Lanes; 4], near: &[Lanes; 2], far: &[Lanes; 2]) -> Lanes {
    let mut out = [0.0; LANES];
    for i in 0..LANES {
        out[i] = (weights[0][i] * near[0][i] + weights[1][i] * near[1][i])
            + (weights[2][i] * far[0][i] + weights[3][i] * far[1][i]);
    }
    out
}
