//! One-way gates: against its direction a ball comes through none.

use geometry::{DVec2, Segment};
use physics::{BALL_RADIUS_M, Kind, Layout};

/// The flaps of a table.
#[derive(Default)]
pub struct OneWayGates(Vec<Flap>);

struct Flap {
    segment: Segment,
    /// Of its free way.
    direction: DVec2,
}

impl OneWayGates {
    /// All of the layout's gates. A spinner lets a ball through both ways and is none.
    pub fn new(layout: &Layout) -> OneWayGates {
        let flaps = layout.parts.iter().filter_map(|part| match &part.kind {
            Kind::Gate(own) => Some(Flap { segment: own.segment, direction: own.direction }),
            _ => None,
        });
        OneWayGates(flaps.collect())
    }

    /// Whether a flap stops the centre of a ball on its way between two places that are near each other.
    pub fn stop(&self, from: DVec2, to: DVec2) -> bool {
        self.0.iter().any(|flap| flap.stops(from, to))
    }
}

impl Flap {
    fn stops(&self, from: DVec2, to: DVec2) -> bool {
        let beyond = |place: DVec2| (place - self.segment.a).dot(self.direction);
        let (before, after) = (beyond(from), beyond(to));
        if before <= 0.0 || after > 0.0 {
            return false;
        }
        // Past the flap's end a ball that is nearer to it than its radius touches it all the same.
        let crossing = from.lerp(to, before / (before - after));
        crossing.distance(self.segment.closest(crossing)) < BALL_RADIUS_M
    }
}
