//! Spectra: how much power lies at each wavelength, and which colour it is.
//!
//! Wavelengths are nanometres, from [`SHORTEST_NM`] to [`LONGEST_NM`]: what is beyond has no colour, and no lamp of this
//! crate emits it.

mod basis;
mod cie;
mod emission;
mod glass;
mod metal;

pub use basis::{emission_of_rgb, reflectance_of_rgb};
pub use cie::{Weights, rgb, xyz};
pub use emission::{Emission, Gas, GasLine, WavelengthSample, WavelengthSampler, WavelengthStratum};
pub use glass::{Dispersion, GLASSES, glass_named};
pub use metal::{METALS, Metal, metal_named};

/// The shortest wavelength that is seen, nm.
pub const SHORTEST_NM: f64 = 380.0;
/// The longest wavelength that is seen, nm.
pub const LONGEST_NM: f64 = 780.0;
