//! Time of impact: when a ball on a straight path first touches an obstacle, a turning flipper or another ball, and the
//! normal there.
//!
//! A ball against a surface is a point against the surface inflated by the ball's radius (Ericson, Real-Time Collision
//! Detection, 2005, 5.5.2), so a still obstacle takes one ray cast. Refuses to know what happens then.

use crate::BALL_RADIUS_M;
use crate::collision::obstacle::Obstacle;
use geometry::{DVec2, Ray, Taper};

/// Nearer than this is touching, m: far above rounding, far below anything else.
pub(crate) const TOUCH_M: f64 = 1e-9;
/// An approach slower than this is none, m/s: a nanometre in a second.
pub(crate) const MIN_APPROACH_M_S: f64 = 1e-9;
/// Tolerance of conservative advancement, m: a ball this near to a turning flipper has hit it.
const ADVANCEMENT_TOLERANCE_M: f64 = 1e-8;
/// Steps of conservative advancement, at most: a ball that has not met the outline after so many only grazes it.
const MAX_ADVANCEMENTS: usize = 64;
/// A flipper that is within the tolerance and does not approach is looked at again after one part in so many of the
/// time: the sign of the approach does not change faster.
const TOUCHING_PARTS: f64 = 8.0;
/// Two balls are tested roughly first: within this margin of each other and of the path, m...
const NEAR_MARGIN_M: f64 = 0.01;
/// ... so from this distance of their centres on they cannot meet.
pub(crate) const FAR_APART_M: f64 = 2.0 * BALL_RADIUS_M + NEAR_MARGIN_M;

/// The straight path of a ball's centre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StraightPath {
    pub center: DVec2,
    /// m/s.
    pub velocity: DVec2,
    /// s.
    pub duration: f64,
}

/// A time of impact, from the path's start, and the unit normal from the other to the ball.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Impact {
    pub time: f64,
    pub normal: DVec2,
}

/// A convex outline that turns evenly about a pivot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TurningOutline<F> {
    pub pivot: DVec2,
    /// Its outline at an angle.
    pub outline: F,
    /// At the path's start, rad.
    pub angle: f64,
    /// rad/s.
    pub angular_velocity: f64,
}

/// Where a ray from outside first meets an obstacle that is `distance` away with this normal: how far, and the normal.
///
/// A ball that touches already is not cast: rounding may have put it a hair inside, from where nothing is entered.
pub(crate) fn cast(obstacle: &Obstacle, ray: &Ray, distance: f64, normal: DVec2, speed: f64) -> Option<(f64, DVec2)> {
    if distance > TOUCH_M {
        return obstacle.shape.cast(ray).map(|hit| (hit.distance, hit.normal));
    }
    if ray.direction.dot(normal) * speed < -MIN_APPROACH_M_S {
        return Some((0.0, normal));
    }
    // Along the inside of a curve the path leads back to it.
    let hit = obstacle.inner_curve(ray.origin, normal)?.cast_from_inside(ray)?;
    (hit.distance > 0.0 && hit.normal.dot(ray.direction) < 0.0).then_some((hit.distance, hit.normal))
}

/// Whether two balls with this offset cannot meet on a path whose squared length is `path_squared`: roughly, and without
/// a root.
pub(crate) fn are_far_apart(offset: DVec2, path_squared: f64) -> bool {
    path_squared < NEAR_MARGIN_M * NEAR_MARGIN_M && offset.length_squared() > FAR_APART_M * FAR_APART_M
}

/// Time of impact of two balls, of which one has this offset and velocity against the other.
///
/// The sphere-sphere sweep (Ericson 5.5.5): `|offset + velocity t| = 2 r` is the quadratic
/// `v^2 t^2 + 2 (o.v) t + (o^2 - 4 r^2) = 0`. Its smaller root is written with the sum of two numbers of one sign below
/// the fraction bar, so that nothing cancels when the balls are near.
pub(crate) fn ball_time_of_impact(offset: DVec2, velocity: DVec2) -> Option<Impact> {
    let touching = 2.0 * BALL_RADIUS_M;
    let distance = offset.length();
    let closing = -offset.dot(velocity);
    if closing <= MIN_APPROACH_M_S * distance {
        return None;
    }
    if distance - touching <= TOUCH_M {
        return Some(Impact { time: 0.0, normal: offset.try_normalize().unwrap_or(DVec2::Y) });
    }
    let gap = (distance - touching) * (distance + touching);
    let discriminant = closing * closing - velocity.length_squared() * gap;
    if discriminant < 0.0 {
        return None;
    }
    let time = gap / (closing + discriminant.sqrt());
    Some(Impact { time, normal: (offset + velocity * time).try_normalize()? })
}

/// Time of impact of a ball and a turning convex outline, by conservative advancement (Mirtich, Impulse-based Dynamic
/// Simulation of Rigid Body Systems, 1996, 2.3; Ericson 5.5.3), in the frame that turns with the outline.
///
/// 1. There the outline stands still and is convex, so the gap closes no faster than along the present normal...
/// 2. ... but for what the turning frame bends the ball's path: Coriolis `2 w v` and centrifugal `w^2 R`, with `R` the
///    farthest that the ball can be from the pivot. That bound is `bend`.
/// 3. So the gap after `t` is at least `gap + opening t - bend t^2 / 2`. The path is followed to the first zero of that.
/// 4. Again from there, until the gap is within the tolerance and closes.
pub(crate) fn turning_time_of_impact<F: Fn(f64) -> Taper>(
    turning: &TurningOutline<F>,
    path: &StraightPath,
) -> Option<Impact> {
    let &TurningOutline { pivot, ref outline, angle, angular_velocity } = turning;
    let &StraightPath { center, velocity, duration } = path;
    let farthest = center.distance(pivot) + velocity.length() * duration;
    let bend = angular_velocity.abs() * (2.0 * velocity.length() + angular_velocity.abs() * farthest);
    let mut time = 0.0;
    for _ in 0..MAX_ADVANCEMENTS {
        let place = center + velocity * time;
        let (distance, normal) = outline(angle + angular_velocity * time).distance(place);
        let gap = distance - BALL_RADIUS_M;
        let lever = place - pivot;
        let opening = (velocity - lever.perp() * angular_velocity).dot(normal);
        if gap <= ADVANCEMENT_TOLERANCE_M && opening < -MIN_APPROACH_M_S {
            return Some(Impact { time, normal });
        }
        let least = if gap <= ADVANCEMENT_TOLERANCE_M { duration / TOUCHING_PARTS } else { 0.0 };
        time += first_zero(gap.max(0.0), opening, bend)?.max(least);
        if time > duration {
            return None;
        }
    }
    None
}

/// The first time at which `gap + opening t - bend t^2 / 2` is 0; `None` if never. Of the two forms of the root that
/// in which nothing cancels.
fn first_zero(gap: f64, opening: f64, bend: f64) -> Option<f64> {
    if bend <= 0.0 {
        return (opening < 0.0).then(|| gap / -opening);
    }
    let root = (opening * opening + 2.0 * bend * gap).sqrt();
    if opening >= 0.0 { Some((opening + root) / bend) } else { Some(2.0 * gap / (root - opening)) }
}
