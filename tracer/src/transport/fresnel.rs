//! Fresnel's equations: how much of a plane wave a smooth boundary reflects.
//!
//! In the plane the electric field is either perpendicular to the drawing (s) or within it (p), and no reflection turns the one
//! into the other: light carries both powers apart, which is exact. M. Born and E. Wolf, "Principles of Optics", sections
//! 1.5 and 14.2.

/// What a boundary between two dielectrics reflects, s and p, and the cosine of the refracted ray's angle; `None` where the
/// reflection is total.
///
/// `cosine` is that of the angle of incidence, 0 to 1; `ratio` the index behind the boundary over that before it.
pub fn dielectric(cosine: f64, ratio: f64) -> Option<([f64; 2], f64)> {
    // Snell: sin t = sin i / ratio.
    let square = 1.0 - (1.0 - cosine * cosine) / (ratio * ratio);
    if square <= 0.0 {
        return None;
    }
    let refracted = square.sqrt();
    let s = (cosine - ratio * refracted) / (cosine + ratio * refracted);
    let p = (ratio * cosine - refracted) / (ratio * cosine + refracted);
    Some(([s * s, p * p], refracted))
}

/// What a metal of the index n + ik reflects, s and p, at an angle of incidence of this cosine.
pub fn metal(cosine: f64, [n, k]: [f64; 2]) -> [f64; 2] {
    // With a + ib the square root of (n + ik)^2 - sin^2.
    let sine_square = 1.0 - cosine * cosine;
    let real = n * n - k * k - sine_square;
    let square_sum = (real * real + 4.0 * n * n * k * k).sqrt();
    let a_square = (0.5 * (square_sum + real)).max(0.0);
    let a = a_square.sqrt();
    let s = (square_sum + cosine * cosine - 2.0 * a * cosine) / (square_sum + cosine * cosine + 2.0 * a * cosine);
    // p = s (|..| cos^2 + sin^4 -+ 2 a cos sin^2).
    let even = square_sum * cosine * cosine + sine_square * sine_square;
    let odd = 2.0 * a * cosine * sine_square;
    [s, s * (even - odd) / (even + odd)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cosine(degrees: f64) -> f64 {
        libm::cos(degrees.to_radians())
    }

    #[test]
    fn air_to_glass_and_back_reflects_what_the_tables_say() {
        for (degrees, ratio, [s, p]) in [
            (0.0, 1.5, [0.04, 0.04]),
            (45.0, 1.5, [0.092013, 0.008466]),
            (56.309932, 1.5, [0.147929, 0.0]),
            (75.0, 1.5, [0.399356, 0.106765]),
            (40.0, 1.0 / 1.5, [0.390518, 0.100064]),
        ] {
            let (reflected, _) = dielectric(cosine(degrees), ratio).expect("some light passes");
            assert!((reflected[0] - s).abs() < 1e-6, "{degrees}: s {}", reflected[0]);
            assert!((reflected[1] - p).abs() < 1e-6, "{degrees}: p {}", reflected[1]);
        }
        assert!(dielectric(cosine(41.8102), 1.0 / 1.5).is_some());
        assert_eq!(dielectric(cosine(41.8104), 1.0 / 1.5), None, "total from 41.8103 degrees on");
    }

    /// A slab: T of all orders is (1 - R) / (1 + R) for s and p apart, then their mean. Averaging R first is another number.
    #[test]
    fn a_slab_passes_s_and_p_apart() {
        for (degrees, expected) in [(0.0, 0.923077), (45.0, 0.907344), (56.309932, 0.871134), (75.0, 0.618149)] {
            let ([s, p], _) = dielectric(cosine(degrees), 1.5).expect("some light passes");
            let passed = 0.5 * ((1.0 - s) / (1.0 + s) + (1.0 - p) / (1.0 + p));
            assert!((passed - expected).abs() < 1e-6, "{degrees}: {passed}");
        }
    }

    /// Without k a metal is a dielectric, at grazing incidence all is reflected, and head on s is p.
    #[test]
    fn a_metal_agrees_with_a_dielectric_and_with_its_limits() {
        for degrees in [0.0, 30.0, 60.0, 85.0] {
            let glass = dielectric(cosine(degrees), 1.5).expect("some light passes").0;
            let metal = metal(cosine(degrees), [1.5, 0.0]);
            assert!((0..2).all(|way| (glass[way] - metal[way]).abs() < 1e-12), "{degrees}");
        }
        let [s, p] = metal(1.0, [0.29, 2.863]);
        let expected = ((0.29_f64 - 1.0).powi(2) + 2.863 * 2.863) / ((0.29_f64 + 1.0).powi(2) + 2.863 * 2.863);
        assert!((s - expected).abs() < 1e-12 && (p - expected).abs() < 1e-12);
        assert!(metal(0.0, [0.29, 2.863]).iter().all(|part| (part - 1.0).abs() < 1e-12));
    }
}
