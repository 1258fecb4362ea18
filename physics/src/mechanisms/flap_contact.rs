//! A ball that passes below the flap of a gate or the plate of a spinner, seen from the side.
//!
//! There the ball is a circle on the playfield and the plate a line that hangs from its axle. Where they touch, an
//! impulse passes along the normal, the same for both: the ball slows and the plate turns.

use crate::ball::Ball;
use crate::collision::world::{Place, Plan};
use crate::mechanisms::rigid_mechanisms::{AXLE_M, BLADE_M, Plate, Works};
use crate::{BALL_MASS_KG, BALL_RADIUS_M};
use geometry::{DVec2, Segment, trig};

/// The farthest that a ball goes between two looks at a plate, m.
const LOOK_M: f64 = 0.002;
/// Restitution of wire and sheet steel against the ball.
const RESTITUTION: f64 = 0.35;
/// Slower than this they stay together, m/s.
const SLOW_M_S: f64 = 0.05;
/// So near to its stop a plate lies on it, rad.
const STOP_RAD: f64 = 0.01;

/// Lets the ball that has come from `start` meet the plates that it passed.
pub(crate) fn pass(plan: &Plan, works: &mut Works, ball: &mut Ball, start: DVec2) {
    let mut met: [Option<Plate>; 4] = [None; 4];
    plan.zone_grid.visit(start, ball.center, |zone| {
        let plate = match plan.zones[zone].what {
            Place::Gate(index) => Plate::Gate(index),
            Place::Spinner(index) => Plate::Spinner(index),
            _ => return,
        };
        if !met.contains(&Some(plate))
            && let Some(free) = met.iter_mut().find(|one| one.is_none())
        {
            *free = Some(plate);
        }
    });
    for plate in met.into_iter().flatten() {
        let (axle, way) = match plate {
            Plate::Gate(index) => (plan.gates[index].1.segment, plan.gates[index].1.direction),
            Plate::Spinner(index) => {
                let segment = plan.spinners[index].1.segment;
                (segment, segment.left_normal().unwrap_or(DVec2::Y))
            }
        };
        pass_one(works, plate, axle, way, ball, start);
    }
}

fn pass_one(works: &mut Works, plate: Plate, axle: Segment, way: DVec2, ball: &mut Ball, start: DVec2) {
    let path = ball.center - start;
    let looks = (path.length() / LOOK_M).ceil().max(1.0);
    for look in 1..=looks as u32 {
        let center = start + path * (f64::from(look) / looks);
        let parameter = (center - axle.a).dot(axle.along()) / axle.along().length_squared();
        if (0.0..=1.0).contains(&parameter) {
            meet(works, plate, way, (center - axle.a).dot(way), ball);
        }
    }
}

/// The ball's centre is at `beyond` past the axle on its way.
fn meet(works: &mut Works, plate: Plate, way: DVec2, beyond: f64, ball: &mut Ball) {
    let angle = works.angle(plate);
    // Hanging is (0, -1), and a positive angle swings the edge the ball's way.
    let (sin, cos) = trig::sin_cos(angle);
    let edge = DVec2::new(sin, -cos) * BLADE_M;
    let hinge = DVec2::new(0.0, AXLE_M);
    let upper = if matches!(plate, Plate::Spinner(_)) { hinge - edge } else { hinge };
    let line = Segment { a: upper, b: hinge + edge };
    let middle = DVec2::new(beyond, BALL_RADIUS_M);
    let contact = line.closest(middle);
    let Some(normal) = (middle - contact).try_normalize() else { return };
    if middle.distance(contact) > BALL_RADIUS_M {
        return;
    }
    let turning = (contact - hinge).perp_dot(normal);
    let speed = ball.velocity.dot(way) * normal.x - works.turn(plate) * turning;
    if speed >= 0.0 {
        return;
    }
    let (least, most) = plate.range();
    let blocked = (angle <= least + STOP_RAD && turning > 0.0) || (angle >= most - STOP_RAD && turning < 0.0);
    let give = if blocked { 0.0 } else { turning * turning / plate.inertia() };
    let mass = normal.x * normal.x / BALL_MASS_KG + give;
    if mass <= 0.0 {
        return;
    }
    let restitution = if speed < -SLOW_M_S { RESTITUTION } else { 0.0 };
    let impulse = -(1.0 + restitution) * speed / mass;
    ball.velocity += way * (impulse * normal.x / BALL_MASS_KG);
    if !blocked {
        works.push(plate, -impulse * turning);
    }
}
