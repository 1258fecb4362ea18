//! Ball step: how a ball moves within a step: the external accelerations, the floor, and what the step's solver gives it.

use crate::ball::floor::Floor;
use crate::ball::step_acceleration::StepAcceleration;
use geometry::DVec2;

/// How a ball moves in what is left of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BallStep {
    /// How velocity and spin change until the step's end.
    pub acceleration: StepAcceleration,
    /// Gravity and everything else that acts from afar, m/s^2.
    pub external: DVec2,
    /// The floor below the ball.
    pub floor: Floor,
    /// The ball rests on something: the step's external acceleration is in its velocity already.
    pub resting: bool,
    /// Its velocity at the step's start, m/s.
    pub start_velocity: DVec2,
    /// Impulse over mass that the floor's friction has given its lowest point in this step, m/s.
    pub floor_impulse: DVec2,
}

impl BallStep {
    /// A free ball on which this external acceleration acts, m/s^2.
    pub fn new(external: DVec2, floor: Floor) -> BallStep {
        BallStep {
            acceleration: StepAcceleration::default(),
            external,
            floor,
            resting: false,
            start_velocity: DVec2::ZERO,
            floor_impulse: DVec2::ZERO,
        }
    }
}
