//! A steel sphere that rolls and slides on the playfield, and nothing that it may hit.

pub(crate) mod motion;

use crate::BALL_RADIUS_M;
use geometry::DVec2;
use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// Moment of inertia of a solid sphere over `m r^2`.
const INERTIA: f64 = 0.4;
/// Deceleration of a rolling ball over the force that presses it down: hard steel on lacquer.
const ROLLING_RESISTANCE: f64 = 2e-4;
/// Radius of the patch that the ball rests on; its friction slows the spin about the vertical.
const PATCH_RADIUS_M: f64 = 3e-4;
/// What stands on the playfield is no higher than this where a ball comes down.
const ABOVE_M: f64 = 0.02;
/// A slide goes on in steps that are this part of what is left of it...
const SLIDE_PART: f64 = 0.3;
/// ... until that is this part of a step.
const SLIDE_END: f64 = 0.05;
/// A ball that would slide for no longer than this rolls.
const ROLLS_S: f64 = 1e-9;
/// A machine hums with its coils and motors: what has lain still for so long is shaken loose. It does not cling by
/// friction, so that no arch of balls holds for ever, and its rolling resistance is that of a trembling ball, which grows
/// with the speed (dither: dry friction under fast vibration acts as a viscous one), so that none balances on a post...
const HUM_TICKS: u32 = 1000;
/// How fast such a ball trembles.
const HUM_M_S: f64 = 5e-4;
/// ... nor for so long after it has begun to move, or it would stop again half a millimetre on.
const LOOSE_TICKS: u32 = 200;
/// Below this a ball counts as still.
const STILL_M_S: f64 = 5e-3;

/// What has a ball in its power.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Hold {
    /// Nothing.
    Free,
    /// It sinks into this saucer's bowl.
    Sinking(usize),
    /// It lies in this saucer.
    Held(usize),
    /// It was thrown out of this saucer and is still above it.
    Thrown(usize),
    /// The walls round it: it is this captive ball, and not in play.
    Captive(usize),
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Ball {
    pub id: u32,
    pub center: DVec2,
    pub velocity: DVec2,
    /// About x, y and the vertical; a point at `r` from the centre moves with `spin x r`.
    pub spin: DVec3,
    pub rotation: DQuat,
    pub hold: Hold,
    /// The track that it is on.
    pub track: Option<u16>,
    /// Of its lowest point above the playfield, m.
    pub height: f64,
    /// How fast it rises, m/s; 0 on a track.
    pub climb: f64,
    /// Ticks since it last moved.
    pub still_ticks: u32,
    /// Ticks for which it still does not cling to anything: it has been shaken loose.
    pub loose_ticks: u32,
}

/// What the playfield does to a ball.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floor {
    /// Down the slope, m/s^2.
    pub gravity: f64,
    /// What presses the ball to the playfield, m/s^2.
    pub press: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// What drags at the turning of the ball: deceleration of one that rolls, beside its rolling resistance, m/s^2.
    pub drag: f64,
}

/// How velocity and spin change, per second.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Drive {
    pub velocity: DVec2,
    pub spin: DVec3,
    /// How much faster the ball is on its mean than with an even change: friction turns as the slip turns. m/s.
    pub lead: DVec2,
    /// For how many seconds this holds, where that is less than asked for: friction turns quickly at a slide's end.
    pub lasts: Option<f64>,
}

impl Floor {
    /// How much of its slip a sliding ball loses to friction, m/s^2.
    fn slip_loss(&self) -> f64 {
        self.friction * self.press * (1.0 + INERTIA) / INERTIA
    }
}

impl Ball {
    pub fn new(id: u32, center: DVec2) -> Ball {
        Ball {
            id,
            center,
            velocity: DVec2::ZERO,
            spin: DVec3::ZERO,
            rotation: DQuat::IDENTITY,
            hold: Hold::Free,
            track: None,
            height: 0.0,
            climb: 0.0,
            still_ticks: 0,
            loose_ticks: 0,
        }
    }

    pub fn is_held(&self) -> bool {
        matches!(self.hold, Hold::Held(_))
    }

    /// Which captive ball it is; `None` of a ball in play.
    pub fn captive(&self) -> Option<usize> {
        match self.hold {
            Hold::Captive(index) => Some(index),
            _ => None,
        }
    }

    /// It is above all that stands on the playfield.
    pub fn is_up(&self) -> bool {
        self.track.is_some() || self.height > ABOVE_M
    }

    /// Velocity of the ball's lowest point over the playfield.
    #[inline(always)]
    pub fn floor_slip(&self) -> DVec2 {
        self.velocity + DVec2::new(-self.spin.y, self.spin.x) * BALL_RADIUS_M
    }

    /// Gives the ball's lowest point an impulse over mass, m/s.
    #[inline(always)]
    pub fn push_floor(&mut self, push: DVec2) {
        self.velocity += push;
        let turn = 1.0 / (INERTIA * BALL_RADIUS_M);
        self.spin += DVec3::new(push.y, -push.x, 0.0) * turn;
    }

    /// Velocity of the point of the ball that faces `-normal`, along `normal.perp()` and along the vertical.
    pub fn rim_slip(&self, normal: DVec2) -> DVec2 {
        let along = self.velocity.dot(normal.perp()) - BALL_RADIUS_M * self.spin.z;
        let up = BALL_RADIUS_M * (self.spin.y * normal.x - self.spin.x * normal.y);
        DVec2::new(along, up)
    }

