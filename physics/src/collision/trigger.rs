//! Trigger: a region in which a ball's centre closes a switch, and which stops no ball.

use crate::part::PartId;
use geometry::{DVec2, Ray, Shape};

/// A region that the ball's centre may be in.
#[derive(Clone, Debug)]
pub(crate) struct Trigger {
    pub part: PartId,
    pub shape: Shape,
    pub kind: TriggerKind,
}

/// What a trigger is for; the index counts the parts of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TriggerKind {
    Rollover(usize),
    Drain,
    Saucer(usize),
    /// Near the flap of this gate.
    Gate(usize),
    /// Near the plate of this spinner.
    Spinner(usize),
}

impl Trigger {
    /// Whether a ball's centre at `center` is in it.
    pub fn contains(&self, center: DVec2) -> bool {
        self.shape.distance(center).0 <= 0.0
    }

    /// Whether a ball's centre that has gone straight from `start` to `center` has come into it on the way.
    pub fn is_crossed(&self, start: DVec2, center: DVec2) -> bool {
        let hit = Ray::towards(start, center).and_then(|ray| self.shape.cast(&ray));
        hit.is_some_and(|hit| hit.distance <= start.distance(center))
    }
}
