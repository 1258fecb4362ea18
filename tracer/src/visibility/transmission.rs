//! Transmission: light through tinted occluders, exactly, whatever of them, of walls and of penumbrae overlap.
//!
//! 1. One ray: its transmittance is the product of those of the tinted groups that it meets, or 0 where it meets a wall.
//! 2. Read a transmittance as a chance: each group is away with that probability, and as opaque as a wall otherwise. The
//!    expectation of a ray's visibility is the product of step 1. (E. Enderton, E. Sintorn, P. Shirley, D. Luebke,
//!    "Stochastic transparency", 2010, sample this expectation.)
//! 3. The expectation of the visible fraction is the sum over all sets R of groups that are away: `U(R)`, the visible
//!    fraction without the groups of R, times the chance of R, which is the product of the transmittances in R and of 1
//!    less those of the others. Multiplied out, it is inclusion and exclusion.
//!
//! The sum has 2^n terms, and each is as exact as the visible fraction is.

use crate::{Group, Occluder, Rgb};

/// The most tinted groups between one lamp and one tile; further ones are opaque there. Sixteen visibility queries are
/// enough.
pub(crate) const MAX_TINTED: usize = 4;

/// A group that light passes, tinted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TintedGroup {
    pub group: Group,
    /// What passes of each colour, 0 to 1.
    pub transmittance: Rgb,
}

/// The tinted groups of a scene. They are in the order of the groups' numbers, so that sums over them have the same bits
/// whatever order the occluders are in.
pub(crate) fn find_tinted(occluders: &[Occluder], tinted: &mut Vec<TintedGroup>) {
    tinted.clear();
    for Occluder { group, material, .. } in occluders {
        if let Some(transmittance) = material.transmittance() {
            tinted.push(TintedGroup { group: *group, transmittance });
        }
    }
    tinted.sort_unstable_by_key(|tinted| tinted.group);
    tinted.dedup_by_key(|tinted| tinted.group);
}

/// The tinted groups between a lamp and a point or a tile.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OnPath {
    groups: [TintedGroup; MAX_TINTED],
    count: usize,
}

impl OnPath {
    /// The groups.
    pub fn as_slice(&self) -> &[TintedGroup] {
        &self.groups[..self.count]
    }
}

/// The first tinted groups that are there.
pub(crate) fn on_path(tinted: &[TintedGroup], is_there: impl Fn(Group) -> bool) -> OnPath {
    let none = TintedGroup { group: Group(0), transmittance: [0.0; 3] };
    let mut on_path = OnPath { groups: [none; MAX_TINTED], count: 0 };
    for tinted in tinted.iter().filter(|tinted| is_there(tinted.group)).take(MAX_TINTED) {
        on_path.groups[on_path.count] = *tinted;
        on_path.count += 1;
    }
    on_path
}

/// Calls `work` for every set of groups that may be taken away, the empty one first, with the groups and the part of the
/// light, by channel, that counts with them away.
pub(crate) fn each_subset(on_path: &[TintedGroup], mut work: impl FnMut(&[Group], Rgb)) {
    for set in 0..1usize << on_path.len() {
        let (mut groups, mut count) = ([Group(0); MAX_TINTED], 0);
        let mut part = [1.0; 3];
        for (at, TintedGroup { group, transmittance }) in on_path.iter().enumerate() {
            let away = set >> at & 1 == 1;
            for channel in 0..3 {
                part[channel] *= if away { transmittance[channel] } else { 1.0 - transmittance[channel] };
            }
            if away {
                groups[count] = *group;
                count += 1;
            }
        }
        work(&groups[..count], part);
    }
}

/// The transmitted fraction of each channel; `seen` is the visible fraction without some groups.
pub(crate) fn transmitted(on_path: &[TintedGroup], mut seen: impl FnMut(&[Group]) -> f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    each_subset(on_path, |away, part| {
        let seen = seen(away);
        for channel in 0..3 {
            sum[channel] += f64::from(part[channel]) * seen;
        }
    });
    sum
}
