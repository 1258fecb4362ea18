//! When a ball on a straight way first touches something, and where: the roots.
//!
//! Refuses to know what happens then.

use crate::BALL_RADIUS_M;
use crate::ball::Ball;
use crate::collision::world::Obstacle;
use crate::mechanisms::flipper::Blade;
use geometry::{Core, DVec2, Ray};

/// Nearer than this is touching: far above rounding, far below anything else.
pub(crate) const TOUCH_M: f64 = 1e-9;
/// An approach slower than this is none.
pub(crate) const STILL_M_S: f64 = 1e-9;
/// A ball this near to a turning flipper has hit it.
pub(crate) const HIT_M: f64 = 1e-8;
/// A ball that rides round the inside of a curve does so in chords this far from it.
pub(crate) const CHORD_M: f64 = 5e-6;

/// Where a ray from outside first meets an obstacle that is `distance` away: how far, and the normal.
///
/// A ball that touches already is not cast: rounding may have put it a hair inside, from where nothing is entered.
pub(crate) fn cast(obstacle: &Obstacle, ray: &Ray, distance: f64, normal: DVec2, speed: f64) -> Option<(f64, DVec2)> {
    if distance > TOUCH_M {
        return obstacle.shape.cast(ray).map(|hit| (hit.distance, hit.normal));
    }
    if ray.direction.dot(normal) * speed < -STILL_M_S {
        return Some((0.0, normal));
    }
    // Along the inside of a curve the way leads back to it.
    let Core::Arc(arc) = &obstacle.shape.core else { return None };
    let radius = arc.circle().radius - obstacle.shape.radius;
    if radius <= 0.0 || (arc.circle().center - ray.origin).dot(normal) <= 0.0 {
        return None;
    }
    let hit = arc.with_radius(radius).cast_from_inside(ray)?;
    (hit.distance > 0.0 && hit.normal.dot(ray.direction) < 0.0).then_some((hit.distance, hit.normal))
}

/// The speed away from the inside of a curve with which a ball that is pressed to it rides round in short chords;
/// `None` where there is no curve to ride.
pub(crate) fn ride(obstacle: &Obstacle, ball: &Ball, approach: f64) -> Option<f64> {
    let Core::Arc(arc) = &obstacle.shape.core else { return None };
    let radius = arc.circle().radius - obstacle.shape.radius;
    let inward = arc.circle().center - ball.center;
    let normal = obstacle.shape.distance(ball.center).1;
    if radius <= 0.0 || inward.dot(normal) <= 0.0 || approach <= 0.0 {
        return None;
    }
    let along = ball.velocity.dot(normal.perp()).abs();
    Some(along * (2.0 * CHORD_M / radius).sqrt())
}

/// Gives back along the wall what a ride round a curve does not lose: a smooth curve turns the ball without work.
pub(crate) fn keep_speed(velocity: &mut DVec2, normal: DVec2, away: f64, kept: f64) {
    let along = velocity.dot(normal.perp());
    let speed = (along * along + kept * kept - away * away).max(0.0).sqrt();
    *velocity = normal * away + normal.perp() * speed.copysign(along);
}

pub(crate) fn is_out_of_reach(blade: &Blade, center: DVec2, travel: f64) -> bool {
    let reach = blade.reach + BALL_RADIUS_M + travel;
    center.distance_squared(blade.pivot()) > reach * reach
}

/// Whether two balls that are `away` from each other cannot meet on a way whose square is `way_squared`: roughly, and
/// without a root.
pub(crate) fn far_apart(away: DVec2, way_squared: f64) -> bool {
    const ROOM_M: f64 = 0.01;
    const FAR_M: f64 = 2.0 * BALL_RADIUS_M + ROOM_M;
    way_squared < ROOM_M * ROOM_M && away.length_squared() > FAR_M * FAR_M
}

/// When two balls meet, `away` from each other and moving at `velocity` against each other, and the normal.
pub(crate) fn meet(away: DVec2, velocity: DVec2) -> Option<(f64, DVec2)> {
    let touching = 2.0 * BALL_RADIUS_M;
    let distance = away.length();
    let closing = -away.dot(velocity);
    if closing <= STILL_M_S * distance {
        return None;
    }
    if distance - touching <= TOUCH_M {
        return Some((0.0, away.try_normalize().unwrap_or(DVec2::Y)));
    }
    let gap = (distance - touching) * (distance + touching);
    let square = closing * closing - velocity.length_squared() * gap;
    if square < 0.0 {
        return None;
    }
    let time = gap / (closing + square.sqrt());
    Some((time, (away + velocity * time).try_normalize()?))
}

/// When a ball meets a turning flipper, and the normal.
///
/// Conservative advancement in the flipper's frame: there the flipper is convex and stands still, so the distance falls
/// no faster than along the present normal, but for what the turning frame bends the ball's way (Coriolis and
/// centrifugal), which is bounded. Each step goes as far as the ball cannot have arrived.
pub(crate) fn meet_flipper(
    blade: &Blade,
    angle: f64,
    turn: f64,
    center: DVec2,
    velocity: DVec2,
    left: f64,
) -> Option<(f64, DVec2)> {
    let farthest = center.distance(blade.pivot()) + velocity.length() * left;
    let bend = turn.abs() * (2.0 * velocity.length() + turn.abs() * farthest);
    let mut time = 0.0;
    for _ in 0..64 {
        let place = center + velocity * time;
        let (distance, normal) = blade.taper(angle + turn * time).distance(place);
        let gap = distance - BALL_RADIUS_M;
        let lever = place - blade.pivot();
        let opening = (velocity - lever.perp() * turn).dot(normal);
        if gap <= HIT_M && opening < -STILL_M_S {
            return Some((time, normal));
        }
        let least = if gap <= HIT_M { left / 8.0 } else { 0.0 };
        time += safe_time(gap.max(0.0), opening, bend)?.max(least);
        if time > left {
            return None;
        }
    }
    None
}

/// The first time at which `gap + opening t - bend t^2 / 2` can be 0; `None` if never.
fn safe_time(gap: f64, opening: f64, bend: f64) -> Option<f64> {
    if bend <= 0.0 {
        return (opening < 0.0).then(|| gap / -opening);
    }
    let root = (opening * opening + 2.0 * bend * gap).sqrt();
    if opening >= 0.0 { Some((opening + root) / bend) } else { Some(2.0 * gap / (root - opening)) }
}
