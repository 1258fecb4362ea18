//! Plunger: the spring rod that shoots the ball, and the place where new balls arrive.
//!
//! How its rod moves is in `crate::mechanisms::rod`.

use crate::BALL_RADIUS_M;
use crate::ball::Ball;
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::rod::{RodActuator, RodModel};
use crate::part::event::{Event, EventKind};
use crate::part::validation::{self, Checked};
use crate::part::{Numbered, PartId};
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// Room that a new ball needs beside what a ball takes, m.
const FEED_GAP_M: f64 = 1e-3;
/// How far before the tip a ball still waits in the lane, m: some balls may queue.
const LANE_M: f64 = 8.0 * BALL_RADIUS_M;

/// The spring rod that shoots the ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plunger {
    /// Where a new ball's centre is put, m: in the lane, above the rod's tip.
    pub feed: DVec2,
    /// The rod's tip at rest, m: the middle of the face that the ball lies on.
    pub tip: DVec2,
    /// Half the width of the tip's face, m.
    pub half_width_m: f64,
    /// The unit vector of the shot.
    pub direction: DVec2,
    /// How far the rod can be pulled, m.
    pub stroke_m: f64,
    /// Time to pull it all the way, s.
    pub pull_s: f64,
    /// Speed of the ball after a full pull, m/s; it is linear in the pull.
    pub full_speed_m_s: f64,
}

impl Plunger {
    pub(crate) fn check(&self) -> Checked {
        validation::point("the feed", self.feed)?;
        validation::point("the tip", self.tip)?;
        validation::unit("the plunger's direction", self.direction)?;
        validation::positive("half the tip's width", self.half_width_m)?;
        validation::positive("the stroke", self.stroke_m)?;
        validation::positive("the time of a pull", self.pull_s)?;
        validation::positive("the full speed", self.full_speed_m_s)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let actuator = RodActuator::Spring { pull_s: self.pull_s, full_speed: self.full_speed_m_s };
        let Plunger { tip, half_width_m, direction, stroke_m, .. } = *self;
        let rod = RodModel { part, tip, half_width: half_width_m, direction, stroke: stroke_m, actuator };
        model.mechanisms.rods.push(rod);
        model.mechanisms.plungers.push(Numbered { part, numbers: self.clone() });
    }

    /// Whether this ball waits in the plunger lane.
    pub(crate) fn has_before_it(&self, ball: &Ball) -> bool {
        let from_tip = ball.center - self.tip;
        let lane = self.half_width_m + BALL_RADIUS_M;
        from_tip.dot(self.direction.perp()).abs() < lane && from_tip.dot(self.direction) < LANE_M
    }
}

/// Puts a waiting ball into the plunger lane, as soon as there is room.
pub(crate) fn feed(model: &Model, state: &mut State, events: &mut Vec<Event>) {
    let Some(Numbered { part, numbers: plunger }) = model.mechanisms.plungers.first() else { return };
    let room = 2.0 * BALL_RADIUS_M + FEED_GAP_M;
    let free = state.balls.iter().all(|ball| ball.center.distance(plunger.feed) > room);
    if state.mechanisms.queue > 0 && free {
        state.mechanisms.queue -= 1;
        state.balls.push(Ball::new(state.mechanisms.next_ball, plunger.feed));
        state.mechanisms.next_ball = state.mechanisms.next_ball.wrapping_add(1);
        events.push(Event { part: Some(*part), kind: EventKind::Fed });
    }
}
