//! The angle of a direction, for inner loops: only `+ - * /` and selections, so the same bits on every SIMD level.

use crate::simd::dispatch::max;
use std::f32::consts::{FRAC_PI_2, PI};

/// The arctangent of `r` over `r` as a polynomial in `r * r`, for `r` from 0 to 1: the interpolation at the Chebyshev
/// nodes of degree 8, wrong by at most 1.6e-8 of its value before rounding.
const ARCTANGENT: [f32; 9] = [
    0.999_999_984,
    -0.333_330_66,
    0.199_924_84,
    -0.142_025_71,
    0.106_367_54,
    -0.074_954_46,
    0.042_587_607,
    -0.016_005_03,
    0.002_834_064,
];

/// The angle of the direction (`x`, `y`) from the first axis, 0 to pi, for `y` of 0 or more; wrong by less than 4e-7 of
/// its value. Without a direction it is 0.
#[inline(always)]
pub(crate) fn angle(x: f32, y: f32) -> f32 {
    let across = max(x, -x);
    let steep = y > across;
    let (small, large) = (if steep { across } else { y }, if steep { y } else { across });
    let r = small / max(large, f32::MIN_POSITIVE);
    let square = r * r;
    let mut sum = ARCTANGENT[8];
    for k in (0..8).rev() {
        sum = sum * square + ARCTANGENT[k];
    }
    let acute = if steep { FRAC_PI_2 - sum * r } else { sum * r };
    if x < 0.0 { PI - acute } else { acute }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_arctangent() {
        for step in 0..=200_000 {
            let turn = std::f64::consts::PI * f64::from(step) / 200_000.0;
            for length in [1e-9, 1.0, 3e11] {
                let (x, y) = ((libm::cos(turn) * length) as f32, (libm::sin(turn) * length).abs() as f32);
                let expected = libm::atan2(f64::from(y), f64::from(x));
                let error = (f64::from(angle(x, y)) - expected).abs();
                assert!(error <= 4e-7 * expected, "{x} {y}: {error} of {expected}");
            }
        }
    }

    #[test]
    fn directions_along_the_axes_are_exact() {
        assert_eq!((angle(2.0, 0.0), angle(0.0, 0.0)), (0.0, 0.0));
        assert_eq!((angle(0.0, 5.0), angle(-3.0, 0.0)), (FRAC_PI_2, PI));
    }
}
