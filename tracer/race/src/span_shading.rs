//! A span of pixels that the same lamps reach, shaded and written.
//!
//! There is one loop for each set of lamps (a const generic), without a branch in it; a hidden lamp costs nothing. The
//! two lamps of a wall share a fraction, a/p + b/q = (a q + b p) / (p q), and the upper and the lower pair share the
//! division, so that a pixel needs only one, for four lamps as for one. Red, green and blue stay in registers until
//! they are a pixel.

use crate::column_terms::ColumnTerms;
use crate::scene::{SIDE_F32, color};
use tracer::Rgb;
use tracer::simd::dispatch::LANES;

/// 2^23: a single-precision number of this size has no fraction, so adding it rounds to a whole number.
pub(crate) const ROUNDING: f32 = 8_388_608.0;

/// The terms of the light that depend on the row alone, for the upper and the lower pair of lamps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowTerms {
    /// One and the square of the distance to the pair's wall.
    wall_square: [f32; 2],
    /// That times both lamps' colours.
    both: [[f32; 3]; 2],
}

impl RowTerms {
    #[inline(always)]
    pub fn new(y: f32) -> RowTerms {
        let wall_square = [1.0 + y * y, 1.0 + (SIDE_F32 - y) * (SIDE_F32 - y)];
        let mut both = [[0.0; 3]; 2];
        for pair in 0..2 {
            for channel in 0..3 {
                both[pair][channel] = (color(pair * 2, channel) + color(pair * 2 + 1, channel)) * wall_square[pair];
            }
        }
        RowTerms { wall_square, both }
    }
}

/// Lights the pixels from `start` to `end` of the row that `pixels` begins with, by the lamps whose bits `lit` has.
///
/// Pixels past `end` may be written too, as far as `pixels` goes: rows and runs are lit in order.
#[inline(always)]
pub(crate) fn shade_span(
    lit: usize,
    row: &RowTerms,
    blocks: &[ColumnTerms],
    start: usize,
    end: usize,
    pixels: &mut [u32],
) {
    if start >= end {
        return;
    }
    macro_rules! by {
        ($($set:literal)*) => {
            match lit {
                $($set => shade_blocks::<$set>(row, blocks, start, end, pixels),)*
                _ => pixels[start..end].fill(0),
            }
        };
    }
    by!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
}

/// Lights whole blocks, and puts back what was in the first of them before `start`.
#[inline(always)]
fn shade_blocks<const LIT: usize>(
    row: &RowTerms,
    blocks: &[ColumnTerms],
    start: usize,
    end: usize,
    pixels: &mut [u32],
) {
    let (first, kept) = (start / LANES, start % LANES);
    let blocks = &blocks[first..end.div_ceil(LANES)];
    let (whole, rest) = pixels[first * LANES..].as_chunks_mut::<LANES>();
    let before = whole.first().copied().unwrap_or_default();
    let mut last = [0; LANES];
    for (number, block) in blocks.iter().enumerate() {
        *whole.get_mut(number).unwrap_or(&mut last) = shade_block::<LIT>(row, block);
    }
    if let Some(chunk) = whole.first_mut() {
        for i in 0..LANES {
            chunk[i] = if i < kept { before[i] } else { chunk[i] };
        }
    }
    if blocks.len() > whole.len() {
        let kept = if whole.is_empty() { kept } else { 0 };
        let count = rest.len();
        rest[kept..].copy_from_slice(&last[kept..count]);
    }
}

/// A block of pixels, lit by the lamps of `LIT`.
#[inline(always)]
fn shade_block<const LIT: usize>(row: &RowTerms, block: &ColumnTerms) -> [u32; LANES] {
    let mut pixels = [0; LANES];
    for i in 0..LANES {
        // A pair's light is its colors over its below.
        let mut below = [1.0; 2];
        let mut colors = [[0.0; 3]; 2];
        for pair in 0..2 {
            let (p, q) = (row.wall_square[pair] + block.left_square[i], row.wall_square[pair] + block.right_square[i]);
            below[pair] = [1.0, p, q, p * q][LIT >> (pair * 2) & 3];
            for channel in 0..3 {
                let both = row.both[pair][channel] + block.crossed[pair][channel][i];
                let (left, right) = (color(pair * 2, channel), color(pair * 2 + 1, channel));
                colors[pair][channel] = [0.0, left, right, both][LIT >> (pair * 2) & 3];
            }
        }
        let [upper, lower] = colors;
        let level = match (LIT & 3, LIT >> 2) {
            (_, 0) => scale(upper, 1.0 / below[0]),
            (0, _) => scale(lower, 1.0 / below[1]),
            _ => {
                let inverse = 1.0 / (below[0] * below[1]);
                add(scale(upper, inverse * below[1]), scale(lower, inverse * below[0]))
            }
        };
        pixels[i] = pack(level[0], level[1], level[2]);
    }
    pixels
}

#[inline(always)]
fn scale(color: Rgb, by: f32) -> Rgb {
    [color[0] * by, color[1] * by, color[2] * by]
}

#[inline(always)]
fn add(a: Rgb, b: Rgb) -> Rgb {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Levels as a pixel. They need no clamp: no point is lit beyond 255 (a test below).
///
/// After [`ROUNDING`] the byte is in the lowest bits; what is left of 2^23 is shifted out of red and green.
#[inline(always)]
pub(crate) fn pack(red: f32, green: f32, blue: f32) -> u32 {
    let bits = |level: f32| (level + ROUNDING).to_bits();
    bits(red) << 16 | bits(green) << 8 | bits(blue) & 0xff
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::corner;

    /// The brightest places are at the lamps: on a grid of 1 / 200 with the corners in it, four lamps stay below full.
    #[test]
    fn no_level_needs_a_clamp() {
        for channel in 0..3 {
            let mut most = 0.0f32;
            for (x, y) in (0..=1000).flat_map(|x| (0..=1000).map(move |y| (x as f32 * 0.005, y as f32 * 0.005))) {
                let level = |lamp| {
                    let (lx, ly) = corner(lamp);
                    color(lamp, channel) / (1.0 + (lx - x) * (lx - x) + (ly - y) * (ly - y))
                };
                most = most.max(level(0) + level(1) + level(2) + level(3));
            }
            assert!((200.0..250.0).contains(&most), "channel {channel} comes to {most}");
        }
    }
}
