//! Constraint projection: takes from the balls' accelerations what would press them together or into what they rest on
//! before the step ends.

use crate::ball::ball_step::BallStep;
use crate::solver::contact_constraint::{ContactBody, ContactConstraint};
use crate::solver::step::Step;
use geometry::DVec2;

/// Rounds over all contacts: the second mends what the first did to a ball that touches two things.
const PROJECTION_ROUNDS: usize = 2;

/// Projects the accelerations of all balls onto what their contacts allow in what is `left` of the step.
pub(crate) fn project(step: &mut Step, left: f64) {
    let (buffers, bodies) = step.split();
    for _ in 0..PROJECTION_ROUNDS {
        buffers.contact_solves += buffers.constraints.len() as u64;
        for constraint in &buffers.constraints {
            project_contact(constraint, constraint.approach(&bodies) / left, &mut buffers.ball_steps);
        }
    }
}

/// The acceleration away from the contact must be more than `least`, m/s^2, which is below 0 where the two part.
fn project_contact(constraint: &ContactConstraint, least: f64, ball_steps: &mut [BallStep]) {
    ball_steps[constraint.ball].acceleration.mean_velocity_correction = DVec2::ZERO;
    match constraint.body {
        ContactBody::Ball(other) => {
            let relative = ball_steps[constraint.ball].acceleration.linear - ball_steps[other].acceleration.linear;
            let missing = (least.min(0.0) - relative.dot(constraint.normal)).max(0.0);
            ball_steps[constraint.ball].acceleration.linear += constraint.normal * (0.5 * missing);
            ball_steps[other].acceleration.linear -= constraint.normal * (0.5 * missing);
            ball_steps[other].acceleration.mean_velocity_correction = DVec2::ZERO;
        }
        _ => {
            let linear = &mut ball_steps[constraint.ball].acceleration.linear;
            *linear += constraint.normal * (least.min(0.0) - linear.dot(constraint.normal)).max(0.0);
        }
    }
}
