//! The oracle's impact: Newton's restitution and Coulomb's cone, from the velocities of the two points that touch.
//!
//! The effective masses are not taken from a formula: each impulse of 1 is tried on the bodies, and what it changes is
//! measured.

use crate::oracle::State;
use geometry::DVec2;
use glam::{DMat3, DVec3};
use physics::{BALL_MASS_KG, BALL_RADIUS_M};

/// A solid sphere.
const INERTIA: f64 = 0.4 * BALL_MASS_KG * BALL_RADIUS_M * BALL_RADIUS_M;

/// What the ball meets.
#[derive(Clone, Copy, Debug)]
pub enum Other {
    Wall,
    Ball(State),
    /// Turns round `pivot` at `turn` rad/s, with this moment of inertia (infinite: it does not yield).
    Rotor {
        pivot: DVec2,
        turn: f64,
        inertia: f64,
    },
}

/// Two bodies that touch.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    pub ball: State,
    pub other: Other,
    /// From the other to the ball.
    pub normal: DVec2,
}

/// A ball's velocity with its third component: during an impact it may rise.
#[derive(Clone, Copy)]
struct Moving {
    velocity: DVec3,
    spin: DVec3,
}

impl Moving {
    fn of(state: &State) -> Moving {
        Moving { velocity: state.velocity.extend(0.0), spin: state.spin }
    }

    fn point(&self, arm: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(arm)
    }

    fn push(&mut self, impulse: DVec3, arm: DVec3) {
        self.velocity += impulse / BALL_MASS_KG;
        self.spin += arm.cross(impulse) / INERTIA;
    }
}

/// The two in motion.
#[derive(Clone, Copy)]
struct Both {
    ball: Moving,
    other: Moving,
    turn: f64,
}

impl Pair {
    fn point(&self) -> DVec2 {
        self.ball.center - self.normal * BALL_RADIUS_M
    }

    /// Velocity of the ball's point that touches over that of the other's.
    fn slip(&self, both: &Both) -> DVec3 {
        let arm = self.normal.extend(0.0) * BALL_RADIUS_M;
        let other = match self.other {
            Other::Wall => DVec3::ZERO,
            Other::Ball(_) => both.other.point(arm),
            Other::Rotor { pivot, .. } => DVec3::Z.cross((self.point() - pivot).extend(0.0)) * both.turn,
        };
        both.ball.point(-arm) - other
    }

    fn push(&self, both: &mut Both, impulse: DVec3) {
        let arm = self.normal.extend(0.0) * BALL_RADIUS_M;
        both.ball.push(impulse, -arm);
        match self.other {
            Other::Wall => {}
            Other::Ball(_) => both.other.push(-impulse, arm),
            Other::Rotor { pivot, inertia, .. } => {
                both.turn -= (self.point() - pivot).extend(0.0).cross(impulse).z / inertia;
            }
        }
    }

    /// The ball's velocity and spin after the impact.
    pub fn part(&self, restitution: f64, friction: f64) -> State {
        let (other, turn) = match self.other {
            Other::Wall => (Moving { velocity: DVec3::ZERO, spin: DVec3::ZERO }, 0.0),
            Other::Ball(state) => (Moving::of(&state), 0.0),
            Other::Rotor { turn, .. } => (Moving { velocity: DVec3::ZERO, spin: DVec3::ZERO }, turn),
        };
        let before = Both { ball: Moving::of(&self.ball), other, turn };
        let axes = DMat3::from_cols(self.normal.extend(0.0), self.normal.perp().extend(0.0), DVec3::Z);
        let slip = axes.transpose() * self.slip(&before);
        let yields = DMat3::from_cols_array_2d(&[0, 1, 2].map(|axis| {
            let mut tried = before;
            self.push(&mut tried, axes.col(axis) * BALL_MASS_KG);
            (axes.transpose() * self.slip(&tried) - slip).to_array()
        }));
        let impulse = cone(yields, slip, -restitution * slip.x, friction);
        let mut after = before;
        self.push(&mut after, axes * impulse * BALL_MASS_KG);
        State { velocity: after.ball.velocity.truncate(), spin: after.ball.spin, ..self.ball }
    }
}

/// The impulse after which the bodies part at `goal` and either stick or slide against the friction: found by creeping
/// up on it.
fn cone(yields: DMat3, slip: DVec3, goal: f64, friction: f64) -> DVec3 {
    let mut impulse = DVec3::ZERO;
    for _ in 0..4000 {
        let across = yields * impulse + slip;
        let pressed = (impulse.x + (goal - across.x) / yields.x_axis.x).max(0.0);
        let rubbed = DVec2::new(impulse.y - 0.1 * across.y, impulse.z - 0.1 * across.z);
        let rubbed = rubbed.clamp_length_max(friction * pressed);
        impulse = DVec3::new(pressed, rubbed.x, rubbed.y);
    }
    impulse
}
