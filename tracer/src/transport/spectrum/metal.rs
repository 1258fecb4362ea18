//! Metals: complex indices of refraction, by wavelength.

use super::{LONGEST_NM, SHORTEST_NM};

/// A metal: its index of refraction n + ik.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metal {
    /// Wavelength, nm, n and k, from short to long; between them n and k are interpolated.
    table: &'static [[f64; 3]],
}

impl Metal {
    /// n and k at a wavelength.
    pub fn index(&self, wavelength_nm: f64) -> [f64; 2] {
        let nm = wavelength_nm.clamp(SHORTEST_NM, LONGEST_NM);
        let above = self.table.partition_point(|row| row[0] < nm).clamp(1, self.table.len() - 1);
        let [a, b] = [self.table[above - 1], self.table[above]];
        let part = ((nm - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0);
        [1, 2].map(|column| a[column] + (b[column] - a[column]) * part)
    }
}

/// Gold, silver and copper: P. B. Johnson and R. W. Christy, "Optical constants of the noble metals", Physical Review B 6,
/// 1972. Aluminium: H.-J. Hagemann, W. Gudat and C. Kunz, DESY report SR-74/7, 1974.
pub const METALS: [(&str, Metal); 4] = [
    ("aluminium", Metal { table: &ALUMINIUM }),
    ("copper", Metal { table: &COPPER }),
    ("gold", Metal { table: &GOLD }),
    ("silver", Metal { table: &SILVER }),
];

/// The metal of this name, in any case.
pub fn metal_named(name: &str) -> Option<Metal> {
    METALS.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, metal)| *metal)
}

const ALUMINIUM: [[f64; 3]; 7] = [
    [310.0, 0.298, 3.70],
    [413.3, 0.548, 5.00],
    [495.9, 0.771, 5.91],
    [619.9, 1.292, 7.28],
    [688.8, 1.731, 7.96],
    [729.3, 2.082, 8.34],
    [774.9, 2.588, 8.55],
];

const COPPER: [[f64; 3]; 15] = [
    [367.9, 1.36, 1.975],
    [381.5, 1.33, 2.045],
    [397.4, 1.32, 2.116],
    [413.3, 1.28, 2.207],
    [430.5, 1.25, 2.305],
    [450.9, 1.24, 2.397],
    [471.4, 1.25, 2.483],
    [495.9, 1.22, 2.564],
    [520.9, 1.18, 2.608],
    [548.6, 1.02, 2.577],
    [582.1, 0.70, 2.704],
    [616.8, 0.30, 3.205],
    [659.5, 0.22, 3.747],
    [704.5, 0.21, 4.205],
    [756.0, 0.24, 4.665],
];

const GOLD: [[f64; 3]; 15] = [
    [367.9, 1.48, 1.895],
    [381.5, 1.46, 1.933],
    [397.4, 1.47, 1.952],
    [413.3, 1.46, 1.958],
    [430.5, 1.45, 1.948],
    [450.9, 1.38, 1.914],
    [471.4, 1.31, 1.849],
    [495.9, 1.04, 1.833],
    [520.9, 0.62, 2.081],
    [548.6, 0.43, 2.455],
    [582.1, 0.29, 2.863],
    [616.8, 0.21, 3.272],
    [659.5, 0.14, 3.697],
    [704.5, 0.13, 4.103],
    [756.0, 0.14, 4.542],
];

const SILVER: [[f64; 3]; 15] = [
    [367.9, 0.07, 1.657],
    [381.5, 0.05, 1.864],
    [397.4, 0.05, 2.070],
    [413.3, 0.05, 2.275],
    [430.5, 0.04, 2.462],
    [450.9, 0.04, 2.657],
    [471.4, 0.05, 2.869],
    [495.9, 0.05, 3.093],
    [520.9, 0.05, 3.324],
    [548.6, 0.06, 3.586],
    [582.1, 0.05, 3.858],
    [616.8, 0.06, 4.152],
    [659.5, 0.05, 4.483],
    [704.5, 0.04, 4.838],
    [756.0, 0.03, 5.242],
];

#[cfg(test)]
mod tests {
    use super::*;

    /// At normal incidence R = ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2): silver reflects all colours, gold and copper little blue.
    #[test]
    fn gold_and_copper_are_red_and_silver_is_white() {
        let reflectance = |name: &str, nm: f64| {
            let [n, k] = metal_named(name).unwrap().index(nm);
            ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k)
        };
        assert!(reflectance("gold", 450.0) < 0.45 && reflectance("gold", 650.0) > 0.93);
        assert!(reflectance("copper", 450.0) < 0.6 && reflectance("copper", 650.0) > 0.9);
        assert!(reflectance("silver", 450.0) > 0.95 && reflectance("silver", 650.0) > 0.97);
        assert!((0.85..0.94).contains(&reflectance("Aluminium", 550.0)));
        // At a measured wavelength it is the measured value, and beyond the last one the last.
        assert_eq!(metal_named("gold").unwrap().index(520.9), [0.62, 2.081]);
        assert_eq!(metal_named("silver").unwrap().index(780.0), [0.03, 5.242]);
    }
}
