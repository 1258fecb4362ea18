//! How balls go up and down: onto ramps, along them, off them, and how they fall.
//!
//! Seen from above a ball on a track moves like any other, between the track's sides and with the track's slope as a
//! part of gravity, so that its energy is `v^2 / 2 + g h` however the floor bends. Left out: that a slope is longer than
//! it looks from above (4 % for one of 16 degrees). A ball that comes off an end above the playfield falls freely while
//! it goes on, and may come down on another one.

use crate::BALL_RADIUS_M;
use crate::ball::motion::Motion;
use crate::ball::{Ball, Floor};
use crate::collision::world::Plan;
use crate::layout::PartId;
use crate::mechanisms::state::State;
use crate::part::event::{Event, EventKind};
use geometry::DVec2;

/// What the playfield gives back of the speed of a fall, and a ball below.
const FLOOR_RESTITUTION: f64 = 0.25;
const BALL_RESTITUTION: f64 = 0.5;
/// A ball that would come up slower than this lies still, m/s.
const STILL_M_S: f64 = 0.1;

/// What a step of `duration` does to a ball above the playfield.
pub(crate) fn act(plan: &Plan, ball: &Ball, duration: f64, motion: &mut Motion) {
    match ball.track {
        Some(track) => {
            let spot = plan.tracks[usize::from(track)].spot(ball.center + ball.velocity * (0.5 * duration));
            motion.pull -= spot.direction * (plan.floor.press * spot.slope);
        }
        None if ball.height > 0.0 => motion.floor = Floor { press: 0.0, ..motion.floor },
        None => {}
    }
}

/// After a tick: balls change tracks, and fall. `starts` is where they were before it.
pub(crate) fn tick(plan: &Plan, state: &mut State, starts: &[DVec2], duration: f64, events: &mut Vec<Event>) {
    for (index, &start) in starts.iter().enumerate() {
        let ball = &mut state.balls[index];
        if ball.is_held() || ball.captive().is_some() {
            continue;
        }
        match ball.track {
            Some(track) => follow(plan, ball, track, events),
            None if ball.height > 0.0 => fall(plan, state, index, duration),
            None => {
                let entered = plan.tracks.iter().position(|track| track.is_entered(start, ball.center));
                ball.track = entered.map(|track| track as u16);
            }
        }
    }
}

fn follow(plan: &Plan, ball: &mut Ball, index: u16, events: &mut Vec<Event>) {
    let track = &plan.tracks[usize::from(index)];
    let spot = track.spot(ball.center);
    ball.height = spot.height;
    ball.climb = 0.0;
    let mouths = track.mouths();
    let left = mouths.iter().position(|mouth| (ball.center - mouth.middle).dot(mouth.out) > 0.0 && is_at(ball, mouth));
    if let Some(end) = left {
        ball.track = track.joined[end];
        if end == 1 {
            events.push(Event { part: Some(PartId(track.part)), kind: EventKind::Closed });
        }
    } else if track.is_over_side(spot.aside) {
        ball.track = None;
    }
}

/// Whether the end of a track that a ball is beyond is the one it lies at: tracks may wind.
fn is_at(ball: &Ball, mouth: &crate::mechanisms::ramp_path::Mouth) -> bool {
    ball.center.distance(mouth.middle) < 3.0 * BALL_RADIUS_M
}

fn fall(plan: &Plan, state: &mut State, index: usize, duration: f64) {
    let ball = &mut state.balls[index];
    ball.climb -= plan.floor.press * duration;
    ball.height += ball.climb * duration;
    for below in (0..state.balls.len()).filter(|&below| below != index) {
        if let Ok([ball, below]) = state.balls.get_disjoint_mut([index, below]) {
            come_down_on(ball, below);
        }
    }
    let ball = &mut state.balls[index];
    if ball.height <= 0.0 {
        ball.height = 0.0;
        let up = -FLOOR_RESTITUTION * ball.climb;
        ball.climb = if up > STILL_M_S { up } else { 0.0 };
        // A ball that bounces is off the playfield by what it rises in a tick.
        ball.height = ball.climb * duration;
    }
}

/// The impact of two spheres of which the playfield carries the lower one; one that is on its way down itself yields
/// no more than one that lies there.
fn come_down_on(ball: &mut Ball, below: &mut Ball) {
    let (away, over) = (ball.center - below.center, ball.height - below.height);
    let reach = 4.0 * BALL_RADIUS_M * BALL_RADIUS_M - away.length_squared();
    if below.track.is_some() || over < 0.0 || reach <= 0.0 || over * over >= reach {
        return;
    }
    ball.height = below.height + reach.sqrt();
    let (across, up) = (away / (2.0 * BALL_RADIUS_M), reach.sqrt() / (2.0 * BALL_RADIUS_M));
    let approach = (ball.velocity - below.velocity).dot(across) + (ball.climb - below.climb) * up;
    if approach < 0.0 {
        let yields = if below.is_held() { 0.0 } else { across.length_squared() };
        let impulse = -(1.0 + BALL_RESTITUTION) * approach / (1.0 + yields);
        ball.velocity += across * impulse;
        ball.climb += up * impulse;
        if !below.is_held() {
            below.velocity -= across * impulse;
        }
    }
}

/// Whether two balls are on different levels, so that neither is in the other's way.
pub(crate) fn apart(one: &Ball, other: &Ball) -> bool {
    let falls = |ball: &Ball| ball.track.is_none() && ball.height > 0.0;
    falls(one) || falls(other) || (one.height - other.height).abs() >= 2.0 * BALL_RADIUS_M
}
