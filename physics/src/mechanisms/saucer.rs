//! Saucer: a hole that holds a ball until it is thrown out.

use crate::ball::{Ball, Hold};
use crate::collision::trigger::TriggerKind;
use crate::mechanisms::model::{Model, State};
use crate::part::event::Event;
use crate::part::validation::{self, Checked};
use crate::part::{Numbered, PartId};
use geometry::{Circle, DVec2, Shape};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A ball this near the middle of a saucer, m...
const LYING_M: f64 = 3e-4;
/// ... and this slow lies in it, m/s.
const LYING_M_S: f64 = 0.02;
/// Slowest natural frequency of a ball in a saucer's bowl, rad/s.
const MIN_BOWL_RAD_S: f64 = 40.0;

/// A hole that holds a ball. Its switch is closed while a ball lies in it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Saucer {
    /// The hole: a slow ball whose centre comes over it falls in.
    pub circle: Circle,
    /// Fastest ball that it catches, m/s.
    pub capture_m_s: f64,
    /// Velocity that it throws the ball out with, m/s.
    pub eject_m_s: DVec2,
}

impl Saucer {
    pub(crate) fn check(&self) -> Checked {
        validation::circle(&self.circle)?;
        validation::not_negative("the capture speed", self.capture_m_s)?;
        validation::point("the ejection", self.eject_m_s)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let saucers = &mut model.mechanisms.saucers;
        let shape = Shape::disc(self.circle.center, self.circle.radius);
        model.collision.add_trigger(part, shape, TriggerKind::Saucer(saucers.len()));
        saucers.push(Numbered { part, numbers: self.clone() });
    }

    /// Acceleration of a ball that sinks into the bowl, m/s^2: a critically damped spring, and steep enough that a ball
    /// of the capture speed does not run out on the other side.
    fn bowl_acceleration(&self, ball: &Ball) -> DVec2 {
        let frequency = (2.0 * self.capture_m_s / self.circle.radius).max(MIN_BOWL_RAD_S);
        (self.circle.center - ball.center) * (frequency * frequency) - ball.velocity * (2.0 * frequency)
    }
}

/// What a saucer does to this ball, if it sinks into one, m/s^2.
pub(crate) fn acceleration(saucers: &[Numbered<Saucer>], ball: &Ball) -> Option<DVec2> {
    let Hold::Sinking(saucer) = ball.hold else { return None };
    Some(saucers[saucer].numbers.bowl_acceleration(ball))
}

/// A slow ball comes over a saucer that is free.
pub(crate) fn capture(model: &Model, state: &mut State, saucer: usize, ball: usize) {
    let takes = |ball: &Ball| matches!(ball.hold, Hold::Sinking(own) | Hold::Held(own) if own == saucer);
    let free = !state.balls.iter().any(takes);
    let ball = &mut state.balls[ball];
    let slow = ball.velocity.length() <= model.mechanisms.saucers[saucer].numbers.capture_m_s;
    if free && slow && ball.hold == Hold::Free {
        ball.hold = Hold::Sinking(saucer);
    }
}

/// A ball in a saucer comes to lie in it, or has left it.
pub(crate) fn settle(saucers: &[Numbered<Saucer>], ball: &mut Ball, events: &mut Vec<Event>) {
    let (Hold::Sinking(index) | Hold::Thrown(index)) = ball.hold else { return };
    let Numbered { part, numbers: saucer } = &saucers[index];
    let away = ball.center.distance(saucer.circle.center);
    if away > saucer.circle.radius {
        ball.hold = Hold::Free;
    } else if ball.hold == Hold::Sinking(index) && away < LYING_M && ball.velocity.length() < LYING_M_S {
        ball.hold = Hold::Held(index);
        ball.center = saucer.circle.center;
        ball.velocity = DVec2::ZERO;
        ball.spin = DVec3::ZERO;
        events.push(Event::closed(*part));
    }
}

/// Throws out the ball that a saucer holds.
pub(crate) fn eject(model: &Model, state: &mut State, saucer: usize, events: &mut Vec<Event>) {
    let Numbered { part, numbers } = &model.mechanisms.saucers[saucer];
    for ball in state.balls.iter_mut().filter(|ball| ball.hold == Hold::Held(saucer)) {
        ball.hold = Hold::Thrown(saucer);
        ball.velocity = numbers.eject_m_s;
        events.push(Event::opened(*part));
    }
}
