//! Flipper contacts: a ball that a turning flipper pushes.
//!
//! The flipper's surface bends away from the straight path of the ball, and the flipper's speed at a step's end is not
//! its mean: both are made up for here.

use crate::BALL_RADIUS_M;
use crate::collision::world::SKIN_M;
use crate::solver::contact_constraint::{ContactBody, ContactConstraint, Touching};
use crate::solver::contact_detection::OVERLAP_SLOP_M;
use crate::solver::step::{RESTITUTION_THRESHOLD_M_S, Step};

/// An error of this speed in where the two lead does not matter, m/s.
const LOOKAHEAD_TOLERANCE_M_S: f64 = 1e-5;
/// A pushed ball that is nearer than the slop gets so much of what is missing in a step.
const SLOP_PART: f64 = 0.2;

/// The two must part with just the speed that leaves them as near at the step's end as they are at its start: that speed
/// becomes the contact's parting speed. True if that changes anything.
pub(crate) fn look_ahead(step: &mut Step, duration: f64) -> bool {
    let mut changed = false;
    for constraint in &mut step.buffers.constraints {
        let ContactBody::Flipper(index) = constraint.body else { continue };
        let (flipper, model) = (&step.state.mechanisms.flippers[index], &step.model.mechanisms.flippers[index]);
        if flipper.speed == 0.0 {
            continue;
        }
        let ball = &step.state.balls[constraint.ball];
        let now = model.outline(flipper.angle).distance(ball.center).0 - BALL_RADIUS_M;
        let outline = model.outline(flipper.angle + flipper.speed * duration);
        let then = outline.distance(ball.center + ball.velocity * duration).0 - BALL_RADIUS_M;
        let wanted = if now < OVERLAP_SLOP_M { now + SLOP_PART * (OVERLAP_SLOP_M - now) } else { now };
        let missing = (wanted - then) / duration;
        if missing > LOOKAHEAD_TOLERANCE_M_S {
            constraint.parting_speed += missing;
            changed = true;
        }
    }
    changed
}

/// The flippers get the speed that they have at the step's end, and the balls that they push take their part of it: an
/// impact without restitution.
pub(crate) fn end_step(step: &mut Step, duration: f64) {
    for (index, model) in step.model.mechanisms.flippers.iter().enumerate() {
        if !step.detached[index] {
            model.end_step(&mut step.state.mechanisms.flippers[index]);
        }
    }
    for at in 0..step.buffers.constraints.len() {
        let ContactConstraint { ball, body, .. } = step.buffers.constraints[at];
        let ContactBody::Flipper(index) = body else { continue };
        let (model, flipper) = (&step.model.mechanisms.flippers[index], &step.state.mechanisms.flippers[index]);
        let own = &step.state.balls[ball];
        let (center, friction) = (own.center, step.buffers.constraints[at].friction());
        let (distance, normal) = model.outline(flipper.angle).distance(center);
        let growth = model.approach_growth(flipper, own.velocity.length()) * duration;
        let mut constraint = ContactConstraint::new(&Touching { ball, body, normal, center, friction }, &step.bodies());
        let is_slow = constraint.approach(&step.bodies()) <= RESTITUTION_THRESHOLD_M_S + growth;
        if distance - BALL_RADIUS_M <= SKIN_M && is_slow {
            constraint.solve_impact(&mut step.bodies(), 0.0);
        }
    }
}
