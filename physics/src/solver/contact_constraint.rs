//! Where a ball touches something, and the impulses that pass there.
//!
//! Impulses are over the ball's mass (m/s), so a free ball takes 1 along the normal and, being a solid sphere, 7/2
//! across it.

use crate::BALL_MASS_KG;
use crate::ball::Ball;
use crate::mechanisms::flipper::{Blade, Rotor};
use geometry::DVec2;

/// Inverse mass of a solid sphere's rim across the normal, over that along it: `1 + m r^2 / I`.
const ACROSS: f64 = 3.5;
/// Coefficient of friction of two balls.
pub(crate) const BALL_FRICTION: f64 = 0.1;

/// What the ball touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Other {
    /// Something that no ball moves, with its own velocity.
    Fixed(DVec2),
    Flipper(usize),
    Ball(usize),
}

/// The bodies that impulses move.
pub(crate) struct Bodies<'a> {
    pub balls: &'a mut [Ball],
    pub rotors: &'a mut [Rotor],
    pub blades: &'a [Blade],
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch {
    pub ball: usize,
    pub other: Other,
    /// From the other to the ball.
    pub normal: DVec2,
    /// Where the ball was when it touched.
    pub center: DVec2,
    pub friction: f64,
    /// Speed at which the two are to part while they lie on each other, m/s.
    pub goal: f64,
    /// From the flipper's pivot to the point of contact.
    lever: DVec2,
    /// The ball's mass over the flipper's moment of inertia; 0 where it is rigid, and for everything else.
    give: f64,
    /// Inverse mass along the normal.
    along: f64,
    /// The larger of the inverse masses along `normal.perp()` and along the vertical. One for both, or what slides in the
    /// end would not slide against the friction.
    across: f64,
    pressed: f64,
    rubbed: DVec2,
    /// It is an impact: for its moment the ball is free to rise, which takes from the slip as well.
    sudden: bool,
}

impl Touch {
    /// Of a ball whose centre is taken to be at `center`.
    pub fn new(ball: usize, center: DVec2, other: Other, normal: DVec2, friction: f64, bodies: &Bodies) -> Touch {
        let (mut lever, mut give) = (DVec2::ZERO, 0.0);
        if let Other::Flipper(index) = other {
            let blade = &bodies.blades[index];
            lever = center - normal * crate::BALL_RADIUS_M - blade.pivot();
            let (rotor, arm) = (&bodies.rotors[index], -lever.perp().dot(normal));
            let approach = (rotor.velocity_at(lever) - bodies.balls[ball].velocity).dot(normal);
            give = BALL_MASS_KG * blade.inverse_inertia(rotor, arm, approach);
        }
        let both = if matches!(other, Other::Ball(_)) { 2.0 } else { 1.0 };
        let turn = DVec2::new(lever.perp().dot(normal), lever.perp().dot(normal.perp()));
        Touch {
            ball,
            other,
            normal,
            center,
            friction,
            goal: 0.0,
            lever,
            give,
            along: both + give * turn.x * turn.x,
            across: (ACROSS * both + give * turn.y * turn.y).max(ACROSS * both),
            pressed: 0.0,
            rubbed: DVec2::ZERO,
            sudden: false,
        }
    }

    fn other_velocity(&self, bodies: &Bodies) -> DVec2 {
        match self.other {
            Other::Fixed(velocity) => velocity,
            Other::Flipper(index) => bodies.rotors[index].velocity_at(self.lever),
            Other::Ball(index) => bodies.balls[index].velocity,
        }
    }

    /// Speed of approach along the normal.
    pub fn approach(&self, bodies: &Bodies) -> f64 {
        (self.other_velocity(bodies) - bodies.balls[self.ball].velocity).dot(self.normal)
    }

    /// How the ball's rim slides on the other: along `normal.perp()` and along the vertical.
    fn slip(&self, bodies: &Bodies) -> DVec2 {
        let own = bodies.balls[self.ball].rim_slip(self.normal);
        let rise = if self.sudden { self.rubbed.y } else { 0.0 };
        match self.other {
            Other::Ball(index) => {
                let other = bodies.balls[index].rim_slip(-self.normal);
                DVec2::new(own.x + other.x, own.y + rise - other.y + rise)
            }
            _ => DVec2::new(own.x - self.other_velocity(bodies).dot(self.normal.perp()), own.y + rise),
        }
    }

    fn press(&self, bodies: &mut Bodies, impulse: f64) {
        bodies.balls[self.ball].velocity += self.normal * impulse;
        match self.other {
            Other::Fixed(_) => {}
            Other::Flipper(index) => {
                bodies.rotors[index].push(-impulse * self.give * self.lever.perp().dot(self.normal));
            }
            Other::Ball(index) => bodies.balls[index].velocity -= self.normal * impulse,
        }
    }

    fn rub(&self, bodies: &mut Bodies, impulse: DVec2) {
        bodies.balls[self.ball].push_rim(self.normal, impulse);
        match self.other {
            Other::Fixed(_) => {}
            Other::Flipper(index) => {
                let across = self.lever.perp().dot(self.normal.perp());
                bodies.rotors[index].push(-impulse.x * self.give * across);
            }
            Other::Ball(index) => bodies.balls[index].push_rim(-self.normal, DVec2::new(impulse.x, -impulse.y)),
        }
    }

    /// Presses until the two part at `goal`. Returns by how much the impulse changed.
    pub fn separate(&mut self, bodies: &mut Bodies, goal: f64) -> f64 {
        let wanted = self.pressed + (goal + self.approach(bodies)) / self.along;
        let change = wanted.max(0.0) - self.pressed;
        self.pressed += change;
        self.press(bodies, change);
        change
    }

    /// Rubs until the slip ends or the friction cone is reached.
    pub fn grip(&mut self, bodies: &mut Bodies) {
        let wanted = self.rubbed - self.slip(bodies) / self.across;
        let limited = wanted.clamp_length_max(self.friction * self.pressed);
        let change = limited - self.rubbed;
        self.rubbed = limited;
        self.rub(bodies, change);
    }

    /// An impact: the two part at `restitution` times their approach, with friction. Returns the impulse over mass.
    pub fn strike(&mut self, bodies: &mut Bodies, restitution: f64) -> DVec2 {
        let goal = restitution * self.approach(bodies);
        let rounds = if self.give > 0.0 { 8 } else { 1 };
        self.sudden = true;
        for _ in 0..rounds {
            self.separate(bodies, goal);
            self.grip(bodies);
        }
        self.sudden = false;
        self.normal * self.pressed + self.normal.perp() * self.rubbed.x
    }
}

impl Touch {
    /// Forgets the impulses that have passed, so that the next ones only push.
    pub fn release(&mut self) {
        self.pressed = 0.0;
    }
}
