//! Optical benches: scenes of the ray-optics simulator (phydemo.app/ray-optics), traced ray by ray, and what their detectors
//! measure.
//!
//! A scene lists objects: light sources that send out a fixed list of rays, things that rays meet, and detectors that change
//! nothing. Everything of a scene that matters is read or named; nothing is passed over in silence.

mod detector;
mod fields;
mod objects;
pub mod picture;
mod scene;
mod sources;
mod trace;

#[cfg(test)]
mod tests;

pub use detector::{Detector, Measured};
pub use scene::OpticsScene;
pub use trace::Measurement;
