//! Continuation: what holds the balls in the rest of a step, after an impact.

use crate::solver::constraint_projection;
use crate::solver::contact_constraint::ContactConstraint;
use crate::solver::impact_candidate::{Collider, ImpactCandidate};
use crate::solver::step::{PARTING_THRESHOLD_M_S, SOLVER_TOLERANCE_M_S, Step};

/// Persistence of a contact, m: when the ball has gone so far from where it touched, the contact says nothing any more.
const PERSISTENCE_M: f64 = 2e-4;
/// Rounds in which the contacts end their approaches after an impact.
const RELEASE_ROUNDS: usize = 8;

/// The contact that the impact has left joins those that the balls rest on, no approach is left in any of them, and the
/// balls that met get new step accelerations for what is `left`.
pub(crate) fn resume(step: &mut Step, candidate: &ImpactCandidate, constraint: ContactConstraint, left: f64) {
    keep(step, constraint);
    end_approaches(step);
    if left <= 0.0 {
        return;
    }
    restart_acceleration(step, candidate.ball, left);
    if let Collider::Ball(other) = candidate.collider {
        restart_acceleration(step, other, left);
    }
    constraint_projection::project(step, left);
}

/// Forgets the contacts that balls have left, and remembers this one, unless the ball parts or it is known.
fn keep(step: &mut Step, constraint: ContactConstraint) {
    let balls = &step.state.balls;
    let is_near =
        |own: &ContactConstraint| balls[own.ball].center.distance_squared(own.center) < PERSISTENCE_M * PERSISTENCE_M;
    step.buffers.constraints.retain(is_near);
    let rests = constraint.approach(&step.bodies()) > -PARTING_THRESHOLD_M_S;
    if rests && !step.buffers.constraints.iter().any(|known| known.is_same_contact(&constraint)) {
        step.buffers.constraints.push(constraint);
    }
}

fn end_approaches(step: &mut Step) {
    let (buffers, mut bodies) = step.split();
    for _ in 0..RELEASE_ROUNDS {
        buffers.contact_solves += buffers.constraints.len() as u64;
        let mut change: f64 = 0.0;
        for constraint in &mut buffers.constraints {
            constraint.release();
            change = change.max(constraint.solve_normal(&mut bodies, 0.0));
        }
        if change < SOLVER_TOLERANCE_M_S {
            break;
        }
    }
}

/// A new step acceleration for what is `left`, unless the ball rests: then all of the step's is in its velocity.
pub(crate) fn restart_acceleration(step: &mut Step, ball: usize, left: f64) {
    let ball_step = &mut step.buffers.ball_steps[ball];
    if !ball_step.resting && !step.state.balls[ball].is_held() {
        ball_step.acceleration = step.state.balls[ball].step_acceleration(&ball_step.floor, ball_step.external, left);
    }
}
