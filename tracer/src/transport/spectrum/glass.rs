//! Refractive indices: how they depend on the wavelength.

/// How the index of refraction depends on the wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dispersion {
    /// The same at every wavelength.
    Constant(f64),
    /// A. L. Cauchy, 1836: `n = a + b / l^2`, l in micrometres.
    Cauchy {
        /// The index of long waves.
        a: f64,
        /// How much it rises, um^2.
        b: f64,
    },
    /// W. Sellmeier, 1871: `n^2 = 1 + sum B l^2 / (l^2 - C)`, l in micrometres, as SCHOTT's catalogue lists it.
    Sellmeier {
        /// The strengths B; a term that is not needed is 0.
        b: [f64; 4],
        /// The resonances C, um^2.
        c: [f64; 4],
    },
}

impl Dispersion {
    /// The index of refraction at a wavelength.
    pub fn index(&self, wavelength_nm: f64) -> f64 {
        let square_um = wavelength_nm * wavelength_nm * 1e-6;
        match self {
            Dispersion::Constant(index) => *index,
            Dispersion::Cauchy { a, b } => a + b / square_um,
            Dispersion::Sellmeier { b, c } => {
                let terms = b.iter().zip(c).map(|(b, c)| b * square_um / (square_um - c));
                (1.0 + terms.sum::<f64>()).sqrt()
            }
        }
    }

    /// Whether light of all wavelengths goes the same way.
    pub fn is_constant(&self) -> bool {
        matches!(self, Dispersion::Constant(_) | Dispersion::Cauchy { b: 0.0, .. })
    }
}

/// A glass of three terms.
const fn three_terms(name: &'static str, b: [f64; 3], c: [f64; 3]) -> (&'static str, Dispersion) {
    (name, Dispersion::Sellmeier { b: [b[0], b[1], b[2], 0.0], c: [c[0], c[1], c[2], 0.0] })
}

/// Transparent materials by name. The glasses are SCHOTT's (optical glass data sheets); water at 20 C is after M. Daimon and A.
/// Masumura, "Measurement of the refractive index of distilled water", Applied Optics 46, 2007; fused silica after I. H.
/// Malitson, JOSA 55, 1965; diamond after F. Peter, Zeitschrift fuer Physik 15, 1923.
pub const GLASSES: [(&str, Dispersion); 8] = [
    three_terms("N-BK7", [1.039_612_12, 0.231_792_344, 1.010_469_45], [0.006_000_698_67, 0.020_017_914_4, 103.560_653]),
    three_terms("N-SF10", [1.621_539_02, 0.256_287_842, 1.644_475_52], [0.012_224_145_7, 0.059_573_677_5, 147.468_793]),
    three_terms("N-SF11", [1.737_596_95, 0.313_747_346, 1.898_781_01], [0.013_188_707, 0.062_306_814_2, 155.236_29]),
    three_terms("F2", [1.345_333_59, 0.209_073_176, 0.937_357_162], [0.009_977_438_71, 0.047_045_076_7, 111.886_764]),
    three_terms(
        "N-BAF10",
        [1.585_149_5, 0.143_559_385, 1.085_212_69],
        [0.009_266_812_82, 0.042_448_980_5, 105.613_573],
    ),
    three_terms("silica", [0.696_166_3, 0.407_942_6, 0.897_479_4], [0.004_679_148, 0.013_512_063, 97.934_002_5]),
    (
        "water",
        Dispersion::Sellmeier {
            b: [0.568_402_756_5, 0.172_617_739_1, 0.020_861_895_78, 0.113_074_868_8],
            c: [0.005_101_829_712, 0.018_211_539_36, 0.026_207_222_93, 10.697_927_21],
        },
    ),
    ("diamond", Dispersion::Sellmeier { b: [0.3306, 4.3356, 0.0, 0.0], c: [0.030_625, 0.011_236, 0.0, 0.0] }),
];

/// The material of this name, in any case.
pub fn glass_named(name: &str) -> Option<Dispersion> {
    GLASSES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, dispersion)| *dispersion)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At the lines F, d and C, as catalogues print them.
    #[test]
    fn glasses_have_the_indices_of_their_data_sheets() {
        for (name, expected) in [
            ("N-BK7", [1.522376, 1.516800, 1.514322]),
            ("N-SF10", [1.746430, 1.728277, 1.720905]),
            ("water", [1.337492, 1.333403, 1.331512]),
        ] {
            for (line_nm, expected) in [486.134, 587.562, 656.281].into_iter().zip(expected) {
                let index = glass_named(name).unwrap().index(line_nm);
                assert!((index - expected).abs() < 1e-6, "{name} at {line_nm}: {index}");
            }
        }
        // Of the others the index at the line d: SCHOTT to five decimals, Malitson and Peter to four.
        for (name, expected, tolerance) in [
            ("N-SF11", 1.78472, 6e-6),
            ("F2", 1.62004, 6e-6),
            ("N-BAF10", 1.67003, 6e-6),
            ("silica", 1.4585, 6e-5),
            ("diamond", 2.4176, 2e-4),
        ] {
            let index = glass_named(name).unwrap().index(587.562);
            assert!((index - expected).abs() < tolerance, "{name}: {index}");
        }
    }

    #[test]
    fn a_name_is_found_in_any_case_and_an_unknown_one_is_not() {
        assert!(glass_named("n-bk7").is_some() && glass_named("Water").is_some());
        assert!(glass_named("BK8").is_none());
    }
}
