//! Transmission: light through translucent occluders (filters), exactly, whatever of filters, walls and penumbrae
//! overlap.
//!
//! 1. One ray: its transmittance is the product of the tints of the filters that it meets, or 0 where it meets a wall.
//! 2. Read a tint as a chance: each filter is away with the probability `tint`, and as opaque as a wall otherwise. The
//!    expectation of a ray's visibility is the product of step 1. (E. Enderton, E. Sintorn, P. Shirley, D. Luebke,
//!    "Stochastic transparency", 2010, sample this expectation.)
//! 3. The expectation of the visible fraction is the sum over all sets R of filters that are away: `U(R)`, the visible
//!    fraction without the filters of R, times the chance of R, which is the product of the tints in R and of `1 -
//!    tint` of the others. Multiplied out, it is inclusion and exclusion.
//!
//! The sum has 2^n terms, and each is as exact as the visible fraction is.

use crate::{Filter, Group, Rgb};

/// The most filters between one lamp and one tile; further ones are opaque there. Sixteen visibility queries are
/// enough.
pub(crate) const MAX_FILTERS: usize = 4;

/// The filters between a lamp and a point or a tile.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OnPath {
    filters: [Filter; MAX_FILTERS],
    count: usize,
}

impl OnPath {
    /// The filters.
    pub fn as_slice(&self) -> &[Filter] {
        &self.filters[..self.count]
    }
}

/// The first filters whose group `is_there`.
pub(crate) fn on_path(filters: &[Filter], is_there: impl Fn(Group) -> bool) -> OnPath {
    let mut on_path = OnPath { filters: [Filter { group: Group(0), tint: [0.0; 3] }; MAX_FILTERS], count: 0 };
    for filter in filters.iter().filter(|filter| is_there(filter.group)).take(MAX_FILTERS) {
        on_path.filters[on_path.count] = *filter;
        on_path.count += 1;
    }
    on_path
}

/// Calls `work` for every set of filters that may be taken away, the empty one first, with their groups and the part of
/// the light, by channel, that counts with them away.
pub(crate) fn each_subset(on_path: &[Filter], mut work: impl FnMut(&[Group], Rgb)) {
    for set in 0..1usize << on_path.len() {
        let (mut groups, mut count) = ([Group(0); MAX_FILTERS], 0);
        let mut part = [1.0; 3];
        for (at, filter) in on_path.iter().enumerate() {
            let away = set >> at & 1 == 1;
            for channel in 0..3 {
                part[channel] *= if away { filter.tint[channel] } else { 1.0 - filter.tint[channel] };
            }
            if away {
                groups[count] = filter.group;
                count += 1;
            }
        }
        work(&groups[..count], part);
    }
}

/// The transmitted fraction of each channel; `seen` is the visible fraction without some groups.
pub(crate) fn transmitted(on_path: &[Filter], mut seen: impl FnMut(&[Group]) -> f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    each_subset(on_path, |away, part| {
        let seen = seen(away);
        for channel in 0..3 {
            sum[channel] += f64::from(part[channel]) * seen;
        }
    });
    sum
}
