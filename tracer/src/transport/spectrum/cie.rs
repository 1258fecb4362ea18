//! The colour of a wavelength: the CIE 1931 standard observer, and the screen's primaries.
//!
//! C. Wyman, P.-P. Sloan, P. Shirley, "Simple analytic approximations to the CIE XYZ color matching functions", JCGT 2(2),
//! 2013, section 2.2: sums of Gaussians whose two sides have their own widths. A single wavelength is outside what a screen
//! can show: its weights are signed, are added up signed, and the sum is brought into the gamut once, at the end
//! ([`crate::transport::film`]).

use super::{LONGEST_NM, SHORTEST_NM};
use libm::exp;

/// A Gaussian with two widths: its middle, nm, and the inverse widths below and above it, 1/nm.
fn lobe(wavelength_nm: f64, middle_nm: f64, below: f64, above: f64) -> f64 {
    let away = wavelength_nm - middle_nm;
    let scaled = away * if away < 0.0 { below } else { above };
    exp(-0.5 * scaled * scaled)
}

/// The standard observer's colour-matching functions x, y, z at a wavelength.
pub fn xyz(wavelength_nm: f64) -> [f64; 3] {
    let lobe = |middle, below, above| lobe(wavelength_nm, middle, below, above);
    [
        0.362 * lobe(442.0, 0.0624, 0.0374) + 1.056 * lobe(599.8, 0.0264, 0.0323) - 0.065 * lobe(501.1, 0.0490, 0.0382),
        0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322),
        1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725),
    ]
}

/// Linear sRGB of XYZ (IEC 61966-2-1).
const RGB_FROM_XYZ: [[f64; 3]; 3] = [
    [3.240_625_5, -1.537_208_0, -0.498_628_6],
    [-0.968_930_7, 1.875_756_1, 0.041_517_5],
    [0.055_710_1, -0.204_021_1, 1.056_995_9],
];

/// The signed weights of a wavelength in linear red, green and blue, before any white balance.
pub fn rgb(wavelength_nm: f64) -> [f64; 3] {
    let [x, y, z] = xyz(wavelength_nm);
    RGB_FROM_XYZ.map(|[a, b, c]| a * x + b * y + c * z)
}

/// The weights of all wavelengths in red, green and blue, such that light of a given spectrum is white.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights {
    /// Weights at whole nanometres from [`SHORTEST_NM`], balanced.
    table: Vec<[f32; 3]>,
}

impl Weights {
    /// The weights with which light whose power is `white` at each wavelength, in any unit, is 1, 1, 1 for each unit of
    /// its mean.
    pub fn balanced(white: impl Fn(f64) -> f64) -> Weights {
        let steps = (LONGEST_NM - SHORTEST_NM) as usize;
        let nm = |step: usize| SHORTEST_NM + step as f64;
        let (mut sums, mut mean) = ([0.0; 3], 0.0);
        for step in 0..=steps {
            // Trapezoids: the ends count half.
            let part = if step == 0 || step == steps { 0.5 } else { 1.0 };
            let power = part * white(nm(step));
            mean += power;
            let weights = rgb(nm(step));
            (0..3).for_each(|channel| sums[channel] += power * weights[channel]);
        }
        let gain = sums.map(|sum| mean / sum);
        let table = (0..=steps).map(|step| {
            let weights = rgb(nm(step));
            std::array::from_fn(|channel| (weights[channel] * gain[channel]) as f32)
        });
        Weights { table: table.collect() }
    }

    /// Those with which equal power at every wavelength is white.
    pub fn equal_energy() -> Weights {
        Weights::balanced(|_| 1.0)
    }

    /// The weights of a wavelength: their mean over all wavelengths, weighted by the white's spectrum, is 1, 1, 1. Between whole
    /// nanometres they are interpolated.
    pub fn at(&self, wavelength_nm: f64) -> [f32; 3] {
        let place = (wavelength_nm.clamp(SHORTEST_NM, LONGEST_NM) - SHORTEST_NM).min(self.table.len() as f64 - 1.001);
        let (below, part) = (place as usize, (place - place.floor()) as f32);
        let [a, b] = [self.table[below], self.table[below + 1]];
        std::array::from_fn(|channel| a[channel] + (b[channel] - a[channel]) * part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sums of equal energy in linear sRGB over luminance: (1.198, 0.950, 0.907), so an equal-energy lamp is pink without
    /// balance.
    #[test]
    fn equal_energy_is_pink_on_a_screen_and_white_when_balanced() {
        let (mut sums, mut luminance) = ([0.0; 3], 0.0);
        for nm in 380..=780 {
            let weights = rgb(f64::from(nm));
            (0..3).for_each(|channel| sums[channel] += weights[channel]);
            luminance += xyz(f64::from(nm))[1];
        }
        for (sum, expected) in sums.iter().zip([1.1984, 0.9504, 0.9072]) {
            assert!((sum / luminance - expected).abs() < 5e-4, "{}", sum / luminance);
        }
        let weights = Weights::equal_energy();
        let mut mean = [0.0_f64; 3];
        for nm in 380..780 {
            let at = weights.at(f64::from(nm) + 0.5);
            (0..3).for_each(|channel| mean[channel] += f64::from(at[channel]) / 400.0);
        }
        assert!(mean.iter().all(|mean| (mean - 1.0).abs() < 1e-5), "{mean:?}");
    }

    /// The luminance curve's top is at 555 nm within the fit's error, and green light is out of the screen's gamut.
    #[test]
    fn the_eye_is_most_sensitive_to_green_which_no_screen_shows_pure() {
        let top = (380..=780).max_by(|a, b| xyz(f64::from(*a))[1].total_cmp(&xyz(f64::from(*b))[1])).unwrap();
        assert!((550..=560).contains(&top), "{top}");
        let [red, green, blue] = rgb(520.0);
        assert!(red < 0.0 && green > 0.0 && blue < green);
    }
}
