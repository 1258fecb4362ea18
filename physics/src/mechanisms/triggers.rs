//! What happens where a ball's centre is: rollovers, drains and saucers.

use crate::ball::{Ball, Hold};
use crate::collision::world::{Place, Plan};
use crate::layout::{Gate, PartId, Saucer};
use crate::mechanisms::state::State;
use crate::part::event::{Event, EventKind};
use geometry::{DVec2, Ray};
use glam::DVec3;

/// A ball this near the middle of a saucer, and this slow, lies in it.
const LYING_M: f64 = 3e-4;
const LYING_M_S: f64 = 0.02;
/// Slowest natural frequency of a ball in a saucer's bowl, rad/s.
const BOWL_RAD_S: f64 = 40.0;

fn event(part: u16, kind: EventKind) -> Event {
    Event { part: Some(PartId(part)), kind }
}

/// What a saucer's bowl does to a ball that sinks into it, m/s^2: critically damped, and steep enough that a ball of the
/// capture speed does not run out on the other side.
pub(crate) fn bowl(saucer: &Saucer, ball: &Ball) -> DVec2 {
    let frequency = (2.0 * saucer.capture_m_s / saucer.circle.radius).max(BOWL_RAD_S);
    (saucer.circle.center - ball.center) * (frequency * frequency) - ball.velocity * (2.0 * frequency)
}

/// Closes and opens the switches that the balls have come to since they were at `starts`.
pub(crate) fn tick(plan: &Plan, state: &mut State, starts: &[DVec2], events: &mut Vec<Event>) {
    // The rollovers that balls are on, once for each ball.
    let mut inside: Vec<usize> = Vec::new();
    let mut drained: Vec<usize> = Vec::new();
    for (index, &start) in starts.iter().enumerate() {
        let center = state.balls[index].center;
        let in_play = state.balls[index].captive().is_none();
        let mut near: Vec<usize> = Vec::new();
        let up = state.balls[index].is_up();
        plan.zone_grid.visit(start, center, |zone| {
            if !up && !near.contains(&zone) {
                near.push(zone);
            }
        });
        near.sort_unstable();
        for zone in near {
            let zone = &plan.zones[zone];
            let within = zone.shape.distance(center).0 <= 0.0;
            let crossed = || {
                let ray = Ray::towards(start, center);
                let hit = ray.and_then(|ray| zone.shape.cast(&ray));
                hit.is_some_and(|hit| hit.distance <= start.distance(center))
            };
            match zone.what {
                Place::Rollover(rollover) if within => inside.push(rollover),
                Place::Rollover(rollover) if state.mechanisms.rollovers[rollover] == 0 && crossed() => {
                    events.push(event(zone.part, EventKind::Closed));
                    events.push(event(zone.part, EventKind::Opened));
                }
                Place::Drain if in_play && (within || crossed()) && !drained.contains(&index) => {
                    events.push(event(zone.part, EventKind::Closed));
                    drained.push(index);
                }
                Place::Gate(gate) if passes(&plan.gates[gate].1, start, center) => {
                    events.push(event(zone.part, EventKind::Closed));
                }
                Place::Saucer(saucer) if within => sink(plan, state, saucer, index),
                _ => {}
            }
        }
        lie(plan, state, index, events);
    }
    for (rollover, state) in state.mechanisms.rollovers.iter_mut().enumerate() {
        let now = inside.iter().filter(|&&on| on == rollover).count() as u16;
        let before = std::mem::replace(state, now);
        match (before > 0, now > 0) {
            (false, true) => events.push(event(plan.rollovers[rollover], EventKind::Closed)),
            (true, false) => events.push(event(plan.rollovers[rollover], EventKind::Opened)),
            _ => {}
        }
    }
    for &index in drained.iter().rev() {
        state.balls.remove(index);
    }
}

/// A ball's centre goes under a gate's flap the way that is free.
fn passes(gate: &Gate, start: DVec2, center: DVec2) -> bool {
    let beyond = |point: DVec2| (point - gate.segment.a).dot(gate.direction);
    let (before, after) = (beyond(start), beyond(center));
    // `parameter` is clamped to the flap's ends, so beside the flap it is exactly one of them.
    let parameter = gate.segment.parameter(center);
    before <= 0.0 && after > 0.0 && parameter > 0.0 && parameter < 1.0
}

/// A slow ball comes over a saucer that is free.
fn sink(plan: &Plan, state: &mut State, saucer: usize, ball: usize) {
    let taken = |ball: &Ball| matches!(ball.hold, Hold::Sinking(own) | Hold::Held(own) if own == saucer);
    let free = !state.balls.iter().any(taken);
    let ball = &mut state.balls[ball];
    let slow = ball.velocity.length() <= plan.saucers[saucer].1.capture_m_s;
    if free && slow && ball.hold == Hold::Free {
        ball.hold = Hold::Sinking(saucer);
    }
}

/// A ball in a saucer comes to lie in it, or has left it.
fn lie(plan: &Plan, state: &mut State, ball: usize, events: &mut Vec<Event>) {
    let ball = &mut state.balls[ball];
    let (Hold::Sinking(saucer) | Hold::Thrown(saucer)) = ball.hold else { return };
    let (part, saucer_plan) = &plan.saucers[saucer];
    let away = ball.center.distance(saucer_plan.circle.center);
    if away > saucer_plan.circle.radius {
        ball.hold = Hold::Free;
    } else if ball.hold == Hold::Sinking(saucer) && away < LYING_M && ball.velocity.length() < LYING_M_S {
        ball.hold = Hold::Held(saucer);
        ball.center = saucer_plan.circle.center;
        ball.velocity = DVec2::ZERO;
        ball.spin = DVec3::ZERO;
        events.push(event(*part, EventKind::Closed));
    }
}

/// Throws out the ball that a saucer holds.
pub(crate) fn eject(plan: &Plan, state: &mut State, saucer: usize, events: &mut Vec<Event>) {
    let (part, numbers) = &plan.saucers[saucer];
    for ball in state.balls.iter_mut().filter(|ball| ball.hold == Hold::Held(saucer)) {
        ball.hold = Hold::Thrown(saucer);
        ball.velocity = numbers.eject_m_s;
        events.push(event(*part, EventKind::Opened));
    }
}
