//! Step: everything that moves by rays, for one step.

use crate::ball::ball_step::BallStep;
use crate::mechanisms::model::{Model, State};
use crate::part::event::{Contact, Event};
use crate::solver::clearance::Clearance;
use crate::solver::contact_constraint::{Bodies, ContactConstraint};
use crate::solver::near_balls::{self, NearBalls};
use crate::solver::{flipper_contact, resting_contacts, sweep};
use geometry::DVec2;

/// Restitution threshold, m/s: an approach slower than this is a contact and no impact, and nothing bounces (as in
/// Box2D).
pub(crate) const RESTITUTION_THRESHOLD_M_S: f64 = 5e-3;
/// A ball that parts faster than this from what it touches is not held by it, m/s.
pub(crate) const PARTING_THRESHOLD_M_S: f64 = 0.02;
/// A round of a contact solver that changes no speed by more than this was the last, m/s.
pub(crate) const SOLVER_TOLERANCE_M_S: f64 = 1e-8;

/// Buffers kept from step to step; they carry nothing over, but for the clearances within a tick.
#[derive(Clone, Debug, Default)]
pub(crate) struct StepBuffers {
    pub ball_steps: Vec<BallStep>,
    pub constraints: Vec<ContactConstraint>,
    /// In a tick of many steps the clearance of each ball at its start...
    pub clearances: Vec<Clearance>,
    /// ... and where the flippers were then, rad.
    pub flipper_angles: Vec<f64>,
    /// The mean velocity of each ball in what is left of a step, while the next impact is looked for.
    pub mean_velocities: Vec<DVec2>,
    /// Which balls are near each other in this step.
    pub near_balls: NearBalls,
    /// How often the impulse of a contact was found in this tick.
    pub contact_solves: u64,
}

/// A step in work.
pub(crate) struct Step<'a> {
    pub model: &'a Model,
    pub state: &'a mut State,
    pub buffers: &'a mut StepBuffers,
    pub events: &'a mut Vec<Event>,
    pub contacts: &'a mut Vec<Contact>,
    /// What has passed of the tick, s.
    pub elapsed: f64,
    /// The flippers that have turned already, out of every ball's reach.
    pub detached: &'a [bool],
}

/// How much of a step there is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepTime {
    /// What is left of it, s.
    pub left: f64,
    /// Its whole length, s.
    pub duration: f64,
}

impl Step<'_> {
    /// The bodies that impulses move.
    pub fn bodies(&mut self) -> Bodies<'_> {
        self.split().1
    }

    /// The buffers, and the bodies that impulses move.
    pub fn split(&mut self) -> (&mut StepBuffers, Bodies<'_>) {
        let bodies = Bodies {
            balls: &mut self.state.balls,
            flippers: &mut self.state.mechanisms.flippers,
            flipper_models: &self.model.mechanisms.flippers,
        };
        (self.buffers, bodies)
    }

    /// A ball's mean velocity over what is `left` of the step, m/s.
    pub fn mean_velocity(&self, ball: usize, left: f64) -> DVec2 {
        if self.state.balls[ball].is_held() {
            return DVec2::ZERO;
        }
        let acceleration = &self.buffers.ball_steps[ball].acceleration;
        self.state.balls[ball].velocity + acceleration.linear * (0.5 * left) + acceleration.mean_velocity_correction
    }
}

/// Advances everything by `duration`. The buffers' `ball_steps` hold what acts on each ball.
pub(crate) fn advance(step: &mut Step, duration: f64) {
    near_balls::find(step);
    resting_contacts::solve(step, duration);
    sweep::run(step, duration);
    flipper_contact::end_step(step, duration);
}
