//! Monte Carlo integration, the reference: shadow rays to random points of a lamp's chord, in double precision, against
//! the scene's own shapes.
//!
//! SplitMix64 numbers are named by lamp, pixel and sample: the same picture on any number of threads. A ray is cast against
//! every shape that may meet the triangle of the point and the chord, and no shape is thought of as anything but what
//! [`geometry::Shape::cast`] says it is.

use crate::reference::monte_carlo::rays::{Near, Rays};
use crate::{Group, Lamp, Rgb, Scene};
use geometry::DVec2;
use geometry::rng::Key;

mod airborne;
mod integrator;
mod rays;

pub(crate) use integrator::render;

/// How a lamp is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Shadow rays a lamp.
    pub samples: u32,
    /// Other seeds give other noise.
    pub seed: u64,
    /// One sample in each of `samples` equal parts of the chord, instead of anywhere: less noise.
    pub stratified: bool,
}

/// The irradiance of a point of the floor from all lamps; what is of the group `exclude` casts no shadow.
pub fn irradiance(scene: &Scene, point_mm: DVec2, exclude: Option<Group>, sampling: Sampling) -> Rgb {
    let mut sum = [0.0; 3];
    let mut near = Near::default();
    for lamp in scene.lamps.iter().filter(|lamp| lamp.shines()) {
        let window = lamp.range_window(point_mm);
        if window > 0.0 {
            let key = Key::new(sampling.seed, u64::from(lamp.id.0)).with_point(point_mm);
            let rays = Rays { sampling, key, point: point_mm };
            let seen = rays.arriving(scene, lamp, exclude, &mut near).seen;
            let open = rays.unoccluded_fraction(&scene.balls, lamp, exclude);
            let strength = open * Lamp::REFERENCE_MM * Lamp::REFERENCE_MM * window * window;
            for channel in 0..3 {
                sum[channel] += f64::from(lamp.color[channel]) * strength * seen[channel];
            }
        }
    }
    sum.map(|light| light as f32)
}
