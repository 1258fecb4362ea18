//! Elevation: how balls go up and down: onto ramps, along them, off them, and how they fall.
//!
//! Seen from above a ball on a ramp moves like any other, between the ramp's sides and with the ramp's slope as a part of
//! gravity, so that its energy is `v^2 / 2 + g h` however the floor bends. Left out: that a slope is longer than it looks
//! from above (4 % for a slope of 16 degrees). A ball that comes off an end above the playfield falls freely while it
//! goes on, and may come down on another ball.

use crate::ball::Ball;
use crate::ball::ball_step::BallStep;
use crate::ball::floor::Floor;
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::ramp_path::Entrance;
use crate::part::event::Event;
use crate::{BALL_RADIUS_M, TICK_S};
use geometry::DVec2;

/// Restitution of a ball that falls on the playfield...
const LANDING_RESTITUTION: f64 = 0.25;
/// ... and on a ball below.
const LANDING_ON_BALL_RESTITUTION: f64 = 0.5;
/// A ball that would come up slower than this lies still, m/s.
const MIN_BOUNCE_M_S: f64 = 0.1;
/// A ball that has come out of a ramp's end is no farther from its middle than this: ramps may wind, m.
const ENTRANCE_RANGE_M: f64 = 3.0 * BALL_RADIUS_M;

/// What a step of `duration` does to a ball above the playfield: a ramp's slope is gravity's, half-way through the step
/// (the midpoint rule); a ball in the air has no floor.
pub(crate) fn apply(model: &Model, ball: &Ball, duration: f64, ball_step: &mut BallStep) {
    match ball.ramp {
        Some(ramp) => {
            let half_way = ball.center + ball.velocity * (0.5 * duration);
            let sample = model.mechanisms.ramps[usize::from(ramp)].sample(half_way);
            ball_step.external -= sample.direction * (model.floor.normal_load * sample.slope);
        }
        None if ball.height > 0.0 => ball_step.floor = Floor { normal_load: 0.0, ..ball_step.floor },
        None => {}
    }
}

/// After a tick: balls change ramps, and fall. `starts` is where they were before it.
pub(crate) fn tick(model: &Model, state: &mut State, starts: &[DVec2], events: &mut Vec<Event>) {
    for (index, &start) in starts.iter().enumerate() {
        let ball = &mut state.balls[index];
        if ball.is_held() || ball.captive().is_some() {
            continue;
        }
        match ball.ramp {
            Some(ramp) => follow(model, ball, ramp, events),
            None if ball.height > 0.0 => fall(model, state, index),
            None => {
                let entered = model.mechanisms.ramps.iter().position(|ramp| ramp.is_entered(start, ball.center));
                ball.ramp = entered.map(|ramp| ramp as u16);
            }
        }
    }
}

fn follow(model: &Model, ball: &mut Ball, index: u16, events: &mut Vec<Event>) {
    let ramp = &model.mechanisms.ramps[usize::from(index)];
    let sample = ramp.sample(ball.center);
    ball.height = sample.height;
    ball.vertical_speed = 0.0;
    let is_beyond = |end: &Entrance| (ball.center - end.middle).dot(end.out) > 0.0 && is_at(ball, end);
    let left = ramp.entrances().iter().position(is_beyond);
    if let Some(end) = left {
        ball.ramp = ramp.joined[end];
        if end == 1 {
            events.push(Event::closed(ramp.part));
        }
    } else if ramp.is_over_side(sample.lateral) {
        ball.ramp = None;
    }
}

/// Whether the end of a ramp that a ball is beyond is the end that it lies at: ramps may wind.
fn is_at(ball: &Ball, entrance: &Entrance) -> bool {
    ball.center.distance(entrance.middle) < ENTRANCE_RANGE_M
}

fn fall(model: &Model, state: &mut State, index: usize) {
    let ball = &mut state.balls[index];
    ball.vertical_speed -= model.floor.normal_load * TICK_S;
    ball.height += ball.vertical_speed * TICK_S;
    for below in (0..state.balls.len()).filter(|&below| below != index) {
        if let Ok([ball, below]) = state.balls.get_disjoint_mut([index, below]) {
            land_on(ball, below);
        }
    }
    let ball = &mut state.balls[index];
    if ball.height <= 0.0 {
        ball.height = 0.0;
        let up = -LANDING_RESTITUTION * ball.vertical_speed;
        ball.vertical_speed = if up > MIN_BOUNCE_M_S { up } else { 0.0 };
        // A ball that bounces is off the playfield by what it rises in a tick.
        ball.height = ball.vertical_speed * TICK_S;
    }
}

/// The impact of two spheres of which the playfield carries the lower ball; a lower ball that is on its way down itself
/// yields no more than a ball that lies there.
///
/// 1. The normal leans by the offset of the centres, `(across, up)`.
/// 2. Approach along the normal, with Newton's restitution.
/// 3. Inverse mass: 1 of the upper ball, `across^2` of the lower, which yields along the playfield only.
fn land_on(ball: &mut Ball, below: &mut Ball) {
    let (offset, over) = (ball.center - below.center, ball.height - below.height);
    let reach = 4.0 * BALL_RADIUS_M * BALL_RADIUS_M - offset.length_squared();
    if below.ramp.is_some() || over < 0.0 || reach <= 0.0 || over * over >= reach {
        return;
    }
    ball.height = below.height + reach.sqrt();
    let (across, up) = (offset / (2.0 * BALL_RADIUS_M), reach.sqrt() / (2.0 * BALL_RADIUS_M));
    let approach = (ball.velocity - below.velocity).dot(across) + (ball.vertical_speed - below.vertical_speed) * up;
    if approach < 0.0 {
        let yields = if below.is_held() { 0.0 } else { across.length_squared() };
        let impulse = -(1.0 + LANDING_ON_BALL_RESTITUTION) * approach / (1.0 + yields);
        ball.velocity += across * impulse;
        ball.vertical_speed += up * impulse;
        if !below.is_held() {
            below.velocity -= across * impulse;
        }
    }
}
