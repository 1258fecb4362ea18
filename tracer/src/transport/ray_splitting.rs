//! Rays that divide: a given list of rays, each followed along all its branches, without chance.
//!
//! A ray carries the power of s and of p polarized light apart. Where surfaces divide it, both parts go on, until what is left is
//! too little or has met too many surfaces: what is given up so is summed up, never lost in silence.

use super::interaction::{Branch, Interaction, interact};
use super::{StartsOn, Surfaces};
use geometry::Ray;

/// A ray with its power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoweredRay {
    /// Where it is, and which way it goes.
    pub ray: Ray,
    /// The edges that it comes from.
    pub starts_on: StartsOn,
    /// Its wavelength, nm.
    pub wavelength_nm: f64,
    /// s and p.
    pub power: [f64; 2],
    /// Surfaces that it has met.
    pub surfaces: u32,
}

/// When rays are given up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplitLimits {
    /// With less power than this.
    pub least_power: f64,
    /// After so many surfaces.
    pub most_surfaces: u32,
    /// After so many branches of one ray in all.
    pub most_branches: u32,
}

/// What was given up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenUp {
    /// Rays with too little power.
    pub weak: f64,
    /// Rays that have met too many surfaces, or were too many.
    pub long: f64,
}

/// Follows a ray and its branches; `fly` sees each with how far it goes, infinite if it meets nothing more. A matt surface ends
/// a ray: it has no list of directions.
pub fn follow(
    surfaces: &Surfaces,
    ray: PoweredRay,
    limits: &SplitLimits,
    given_up: &mut GivenUp,
    mut fly: impl FnMut(&PoweredRay, f64),
) {
    let mut open = vec![ray];
    let mut branches = 0;
    while let Some(ray) = open.pop() {
        let power = ray.power[0] + ray.power[1];
        if power < limits.least_power {
            given_up.weak += power;
            continue;
        }
        if ray.surfaces > limits.most_surfaces || branches >= limits.most_branches {
            given_up.long += power;
            continue;
        }
        branches += 1;
        let contacts = surfaces.meet(&ray.ray, &ray.starts_on);
        fly(&ray, contacts.as_ref().map_or(f64::INFINITY, |contacts| contacts.first().distance));
        let Some(contacts) = contacts else { continue };
        let mut smooth = |normal, _| normal;
        let interaction = interact(surfaces, &contacts, ray.ray.direction, ray.wavelength_nm, &mut smooth);
        let Interaction::Split { reflected, transmitted } = interaction else { continue };
        let goes_on = |branch: Branch| PoweredRay {
            ray: Ray { origin: contacts.first().place, direction: branch.direction },
            starts_on: contacts.starts_on(),
            power: [0, 1].map(|way| ray.power[way] * branch.power[way]),
            surfaces: ray.surfaces + 1,
            ..ray
        };
        open.extend([reflected, transmitted].into_iter().flatten().map(goes_on));
    }
}
