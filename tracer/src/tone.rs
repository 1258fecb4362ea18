//! From light to the pixels of a screen.
//!
//! Exposure, glare, a filmic curve that keeps the hue, the sRGB transfer curve, and blue noise before the rounding. The
//! curve looks at the strongest channel and scales all three alike, so that a red lamp stays red however bright; only
//! far beyond white does it pale.

use crate::glare::{Level, Pyramid, STEP};
use crate::irradiance::{DARKNESS, Light};
use crate::lanes::{LANES, Lanes, Path, clamp, clones, max};
use crate::points::TILE;
use crate::{Frame, Radiance, dither};
use rayon::prelude::*;

/// How much of the light the eye scatters.
const GLARE: f32 = 0.09;

/// Cells of glare that a tile's pixels lie between, along a side.
const CELLS: usize = TILE / STEP + 2;

/// The pixels of a tile.
pub(crate) type Pixels = [[u32; LANES]; TILE];

/// Turns light into pixels; `exposure` is the factor by which the light is multiplied first, 1 is plain.
///
/// The frame takes the size of the picture.
pub fn map(radiance: &Radiance, exposure: f32, frame: &mut Frame) {
    map_on(Path::best(), radiance, exposure, frame);
}

/// [`map`] on a chosen instruction set: the same bits on each.
pub fn map_on(path: Path, radiance: &Radiance, exposure: f32, frame: &mut Frame) {
    let (width, height) = (radiance.width(), radiance.height());
    (frame.width, frame.height) = (width, height);
    frame.pixels.resize(width * height, 0);
    if width == 0 || height == 0 {
        return;
    }
    frame.pixels.par_chunks_mut(width * TILE).enumerate().for_each(|(band, pixels)| {
        let mut light = DARKNESS;
        let mut tile = [[0; LANES]; TILE];
        for x in (0..width).step_by(TILE) {
            radiance.read_tile(x, band * TILE, &mut light);
            develop(path, &light, &radiance.glare, exposure, [x, band * TILE], &mut tile);
            put(&tile, x, width, pixels);
        }
    });
}

/// Copies a developed tile into rows of pixels `width` wide, as far as they reach.
pub(crate) fn put(tile: &Pixels, x: usize, width: usize, pixels: &mut [u32]) {
    for (row, line) in pixels.chunks_mut(width).zip(tile) {
        let count = LANES.min(width - x);
        row[x..x + count].copy_from_slice(&line[..count]);
    }
}

/// Develops the tile whose upper left pixel is `corner`.
pub(crate) fn develop(
    path: Path,
    light: &Light,
    glare: &Pyramid,
    exposure: f32,
    corner: [usize; 2],
    pixels: &mut Pixels,
) {
    if let Some((level, planes)) = glare.finest() {
        develop_tile(path, light, level, planes, exposure, corner, pixels);
    }
}

clones! {
    fn develop_tile(
        light: &Light, level: &Level, glare: [&[f32]; 3], exposure: f32, corner: [usize; 2], pixels: &mut Pixels,
    ) = develop_lanes;
}

#[inline(always)]
fn develop_lanes(
    light: &Light,
    level: &Level,
    glare: [&[f32]; 3],
    exposure: f32,
    [x, y]: [usize; 2],
    pixels: &mut Pixels,
) {
    let noise = dither::thresholds();
    let mut stretched = [[[0.0; LANES]; CELLS]; 3];
    for (plane, stretched) in glare.into_iter().zip(&mut stretched) {
        for (row, stretched) in stretched.iter_mut().enumerate() {
            let row = (y / STEP + row).min(level.height + 1) * level.stride;
            stretch(&plane[row..row + level.width + 2], x / STEP, stretched);
        }
    }
    for row in 0..TILE {
        // Half a cell down from the border's middle: between which cells, and how far.
        let (near, part) = ((row + 2) / STEP, ((row + 2) % STEP) as f32 * 0.25 + 0.125);
        let mut levels: [Lanes; 3] = [[0.0; LANES]; 3];
        for channel in 0..3 {
            let (light, above, below) =
                (&light[channel][row], &stretched[channel][near], &stretched[channel][near + 1]);
            for i in 0..LANES {
                let glare = above[i] + (below[i] - above[i]) * part;
                levels[channel][i] = exposure * (light[i] + (glare - light[i]) * GLARE);
            }
        }
        let [red, green, blue] = &mut levels;
        for i in 0..LANES {
            let [r, g, b] = film([red[i], green[i], blue[i]]);
            (red[i], green[i], blue[i]) = (srgb(r), srgb(g), srgb(b));
        }
        let mut packed = [0u32; LANES];
        for (channel, level) in levels.iter().enumerate() {
            let line = (y + row + 21 * channel) % dither::SIZE * dither::SIZE;
            let column = (x + LANES * channel) % dither::SIZE;
            let noise = &noise[line + column..line + column + LANES];
            for i in 0..LANES {
                packed[i] = packed[i] << 8 | rounded(level[i] * 255.0 + noise[i]);
            }
        }
        pixels[row] = packed;
    }
}

/// A row of cells, from the one before `cell` on, at the picture's resolution.
#[inline(always)]
fn stretch(row: &[f32], cell: usize, out: &mut Lanes) {
    let last = row.len() - 1;
    let mut cells = [0.0; CELLS];
    for (at, value) in cells.iter_mut().enumerate() {
        *value = row[(cell + at).min(last)];
    }
    for at in 0..TILE / STEP {
        let [left, here, right] = [cells[at], cells[at + 1], cells[at + 2]];
        out[at * STEP] = 0.375 * left + 0.625 * here;
        out[at * STEP + 1] = 0.125 * left + 0.875 * here;
        out[at * STEP + 2] = 0.875 * here + 0.125 * right;
        out[at * STEP + 3] = 0.625 * here + 0.375 * right;
    }
}

/// The nearest whole number, for a value that is brought into 0 to 255: 2^23 leaves no room for a fraction.
#[inline(always)]
fn rounded(value: f32) -> u32 {
    (clamp(value, 0.0, 255.0) + 8_388_608.0).to_bits() & 0xff
}

/// Light, unbounded, to light on a screen, 0 to 1: a toe, a straight middle and a long shoulder.
///
/// The curve is K. Narkowicz's fit of the ACES reference transform (2016), on the strongest channel.
#[inline(always)]
fn film([r, g, b]: [f32; 3]) -> [f32; 3] {
    let strongest = max(max(r, g), max(b, 1e-5));
    let m = strongest * 0.72;
    let (above, below) = (m * (2.51 * m + 0.03), m * (2.43 * m + 0.59) + 0.14);
    let white = m + 14.0;
    // One division for three: over the curve, over the strongest and over where light pales.
    let over = 1.0 / (below * white * strongest);
    let scale = above * white * over;
    let curve = scale * strongest;
    let pale = 0.7 * m * (below * strongest * over);
    let bleach = |c: f32| {
        let kept = c * scale;
        kept + (curve - kept) * pale
    };
    [bleach(r), bleach(g), bleach(b)]
}

/// The sRGB transfer curve, to a ninth of an 8-bit level: a polynomial in the square root.
#[inline(always)]
pub(crate) fn srgb(linear: f32) -> f32 {
    let s = max(linear, 0.0).sqrt();
    let curved = ((((-0.761_408 * s + 2.801_746) * s - 4.212_598) * s + 3.406_116) * s - 1.746_204) * s;
    let curved = (curved + 1.553_333) * s - 0.041_132;
    if linear <= 0.003_130_8 { 12.92 * linear } else { curved }
}
