//! Contact detection: what each ball touches at the start of a step, and how far it is moved out of what it overlaps.
//!
//! A slow ball within the skin of something touches it.

use crate::BALL_RADIUS_M;
use crate::ball::Ball;
use crate::collision::time_of_impact::{StraightPath, are_far_apart};
use crate::collision::world::SKIN_M;
use crate::part::material::Material;
use crate::solver::clearance;
use crate::solver::contact_constraint::{ContactBody, ContactConstraint, Touching};
use crate::solver::step::{PARTING_THRESHOLD_M_S, RESTITUTION_THRESHOLD_M_S, Step};
use geometry::DVec2;

/// Obstacles that a ball touches at once, at most: more than fit round it in a machine.
const MAX_OBSTACLES: usize = 4;
/// An overlap up to this is left as it is, m: a ball that a flipper pushes is kept at least this far from it.
pub(crate) const OVERLAP_SLOP_M: f64 = 1e-6;
/// Position correction: the part of an overlap that is undone in a step...
const CORRECTION_PART: f64 = 0.2;
/// ... and how far at most, m: gently, and without speed (as Box2D's position correction).
const MAX_CORRECTION_M: f64 = 1e-4;

/// Finds the contacts of every ball that no saucer holds.
pub(crate) fn detect(step: &mut Step, duration: f64) {
    step.buffers.constraints.clear();
    let travel = clearance::flipper_travel(step, 0.0);
    for ball in 0..step.state.balls.len() {
        if !step.state.balls[ball].is_held() {
            let correction = detect_of_ball(step, ball, duration, travel);
            step.state.balls[ball].center += correction;
        }
    }
}

/// Finds the contacts of a ball. Returns how far it is to be moved out of what it overlaps.
fn detect_of_ball(step: &mut Step, ball: usize, duration: f64, travel: f64) -> DVec2 {
    let clear = clearance::clear_of(step, ball, SKIN_M, travel);
    let mut out = DVec2::ZERO;
    if !clear.obstacles {
        touch_obstacles(step, ball, &mut out);
    }
    if !clear.mechanisms && !step.state.balls[ball].is_up() {
        touch_rods(step, ball, &mut out);
        touch_flippers(step, ball, duration, &mut out);
    }
    touch_balls(step, ball, &mut out);
    out
}

fn touch_obstacles(step: &mut Step, ball: usize, out: &mut DVec2) {
    let Ball { center, velocity, ramp, .. } = step.state.balls[ball];
    let path = StraightPath { center, velocity, duration: 0.0 };
    let mut found: [(usize, DVec2); MAX_OBSTACLES] = [(usize::MAX, DVec2::ZERO); MAX_OBSTACLES];
    let mut count = 0;
    step.model.collision.visit_obstacles(ramp, center, center, |index: usize| {
        let obstacle = &step.model.collision.obstacles[index];
        let (distance, normal) = obstacle.shape.distance(center);
        let known = found[..count].iter().any(|&(other, _)| other == index);
        let near = distance <= SKIN_M && count < found.len() && !known;
        if near && step.state.is_solid(step.model, obstacle, &path, distance) {
            found[count] = (index, normal);
            count += 1;
            *out += correction(distance, normal);
        }
    });
    for &(index, normal) in &found[..count] {
        let friction = step.model.collision.obstacles[index].material.friction;
        let body = ContactBody::Fixed(DVec2::ZERO);
        add_contact(step, Touching { ball, body, normal, center, friction }, 0.0);
    }
}

fn touch_rods(step: &mut Step, ball: usize, out: &mut DVec2) {
    let center = step.state.balls[ball].center;
    for (index, model) in step.model.mechanisms.rods.iter().enumerate() {
        let rod = &step.state.mechanisms.rods[index];
        let (distance, normal) = model.face(rod).distance(center);
        if distance <= SKIN_M {
            *out += correction(distance, normal);
            // What a shot presses on is pushed, however fast.
            let growth = if rod.is_shooting() { f64::INFINITY } else { 0.0 };
            let (body, friction) = (ContactBody::Fixed(model.velocity(rod)), model.material(rod).friction);
            add_contact(step, Touching { ball, body, normal, center, friction }, growth);
        }
    }
}

