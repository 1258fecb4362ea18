//! The shapes of a table's parts, as balls meet them.

use geometry::{Circle, Core, Hit, Ray, Shape, Taper, trig};
use physics::{BALL_RADIUS_M, BallPose, Kind, Layout, Leg, Part, Pose};

pub(super) const SOLID: u32 = 0x4f_d8ff;
pub(super) const SENSOR: u32 = 0x8a_ff9a;
pub(super) const ABOVE: u32 = 0xff_c86b;
pub(super) const CAPTIVE: u32 = 0xff_d28a;

/// Where a ball that flies along `ray` first meets something solid: the same rays, the same shapes, grown by the
/// ball's radius.
pub(super) fn first_hit(layout: &Layout, pose: &Pose, ball: &BallPose, ray: &Ray) -> Option<Hit> {
    if ball.above {
        return None; // what stands on the playfield is not in its way
    }
    let still = layout.parts.iter().flat_map(|part| standing(&part.kind));
    let moving = layout.parts.iter().enumerate().flat_map(|(index, part)| moving(index, part, pose));
    let captives = pose.captives.iter().map(|(_, captive)| captive);
    let others = pose.balls.iter().chain(captives).filter(|other| other.id != ball.id);
    let balls = others.map(|other| Shape::disc(other.center, BALL_RADIUS_M));
    let solids = still.chain(moving).filter(|(_, color)| *color == SOLID).map(|(shape, _)| shape);
    let cast = |shape: Shape| shape.inflated(BALL_RADIUS_M).cast(ray);
    solids.chain(balls).map(cast).fold(None, Hit::nearer)
}

/// The shapes of a part that stand still, m, with the colour of what they do.
pub(super) fn standing(part: &Kind) -> Vec<(Shape, u32)> {
    let thin = |segment: geometry::Segment| Shape::capsule(segment.a, segment.b, 0.0005);
    match part {
        Kind::Wall(wall) => wall.shapes.iter().map(|&shape| (shape, SOLID)).collect(),
        Kind::Bumper(bumper) => vec![(Shape::disc(bumper.circle.center, bumper.circle.radius), SOLID)],
        Kind::Slingshot(sling) => vec![(Shape::capsule(sling.segment.a, sling.segment.b, sling.radius_m), SOLID)],
        Kind::Target(target) => vec![(target.shape, SOLID)],
        Kind::Gate(gate) => vec![(thin(gate.segment), SENSOR)],
        Kind::Spinner(spinner) => vec![(thin(spinner.segment), SENSOR)],
        Kind::Ramp(ramp) => ramp.path.iter().flat_map(|leg| sides(leg, ramp.half_width_m)).collect(),
        other => other.sensor().map(|shape| (shape, SENSOR)).into_iter().collect(),
    }
}

/// The two sides of a piece of a way above the playfield.
fn sides(leg: &Leg, half_width_m: f64) -> [(Shape, u32); 2] {
    [-half_width_m, half_width_m].map(|offset| (Shape { core: leg.offset(offset), radius: 0.0005 }, ABOVE))
}

/// The shapes of a part that moves, m, where they are in a pose.
pub(super) fn moving(index: usize, part: &Part, pose: &Pose) -> Vec<(Shape, u32)> {
    let value = |parts: &[(physics::PartId, f64)]| {
        parts.iter().find(|(id, _)| usize::from(id.0) == index).map(|(_, value)| *value)
    };
    match &part.kind {
        Kind::Flipper(flipper) => {
            let angle = value(&pose.flippers_rad).unwrap_or(flipper.rest_rad);
            let center = flipper.base.center + trig::direction(angle) * flipper.length_m;
            let taper = Taper { a: flipper.base, b: Circle { center, radius: flipper.tip_radius_m } };
            vec![(Shape { core: Core::Taper(taper), radius: 0.0 }, SOLID)]
        }
        Kind::DropTarget(target) => {
            let up = value(&pose.drop_targets).is_none_or(|height| height > 0.5);
            vec![(target.shape, if up { SOLID } else { SENSOR })]
        }
        Kind::Plunger(plunger) => {
            let tip = plunger.tip - plunger.direction * (plunger.stroke_m * pose.plunger);
            let half = plunger.direction.perp() * plunger.half_width_m;
            vec![(Shape::capsule(tip - half, tip + half, 0.0), SOLID)]
        }
        Kind::Kickback(kickback) => {
            let out = value(&pose.extensions).unwrap_or_default();
            let tip = kickback.tip + kickback.direction * (kickback.stroke_m * out);
            let half = kickback.direction.perp() * kickback.half_width_m;
            vec![(Shape::capsule(tip - half, tip + half, 0.0), SOLID)]
        }
        Kind::CaptiveBall(_) => {
            let captive = pose.captives.iter().find(|(id, _)| usize::from(id.0) == index);
            captive.map(|(_, ball)| (Shape::disc(ball.center, BALL_RADIUS_M), CAPTIVE)).into_iter().collect()
        }
        _ => Vec::new(),
    }
}
