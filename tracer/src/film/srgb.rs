//! The sRGB curve (the transfer curve of IEC 61966-2-1): linear light to the codes of a screen and back.
//!
//! Four forms of the one curve, since each caller needs another trade of speed, precision and platform:
//! - [`decode`]: exact in single precision, through `libm`, for the few colours that people write.
//! - [`decode_f64`]: exact in double precision, for the judge of pictures, which must not share the renderer's
//!   rounding.
//! - `decode_fast`: a polynomial for millions of texels: no `pow`, so it vectorizes, and every processor gives the same
//!   bits.
//! - `encode_fast`: the same for the tone map's pixels.
//!
//! The tests hold the fast forms to the exact ones.

use crate::Rgb;
use crate::simd::dispatch::max;

/// Below this code the curve is a straight line.
const LINEAR_UP_TO_CODE: f64 = 0.040_45;

/// The same point in linear light.
const LINEAR_UP_TO_LIGHT: f32 = 0.003_130_8;

/// The straight line's slope, codes over light.
const SLOPE: f64 = 12.92;

/// The offset of the power law.
const OFFSET: f64 = 0.055;

/// One plus the offset: white stays white.
const SCALE: f64 = 1.055;

/// The exponent of the power law.
const GAMMA: f64 = 2.4;

/// The linear light of a code from 0 to 1.
pub fn decode(code: f32) -> f32 {
    if code <= LINEAR_UP_TO_CODE as f32 {
        code / SLOPE as f32
    } else {
        libm::powf((code + OFFSET as f32) / SCALE as f32, GAMMA as f32)
    }
}

/// [`decode`] in double precision.
pub fn decode_f64(code: f64) -> f64 {
    if code <= LINEAR_UP_TO_CODE { code / SLOPE } else { libm::pow((code + OFFSET) / SCALE, GAMMA) }
}

/// The linear light of an 8-bit colour.
pub fn decode_rgb8(color: [u8; 3]) -> Rgb {
    color.map(|code| decode(f32::from(code) / 255.0))
}

/// [`decode`] to a twelfth of an 8-bit level: t^2.4 as t^2 times a polynomial of degree 5 for t^0.4, where t is
/// `(code + 0.055) / 1.055`.
#[inline(always)]
pub(crate) fn decode_fast(code: f32) -> f32 {
    let t = (code + OFFSET as f32) * (1.0 / SCALE as f32);
    let curved = ((((1.243444 * t - 4.204595) * t + 5.699062) * t - 4.112618) * t + 2.155841) * t + 0.218865;
    if code <= LINEAR_UP_TO_CODE as f32 { code * (1.0 / SLOPE as f32) } else { curved * t * t }
}

/// The code of linear light, to a ninth of an 8-bit level: a polynomial of degree 6 in the square root, which is nearer
/// to the 2.4th root than the light itself.
#[inline(always)]
pub(crate) fn encode_fast(light: f32) -> f32 {
    let s = max(light, 0.0).sqrt();
    let curved = ((((-0.761_408 * s + 2.801_746) * s - 4.212_598) * s + 3.406_116) * s - 1.746_204) * s;
    let curved = (curved + 1.553_333) * s - 0.041_132;
    if light <= LINEAR_UP_TO_LIGHT { SLOPE as f32 * light } else { curved }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The code of linear light, exactly.
    fn encode(light: f64) -> f64 {
        let is_linear = light <= f64::from(LINEAR_UP_TO_LIGHT);
        if is_linear { SLOPE * light } else { SCALE * libm::pow(light, 1.0 / GAMMA) - OFFSET }
    }

    #[test]
    fn the_exact_forms_agree_and_the_inverse_brings_every_code_back() {
        for code in 0..=255u8 {
            let exact = decode_f64(f64::from(code) / 255.0);
            assert!((f64::from(decode(f32::from(code) / 255.0)) - exact).abs() < 1e-6, "{code}");
            assert!((encode(exact) * 255.0 - f64::from(code)).abs() < 1e-3, "{code}");
        }
    }

    #[test]
    fn the_fast_decoder_is_within_a_twelfth_of_a_level() {
        for step in 0..=255 * 16 {
            let code = step as f32 / (255.0 * 16.0);
            let off = (encode(f64::from(decode_fast(code))) - f64::from(code)) * 255.0;
            assert!(off.abs() < 1.0 / 12.0, "{off} levels at {code}");
        }
    }

    #[test]
    fn the_fast_encoder_is_within_a_ninth_of_a_level() {
        for step in 0..=100_000 {
            let light = step as f32 / 100_000.0;
            let off = (f64::from(encode_fast(light)) - encode(f64::from(light))) * 255.0;
            assert!(off.abs() < 1.0 / 9.0, "{off} levels at {light}");
        }
    }
}