fn touch_flippers(step: &mut Step, ball: usize, duration: f64, out: &mut DVec2) {
    let Ball { center, velocity, .. } = step.state.balls[ball];
    for (index, model) in step.model.mechanisms.flippers.iter().enumerate() {
        if model.is_out_of_reach(center, SKIN_M) {
            continue;
        }
        let flipper = step.state.mechanisms.flippers[index];
        let (distance, normal) = model.outline(flipper.angle).distance(center);
        if distance - BALL_RADIUS_M <= SKIN_M {
            *out += correction(distance - BALL_RADIUS_M, normal);
            let growth = model.approach_growth(&flipper, velocity.length()) * duration;
            // The normal turns with the flipper: on the mean it is as in the middle of the step.
            let middle = center + velocity * (0.5 * duration);
            let half_way = flipper.angle + flipper.speed * 0.5 * duration;
            let normal = model.outline(half_way).distance(middle).1;
            let (body, friction) = (ContactBody::Flipper(index), model.flipper.material.friction);
            add_contact(step, Touching { ball, body, normal, center: middle, friction }, growth);
        }
    }
}

fn touch_balls(step: &mut Step, ball: usize, out: &mut DVec2) {
    let near = std::mem::take(&mut step.buffers.near_balls);
    if near.is_empty() {
        (0..step.state.balls.len()).for_each(|other| touch_ball(step, ball, other, out));
    } else {
        near.of(ball).for_each(|other| touch_ball(step, ball, other, out));
    }
    step.buffers.near_balls = near;
}

fn touch_ball(step: &mut Step, ball: usize, other: usize, out: &mut DVec2) {
    let center = step.state.balls[ball].center;
    let offset = center - step.state.balls[other].center;
    if other == ball || are_far_apart(offset, 0.0) || step.state.balls[ball].passes(&step.state.balls[other]) {
        return;
    }
    let held = step.state.balls[other].is_held();
    let normal = offset.try_normalize().unwrap_or(DVec2::Y);
    // Each of the two balls moves by half of it.
    *out += correction(0.5 * (offset.length() - 2.0 * BALL_RADIUS_M), normal);
    if other < ball && !held {
        return;
    }
    if offset.length() - 2.0 * BALL_RADIUS_M <= SKIN_M {
        let body = if held { ContactBody::Fixed(DVec2::ZERO) } else { ContactBody::Ball(other) };
        let friction = Material::BALL_ON_BALL.friction;
        add_contact(step, Touching { ball, body, normal, center, friction }, 0.0);
    }
}

/// Adds a contact, unless the two part or come at each other so fast that it is an impact: faster than the restitution
/// threshold and by how much the approach may grow within the step.
fn add_contact(step: &mut Step, touching: Touching, growth: f64) {
    let has_friction = |ball: usize| step.state.balls[ball].dither_ticks == 0;
    let both = match touching.body {
        ContactBody::Ball(other) => has_friction(touching.ball) && has_friction(other),
        _ => has_friction(touching.ball),
    };
    let friction = if both { touching.friction } else { 0.0 };
    let (buffers, bodies) = step.split();
    let constraint = ContactConstraint::new(&Touching { friction, ..touching }, &bodies);
    let approach = constraint.approach(&bodies);
    if approach > -PARTING_THRESHOLD_M_S && approach <= RESTITUTION_THRESHOLD_M_S + growth {
        buffers.constraints.push(constraint);
    }
}

/// How far a ball that is `distance` (below 0) deep in something is moved out of it in a step.
fn correction(distance: f64, normal: DVec2) -> DVec2 {
    if distance < -OVERLAP_SLOP_M { normal * (-CORRECTION_PART * distance).min(MAX_CORRECTION_M) } else { DVec2::ZERO }
}
