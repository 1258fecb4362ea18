//! Sweep: the balls' path through a step, from impact to impact, each at its time of impact (event-driven simulation).
//!
//! Between impacts everything goes straight: a ball with its mean velocity up to the end of the step, a flipper with its
//! angular velocity. The earliest impact is found (rays against shapes inflated by the ball's radius, conservative
//! advancement for a turning flipper), everything advances to it, the bodies respond, and so on until the step is used
//! up.

use crate::solver::contact_constraint::ContactBody;
use crate::solver::step::{Step, StepTime};
use crate::solver::{
    constraint_projection, continuation, impact_candidate, impact_response, refinement, simultaneous_impacts,
};

/// Impacts that follow each other sooner than this, s, are simultaneous if there are many in a row: a Zeno sequence, in
/// which time does not go on.
const ZENO_S: f64 = 1e-6;
/// Impacts in a row that are no Zeno sequence yet: this many and two for each ball, more than in any chain of balls.
const ZENO_IMPACTS: usize = 4;
const ZENO_IMPACTS_PER_BALL: usize = 2;
/// Impacts in a step, at most: this many and eight for each ball.
const MAX_IMPACTS: usize = 16;
const MAX_IMPACTS_PER_BALL: usize = 8;

/// From impact to impact.
///
/// After very many impacts (a ball squeezed between moving things) the rest of the step is dropped: everything stands
/// still for less than a millisecond. A flipper that is in it is jammed and stops, or its coil would go on giving it
/// speed in a place where time does not pass.
pub(crate) fn run(step: &mut Step, duration: f64) {
    let mut left = duration;
    let balls = step.state.balls.len();
    let (mut impacts, mut in_a_row) = (0, 0);
    while impacts < MAX_IMPACTS + MAX_IMPACTS_PER_BALL * balls {
        let reach = step
            .buffers
            .ball_steps
            .iter()
            .filter_map(|ball_step| ball_step.acceleration.valid_for)
            .fold(left, f64::min);
        let candidate = impact_candidate::first(step, reach);
        let candidate = candidate.map(|candidate| refinement::refine(step, candidate, reach));
        let time = candidate.map_or(reach, |candidate| candidate.time);
        advance(step, time);
        left -= time;
        in_a_row = if time < ZENO_S { in_a_row + 1 } else { 0 };
        if let Some(candidate) = candidate {
            impacts += 1;
            let constraint = impact_response::respond(step, &candidate, StepTime { left, duration });
            continuation::resume(step, &candidate, constraint, left);
            if in_a_row > ZENO_IMPACTS + ZENO_IMPACTS_PER_BALL * balls {
                simultaneous_impacts::solve(step, left);
                in_a_row = 0;
            }
        } else if left <= 0.0 {
            return;
        }
        continue_slides(step, left);
    }
    for constraint in &step.buffers.constraints {
        if let ContactBody::Flipper(index) = constraint.body {
            step.state.mechanisms.flippers[index].speed = 0.0;
        }
    }
}

/// Moves everything on for `time`.
fn advance(step: &mut Step, time: f64) {
    step.elapsed += time;
    for index in 0..step.state.balls.len() {
        if step.state.balls[index].is_held() {
            continue;
        }
        let mean = step.mean_velocity(index, time);
        let acceleration = &mut step.buffers.ball_steps[index].acceleration;
        let ball = &mut step.state.balls[index];
        ball.center += mean * time;
        ball.velocity += acceleration.linear * time;
        ball.spin += acceleration.angular * time;
        acceleration.valid_for = acceleration.valid_for.map(|valid| valid - time);
    }
    let mechanisms = &mut step.state.mechanisms;
    for (flipper, _) in mechanisms.flippers.iter_mut().zip(step.detached).filter(|(_, detached)| !**detached) {
        flipper.advance(time);
    }
    for rod in &mut mechanisms.rods {
        rod.advance(time);
    }
}

/// New step accelerations for the balls whose slide has come to its next piece, or to its end.
fn continue_slides(step: &mut Step, left: f64) {
    for ball in 0..step.state.balls.len() {
        let is_over = step.buffers.ball_steps[ball].acceleration.valid_for.is_some_and(|time| time <= 0.0);
        if is_over && left > 0.0 {
            continuation::restart_acceleration(step, ball, left);
            constraint_projection::project(step, left);
        }
    }
}
