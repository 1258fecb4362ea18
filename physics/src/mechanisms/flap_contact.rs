//! Flap contacts: a ball that passes below the flap of a gate or the plate of a spinner, seen from the side.
//!
//! There the ball is a circle on the playfield and the flap a line that hangs from its axle. Where they touch, an
//! impulse passes along the normal, the same for both: the ball slows and the flap turns.

use crate::ball::Ball;
use crate::collision::trigger::TriggerKind;
use crate::mechanisms::flap::{AXLE_M, AXLE_TO_EDGE_M, Flap};
use crate::mechanisms::model::Model;
use crate::mechanisms::rigid_mechanisms::RigidMechanisms;
use crate::{BALL_MASS_KG, BALL_RADIUS_M};
use geometry::{DVec2, Segment, trig};

/// The farthest that a ball goes between two looks at a flap, m.
const LOOK_M: f64 = 0.002;
/// Most flaps that a ball passes in a tick: they stand farther apart than it goes.
const MAX_FLAPS: usize = 4;
/// Restitution of wire and sheet steel against the ball.
const FLAP_RESTITUTION: f64 = 0.35;
/// Slower than this flap and ball stay together, m/s.
const FLAP_RESTITUTION_THRESHOLD_M_S: f64 = 0.05;
/// So near to its stop a flap lies on it, rad.
const STOP_RANGE_RAD: f64 = 0.01;

/// A flap's hinge line seen from above, and the direction in which a positive angle swings its lower edge.
#[derive(Clone, Copy)]
struct Hinge {
    flap: Flap,
    axle: Segment,
    direction: DVec2,
}

/// Lets every ball meet the flaps that it passed since the tick's start.
pub(crate) fn tick(model: &Model, rigid: &mut RigidMechanisms, balls: &mut [Ball], starts: &[DVec2]) {
    if model.mechanisms.gates.is_empty() && model.mechanisms.spinners.is_empty() {
        return;
    }
    for (ball, &start) in balls.iter_mut().zip(starts) {
        if !ball.is_held() && !ball.is_up() {
            pass(model, rigid, ball, start);
        }
    }
}

fn pass(model: &Model, rigid: &mut RigidMechanisms, ball: &mut Ball, start: DVec2) {
    let mut met: [Option<Flap>; MAX_FLAPS] = [None; MAX_FLAPS];
    model.collision.visit_triggers(start, ball.center, |trigger| {
        let flap = match model.collision.triggers[trigger].kind {
            TriggerKind::Gate(index) => Flap::Gate(index),
            TriggerKind::Spinner(index) => Flap::Spinner(index),
            _ => return,
        };
        if !met.contains(&Some(flap))
            && let Some(free) = met.iter_mut().find(|one| one.is_none())
        {
            *free = Some(flap);
        }
    });
    for flap in met.into_iter().flatten() {
        pass_below(rigid, &hinge(model, flap), ball, start);
    }
}

fn hinge(model: &Model, flap: Flap) -> Hinge {
    let (axle, direction) = match flap {
        Flap::Gate(index) => {
            let gate = &model.mechanisms.gates[index].numbers;
            (gate.segment, gate.direction)
        }
        Flap::Spinner(index) => {
            let axle = model.mechanisms.spinners[index].numbers.segment;
            (axle, axle.left_normal().unwrap_or(DVec2::Y))
        }
    };
    Hinge { flap, axle, direction }
}

fn pass_below(rigid: &mut RigidMechanisms, hinge: &Hinge, ball: &mut Ball, start: DVec2) {
    let Hinge { flap, axle, direction } = *hinge;
    let path = ball.center - start;
    let looks = (path.length() / LOOK_M).ceil().max(1.0);
    for look in 1..=looks as u32 {
        let center = start + path * (f64::from(look) / looks);
        let parameter = (center - axle.a).dot(axle.along()) / axle.along().length_squared();
        if (0.0..=1.0).contains(&parameter) {
            collide(rigid, flap, ((center - axle.a).dot(direction), direction), ball);
        }
    }
}

/// The ball's centre is at `beyond` past the axle in this direction: the impulse of the two, if they touch.
///
/// 1. In the plane of the side view: hinge, edge of the flap, nearest point to the ball's middle, normal.
/// 2. Speed of approach: the ball's along the normal less the flap's there, `w` times the lever across the normal.
/// 3. Inverse mass along the normal: `n_x^2 / m` of a ball that the playfield keeps at its height, and `lever^2 / I` of a
///    flap that does not lie on its stop.
/// 4. Newton's restitution: the impulse is `-(1 + e) speed / (inverse mass)`.
fn collide(rigid: &mut RigidMechanisms, flap: Flap, (beyond, direction): (f64, DVec2), ball: &mut Ball) {
    let angle = rigid.angle(flap);
    // Hanging is (0, -1), and a positive angle swings the edge in the ball's direction.
    let (sin, cos) = trig::sin_cos(angle);
    let edge = DVec2::new(sin, -cos) * AXLE_TO_EDGE_M;
    let hinge = DVec2::new(0.0, AXLE_M);
    let upper = if matches!(flap, Flap::Spinner(_)) { hinge - edge } else { hinge };
    let line = Segment { a: upper, b: hinge + edge };
    let middle = DVec2::new(beyond, BALL_RADIUS_M);
    let contact = line.closest(middle);
    let Some(normal) = (middle - contact).try_normalize() else { return };
    if middle.distance(contact) > BALL_RADIUS_M {
        return;
    }
    let lever = (contact - hinge).perp_dot(normal);
    let speed = ball.velocity.dot(direction) * normal.x - rigid.angular_velocity(flap) * lever;
    if speed >= 0.0 {
        return;
    }
    let (least, most) = flap.range();
    let blocked = (angle <= least + STOP_RANGE_RAD && lever > 0.0) || (angle >= most - STOP_RANGE_RAD && lever < 0.0);
    let flap_inverse_mass = if blocked { 0.0 } else { lever * lever / flap.inertia() };
    let inverse_mass = normal.x * normal.x / BALL_MASS_KG + flap_inverse_mass;
    if inverse_mass <= 0.0 {
        return;
    }
    let restitution = if speed < -FLAP_RESTITUTION_THRESHOLD_M_S { FLAP_RESTITUTION } else { 0.0 };
    let impulse = -(1.0 + restitution) * speed / inverse_mass;
    ball.velocity += direction * (impulse * normal.x / BALL_MASS_KG);
    if !blocked {
        rigid.push(flap, -impulse * lever);
    }
}
