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
    /// Reads the rows of a tile from premultiplied sRGB pixels.
    pub(crate) fn read(
        pixels: &[[u8; 4]], stride: usize, x: usize, y: usize, width: usize, height: usize, out: &mut Albedo,
    ) = read_lanes;
}

#[inline(always)]
fn read_lanes(pixels: &[[u8; 4]], stride: usize, x: usize, y: usize, width: usize, height: usize, out: &mut Albedo) {
    for row in 0..TILE.min(height) {
        let start = (y + row) * stride + x;
        let mut source = [[0u8; 4]; LANES];
        source[..width].copy_from_slice(&pixels[start..start + width]);
        let alpha = &mut out.alpha[row];
        let mut inverse: Lanes = [0.0; LANES];
        for i in 0..LANES {
            let a = f32::from(source[i][3]);
            alpha[i] = a * (1.0 / 255.0);
            inverse[i] = 1.0 / max(a, 1.0);
        }
        for channel in 0..3 {
            let color = &mut out.color[channel][row];
            for i in 0..LANES {
                color[i] = linear(f32::from(source[i][channel]) * inverse[i]);
            }
        }
    }
}

/// The inverse of the sRGB transfer curve, to a twentieth of an 8-bit level.
#[inline(always)]
pub(crate) fn linear(encoded: f32) -> f32 {
    let t = (encoded + 0.055) * (1.0 / 1.055);
    let curved = ((((1.2434443 * t - 4.2045953) * t + 5.6990622) * t - 4.1126176) * t + 2.1558409) * t + 0.2188655;
    if encoded <= 0.040_45 { encoded * (1.0 / 12.92) } else { curved * t * t }
}
