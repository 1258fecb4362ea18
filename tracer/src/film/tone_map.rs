//! The tone map: from linear radiance to the pixels of a screen.
//!
//! 1. Exposure and bloom: `exposure ((1 - b) light + b bloom)`, where b is `BLOOM_STRENGTH`.
//! 2. A filmic curve that keeps the hue (`filmic_curve`).
//! 3. The sRGB transfer curve ([`crate::film::srgb`]).
//! 4. Dithering: blue noise of one level's width before the rounding, so that dark gradients have no bands.

use crate::film::bloom::{BloomPyramid, CELL_PX, MipLevel, READ_AHEAD_CELLS};
use crate::film::blue_noise;
use crate::film::srgb::encode_fast;
use crate::simd::dispatch::{LANES, Lanes, SimdLevel, clamp, max, multiversion};
use crate::tile::planes::{BLACK, RgbTile, TILE};
use crate::{Frame, Radiance};
use rayon::prelude::*;

/// The part of the light that goes into bloom: art direction.
const BLOOM_STRENGTH: f32 = 0.09;

/// Cells of bloom that a tile's pixels lie between, along a side.
const BLOOM_CELLS: usize = TILE / CELL_PX + 2;

/// The pixels of a tile.
pub(crate) type Pixels = [[u32; LANES]; TILE];

/// Turns light into pixels; `exposure` is the factor by which the light is multiplied first, 1 is plain.
///
/// The frame takes the size of the picture.
pub fn map(radiance: &Radiance, exposure: f32, frame: &mut Frame) {
    map_on(SimdLevel::best(), radiance, exposure, frame);
}

/// [`map`] on a chosen instruction set: the same bits on each.
pub fn map_on(simd: SimdLevel, radiance: &Radiance, exposure: f32, frame: &mut Frame) {
    let (width, height) = (radiance.width(), radiance.height());
    (frame.width, frame.height) = (width, height);
    frame.pixels.resize(width * height, 0);
    if width == 0 || height == 0 {
        return;
    }
    frame.pixels.par_chunks_mut(width * TILE).enumerate().for_each(|(band, pixels)| {
        let mut light = BLACK;
        let mut tile = [[0; LANES]; TILE];
        for x in (0..width).step_by(TILE) {
            radiance.read_tile(x, band * TILE, &mut light);
            tone_map_tile(simd, &light, &radiance.bloom, exposure, [x, band * TILE], &mut tile);
            store_tile(&tile, x, width, pixels);
        }
    });
}

/// The same curve, transfer and dithering for light that is no table's: a picture `width` pixels wide, row by row, without bloom.
pub fn map_pixels(light: &[[f32; 3]], width: usize, exposure: f32) -> Frame {
    let noise = blue_noise::thresholds();
    let pixel = |(at, light): (usize, &[f32; 3])| {
        let (x, y) = (at % width, at / width);
        let screen = filmic_curve(light.map(|channel| channel * exposure));
        let byte = |channel: usize| {
            let line = (y + 21 * channel) % blue_noise::MATRIX_SIDE * blue_noise::MATRIX_SIDE;
            let noise = noise[line + (x + LANES * channel) % blue_noise::MATRIX_SIDE];
            round_to_byte(encode_fast(screen[channel]) * 255.0 + noise)
        };
        byte(0) << 16 | byte(1) << 8 | byte(2)
    };
    let pixels = light.par_iter().enumerate().map(pixel).collect();
    Frame { width, height: light.len() / width.max(1), pixels }
}

/// The same curve and transfer for one light, without dithering: what a screen is told, 0 to 1.
pub fn displayed(light: [f32; 3]) -> [f32; 3] {
    filmic_curve(light).map(encode_fast)
}

/// Copies a tone-mapped tile into rows of pixels `width` wide, as far as they reach.
pub(crate) fn store_tile(tile: &Pixels, x: usize, width: usize, pixels: &mut [u32]) {
    for (row, line) in pixels.chunks_exact_mut(width).zip(tile) {
        let row = &mut row[x..];
        match row.first_chunk_mut() {
            Some(whole) => *whole = *line,
            None => row.copy_from_slice(&line[..row.len()]),
        }
    }
}

/// Tone-maps the tile whose upper left pixel is `corner`.
pub(crate) fn tone_map_tile(
    simd: SimdLevel,
    light: &RgbTile,
    bloom: &BloomPyramid,
    exposure: f32,
    corner: [usize; 2],
    pixels: &mut Pixels,
) {
    if let Some((level, planes)) = bloom.finest() {
        tone_map_dispatch(simd, light, level, planes, exposure, corner, pixels);
    }
}

multiversion! {
    fn tone_map_dispatch(
        light: &RgbTile, level: &MipLevel, bloom: [&[f32]; 3], exposure: f32, corner: [usize; 2], pixels: &mut Pixels,
    ) = tone_map_lanes;
}

