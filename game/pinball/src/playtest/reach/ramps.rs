//! Ramps that a ball can come onto: through an end that lies on the playfield, or from a ramp that is joined to it.

use super::{Flood, Reach};
use geometry::{DVec2, Shape};
use physics::{BALL_RADIUS_M, Kind, PartId, Ramp};

/// An end of a ramp that is no higher lies on the playfield, m.
const LOW_M: f64 = 1e-3;

impl Reach {
    /// Whether a ball can come onto this ramp.
    pub fn comes_onto(&self, part: PartId) -> bool {
        self.ramps.contains(&part)
    }

    /// Adds what a ball can come to over ramps.
    pub(super) fn follow_ramps(&mut self, flood: &mut Flood) {
        let parts = flood.machine.layout().parts.iter().enumerate();
        let ramps = parts.filter_map(|(index, part)| Some((PartId(index as u16), ramp(&part.kind)?)));
        let mut ramps: Vec<(PartId, &Ramp)> = ramps.collect();
        let joints = flood.machine.ramp_joints();
        let goes_over =
            |reach: &Reach, part: PartId| joints.iter().any(|(from, onto)| *onto == part && reach.comes_onto(*from));
        // A ramp may lead to another one.
        while let Some(index) = ramps.iter().position(|(part, ramp)| self.rolls_onto(ramp) || goes_over(self, *part)) {
            let (part, ramp) = ramps.swap_remove(index);
            self.ramps.push(part);
            ends(ramp).into_iter().for_each(|end| self.flood(flood, end));
        }
    }

    /// Whether a ball can roll into one of the ramp's ends that lie on the playfield.
    fn rolls_onto(&self, ramp: &Ramp) -> bool {
        let outside = |(middle, inward): (DVec2, DVec2)| middle - inward * BALL_RADIUS_M;
        low_ends(ramp).into_iter().any(|end| self.comes_to(&Shape::disc(outside(end), ramp.half_width_m), 0.0))
    }
}

/// The ramp that this kind is, if it is one.
pub fn ramp(kind: &Kind) -> Option<&Ramp> {
    match kind {
        Kind::Ramp(ramp) => Some(ramp),
        _ => None,
    }
}

/// The ramp's ends that lie on the playfield: the middle of each, and the way into the ramp.
pub fn low_ends(ramp: &Ramp) -> Vec<(DVec2, DVec2)> {
    let first = ramp.path.first().map(|leg| (leg.at(0.0), leg.direction_at(0.0)));
    let last = ramp.path.last().map(|leg| (leg.at(leg.length()), -leg.direction_at(leg.length())));
    let low = |height: Option<&f64>| height.is_some_and(|height| *height <= LOW_M);
    let first = first.filter(|_| low(ramp.heights_m.first()));
    first.into_iter().chain(last.filter(|_| low(ramp.heights_m.last()))).collect()
}

/// Places just outside of the ramp's two ends.
fn ends(ramp: &Ramp) -> Vec<DVec2> {
    let first = ramp.path.first().map(|leg| leg.at(0.0) - leg.direction_at(0.0) * BALL_RADIUS_M);
    let last = ramp.path.last().map(|leg| {
        let length = leg.length();
        leg.at(length) + leg.direction_at(length) * BALL_RADIUS_M
    });
    first.into_iter().chain(last).collect()
}
