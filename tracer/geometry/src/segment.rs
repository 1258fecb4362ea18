//! A straight piece of line.

use crate::{Bounds, Hit, Ray};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The straight line from `a` to `b`, met from both sides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Segment {
    /// One end.
    pub a: DVec2,
    /// The other end.
    pub b: DVec2,
}

impl Segment {
    /// From `a` to `b`, with the length of the segment.
    pub fn along(&self) -> DVec2 {
        self.b - self.a
    }

    /// The length.
    pub fn length(&self) -> f64 {
        self.along().length()
    }

    /// The unit normal on the left of the way from `a` to `b` (y up), or `None` for a segment without length.
    pub fn left_normal(&self) -> Option<DVec2> {
        self.along().try_normalize().map(DVec2::perp)
    }

    /// Where along the segment its point nearest to `point` lies: 0 at `a`, 1 at `b`.
    pub fn parameter(&self, point: DVec2) -> f64 {
        let along = self.along();
        let length_squared = along.length_squared();
        if length_squared == 0.0 { 0.0 } else { ((point - self.a).dot(along) / length_squared).clamp(0.0, 1.0) }
    }

    /// The point of the segment nearest to `point`.
    pub fn closest(&self, point: DVec2) -> DVec2 {
        self.a + self.along() * self.parameter(point)
    }

    /// Where the ray crosses the segment, from either side. A ray along the segment's own line does not cross it.
    pub fn cast(&self, ray: &Ray) -> Option<Hit> {
        let along = self.along();
        let denominator = ray.direction.perp_dot(along);
        if denominator == 0.0 {
            return None;
        }
        let to_a = self.a - ray.origin;
        let distance = to_a.perp_dot(along) / denominator;
        let parameter = to_a.perp_dot(ray.direction) / denominator;
        if distance < 0.0 || !(0.0..=1.0).contains(&parameter) {
            return None;
        }
        let left = self.left_normal()?;
        Some(Hit { distance, normal: if denominator > 0.0 { -left } else { left } })
    }

    /// The smallest box around the segment.
    pub fn bounds(&self) -> Bounds {
        Bounds::of(self.a, self.b)
    }
}
