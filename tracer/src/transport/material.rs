//! Materials of transport: what becomes of light at an outline.

use super::spectrum::{Dispersion, Metal, reflectance_of_rgb};

/// What an outline is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Material {
    /// Light ends here.
    Absorber,
    /// Light goes on in every direction, by Lambert's law in the plane: radiance the same in all of them.
    Diffuse {
        /// What is reflected, linear sRGB, 0 to 1.
        reflectance: [f64; 3],
    },
    /// A mirror.
    Mirror {
        /// What is reflected, linear sRGB, 0 to 1.
        reflectance: [f64; 3],
        /// Standard deviation of the slopes of its facets; 0 is polished.
        roughness: f64,
    },
    /// A metal, with Fresnel's reflectance.
    Metal {
        /// Which.
        metal: Metal,
        /// As a mirror's.
        roughness: f64,
    },
    /// Half-silvered glass without thickness: what is not let through is reflected.
    BeamSplitter {
        /// What is let through, 0 to 1.
        transmittance: f64,
    },
    /// A lens without thickness that has no aberration: a ray at height h gets `tan' = tan - h / f`.
    IdealLens {
        /// The focal length f; negative for a diverging lens.
        focal_length: f64,
    },
    /// The same as a mirror.
    IdealMirror {
        /// The focal length f; negative for a diverging mirror.
        focal_length: f64,
    },
    /// Glass, or another thing that light passes: the outline is closed.
    Dielectric(Dielectric),
}

/// A transparent material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric {
    /// Its index of refraction. Where bodies overlap, their indices multiply.
    pub dispersion: Dispersion,
    /// What is left of light after one millimetre, linear sRGB, over 0 to 1: Beer and Lambert's law.
    pub transmittance_per_mm: [f64; 3],
    /// Standard deviation of the slopes of its facets; 0 is polished.
    pub roughness: f64,
    /// Whether its surface also reflects part of the light, as Fresnel says; else all that can pass does.
    pub reflects: bool,
}

impl Dielectric {
    /// Clear polished glass.
    pub fn clear(dispersion: Dispersion) -> Dielectric {
        Dielectric { dispersion, transmittance_per_mm: [1.0; 3], roughness: 0.0, reflects: true }
    }

    /// The coefficient of absorption at a wavelength, 1/mm.
    pub fn absorption_per_mm(&self, wavelength_nm: f64) -> f64 {
        if self.transmittance_per_mm == [1.0; 3] {
            return 0.0;
        }
        // The logarithm of a colour's spectrum, not the spectrum of a logarithm: thick glass keeps its hue.
        -libm::log(reflectance_of_rgb(self.transmittance_per_mm, wavelength_nm).max(1e-300))
    }
}

/// The wavelengths on which a body acts; others pass it as if it were not there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// The middle, nm.
    pub middle_nm: f64,
    /// Half of the width, nm: both ends belong to the band.
    pub half_nm: f64,
    /// It acts on all other wavelengths instead.
    pub inverted: bool,
}

impl Band {
    /// Whether the body acts on a wavelength.
    pub fn holds(&self, wavelength_nm: f64) -> bool {
        ((wavelength_nm - self.middle_nm).abs() <= self.half_nm) != self.inverted
    }
}

impl Material {
    /// Clear glass of this dispersion.
    pub fn glass(dispersion: Dispersion) -> Material {
        Material::Dielectric(Dielectric::clear(dispersion))
    }

    /// A perfect mirror.
    pub const MIRROR: Material = Material::Mirror { reflectance: [1.0; 3], roughness: 0.0 };

    /// The standard deviation of its facets' slopes.
    pub fn roughness(&self) -> f64 {
        match self {
            Material::Mirror { roughness, .. } | Material::Metal { roughness, .. } => *roughness,
            Material::Dielectric(glass) => glass.roughness,
            _ => 0.0,
        }
    }
}
