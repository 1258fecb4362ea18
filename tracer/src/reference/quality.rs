//! The judge of the exact light: point by point and picture by picture against many shadow rays.
//!
//! It asks the renderer as anybody would, and [`crate::monte_carlo`] for the truth. Where half of a lamp is seen and
//! where a point touches an outline is the hard case, so half of the points are chosen there.

use crate::film::tone_map;
use crate::realtime::exact_renderer::ExactRenderer;
use crate::reference::flip;
use crate::reference::monte_carlo::{self, Sampling};
use crate::scenes::white;
use crate::visibility::disc_chain::DiscChains;
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::scalar;
use crate::visibility::sphere_shadow::unoccluded_fraction;
use crate::{Ball, Frame, Lamp, Radiance, Scene, SimdLevel};
use geometry::DVec2;
use geometry::rng::SplitMix64;
use rayon::prelude::*;

/// Shadow rays to each lamp from each point.
pub const SAMPLES: u32 = 16_384;

/// The most that the light at points may be wrong, as the root of the mean square, linear light.
pub const MOST_RMSE: f64 = 1e-3;

/// The most that the light at any point may be wrong, linear light.
pub const MOST_DIFFERENCE: f64 = 0.02;

/// The most that a picture may look different, mean FLIP.
pub const MOST_FLIP: f64 = 0.005;

/// How much an exact picture is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Points that were compared.
    pub points: usize,
    /// Root of the mean square of the differences, linear light.
    pub rmse: f64,
    /// The largest difference, linear light.
    pub maximum: f64,
    /// Where that is, mm.
    pub place_mm: DVec2,
    /// Mean FLIP of a whole picture, if one was looked at.
    pub flip: Option<f64>,
}

impl Quality {
    /// Whether it is good enough. What is not a number is not.
    pub fn passes(&self) -> bool {
        self.rmse <= MOST_RMSE && self.maximum <= MOST_DIFFERENCE && self.flip.is_none_or(|flip| flip <= MOST_FLIP)
    }
}

/// Compares `count` points of `scene` on a white floor without tops, and the whole picture of `small` (the same scene in
/// fewer pixels, as a rule) if there is one.
pub fn judge(scene: &Scene, small: Option<&Scene>, count: usize, seed: u64) -> Quality {
    let floor = white(scene.view.width, scene.view.height);
    let bare = Scene {
        lamps: scene.lamps.clone(),
        occluders: scene.occluders.clone(),
        overhangs: scene.overhangs.clone(),
        tops: Vec::new(),
        balls: scene.balls.iter().copied().filter(Ball::is_airborne).collect(),
        glows: Vec::new(),
        floor: &floor,
        half_floor: None,
        ambient: [0.0; 3],
        ..*scene
    }
    .drawable();
    let mut radiance = Radiance::default();
    // What lies below a floating ball is judged too.
    ExactRenderer::on(SimdLevel::best()).render_table(&bare, &mut radiance);
    let sampling = Sampling { samples: SAMPLES, seed, stratified: true };
    let pixels = choose(&bare, count, seed);
    let differences = pixels.par_iter().map(|&(x, y)| {
        let point = bare.view.table_from_pixel(x, y);
        let expected = monte_carlo::irradiance(&bare, point, None, sampling);
        let got = radiance.pixel(x, y);
        ([0, 1, 2].map(|channel| f64::from(got[channel]) - f64::from(expected[channel])), point)
    });
    let differences: Vec<([f64; 3], DVec2)> = differences.collect();
    let mut quality = Quality { points: pixels.len(), rmse: 0.0, maximum: 0.0, place_mm: DVec2::ZERO, flip: None };
    quality.flip = small.map(|scene| look(scene, sampling));
    for (difference, place) in differences.iter().flat_map(|(all, place)| all.map(|one| (one, *place))) {
        quality.rmse += difference * difference;
        if difference.is_nan() || difference.abs() > quality.maximum {
            (quality.maximum, quality.place_mm) = (difference.abs(), place);
        }
    }
    quality.rmse = (quality.rmse / (3 * pixels.len()).max(1) as f64).sqrt();
    quality
}

/// The mean FLIP between the exact picture and the sampled one.
fn look(scene: &Scene, sampling: Sampling) -> f64 {
    let mut radiance = Radiance::default();
    let mut frames = [Frame::default(), Frame::default()];
    monte_carlo::render(scene, sampling, &mut radiance);
    tone_map::map(&radiance, 1.0, &mut frames[0]);
    ExactRenderer::on(SimdLevel::best()).render(scene, &mut radiance);
    tone_map::map(&radiance, 1.0, &mut frames[1]);
    flip::mean(&frames[0], &frames[1])
}

/// Pixels of the scene: half of them anywhere, half where it is hard, as far as there are such.
fn choose(scene: &Scene, count: usize, seed: u64) -> Vec<(usize, usize)> {
    let mut random = SplitMix64::new(seed);
    let (width, height) = (scene.view.width, scene.view.height);
    let mut pixel = || {
        let place = random.point_within(DVec2::new(width as f64, height as f64));
        (place.x as usize, place.y as usize)
    };
    let mut pixels: Vec<(usize, usize)> = (0..count / 2).map(|_| pixel()).collect();
    let hard = Hard::new(scene);
    let tries: Vec<(usize, usize)> = (0..count * 40).map(|_| pixel()).collect();
    let is_hard = |&(x, y): &(usize, usize)| hard.is(scene.view.table_from_pixel(x, y));
    pixels.extend(tries.into_iter().filter(is_hard).take(count - count / 2));
    pixels
}

/// Knows where the light of a scene is hard to find.
struct Hard<'a> {
    scene: &'a Scene<'a>,
    disc_chains: DiscChains,
    lamps: Vec<(Lamp, PotentialOccluders)>,
}

impl<'a> Hard<'a> {
    fn new(scene: &'a Scene<'a>) -> Hard<'a> {
        let mut disc_chains = DiscChains::default();
        disc_chains.set(&scene.occluders);
        let lamp = |lamp: &Lamp| {
            let mut potential_occluders = PotentialOccluders::default();
            potential_occluders.set(lamp, &disc_chains);
            (*lamp, potential_occluders)
        };
        let lamps = scene.lamps.iter().filter(|lamp| lamp.shines()).map(lamp).collect();
        Hard { scene, disc_chains, lamps }
    }

    /// Whether a point is within a pixel of an outline, or sees some lamp in part.
    fn is(&self, point: DVec2) -> bool {
        let near = self.scene.view.mm_per_px;
        let touches = self.scene.occluders.iter().any(|occluder| occluder.shape.distance(point).0.abs() < near);
        touches
            || self.lamps.iter().any(|(lamp, potential_occluders)| {
                let seen = || {
                    let room = &mut Vec::new();
                    let open = unoccluded_fraction(&self.scene.balls, lamp, point, None);
                    open * scalar::visible_fraction_of(&self.disc_chains, potential_occluders, lamp, point, &[], room)
                };
                lamp.falloff(point) > 0.0 && (0.01..0.99).contains(&seen())
            })
    }
}