    /// Gives the point of the ball that faces `-normal` an impulse over mass, m/s, along `normal.perp()` and along the
    /// vertical. The vertical one only turns the ball: the playfield and the glass keep its centre at its height.
    pub fn push_rim(&mut self, normal: DVec2, push: DVec2) {
        self.velocity += normal.perp() * push.x;
        let turn = 1.0 / (INERTIA * BALL_RADIUS_M);
        self.spin += DVec3::new(-normal.y * push.y, normal.x * push.y, -push.x) * turn;
    }

    /// How the ball goes on for `duration` with nothing in its way, under `pull` (gravity and the cabinet), m/s^2.
    ///
    /// Friction never does more than end the slip, so a rolling ball keeps rolling: 5/7 of the pull is left of itself.
    pub fn drive(&self, floor: &Floor, pull: DVec2, duration: f64) -> Drive {
        let lasts = self.slides_for(floor, pull, duration);
        let stops = lasts.is_some_and(|time| time < SLIDE_END * duration);
        let lasts = lasts.map(|time| if stops { time } else { SLIDE_PART * time }).filter(|&time| time < duration);
        let duration = lasts.unwrap_or(duration);
        let mut after = *self;
        // Half of it before all else and half after it: so the error of taking them in turn is of the third order.
        after.resist(floor, 0.5 * duration);
        after.velocity += pull * duration;
        let slip = after.floor_slip();
        let stop = slip * (-INERTIA / (1.0 + INERTIA));
        let most = floor.friction * floor.press * duration;
        let (push, lead) = if stops || stop.length_squared() <= most * most {
            (stop, DVec2::ZERO)
        } else {
            let (mean, turn) = self.slip_ways(floor, pull, duration);
            (mean * -most, turn * (most / 12.0))
        };
        after.push_floor(push);
        after.resist(floor, 0.5 * duration);
        let (velocity, spin) = ((after.velocity - self.velocity) / duration, (after.spin - self.spin) / duration);
        Drive { velocity, spin, lead, lasts }
    }

    /// The mean of the unit vectors in which a sliding ball slips in the next `duration`, and by how much they change
    /// (by the rule of Runge and Kutta): the pull turns the slip, and friction turns with it.
    fn slip_ways(&self, floor: &Floor, pull: DVec2, duration: f64) -> (DVec2, DVec2) {
        let slip = self.floor_slip();
        let way = |gained: DVec2| (slip + gained).normalize_or_zero();
        let gain = |way: DVec2, time: f64| (pull - way * floor.slip_loss()) * time;
        let first = way(DVec2::ZERO);
        let second = way(gain(first, 0.5 * duration));
        let third = way(gain(second, 0.5 * duration));
        let fourth = way(gain(third, duration));
        ((first + (second + third) * 2.0 + fourth) / 6.0, fourth - first)
    }

    /// In what time friction ends the slip, if it does; only told where that is not many times `duration`.
    #[inline(always)]
    fn slides_for(&self, floor: &Floor, pull: DVec2, duration: f64) -> Option<f64> {
        let slip = self.floor_slip();
        if slip.length() > 20.0 * floor.slip_loss() * duration {
            return None;
        }
        // The slip is lost along the way that it has on the mean: the whole slip, the pull's with it, is what is lost.
        let (loss, own) = (floor.slip_loss(), pull.length_squared());
        let (half, end) = (slip.dot(pull), slip.length_squared());
        let square = half * half + (loss * loss - own) * end;
        let time = (half + square.max(0.0).sqrt()) / (loss * loss - own);
        (loss * loss > own && time > ROLLS_S).then_some(time)
    }

    /// Rolling resistance, and the drag of the patch on the spin about the vertical.
    ///
    /// In line, or [`Ball::drive`] copies a whole ball for the little of it that changes.
    #[inline(always)]
    pub fn resist(&mut self, floor: &Floor, duration: f64) {
        let speed = self.velocity.length();
        let mut resistance = ROLLING_RESISTANCE * floor.press;
        if self.loose_ticks > 0 {
            resistance *= (speed / HUM_M_S).min(1.0);
        }
        if floor.drag > 0.0 {
            // What drags at the turning of the ball leaves one alone that slides without turning.
            resistance += floor.drag * (self.spin.truncate().length() * BALL_RADIUS_M / speed).min(1.0);
        }
        let loss = resistance * duration;
        let keep = if speed > loss { 1.0 - loss / speed } else { 0.0 };
        self.velocity *= keep;
        self.spin.x *= keep;
        self.spin.y *= keep;
        let drag = floor.friction * floor.press * PATCH_RADIUS_M / (1.5 * INERTIA * BALL_RADIUS_M * BALL_RADIUS_M);
        self.spin.z -= self.spin.z.signum() * (drag * duration).min(self.spin.z.abs());
    }

    /// Turns the ball by its spin, and counts how long it has been still.
    pub fn end_tick(&mut self, duration: f64) {
        let half = self.spin * (0.5 * duration);
        let turn = DQuat::from_xyzw(half.x, half.y, half.z, 0.0) * self.rotation;
        self.rotation = (self.rotation + turn).normalize();
        // Nobody waits for a captive ball.
        let still = self.velocity.length() < STILL_M_S && self.captive().is_none();
        self.still_ticks = if still { self.still_ticks.saturating_add(1) } else { 0 };
        self.loose_ticks = if self.still_ticks >= HUM_TICKS { LOOSE_TICKS } else { self.loose_ticks.saturating_sub(1) };
    }

    pub fn pose(&self) -> crate::mechanisms::pose::BallPose {
        crate::mechanisms::pose::BallPose {
            id: self.id,
            center: self.center,
            velocity: self.velocity,
            spin: self.spin.to_array(),
            rotation: self.rotation.to_array(),
            held: self.is_held(),
            height_m: self.height,
            above: self.is_up(),
        }
    }
}
