//! Resting contacts: the speeds of balls that rest on something, at the start of a step.
//!
//! Gravity, the floor's friction and every contact act together, so that stacks, wedges and a ball on a flipper find
//! their common speeds: sequential impulses with accumulation (Catto, Iterative Dynamics with Temporal Coherence, 2005).

use crate::solver::contact_constraint::ContactBody;
use crate::solver::contact_detection;
use crate::solver::flipper_contact;
use crate::solver::step::{SOLVER_TOLERANCE_M_S, Step};
use geometry::DVec2;

/// Rounds of the solver over all contacts, at most.
const SOLVER_ROUNDS: usize = 24;
/// How often the speeds are checked against where they lead on a turning flipper.
const LOOKAHEAD_ROUNDS: usize = 4;
/// The part of a slip that an impulse against it takes of the velocity: `I / (I + m r^2)` of a solid sphere.
const FLOOR_SLIP_SHARE: f64 = 2.0 / 7.0;
/// The sine of an angle by which two directions differ that are the same but for rounding.
const SAME_DIRECTION_SIN: f64 = 1e-9;

/// Finds the contacts, and the step accelerations: of a free ball at once, of a resting ball by the solver.
pub(crate) fn solve(step: &mut Step, duration: f64) {
    contact_detection::detect(step, duration);
    mark_resting(step);
    start(step, duration);
    if !step.buffers.constraints.is_empty() {
        for _ in 0..LOOKAHEAD_ROUNDS {
            solve_contacts(step, duration);
            if !flipper_contact::look_ahead(step, duration) {
                break;
            }
        }
        resist(step, duration);
        spread(step, duration);
    }
}

fn mark_resting(step: &mut Step) {
    for constraint in &step.buffers.constraints {
        step.buffers.ball_steps[constraint.ball].resting = true;
        if let ContactBody::Ball(other) = constraint.body {
            step.buffers.ball_steps[other].resting = true;
        }
    }
}

/// A resting ball gets the step's external acceleration at once; a free ball its step acceleration.
fn start(step: &mut Step, duration: f64) {
    for (ball, ball_step) in step.state.balls.iter_mut().zip(&mut step.buffers.ball_steps) {
        if ball.is_held() {
            continue;
        } else if ball_step.resting {
            ball_step.start_velocity = ball.velocity;
            ball.velocity += ball_step.external * duration;
        } else {
            ball_step.acceleration = ball.step_acceleration(&ball_step.floor, ball_step.external, duration);
        }
    }
}

/// Round after round over the floor's friction and all contacts, until nothing changes.
fn solve_contacts(step: &mut Step, duration: f64) {
    let (buffers, mut bodies) = step.split();
    for _ in 0..SOLVER_ROUNDS {
        buffers.contact_solves += buffers.constraints.len() as u64;
        let mut change: f64 = 0.0;
        for (ball, ball_step) in bodies.balls.iter_mut().zip(&mut buffers.ball_steps) {
            if ball_step.resting && !ball.is_held() {
                // Coulomb: the sum of the step's floor impulses stays within the friction cone.
                let cone = ball_step.floor.friction * ball_step.floor.normal_load * duration;
                let wanted = (ball_step.floor_impulse - ball.floor_slip() * FLOOR_SLIP_SHARE).clamp_length_max(cone);
                ball.apply_floor_impulse(wanted - ball_step.floor_impulse);
                ball_step.floor_impulse = wanted;
            }
        }
        for constraint in &mut buffers.constraints {
            change = change.max(constraint.solve_normal(&mut bodies, constraint.parting_speed).abs());
            constraint.solve_friction(&mut bodies);
        }
        if change < SOLVER_TOLERANCE_M_S {
            break;
        }
    }
}

fn resist(step: &mut Step, duration: f64) {
    for (ball, ball_step) in step.state.balls.iter_mut().zip(&step.buffers.ball_steps) {
        if ball_step.resting && !ball.is_held() {
            ball.apply_rolling_resistance(&ball_step.floor, duration);
        }
    }
}

/// Spreads what the step has given evenly over it: a ball that rolls along something gains its speed evenly, and its
/// path is that of the mean.
///
/// Only what is along a body that stands still is spread; the rest is given at once, or the ball would go into the body
/// before the contact's impulse is there.
fn spread(step: &mut Step, duration: f64) {
    for (ball, ball_step) in step.state.balls.iter_mut().zip(&mut step.buffers.ball_steps) {
        if ball_step.resting && !ball.is_held() {
            ball_step.acceleration.linear = (ball.velocity - ball_step.start_velocity) / duration;
        }
    }
    keep_along_still_bodies(step);
    drop_in_corners(step);
    for (ball, ball_step) in
        step.state.balls.iter_mut().zip(&step.buffers.ball_steps).filter(|(_, ball_step)| ball_step.resting)
    {
        ball.velocity -= ball_step.acceleration.linear * duration;
    }
}

fn keep_along_still_bodies(step: &mut Step) {
    for constraint in &step.buffers.constraints {
        let still = match constraint.body {
            ContactBody::Fixed(velocity) => velocity == DVec2::ZERO,
            ContactBody::Flipper(index) => step.state.mechanisms.flippers[index].seated,
            ContactBody::Ball(other) => {
                step.buffers.ball_steps[other].acceleration.linear = DVec2::ZERO;
                false
            }
        };
        let gain = &mut step.buffers.ball_steps[constraint.ball].acceleration.linear;
        *gain = if still { gain.project_onto_normalized(constraint.normal.perp()) } else { DVec2::ZERO };
    }
}

/// There is no direction along both walls of a corner.
fn drop_in_corners(step: &mut Step) {
    for constraint in &step.buffers.constraints {
        let gain = &mut step.buffers.ball_steps[constraint.ball].acceleration.linear;
        if gain.dot(constraint.normal).abs() > SAME_DIRECTION_SIN * gain.length() {
            *gain = DVec2::ZERO;
        }
    }
}
