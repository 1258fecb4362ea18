//! The ball: a steel sphere that rolls and slides on the floor below it.
//!
//! Refuses to know what the ball may hit.

pub(crate) mod ball_step;
pub(crate) mod floor;
pub(crate) mod pose;
pub(crate) mod step_acceleration;

use crate::{BALL_RADIUS_M, TICK_S};
use geometry::DVec2;
use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// Moment of inertia of a solid sphere over `m r^2`: 2/5.
pub(crate) const SPHERE_INERTIA: f64 = 0.4;
/// A ball whose lowest point is higher than this passes above all that stands on the playfield, m.
const OBSTACLE_HEIGHT_M: f64 = 0.02;
/// Dither: a machine hums with its coils and motors, which ends static friction. What has lain still for so many ticks is
/// shaken loose: no contact of it has friction, so that no arch of balls holds for ever...
const DITHER_AFTER_TICKS: u32 = 1000;
/// ... nor for so many ticks after it has begun to move, or it would stop again half a millimetre on.
const DITHER_TICKS: u32 = 200;
/// A ball slower than this counts as still: a twentieth of a millimetre in a hundredth of a second, m/s.
const STILL_SPEED_M_S: f64 = 5e-3;

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

/// The state of a ball.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Ball {
    pub id: u32,
    pub center: DVec2,
    pub velocity: DVec2,
    /// About x, y and the vertical; a point at `r` from the centre moves with `spin x r`.
    pub spin: DVec3,
    pub rotation: DQuat,
    pub hold: Hold,
    /// The ramp that it is on.
    pub ramp: Option<u16>,
    /// Of its lowest point above the playfield, m.
    pub height: f64,
    /// How fast it rises, m/s; 0 on a ramp.
    pub vertical_speed: f64,
    /// Ticks since it last moved.
    pub still_ticks: u32,
    /// Ticks for which its contacts still have no friction: dither has shaken it loose.
    pub dither_ticks: u32,
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
            ramp: None,
            height: 0.0,
            vertical_speed: 0.0,
            still_ticks: 0,
            dither_ticks: 0,
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
        self.ramp.is_some() || self.height > OBSTACLE_HEIGHT_M
    }

    /// It has come off a ramp and falls.
    pub fn is_airborne(&self) -> bool {
        self.ramp.is_none() && self.height > 0.0
    }

    /// Whether the two are at different elevations, so that neither is in the other's way.
    pub fn passes(&self, other: &Ball) -> bool {
        self.is_airborne() || other.is_airborne() || (self.height - other.height).abs() >= 2.0 * BALL_RADIUS_M
    }

    /// Slip over the floor: velocity of the ball's lowest point.
    #[inline(always)]
    pub fn floor_slip(&self) -> DVec2 {
        self.velocity + DVec2::new(-self.spin.y, self.spin.x) * BALL_RADIUS_M
    }

    /// Gives the ball's lowest point an impulse over mass, m/s.
    #[inline(always)]
    pub fn apply_floor_impulse(&mut self, impulse: DVec2) {
        self.velocity += impulse;
        let spin_per_impulse = 1.0 / (SPHERE_INERTIA * BALL_RADIUS_M);
        self.spin += DVec3::new(impulse.y, -impulse.x, 0.0) * spin_per_impulse;
    }

    /// Slip at a contact: velocity of the point of the ball that faces `-normal`, along the tangent `normal.perp()` and
    /// along the vertical.
    pub fn contact_slip(&self, normal: DVec2) -> DVec2 {
        let along = self.velocity.dot(normal.perp()) - BALL_RADIUS_M * self.spin.z;
        let up = BALL_RADIUS_M * (self.spin.y * normal.x - self.spin.x * normal.y);
        DVec2::new(along, up)
    }

    /// Gives the point of the ball that faces `-normal` a tangential impulse over mass, m/s, along `normal.perp()` and
    /// along the vertical. The vertical impulse only turns the ball: the playfield and the glass keep its centre at its
    /// height.
    pub fn apply_tangent_impulse(&mut self, normal: DVec2, impulse: DVec2) {
        self.velocity += normal.perp() * impulse.x;
        let spin_per_impulse = 1.0 / (SPHERE_INERTIA * BALL_RADIUS_M);
        self.spin += DVec3::new(-normal.y * impulse.y, normal.x * impulse.y, -impulse.x) * spin_per_impulse;
    }

    /// Turns the ball by its spin, and counts how long it has been still.
    ///
    /// The rotation follows `q' = spin q / 2` by Euler's rule, made a unit quaternion again: it is only drawn.
    pub fn end_tick(&mut self) {
        let half = self.spin * (0.5 * TICK_S);
        let turn = DQuat::from_xyzw(half.x, half.y, half.z, 0.0) * self.rotation;
        self.rotation = (self.rotation + turn).normalize();
        // Nobody waits for a captive ball.
        let still = self.velocity.length() < STILL_SPEED_M_S && self.captive().is_none();
        self.still_ticks = if still { self.still_ticks.saturating_add(1) } else { 0 };
        self.dither_ticks =
            if self.still_ticks >= DITHER_AFTER_TICKS { DITHER_TICKS } else { self.dither_ticks.saturating_sub(1) };
    }
}
