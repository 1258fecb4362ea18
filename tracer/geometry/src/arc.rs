//! A piece of a circle's line.

use crate::{Bounds, Circle, Hit, Ray, trig};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A piece of a circle's line, up to the whole of it, met from both sides.
///
/// It is kept as the direction of its middle and half its angle, so that "is this point on it" is one dot product.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arc {
    circle: Circle,
    middle: DVec2,
    half_angle: f64,
    cos_half_angle: f64,
    /// The unit vectors from the centre to the ends: kept, because trigonometry at every question would cost more than
    /// the question.
    ends: [DVec2; 2],
}

impl Arc {
    /// The arc of `circle` that starts at `start_rad` and goes on for `sweep_rad` (negative: the other way; more than a
    /// turn is a whole turn).
    pub fn new(circle: Circle, start_rad: f64, sweep_rad: f64) -> Arc {
        let half_angle = (sweep_rad.abs() * 0.5).min(std::f64::consts::PI);
        let middle = trig::direction(start_rad + half_angle.copysign(sweep_rad));
        let (sin, cos) = trig::sin_cos(half_angle);
        let ends = [DVec2::new(cos, -sin).rotate(middle), DVec2::new(cos, sin).rotate(middle)];
        Arc { circle, middle, half_angle, cos_half_angle: cos, ends }
    }

    /// The arc's two ends, in the order of [`Arc::at`].
    pub fn ends(&self) -> [DVec2; 2] {
        self.ends.map(|end| self.circle.center + end * self.circle.radius)
    }

    /// The circle that the arc is a piece of.
    pub fn circle(&self) -> Circle {
        self.circle
    }

    /// Half of the angle that the arc spans, in [0, pi].
    pub fn half_angle(&self) -> f64 {
        self.half_angle
    }

    /// The cosine of half of the angle that the arc spans.
    pub fn cos_half_angle(&self) -> f64 {
        self.cos_half_angle
    }

    /// The unit vector from the centre to the arc's middle.
    pub fn middle(&self) -> DVec2 {
        self.middle
    }

    /// The same arc with another radius round the same centre.
    pub fn with_radius(&self, radius: f64) -> Arc {
        Arc { circle: Circle { radius, ..self.circle }, ..*self }
    }

    /// The arc in another unit: every length times `factor`, which is over 0.
    pub fn scaled(&self, factor: f64) -> Arc {
        let Circle { center, radius } = self.circle;
        Arc { circle: Circle { center: center * factor, radius: radius * factor }, ..*self }
    }

    /// The point of the arc at `part` of the way: 0 and 1 are its ends.
    pub fn at(&self, part: f64) -> DVec2 {
        let turned = trig::rotate(self.middle, (2.0 * part - 1.0) * self.half_angle);
        self.circle.center + turned * self.circle.radius
    }

    /// Whether the direction from the centre to `point` lies within the arc's angle.
    pub fn spans(&self, point: DVec2) -> bool {
        let from_center = point - self.circle.center;
        from_center.dot(self.middle) >= self.cos_half_angle * from_center.length()
    }

    /// The point of the arc nearest to `point`.
    pub fn closest(&self, point: DVec2) -> DVec2 {
        if self.spans(point) {
            let outward = (point - self.circle.center).try_normalize().unwrap_or(self.middle);
            return self.circle.center + outward * self.circle.radius;
        }
        let [start, end] = self.ends();
        if point.distance_squared(end) < point.distance_squared(start) { end } else { start }
    }

    /// Where the ray first crosses the arc's line, from either side.
    pub fn cast(&self, ray: &Ray) -> Option<Hit> {
        Hit::nearer(self.cast_from_outside(ray), self.cast_from_inside(ray))
    }

    /// Where the ray enters the circle through the arc.
    pub fn cast_from_outside(&self, ray: &Ray) -> Option<Hit> {
        self.circle.cast(ray).filter(|hit| self.spans(ray.at(hit.distance)))
    }

    /// Where the ray leaves the circle through the arc.
    pub fn cast_from_inside(&self, ray: &Ray) -> Option<Hit> {
        self.circle.cast_from_inside(ray).filter(|hit| self.spans(ray.at(hit.distance)))
    }

    /// The smallest box around the arc.
    pub fn bounds(&self) -> Bounds {
        let Circle { center, radius } = self.circle;
        [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y]
            .into_iter()
            .map(|axis| center + axis * radius)
            .filter(|&extreme| self.spans(extreme))
            .fold(Bounds::of(self.ends()[0], self.ends()[1]), |bounds, extreme| {
                bounds.union(Bounds::of(extreme, extreme))
            })
    }
}
