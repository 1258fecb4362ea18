//! Light through translucent things, exactly.
//!
//! What a point sees of a lamp through filters is a sum over the sets of filters that are taken away: with `U(R)` the
//! visible fraction without the filters of `R`, and the others as opaque as walls, the light that passes is the sum of
//! `U(R) * (product of the tints in R) * (product of 1 - tint of the others)`. That is inclusion and exclusion, put in
//! order, and as exact as `U` for any overlap of filters, walls and shadow bounds.

use crate::{Filter, Group, Rgb};

/// Filters that are told apart on one way from a lamp; further ones are opaque there.
pub(crate) const MAX_FILTERS: usize = 4;

/// The filters on a way.
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

/// What passes of each channel; `seen` is the visible fraction without some groups.
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
