//! Contact constraint: where a ball touches something, and the normal and tangential impulses that pass there.
//!
//! Impulses are over the ball's mass (m/s). So the inverse mass of a free ball is 1 along the normal, and across it, being
//! a solid sphere, `1 + m r^2 / I = 7/2` (Stronge, Impact Mechanics, 2000, 3.3).

use crate::ball::Ball;
use crate::mechanisms::flipper_model::{FlipperModel, FlipperState};
use crate::{BALL_MASS_KG, BALL_RADIUS_M};
use geometry::DVec2;

/// Inverse mass of a solid sphere's surface across the normal, over that along it: `1 + m r^2 / I`.
const TANGENT_INVERSE_MASS: f64 = 3.5;
/// Rounds in which normal and tangential impulse of an impact on a flipper find each other: each changes the other's
/// speed through the rotor. On anything else they do not, and one round is exact.
const FLIPPER_IMPACT_ROUNDS: usize = 8;

/// Two normals whose angle has a larger cosine, 1.4 thousandths of a radian, are the same.
const SAME_NORMAL_COS: f64 = 0.999_999;

/// What the ball touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ContactBody {
    /// Something that no ball moves, with its own velocity.
    Fixed(DVec2),
    Flipper(usize),
    Ball(usize),
}

/// The bodies that impulses move.
pub(crate) struct Bodies<'a> {
    pub balls: &'a mut [Ball],
    pub flippers: &'a mut [FlipperState],
    pub flipper_models: &'a [FlipperModel],
}

/// What a ball touches, and where.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touching {
    pub ball: usize,
    pub body: ContactBody,
    /// From the body to the ball.
    pub normal: DVec2,
    /// Where the ball's centre is taken to be.
    pub center: DVec2,
    /// Coefficient of friction.
    pub friction: f64,
}

/// A contact with the impulses that have passed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactConstraint {
    pub ball: usize,
    pub body: ContactBody,
    /// From the body to the ball.
    pub normal: DVec2,
    /// Where the ball was when it touched.
    pub center: DVec2,
    friction: f64,
    /// Speed at which the two are to part while they rest on each other, m/s.
    pub parting_speed: f64,
    /// From the flipper's pivot to the point of contact.
    lever: DVec2,
    /// The ball's mass over the flipper's moment of inertia, 1/m^2; 0 where it is rigid, and for everything else.
    rotor_inverse_inertia: f64,
    normal_inverse_mass: f64,
    /// The larger of the inverse masses along `normal.perp()` and along the vertical. The same for both, or what slides
    /// in the end would not slide against the friction.
    tangent_inverse_mass: f64,
    normal_impulse: f64,
    tangent_impulse: DVec2,
    /// It is an impact: for its moment the ball is free to rise, which takes from the slip as well.
    is_impact: bool,
}

impl ContactConstraint {
    pub fn new(touching: &Touching, bodies: &Bodies) -> ContactConstraint {
        let &Touching { ball, body, normal, center, friction } = touching;
        let (mut lever, mut rotor_inverse_inertia) = (DVec2::ZERO, 0.0);
        if let ContactBody::Flipper(index) = body {
            let model = &bodies.flipper_models[index];
            lever = center - normal * BALL_RADIUS_M - model.pivot();
            let (flipper, arm) = (&bodies.flippers[index], -lever.perp().dot(normal));
            let approach = (flipper.velocity_at(lever) - bodies.balls[ball].velocity).dot(normal);
            rotor_inverse_inertia = BALL_MASS_KG * model.inverse_inertia(flipper, arm, approach);
        }
        let balls = if matches!(body, ContactBody::Ball(_)) { 2.0 } else { 1.0 };
        let arms = DVec2::new(lever.perp().dot(normal), lever.perp().dot(normal.perp()));
        let tangent = TANGENT_INVERSE_MASS * balls;
        ContactConstraint {
            ball,
            body,
            normal,
            center,
            friction,
            parting_speed: 0.0,
            lever,
            rotor_inverse_inertia,
            normal_inverse_mass: balls + rotor_inverse_inertia * arms.x * arms.x,
            tangent_inverse_mass: (tangent + rotor_inverse_inertia * arms.y * arms.y).max(tangent),
            normal_impulse: 0.0,
            tangent_impulse: DVec2::ZERO,
            is_impact: false,
        }
    }

    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// Whether the two bodies are the same, and the normal but for 1.4 thousandths of a radian.
    pub fn is_same_contact(&self, other: &ContactConstraint) -> bool {
        self.ball == other.ball && self.body == other.body && self.normal.dot(other.normal) > SAME_NORMAL_COS
    }

