//! The measurement: every ray of a scene, followed along all its branches.

use super::{Measured, OpticsScene};
use tracer::transport::ray_splitting::{GivenUp, PoweredRay, SplitLimits, follow};
use tracer::transport::{StartsOn, Surfaces};

/// Hits are one that are nearer to each other than this part of a unit.
const TOGETHER: f64 = 1e-6;

/// Branches that are weaker than this are given up.
const LEAST_POWER: f64 = 1e-7;

/// Surfaces that a branch meets at most, if the scene does not say.
const MOST_SURFACES: u32 = 1_000;

/// Branches of one ray at most.
const MOST_BRANCHES: u32 = 100_000;

/// Branches of all rays together at most: some ten seconds, if there are no more detectors than [`FEW_DETECTORS`].
const MOST_BRANCHES_IN_ALL: u32 = 10_000_000;

/// Detectors that cost less than following a ray does; with more of them there are fewer branches.
const FEW_DETECTORS: usize = 16;

/// Branches of one ray that are followed all the same.
const LEAST_BRANCHES: u32 = 16;

/// What a scene's detectors have measured.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// One for each detector.
    pub measured: Vec<Measured>,
    /// The power of what was given up.
    pub given_up: GivenUp,
    /// The power of all sources.
    pub sent: f64,
}

impl Measurement {
    /// Measures a scene.
    pub fn of(scene: &OpticsScene) -> Measurement {
        let mut measured: Vec<Measured> = scene.detectors.iter().map(|detector| detector.start()).collect();
        let given_up = follow_all(scene, &|| false, |ray, distance| {
            let power = ray.power[0] + ray.power[1];
            for (detector, measured) in scene.detectors.iter().zip(&mut measured) {
                detector.count(&ray.ray, distance, power, measured);
            }
        });
        let sent = scene.rays.iter().map(|ray| ray.brightness).sum();
        Measurement { measured, given_up, sent }
    }
}

/// Follows every ray of a scene along all its branches; `fly` sees each with how far it goes. Gives what was given up: of
/// all rays together no more than [`MOST_BRANCHES_IN_ALL`] branches are followed, each ray's share of them.
pub fn follow_all(
    scene: &OpticsScene,
    is_cancelled: &dyn Fn() -> bool,
    mut fly: impl FnMut(&PoweredRay, f64),
) -> GivenUp {
    let surfaces = Surfaces::new(&scene.bodies, TOGETHER * scene.length_scale);
    let work = scene.rays.len().max(1) * scene.detectors.len().div_ceil(FEW_DETECTORS).max(1);
    let shared = MOST_BRANCHES_IN_ALL as usize / work;
    let limits = SplitLimits {
        least_power: LEAST_POWER,
        most_surfaces: scene.most_surfaces.unwrap_or(MOST_SURFACES),
        most_branches: (shared as u32).clamp(LEAST_BRANCHES, MOST_BRANCHES),
    };
    let mut given_up = GivenUp::default();
    for source in &scene.rays {
        if is_cancelled() {
            return given_up;
        }
        let ray = PoweredRay {
            ray: source.ray,
            starts_on: StartsOn::NOTHING,
            wavelength_nm: source.wavelength_nm,
            power: [0.5 * source.brightness; 2],
            surfaces: 0,
        };
        follow(&surfaces, ray, &limits, &mut given_up, &mut fly);
    }
    given_up
}
