//! A scene of transport: bodies and light sources.

use super::{Body, LightSource};

/// Bodies and what lights them; lengths are millimetres.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// What light meets.
    pub bodies: Vec<Body>,
    /// Where it comes from.
    pub sources: Vec<LightSource>,
}

/// Surfaces no farther apart than this along a ray are one place, mm: a nanometre, far below any wavelength.
pub const TOLERANCE_MM: f64 = 1e-6;
