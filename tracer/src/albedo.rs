//! Art in sRGB bytes as the reflectance that light works with.

use crate::lanes::{LANES, Lanes, clones, max};
use crate::points::{Plane, TILE};

/// Reflectance and coverage of the pixels of a tile.
#[derive(Clone, Debug)]
pub(crate) struct Albedo {
    /// Red, green, blue, linear, not multiplied by the coverage.
    pub color: [Plane; 3],
    /// 0 where there is no art, 1 where it is opaque.
    pub alpha: Plane,
}

impl Albedo {
    /// Black, and none of it.
    pub fn none() -> Albedo {
        Albedo { color: [[[0.0; LANES]; TILE]; 3], alpha: [[0.0; LANES]; TILE] }
    }
}

clones! {
    /// Reads the rows of a tile from opaque sRGB pixels.
    pub(crate) fn read_opaque(
        pixels: &[[u8; 4]], stride: usize, x: usize, y: usize, width: usize, height: usize, out: &mut Albedo,
    ) = read_lanes::<true>;
}

clones! {
    /// Reads the rows of a tile from premultiplied sRGB pixels.
    pub(crate) fn read(
        pixels: &[[u8; 4]], stride: usize, x: usize, y: usize, width: usize, height: usize, out: &mut Albedo,
    ) = read_lanes::<false>;
}

#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn read_lanes<const OPAQUE: bool>(
    pixels: &[[u8; 4]],
    stride: usize,
    x: usize,
    y: usize,
    width: usize,
    height: usize,
    out: &mut Albedo,
) {
    for row in 0..TILE.min(height) {
        let start = (y + row) * stride + x;
        let mut packed = [0i32; LANES];
        match pixels[start..start + width].first_chunk::<LANES>() {
            Some(whole) => packed = whole.map(i32::from_le_bytes),
            None => {
                for (packed, pixel) in packed.iter_mut().zip(&pixels[start..start + width]) {
                    *packed = i32::from_le_bytes(*pixel);
                }
            }
        }
        let mut scale: Lanes = [1.0 / 255.0; LANES];
        if !OPAQUE {
            for i in 0..LANES {
                let alpha = ((packed[i] >> 24) & 255) as f32;
                out.alpha[row][i] = alpha * (1.0 / 255.0);
                scale[i] = 1.0 / max(alpha, 1.0);
            }
        }
        // Channel by channel and not in a loop, which the compiler would turn round.
        let [red, green, blue] = &mut out.color;
        read_channel::<0>(&packed, &scale, &mut red[row]);
        read_channel::<8>(&packed, &scale, &mut green[row]);
        read_channel::<16>(&packed, &scale, &mut blue[row]);
    }
}

#[inline(always)]
fn read_channel<const SHIFT: u32>(packed: &[i32; LANES], scale: &Lanes, out: &mut Lanes) {
    for i in 0..LANES {
        out[i] = linear(((packed[i] >> SHIFT) & 255) as f32 * scale[i]);
    }
}

/// The inverse of the sRGB transfer curve, to a twentieth of an 8-bit level.
#[inline(always)]
pub(crate) fn linear(encoded: f32) -> f32 {
    let t = (encoded + 0.055) * (1.0 / 1.055);
    let curved = ((((1.243444 * t - 4.204595) * t + 5.699062) * t - 4.112618) * t + 2.155841) * t + 0.218865;
    if encoded <= 0.040_45 { encoded * (1.0 / 12.92) } else { curved * t * t }
}
