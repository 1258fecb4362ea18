//! The integrators: how the light of a scene is found.

use crate::monte_carlo::Sampling;

/// How the light of a scene is found. The set is closed: an integrator joins by a variant here, a room of its own and
/// tests against the reference (`docs/add_an_integrator.md`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// Direct light, exactly: the visible fraction of each lamp is one minus the length of the union of the intervals that
    /// occluders cover of it.
    #[default]
    Exact,
    /// The same at half the resolution, brought to the full one by joint bilateral upsampling: for small machines. The scene
    /// must have its art at half the resolution ([`crate::Scene::half_floor`]).
    HalfResolution,
    /// Direct light by shadow rays to random points of each lamp: the reference that the others are judged by.
    MonteCarlo(Sampling),
}
