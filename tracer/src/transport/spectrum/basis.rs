//! Spectra of colours: a smooth reflectance or emission for each linear sRGB colour.
//!
//! A colour (r, g, b) is `r R + g G + b B` of three curves with three properties:
//! 1. R + G + B = 1 at every wavelength, so white is flat;
//! 2. each lies between 0 and 1, so no colour between black and white reflects more than there is;
//! 3. under equal energy each is its primary exactly, so a colour comes back as it went in.
//!
//! Of all such curves, linear between knots of 10 nm, these have the least sum of squared second differences. The idea of
//! three curves that add up to 1 is that of I. Mallett and C. Yuksel, "Spectral primary decomposition for rendering with sRGB
//! reflectance", EGSR 2019; the numbers are for equal energy and for the observer of this crate.

use super::{LONGEST_NM, SHORTEST_NM};

/// From one knot to the next, nm.
const STEP_NM: f64 = 10.0;

/// The curves of red and green at the knots; blue is what is left of 1.
const RED_GREEN: [[f64; 2]; 41] = [
    [0.19894, 0.02517],
    [0.18700, 0.01496],
    [0.17312, 0.00561],
    [0.15047, 0.00000],
    [0.11154, 0.00000],
    [0.06266, 0.00000],
    [0.02015, 0.00000],
    [0.00000, 0.00000],
    [0.00000, 0.03286],
    [0.00000, 0.13455],
    [0.00000, 0.29982],
    [0.00000, 0.50133],
    [0.00000, 0.70181],
    [0.00000, 0.86491],
    [0.00000, 0.96533],
    [0.00000, 1.00000],
    [0.00000, 1.00000],
    [0.00000, 1.00000],
    [0.00000, 1.00000],
    [0.00000, 0.96564],
    [0.16366, 0.77875],
    [0.56735, 0.41578],
    [0.91119, 0.08881],
    [1.00000, 0.00000],
    [1.00000, 0.00000],
    [1.00000, 0.00000],
    [1.00000, 0.00000],
    [1.00000, 0.00000],
    [1.00000, 0.00000],
    [1.00000, 0.00000],
    [1.00000, 0.00000],
    [0.99828, 0.00172],
    [0.98929, 0.00779],
    [0.97482, 0.01689],
    [0.95741, 0.02757],
    [0.93868, 0.03895],
    [0.91943, 0.05060],
    [0.90000, 0.06235],
    [0.88052, 0.07412],
    [0.86102, 0.08591],
    [0.84152, 0.09769],
];

/// The three curves at a wavelength.
fn curves(wavelength_nm: f64) -> [f64; 3] {
    let place = (wavelength_nm.clamp(SHORTEST_NM, LONGEST_NM) - SHORTEST_NM) / STEP_NM;
    let below = (place as usize).min(RED_GREEN.len() - 2);
    let part = place - below as f64;
    let [a, b] = [RED_GREEN[below], RED_GREEN[below + 1]];
    let [red, green] = [0, 1].map(|curve| a[curve] + (b[curve] - a[curve]) * part);
    [red, green, 1.0 - red - green]
}

/// What a surface of this linear colour (each channel 0 to 1) reflects at a wavelength, 0 to 1.
pub fn reflectance_of_rgb(color: [f64; 3], wavelength_nm: f64) -> f64 {
    emission_of_rgb(color, wavelength_nm).clamp(0.0, 1.0)
}

/// The power of a lamp of this linear colour (each channel 0 or more) at a wavelength, relative to that of equal energy.
pub fn emission_of_rgb([r, g, b]: [f64; 3], wavelength_nm: f64) -> f64 {
    let [red, green, blue] = curves(wavelength_nm);
    r * red + g * green + b * blue
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transport::spectrum::Weights;

    #[test]
    fn a_colour_comes_back_as_it_went_in() {
        let weights = Weights::equal_energy();
        for color in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.5, 0.9], [1.0; 3]] {
            let mut seen = [0.0; 3];
            for step in 0..4000 {
                let nm = SHORTEST_NM + (f64::from(step) + 0.5) * 0.1;
                let power = emission_of_rgb(color, nm) / 4000.0;
                (0..3).for_each(|channel| seen[channel] += power * f64::from(weights.at(nm)[channel]));
            }
            for (seen, sent) in seen.iter().zip(color) {
                assert!((seen - sent).abs() < 2e-4, "{color:?}: {seen}");
            }
        }
    }

    #[test]
    fn no_colour_reflects_more_than_there_is_and_white_is_flat() {
        for nm in 380..=780 {
            let [red, green, blue] = curves(f64::from(nm));
            assert!([red, green, blue].iter().all(|part| (-1e-12..=1.0 + 1e-12).contains(part)));
            assert!((red + green + blue - 1.0).abs() < 1e-12);
        }
    }
}
