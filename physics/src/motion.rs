//! How balls move between two hits.

use crate::ball::{Drive, Floor};
use crate::touch::{Other, Touch};
use geometry::DVec2;

/// How a ball moves in what is left of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    pub drive: Drive,
    /// Gravity and everything else that acts from afar, m/s^2.
    pub pull: DVec2,
    /// What the playfield does to it here.
    pub floor: Floor,
    /// The step's pull is in its velocity already.
    pub settled: bool,
}

impl Motion {
    /// Of a ball that `pull` acts on, m/s^2.
    pub fn new(pull: DVec2, floor: Floor) -> Motion {
        Motion { drive: Drive::default(), pull, floor, settled: false }
    }
}

/// Takes from the balls' drive what would push them into what they touch.
pub(crate) fn hold_back(touch: &Touch, motions: &mut [Motion]) {
    match touch.other {
        Other::Ball(other) => {
            let into = (motions[touch.ball].drive.velocity - motions[other].drive.velocity).dot(touch.normal);
            if into < 0.0 {
                motions[touch.ball].drive.velocity -= touch.normal * (0.5 * into);
                motions[other].drive.velocity += touch.normal * (0.5 * into);
            }
        }
        _ => {
            let drive = &mut motions[touch.ball].drive.velocity;
            *drive -= touch.normal * drive.dot(touch.normal).min(0.0);
        }
    }
}