    fn body_velocity(&self, bodies: &Bodies) -> DVec2 {
        match self.body {
            ContactBody::Fixed(velocity) => velocity,
            ContactBody::Flipper(index) => bodies.flippers[index].velocity_at(self.lever),
            ContactBody::Ball(index) => bodies.balls[index].velocity,
        }
    }

    /// Speed of approach along the normal.
    pub fn approach(&self, bodies: &Bodies) -> f64 {
        (self.body_velocity(bodies) - bodies.balls[self.ball].velocity).dot(self.normal)
    }

    /// Slip: how the ball's surface slides on the body, along `normal.perp()` and along the vertical.
    fn slip(&self, bodies: &Bodies) -> DVec2 {
        let own = bodies.balls[self.ball].contact_slip(self.normal);
        let rise = if self.is_impact { self.tangent_impulse.y } else { 0.0 };
        match self.body {
            ContactBody::Ball(index) => {
                let other = bodies.balls[index].contact_slip(-self.normal);
                DVec2::new(own.x + other.x, own.y + rise - other.y + rise)
            }
            _ => DVec2::new(own.x - self.body_velocity(bodies).dot(self.normal.perp()), own.y + rise),
        }
    }

    fn apply_normal(&self, bodies: &mut Bodies, impulse: f64) {
        bodies.balls[self.ball].velocity += self.normal * impulse;
        match self.body {
            ContactBody::Fixed(_) => {}
            ContactBody::Flipper(index) => {
                let arm = self.lever.perp().dot(self.normal);
                bodies.flippers[index].push(-impulse * self.rotor_inverse_inertia * arm);
            }
            ContactBody::Ball(index) => bodies.balls[index].velocity -= self.normal * impulse,
        }
    }

    fn apply_tangent(&self, bodies: &mut Bodies, impulse: DVec2) {
        bodies.balls[self.ball].apply_tangent_impulse(self.normal, impulse);
        match self.body {
            ContactBody::Fixed(_) => {}
            ContactBody::Flipper(index) => {
                let arm = self.lever.perp().dot(self.normal.perp());
                bodies.flippers[index].push(-impulse.x * self.rotor_inverse_inertia * arm);
            }
            ContactBody::Ball(index) => {
                bodies.balls[index].apply_tangent_impulse(-self.normal, DVec2::new(impulse.x, -impulse.y));
            }
        }
    }

    /// The normal constraint: presses until the two part at `parting_speed`, m/s. The sum of all impulses pushes and
    /// never pulls (Catto, Iterative Dynamics with Temporal Coherence, 2005: accumulated and clamped). Returns by how
    /// much the impulse changed.
    pub fn solve_normal(&mut self, bodies: &mut Bodies, parting_speed: f64) -> f64 {
        let wanted = self.normal_impulse + (parting_speed + self.approach(bodies)) / self.normal_inverse_mass;
        let change = wanted.max(0.0) - self.normal_impulse;
        self.normal_impulse += change;
        self.apply_normal(bodies, change);
        change
    }

    /// The friction constraint (Coulomb): rubs until the slip ends, `-slip / (tangential inverse mass)`, or until the
    /// friction cone is reached, `mu` times the normal impulse. A ball that slides through the whole contact gets the
    /// second, a ball that grips the first (Routh; Cross, Grip-slip behavior of a bouncing ball, American Journal of
    /// Physics 70, 2002).
    pub fn solve_friction(&mut self, bodies: &mut Bodies) {
        let wanted = self.tangent_impulse - self.slip(bodies) / self.tangent_inverse_mass;
        let limited = wanted.clamp_length_max(self.friction * self.normal_impulse);
        let change = limited - self.tangent_impulse;
        self.tangent_impulse = limited;
        self.apply_tangent(bodies, change);
    }

    /// An impact: the two part at `restitution` times their approach (Newton), with friction. Returns the impulse over
    /// mass.
    pub fn solve_impact(&mut self, bodies: &mut Bodies, restitution: f64) -> DVec2 {
        let parting_speed = restitution * self.approach(bodies);
        let rounds = if self.rotor_inverse_inertia > 0.0 { FLIPPER_IMPACT_ROUNDS } else { 1 };
        self.is_impact = true;
        for _ in 0..rounds {
            self.solve_normal(bodies, parting_speed);
            self.solve_friction(bodies);
        }
        self.is_impact = false;
        self.normal * self.normal_impulse + self.normal.perp() * self.tangent_impulse.x
    }

    /// Forgets the normal impulse that has passed, so that the next only pushes.
    pub fn release(&mut self) {
        self.normal_impulse = 0.0;
    }
}
