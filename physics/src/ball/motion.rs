//! How balls move between two hits.

use crate::ball::{Drive, Floor};
use crate::solver::contact_constraint::{Other, Touch};
use geometry::DVec2;

/// How a ball moves in what is left of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    pub drive: Drive,
    /// Gravity and everything else that acts from afar, m/s^2.
    pub pull: DVec2,
    /// What the playfield does to it here.
    pub floor: Floor,
    /// It lies on something: the step's pull is in its velocity already.
    pub settled: bool,
    /// Its velocity at the step's start.
    pub start: DVec2,
    /// What the playfield has given its lowest point in this step, m/s.
    pub rubbed: DVec2,
}

impl Motion {
    /// Of a ball that `pull` acts on, m/s^2.
    pub fn new(pull: DVec2, floor: Floor) -> Motion {
        Motion { drive: Drive::default(), pull, floor, settled: false, start: DVec2::ZERO, rubbed: DVec2::ZERO }
    }
}

/// Takes from the balls' drive what would push them into what they touch: what they are given away from it must be more
/// than `least`, m/s^2, which is below 0 where they part.
pub(crate) fn hold_back(touch: &Touch, least: f64, motions: &mut [Motion]) {
    motions[touch.ball].drive.lead = DVec2::ZERO;
    match touch.other {
        Other::Ball(other) => {
            let away = (motions[touch.ball].drive.velocity - motions[other].drive.velocity).dot(touch.normal);
            let missing = (least.min(0.0) - away).max(0.0);
            motions[touch.ball].drive.velocity += touch.normal * (0.5 * missing);
            motions[other].drive.velocity -= touch.normal * (0.5 * missing);
            motions[other].drive.lead = DVec2::ZERO;
        }
        _ => {
            let drive = &mut motions[touch.ball].drive.velocity;
            *drive += touch.normal * (least.min(0.0) - drive.dot(touch.normal)).max(0.0);
        }
    }
}
