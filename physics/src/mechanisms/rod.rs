//! Rod: a rigid rod that shoots along its own line: the plunger's, which a hand pulls back and a spring drives, and a
//! kickback's, which a coil drives.
//!
//! Balls meet its face, wherever it is. Refuses to know how balls move.

use crate::ball::Ball;
use crate::collision::world::SKIN_M;
use crate::part::PartId;
use crate::part::event::{Event, EventKind};
use crate::part::material::Material;
use crate::{BALL_RADIUS_M, TICK_S};
use geometry::{DVec2, Shape};
use serde::{Deserialize, Serialize};

/// What the tip of a rod does to the ball.
const ROD_MATERIAL: Material = Material { restitution: 0.3, falloff_s_per_m: 0.1, friction: 0.2 };
/// How fast a rod that has shot goes back to its place, m/s.
const RETURN_M_S: f64 = 0.3;
/// A plunger's speed when it strikes, over that of the ball that it strikes. A rod of 0.2 kg with a tip that gives back
/// 0.87 throws a ball of 0.08 kg at `1.87 * 0.2 / 0.28` of its own speed (conservation of momentum).
const STRIKING_SPEED_RATIO: f64 = 0.75;

/// A ball no farther from a rod's face than this is still at it, m.
const FACE_RANGE_M: f64 = 2e-3;

/// Rod model: where a rod slides, and what drives it.
#[derive(Clone, Debug)]
pub(crate) struct RodModel {
    pub part: PartId,
    /// The middle of the face at rest, m.
    pub tip: DVec2,
    /// Of the face, m.
    pub half_width: f64,
    /// The unit vector of the shot.
    pub direction: DVec2,
    /// How far the rod can be pulled back, or comes out, m.
    pub stroke: f64,
    pub actuator: RodActuator,
}

/// What moves a rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum RodActuator {
    /// A hand that takes `pull_s` for a full pull, and a spring that gives `full_speed` after it.
    Spring { pull_s: f64, full_speed: f64 },
    /// A coil that gives `speed` over the stroke.
    Coil { speed: f64 },
}

/// Rod state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct RodState {
    /// How far the rod is pulled back, m; below 0 where it is out.
    pub pulled: f64,
    /// Speed of the tip forwards, m/s.
    pub speed: f64,
    /// Speed at which a shot ends, m/s; 0 when no shot is on.
    shot: f64,
    /// A ball has hit the face in this tick.
    pub hit: bool,
    /// The switch behind the face is closed.
    pub closed: bool,
}

impl RodModel {
    pub fn is_plunger(&self) -> bool {
        matches!(self.actuator, RodActuator::Spring { .. })
    }

    pub fn velocity(&self, rod: &RodState) -> DVec2 {
        self.direction * rod.speed
    }

    /// What its face does to a ball: while it shoots, the ball goes with it and does not bounce.
    pub fn material(&self, rod: &RodState) -> Material {
        let restitution = if rod.is_shooting() { 0.0 } else { ROD_MATERIAL.restitution };
        Material { restitution, ..ROD_MATERIAL }
    }

    /// The places of the ball's centre where it touches the face.
    pub fn face(&self, rod: &RodState) -> Shape {
        let middle = self.tip - self.direction * rod.pulled;
        let half = self.direction.perp() * self.half_width;
        Shape::capsule(middle - half, middle + half, BALL_RADIUS_M)
    }

    /// One tick of the hand and the spring, or of the coil: sets the tip's speed.
    pub fn tick(&self, rod: &mut RodState, held: bool) {
        match self.actuator {
            RodActuator::Spring { pull_s, full_speed } => self.tick_spring(rod, held, self.stroke / pull_s, full_speed),
            RodActuator::Coil { .. } => self.tick_coil(rod),
        }
    }

    fn tick_spring(&self, rod: &mut RodState, held: bool, pull: f64, full_speed: f64) {
        if held {
            rod.shot = 0.0;
            rod.speed = -pull.min((self.stroke - rod.pulled).max(0.0) / TICK_S);
        } else if rod.shot > 0.0 && rod.pulled <= 0.0 {
            rod.stop();
        } else if rod.shot > 0.0 {
            // The same acceleration for every pull would give the square root of it: a spring's is linear in it.
            let rate = STRIKING_SPEED_RATIO * full_speed / self.stroke;
            rod.speed += rate * rate * rod.pulled * TICK_S;
            if rod.pulled <= rod.speed * TICK_S {
                rod.speed = rod.shot;
            }
        } else if rod.pulled > 0.0 {
            rod.shot = full_speed * rod.pulled / self.stroke;
            rod.speed = 0.0;
        } else {
            rod.go_back();
        }
    }

