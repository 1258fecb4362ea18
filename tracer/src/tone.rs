//! From light to the pixels of a screen.
//!
//! Exposure, glare, a filmic curve that keeps the hue, the sRGB transfer curve, and blue noise before the rounding. The
//! curve looks at the strongest channel and scales all three alike, so that a red lamp stays red however bright; only
//! far beyond white does it pale.

use crate::glare::{Level, STEP};
use crate::lanes::{LANES, Lanes, Path, clamp, clones, max};
use crate::{Frame, Radiance, dither};
use rayon::prelude::*;
use std::cell::RefCell;

/// How much of the light the eye scatters.
const GLARE: f32 = 0.09;

/// Rows that one task develops.
const ROWS: usize = 16;

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
    frame.pixels.par_chunks_mut(width * ROWS).enumerate().for_each(|(band, pixels)| {
        GLARE_ROW.with_borrow_mut(|glare| {
            for (row, pixels) in pixels.chunks_mut(width).enumerate() {
                develop_row(path, radiance, exposure, band * ROWS + row, glare, pixels);
            }
        });
    });
}

thread_local! {
    /// One row of glare at the picture's own resolution.
    static GLARE_ROW: RefCell<[Vec<f32>; 3]> = const { RefCell::new([Vec::new(), Vec::new(), Vec::new()]) };
}

fn develop_row(
    path: Path,
    radiance: &Radiance,
    exposure: f32,
    y: usize,
    glare: &mut [Vec<f32>; 3],
    pixels: &mut [u32],
) {
    let stride = radiance.stride();
    let room = stride + 2 * STEP;
    let Some((finest, planes)) = radiance.glare.finest() else { return };
    for (source, target) in planes.into_iter().zip(glare.iter_mut()) {
        target.resize(room, 0.0);
        stretch(path, source, finest, y, target);
    }
    let light = [0, 1, 2].map(|channel| &radiance.planes[channel][y * stride..(y + 1) * stride]);
    let glare = [0, 1, 2].map(|channel| &glare[channel][..stride]);
    develop(path, light, glare, exposure, y, pixels);
}

clones! {
    fn stretch(source: &[f32], level: &Level, y: usize, target: &mut [f32]) = stretch_row;
}

/// The row of the finest glare level that belongs to row `y` of the picture, stretched by [`STEP`].
#[inline(always)]
fn stretch_row(source: &[f32], level: &Level, y: usize, target: &mut [f32]) {
    let place = (y as f32 + 0.5) / STEP as f32 + 0.5;
    let part = place - place.floor();
    let near = place as usize;
    let near = &source[near * level.stride..][..level.width + 2];
    let far_at = (place as usize + 1).min(level.height + 1);
    let far = &source[far_at * level.stride..][..level.width + 2];
    let cells = target.chunks_exact_mut(STEP).zip(0..level.width);
    for (out, x) in cells {
        let blend = |at: usize| near[at] + (far[at] - near[at]) * part;
        let (left, here, right) = (blend(x), blend(x + 1), blend(x + 2));
        out[0] = 0.375 * left + 0.625 * here;
        out[1] = 0.125 * left + 0.875 * here;
        out[2] = 0.875 * here + 0.125 * right;
        out[3] = 0.625 * here + 0.375 * right;
    }
}

clones! {
    fn develop(light: [&[f32]; 3], glare: [&[f32]; 3], exposure: f32, y: usize, pixels: &mut [u32]) = develop_lanes;
}

#[inline(always)]
fn develop_lanes(light: [&[f32]; 3], glare: [&[f32]; 3], exposure: f32, y: usize, pixels: &mut [u32]) {
    let noise = dither::thresholds();
    for (block, out) in pixels.chunks_mut(LANES).enumerate() {
        let at = block * LANES;
        let mut levels: [Lanes; 3] = [[0.0; LANES]; 3];
        for channel in 0..3 {
            let (light, glare) = (&light[channel][at..at + LANES], &glare[channel][at..at + LANES]);
            for i in 0..LANES {
                levels[channel][i] = exposure * (light[i] + (glare[i] - light[i]) * GLARE);
            }
        }
        let [red, green, blue] = &mut levels;
        for i in 0..LANES {
            let [r, g, b] = film([red[i], green[i], blue[i]]);
            (red[i], green[i], blue[i]) = (srgb(r), srgb(g), srgb(b));
        }
        let mut packed = [0u32; LANES];
        for (channel, level) in levels.iter().enumerate() {
            let row = (y + 21 * channel) % dither::SIZE * dither::SIZE;
            let column = (at + LANES * channel) % dither::SIZE;
            let noise = &noise[row + column..row + column + LANES];
            for i in 0..LANES {
                packed[i] = packed[i] << 8 | rounded(level[i] * 255.0 + noise[i]);
            }
        }
        out.copy_from_slice(&packed[..out.len()]);
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
    let curve = clamp((m * (2.51 * m + 0.03)) / (m * (2.43 * m + 0.59) + 0.14), 0.0, 1.0);
    let scale = curve / strongest;
    let pale = 0.7 * m / (m + 14.0);
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
