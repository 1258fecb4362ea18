//! A floating ball as a sphere in space: what it hides of a lamp from a point of the floor, in double precision, where
//! [`crate::floating`] is fast.
//!
//! Nothing is projected here: rays are rays in space, and the tangent cone is where `(x . m)^2 = |x|^2 (|m|^2 - r^2)`,
//! with the point as the origin and `m` the sphere's centre. On a line x = middle + s along, that is a quadratic
//! equation in s.

use crate::scene::validation;
use crate::{Ball, Group, Lamp};
use geometry::{DVec2, trig};

/// Into how many strips a lamp's disc is cut.
const REFERENCE_STRIPS: usize = 1024;

/// A sphere, seen from a point of the floor, which is the origin: x, y, and z upwards, mm.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sphere {
    middle: [f64; 3],
    radius: f64,
}

/// The balls that may hide `lamp`: they float, their lowest points are lower than it is, and it is not of their own
/// group.
pub(crate) fn occluding_balls<'a>(
    balls: &'a [Ball],
    lamp: &Lamp,
    without: Option<Group>,
) -> impl Iterator<Item = &'a Ball> + use<'a> {
    let (height, inside) = (lamp.height_mm(), lamp.inside);
    balls.iter().filter(move |ball| {
        let counts = Some(ball.group) != inside && Some(ball.group) != without;
        ball.is_airborne() && ball.height_mm < height && counts && validation::wrong_with_ball(ball).is_none()
    })
}

/// How much of `lamp` the floating balls leave to a point of the floor, but for those of a group.
pub(crate) fn unoccluded_fraction(balls: &[Ball], lamp: &Lamp, point: DVec2, without: Option<Group>) -> f64 {
    occluding_balls(balls, lamp, without).map(|ball| 1.0 - Sphere::new(ball, point).hidden_share(lamp, point)).product()
}

impl Sphere {
    /// `ball`, seen from a point of the floor.
    pub fn new(ball: &Ball, point: DVec2) -> Sphere {
        let across = ball.center_mm - point;
        Sphere { middle: [across.x, across.y, ball.radius_mm + ball.lift_mm()], radius: ball.radius_mm }
    }

    /// Whether it is on the way to a place.
    pub fn hides(&self, target: [f64; 3]) -> bool {
        let along = (dot(target, self.middle) / dot(target, target)).clamp(0.0, 1.0);
        let off = [0, 1, 2].map(|axis: usize| self.middle[axis] - target[axis] * along);
        dot(off, off) <= self.radius * self.radius
    }

    /// Whether it may be on the way to any place that is so far from a target.
    pub fn may_hide(&self, target: [f64; 3], room: f64) -> bool {
        Sphere { radius: self.radius + room, ..*self }.hides(target)
    }

    /// What it hides of a lamp from the point that it is seen from.
    fn hidden_share(&self, lamp: &Lamp, point: DVec2) -> f64 {
        let across = lamp.center_mm - point;
        let (height, radius) = (lamp.height_mm(), lamp.radius_mm());
        let target = [across.x, across.y, height];
        if !self.may_hide(target, radius) {
            return 0.0;
        }
        if let Some(half) = lamp.tube() {
            let along = half / half.length();
            let (foot, aside) = (across.dot(along), across.perp_dot(along));
            let square = aside * aside + height * height;
            // What arrives from a stretch is the angle that it is seen under.
            let arrives = |(low, high): (f64, f64)| {
                libm::atan2((high - low) * square.sqrt(), square + (foot + low) * (foot + high))
            };
            return self.covered(target, along, radius).map_or(0.0, arrives) / arrives((-radius, radius));
        }
        if radius == 0.0 {
            return f64::from(u8::from(self.hides(target)));
        }
        // The middle of each of many strips, as wide as equal angles round the disc make them.
        let (mut hidden, mut whole) = (0.0, 0.0);
        for strip in 1..=REFERENCE_STRIPS {
            let (sin, cos) = trig::sin_cos(std::f64::consts::PI * strip as f64 / (REFERENCE_STRIPS + 1) as f64);
            let half = radius * sin;
            let middle = [target[0], target[1] + radius * cos, height];
            whole += sin * sin;
            hidden +=
                sin * sin * self.covered(middle, DVec2::X, half).map_or(0.0, |(low, high)| (high - low) / (2.0 * half));
        }
        hidden / whole
    }

    /// The part of a level line that is hidden: the line has its middle at `middle`, its direction is `along`, and half
    /// of its length is given. What a sphere's lower part hides of a plane is convex, so it is one part.
    fn covered(&self, middle: [f64; 3], along: DVec2, half: f64) -> Option<(f64, f64)> {
        let along = [along.x, along.y, 0.0];
        let tangent_square = dot(self.middle, self.middle) - self.radius * self.radius;
        let (start, step) = (dot(middle, self.middle), dot(along, self.middle));
        let mut part: Option<(f64, f64)> = None;
        let mut add = |(low, high): (f64, f64)| {
            let (low, high) = (low.max(-half), high.min(half));
            if low <= high {
                part = Some(part.map_or((low, high), |(least, most)| (low.min(least), high.max(most))));
            }
        };
        // 1. Within the cone: (start + s step)^2 >= (|middle|^2 + 2 s middle . along + s^2) tangent^2, a s^2 + 2 b s +
        //    c >= 0.
        // 2. Beyond the circle where the cone touches the sphere: x . m >= tangent^2.
        let a = step * step - tangent_square;
        let b = start * step - dot(middle, along) * tangent_square;
        let c = start * start - dot(middle, middle) * tangent_square;
        if let Some((low, high)) = between_roots(-a, -b, -c) {
            let touch = (tangent_square - start) / step;
            match step {
                _ if step > 0.0 => add((low.max(touch), high)),
                _ if step < 0.0 => add((low, high.min(touch))),
                _ if start >= tangent_square => add((low, high)),
                _ => {}
            }
        }
        // 3. Within the sphere itself.
        let from_middle = [0, 1, 2].map(|axis: usize| middle[axis] - self.middle[axis]);
        let inside = dot(from_middle, from_middle) - self.radius * self.radius;
        between_roots(1.0, dot(from_middle, along), inside).into_iter().for_each(add);
        part
    }
}

/// Where `a s^2 + 2 b s + c` is not above 0, for `a` above 0.
fn between_roots(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let square = b * b - a * c;
    (square >= 0.0).then(|| ((-b - square.sqrt()) / a, (-b + square.sqrt()) / a))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
