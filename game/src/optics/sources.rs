//! Light sources of a scene: the fixed list of rays that each one sends out.

use geometry::{DVec2, Ray, trig};
use std::f64::consts::TAU;

/// Angles nearer than this to the end of a range are its end, rad.
const ANGLE_SLACK: f64 = 1e-5;

/// Rays in all at most.
pub const MOST_RAYS: usize = 2_000_000;

/// What a scene says of its rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayDensity {
    /// Rays for each unit.
    pub density: f64,
    /// The length of a unit.
    pub length_scale: f64,
    /// Brightness is right in every mode: where a ray would be brighter than 1 there are more of them.
    pub correct_brightness: bool,
}

/// A ray of a source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SourceRay {
    pub ray: Ray,
    pub brightness: f64,
    pub wavelength_nm: f64,
}

/// A source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    Single { ray: Ray },
    Point { center: DVec2 },
    Angle { center: DVec2, towards: DVec2, angle: f64, symmetric: bool },
    Beam { from: DVec2, to: DVec2, angle: f64, lambert: bool },
}

impl RayDensity {
    /// The density at which no ray is brighter than 1, if that is asked for, and the brightness there.
    fn for_brightness(&self, brightness_at: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
        let mut density = self.density;
        let mut brightness = brightness_at(density);
        if self.correct_brightness {
            while brightness > 1.0 {
                density += 1.0 / 500.0;
                brightness = brightness_at(density);
                if density * 500.0 > MOST_RAYS as f64 {
                    return None;
                }
            }
        }
        Some((density, brightness.min(1.0)))
    }
}

impl Source {
    /// Its rays: `None` if they are too many.
    pub fn rays(&self, scene: &RayDensity, brightness: f64, wavelength_nm: f64) -> Option<Vec<SourceRay>> {
        let shining = |ray: Ray, brightness: f64| SourceRay { ray, brightness, wavelength_nm };
        let per_density = |density: f64| brightness / density;
        match *self {
            Source::Single { ray } => Some(vec![shining(ray, brightness)]),
            Source::Point { center } => {
                let (density, brightness) = scene.for_brightness(per_density)?;
                let angles = angles(0.0, TAU, step(density)?)?;
                let direction = |angle: f64| DVec2::new(libm::sin(angle), libm::cos(angle));
                let ray = |angle| shining(Ray { origin: center, direction: direction(angle) }, brightness);
                Some(angles.into_iter().map(ray).collect())
            }
            Source::Angle { center, towards, angle, symmetric } => {
                let (density, brightness) = scene.for_brightness(per_density)?;
                let (from, to) = if symmetric { (-0.5 * angle, 0.5 * angle) } else { (0.0, angle) };
                let middle = trig::angle(towards - center);
                let angles = angles(from, to, step(density)?)?;
                let ray = |angle: f64| {
                    shining(Ray { origin: center, direction: trig::direction(angle + middle) }, brightness)
                };
                Some(angles.into_iter().map(ray).collect())
            }
            Source::Beam { from, to, angle, lambert } => {
                beam([from, to], angle, lambert, scene, brightness, wavelength_nm)
            }
        }
    }
}

/// The angle from one ray to the next.
fn step(density: f64) -> Option<f64> {
    let count = (500.0 * density).trunc();
    (1.0..=MOST_RAYS as f64).contains(&count).then(|| TAU / count)
}

/// `from` and so on, step by step, short of `to`.
fn angles(from: f64, to: f64, step: f64) -> Option<Vec<f64>> {
    let mut angles = Vec::new();
    // Summed up, as the simulator does: the last bit of each angle is the sum's.
    let mut angle = from;
    while angle < to - ANGLE_SLACK {
        angles.push(angle);
        angle += step;
        if angles.len() > MOST_RAYS {
            return None;
        }
    }
    Some(angles)
}

/// Places along a line, and at each of them the straight ray and pairs that are turned to both sides.
fn beam(
    [from, to]: [DVec2; 2],
    angle: f64,
    lambert: bool,
    scene: &RayDensity,
    brightness: f64,
    wavelength_nm: f64,
) -> Option<Vec<SourceRay>> {
    let length = from.distance(to);
    let turn = |density: f64| TAU / (500.0 * density).trunc();
    let pairs = |density: f64| if angle > 0.0 { (0.5 * angle / turn(density)).floor() } else { 0.0 };
    let at = |density: f64| brightness * scene.length_scale / density / (1.0 + 2.0 * pairs(density));
    let (density, brightness) = scene.for_brightness(at)?;
    let places = length * density / scene.length_scale;
    let turned = if angle > 0.0 { step(density)? } else { 0.0 };
    if places * (1.0 + 2.0 * pairs(density)) > MOST_RAYS as f64 {
        return None;
    }
    let along = (to - from) / places;
    let straight = trig::angle((to - from).perp() * -1.0);
    let mut rays = Vec::new();
    let mut place = 0.5;
    while place <= places {
        let origin = from + along * place;
        let mut send = |angle: f64| {
            let brightness = if lambert { brightness * libm::cos(angle) } else { brightness };
            rays.push(SourceRay {
                ray: Ray { origin, direction: trig::direction(straight + angle) },
                brightness,
                wavelength_nm,
            });
        };
        send(0.0);
        let mut turn = turned;
        while angle > 0.0 && turn < 0.5 * angle {
            send(turn);
            send(-turn);
            turn += turned;
        }
        place += 1.0;
    }
    Some(rays)
}
