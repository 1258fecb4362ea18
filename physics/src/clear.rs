//! Room round a ball: how far away all that stands still is at least, so that nothing is asked again at every step.

use crate::ball::Ball;
use crate::plan::Plan;
use geometry::DVec2;

/// How far is looked, m: a ball hardly goes farther in a tick.
const LOOK_M: f64 = 0.01;
/// Far above rounding, far below anything else, m.
const ROUNDING_M: f64 = 1e-9;

/// Where a ball was, and the room that it had there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clear {
    center: DVec2,
    track: Option<u16>,
    /// No obstacle is nearer to touching than this, m.
    room: f64,
}

impl Clear {
    /// The room round a ball, looked for up to [`LOOK_M`].
    pub fn around(plan: &Plan, ball: &Ball) -> Clear {
        let Ball { center, track, .. } = *ball;
        let mut room = LOOK_M;
        plan.near(track, center - LOOK_M, center + LOOK_M, |index| {
            room = room.min(plan.obstacles[index].shape.distance(center).0);
        });
        Clear { center, track, room }
    }

    /// Whether no obstacle is within `reach` of touching a ball that is at `center` now.
    pub fn holds(&self, track: Option<u16>, center: DVec2, reach: f64) -> bool {
        self.track == track && center.distance(self.center) + reach + ROUNDING_M < self.room
    }
}