    /// A coil pulls about alike over the whole stroke, so the speed grows evenly.
    fn tick_coil(&self, rod: &mut RodState) {
        let left = self.stroke + rod.pulled;
        if rod.shot > 0.0 && left <= 0.0 {
            rod.stop();
        } else if rod.shot > 0.0 {
            let gain = rod.shot * rod.shot / (2.0 * self.stroke);
            rod.speed = (rod.speed + gain * TICK_S).min(rod.shot);
            if left <= rod.speed * TICK_S {
                rod.speed = rod.shot;
            }
        } else {
            rod.go_back();
        }
    }

    /// How far the rod is pulled back over its stroke: below 0 where it is out.
    pub fn pull(&self, rod: &RodState) -> f64 {
        rod.pulled / self.stroke
    }

    /// Fires the coil, if there is one and the rod is not on its way out.
    pub fn fire(&self, rod: &mut RodState) {
        if let RodActuator::Coil { speed } = self.actuator
            && !rod.is_shooting()
        {
            rod.shot = speed;
            rod.speed = 0.0;
        }
    }
}

impl RodState {
    /// True up to the tick after which the rod has given all its speed.
    pub fn is_shooting(&self) -> bool {
        self.shot > 0.0
    }

    pub fn advance(&mut self, duration: f64) {
        self.pulled -= self.speed * duration;
    }

    fn stop(&mut self) {
        self.shot = 0.0;
        self.speed = 0.0;
    }

    fn go_back(&mut self) {
        self.speed = -RETURN_M_S.min(-self.pulled / TICK_S);
    }
}

/// Says which plungers have shot, and which kickbacks a ball has come to or left.
pub(crate) fn emit_switch_events(models: &[RodModel], balls: &[Ball], rods: &mut [RodState], events: &mut Vec<Event>) {
    for (model, rod) in models.iter().zip(rods) {
        let kind = if model.is_plunger() { model.launches(rod, balls) } else { model.switch(rod, balls) };
        events.extend(kind.map(|kind| Event { part: Some(model.part), kind }));
        rod.hit = false;
    }
}

impl RodModel {
    fn launches(&self, rod: &RodState, balls: &[Ball]) -> Option<EventKind> {
        let face = self.face(rod);
        let flies = |ball: &Ball| ball.velocity.dot(self.direction) > 0.5 * rod.speed;
        let shot = |ball: &Ball| flies(ball) && face.distance(ball.center).0 < FACE_RANGE_M;
        let given = rod.is_shooting() && rod.pulled <= 0.0;
        (given && balls.iter().any(shot)).then_some(EventKind::Launched)
    }

    /// The switch closes when a ball hits the face or comes to lie on it, and opens when none is near it any more.
    fn switch(&self, rod: &mut RodState, balls: &[Ball]) -> Option<EventKind> {
        let face = self.face(rod);
        let nearest = balls.iter().map(|ball| face.distance(ball.center).0).fold(f64::INFINITY, f64::min);
        let closed = nearest < FACE_RANGE_M && (rod.closed || rod.hit || nearest < SKIN_M);
        let kind = match (rod.closed, closed) {
            (false, true) => Some(EventKind::Closed),
            (true, false) => Some(EventKind::Opened),
            _ => None,
        };
        rod.closed = closed;
        kind
    }
}

/// Fires the coils of these rods.
pub(crate) fn fire(models: &[RodModel], rods: &mut [RodState], which: impl Fn(&RodModel) -> bool) {
    for (model, rod) in models.iter().zip(rods) {
        if which(model) {
            model.fire(rod);
        }
    }
}

/// One tick of every rod: sets the tips' speeds. `held` says whether the player pulls the plunger.
pub(crate) fn tick(models: &[RodModel], rods: &mut [RodState], held: bool) {
    for (model, rod) in models.iter().zip(rods) {
        model.tick(rod, held);
    }
}