#[inline(always)]
fn tone_map_lanes(
    light: &RgbTile,
    level: &MipLevel,
    bloom: [&[f32]; 3],
    exposure: f32,
    [x, y]: [usize; 2],
    pixels: &mut Pixels,
) {
    let noise = blue_noise::thresholds();
    let mut stretched = [[[0.0; LANES]; BLOOM_CELLS]; 3];
    for (plane, stretched) in bloom.into_iter().zip(&mut stretched) {
        for (row, stretched) in stretched.iter_mut().enumerate() {
            let row = (y / CELL_PX + row).min(level.height + 1) * level.stride;
            let mut cells = [0.0; READ_AHEAD_CELLS];
            cells.copy_from_slice(&plane[row + x / CELL_PX..][..READ_AHEAD_CELLS]);
            stretch(&cells, exposure * BLOOM_STRENGTH, stretched);
        }
    }
    for row in 0..TILE {
        // Half a cell down from the border's middle: between which cells, and how far.
        let (near, part) = ((row + 2) / CELL_PX, CELL_FRACTIONS[row]);
        // Channel by channel and not in a loop, which the compiler would turn round and gather from memory.
        let gain = exposure * (1.0 - BLOOM_STRENGTH);
        let mut red = expose(&light[0][row], &stretched[0], near, part, gain);
        let mut green = expose(&light[1][row], &stretched[1], near, part, gain);
        let mut blue = expose(&light[2][row], &stretched[2], near, part, gain);
        for i in 0..LANES {
            let [r, g, b] = filmic_curve([red[i], green[i], blue[i]]);
            (red[i], green[i], blue[i]) = (encode_fast(r), encode_fast(g), encode_fast(b));
        }
        let noise = |channel: usize| {
            let line = (y + row + 21 * channel) % blue_noise::MATRIX_SIDE * blue_noise::MATRIX_SIDE;
            &noise[line + (x + LANES * channel) % blue_noise::MATRIX_SIDE..][..LANES]
        };
        let (red_noise, green_noise, blue_noise) = (noise(0), noise(1), noise(2));
        let mut packed = [0u32; LANES];
        for i in 0..LANES {
            packed[i] = round_to_byte(red[i] * 255.0 + red_noise[i]) << 16
                | round_to_byte(green[i] * 255.0 + green_noise[i]) << 8
                | round_to_byte(blue[i] * 255.0 + blue_noise[i]);
        }
        pixels[row] = packed;
    }
}

/// A row of light, times `gain`, and the bloom, which lies `part` of the way from the row of cells `near` to the next.
#[inline(always)]
fn expose(light: &Lanes, bloom: &[Lanes; BLOOM_CELLS], near: usize, part: f32, gain: f32) -> Lanes {
    let (above, below) = (&bloom[near], &bloom[near + 1]);
    let mut out = [0.0; LANES];
    for i in 0..LANES {
        out[i] = light[i] * gain + (above[i] + (below[i] - above[i]) * part);
    }
    out
}

/// A row of cells, of which the first is left of the tile, at the picture's resolution, times `gain`.
#[inline(always)]
fn stretch(cells: &[f32; READ_AHEAD_CELLS], gain: f32, out: &mut Lanes) {
    let (mut near, mut far) = ([0.0; LANES], [0.0; LANES]);
    for i in 0..LANES {
        (near[i], far[i]) = (cells[(i + 2) / CELL_PX], cells[(i + 2) / CELL_PX + 1]);
    }
    for i in 0..LANES {
        out[i] = gain * (near[i] + (far[i] - near[i]) * CELL_FRACTIONS[i]);
    }
}

/// How far each pixel of a row is from the middle of one cell to that of the next.
const CELL_FRACTIONS: Lanes = {
    let mut parts = [0.0; LANES];
    let mut i = 0;
    while i < LANES {
        parts[i] = ((i + 2) % CELL_PX) as f32 * 0.25 + 0.125;
        i += 1;
    }
    parts
};

/// The nearest whole number, for a value that is brought into 0 to 255: 2^23 leaves no room for a fraction.
#[inline(always)]
fn round_to_byte(value: f32) -> u32 {
    (clamp(value, 0.0, 255.0) + 8_388_608.0).to_bits() & 0xff
}

/// Scales light before the filmic curve: art direction, a little brighter than the 0.6 with which Narkowicz matches
/// ACES.
const FILMIC_GAIN: f32 = 0.72;

/// K. Narkowicz, "ACES filmic tone mapping curve", 2016: x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), a fit of the
/// ACES reference transform.
const ACES: [f32; 5] = [2.51, 0.03, 2.43, 0.59, 0.14];

/// Scaled light at which half of the bleaching is reached: art direction.
const BLEACH_HALF: f32 = 14.0;

/// The part of its saturation that an infinitely bright colour loses: art direction.
const BLEACH_MOST: f32 = 0.7;

/// Less light than this in the strongest channel is as dark: keeps the division finite.
const DARKEST: f32 = 1e-5;

/// The filmic curve: unbounded light to light on a screen, 0 to 1, with a toe, a straight middle and a long shoulder.
///
/// 1. The curve is taken of the strongest channel alone, and all channels are scaled alike: hue and saturation stay, so
///    a red lamp stays red however bright it is.
/// 2. Beyond white, colours bleach, as film's do: with m the scaled light, a part `BLEACH_MOST m / (m + BLEACH_HALF)`
///    of the colour is replaced by grey of the curve's value.
#[inline(always)]
fn filmic_curve([r, g, b]: [f32; 3]) -> [f32; 3] {
    let strongest = max(max(r, g), max(b, DARKEST));
    let m = strongest * FILMIC_GAIN;
    let [a1, a0, b2, b1, b0] = ACES;
    let (above, below) = (m * (a1 * m + a0), m * (b2 * m + b1) + b0);
    let white = m + BLEACH_HALF;
    // One division for three: that of the curve, that by the strongest channel and that of the bleaching.
    let over = 1.0 / (below * white * strongest);
    let scale = above * white * over;
    let curve = scale * strongest;
    let pale = BLEACH_MOST * m * (below * strongest * over);
    let (kept, bleached) = (scale - scale * pale, curve * pale);
    [r * kept + bleached, g * kept + bleached, b * kept + bleached]
}
