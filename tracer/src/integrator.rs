//! The integrators: how the light of a scene is found.

use crate::monte_carlo::Sampling;
use crate::{Radiance, Renderer, Scene};

/// How the light of a scene is found. The set is closed: an integrator joins by a variant here, a room of its own and
/// tests against the reference (`docs/add_an_integrator.md`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// Direct light, exactly: the visible fraction of each lamp is one minus the length of the union of the intervals that
    /// occluders cover of it.
    #[default]
    Exact,
    /// The same at half the resolution, brought to the full one by joint bilateral upsampling: for small machines. The scene
    /// must have its art at half the resolution ([`Scene::half_floor`]).
    HalfResolution,
    /// Direct light by shadow rays to random points of each lamp: the reference that the others are judged by.
    MonteCarlo(Sampling),
}

/// Renders a scene once, on the threads of the current rayon pool: the same bits on any number. What [`Scene::check`]
/// refuses is not drawn; of a view that it refuses there is no picture.
///
/// Nothing is kept, so nothing is rounded to be kept: this is the slow twin of [`Renderer::render`].
pub fn render(scene: &Scene, integrator: Integrator, radiance: &mut Radiance) {
    let mut renderer = Renderer::with(integrator);
    match integrator {
        Integrator::Exact => renderer.render_uncached(scene, radiance),
        Integrator::HalfResolution | Integrator::MonteCarlo(_) => renderer.render(scene, radiance),
    }
}
