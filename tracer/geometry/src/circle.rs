//! A circle, seen from outside and from inside.

use crate::{Bounds, Hit, Ray};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A circle; as a solid, the disc inside it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Circle {
    /// The middle.
    pub center: DVec2,
    /// 0 or more.
    pub radius: f64,
}

impl Circle {
    /// Distances along the ray's whole line at which it crosses the circle, entry first.
    ///
    /// The discriminant is taken from the distance between line and centre, not from `b^2 - 4ac`: no cancellation when
    /// the ray starts far away.
    pub fn crossings(&self, ray: &Ray) -> Option<(f64, f64)> {
        let to_origin = ray.origin - self.center;
        let miss = ray.direction.perp_dot(to_origin);
        let half_chord_squared = (self.radius - miss) * (self.radius + miss);
        if half_chord_squared < 0.0 {
            return None;
        }
        let half_chord = half_chord_squared.sqrt();
        let nearest = -ray.direction.dot(to_origin);
        Some((nearest - half_chord, nearest + half_chord))
    }

    /// Where the ray enters the disc from outside.
    pub fn cast(&self, ray: &Ray) -> Option<Hit> {
        let (entry, _) = self.crossings(ray)?;
        (entry >= 0.0).then(|| Hit { distance: entry, normal: self.outward(ray.at(entry)) })
    }

    /// Where a ray that starts inside leaves the disc; the normal points inwards.
    pub fn cast_from_inside(&self, ray: &Ray) -> Option<Hit> {
        let (_, exit) = self.crossings(ray)?;
        (exit >= 0.0).then(|| Hit { distance: exit, normal: -self.outward(ray.at(exit)) })
    }

    /// The unit vector from the centre to `point` (the x axis at the very centre).
    pub fn outward(&self, point: DVec2) -> DVec2 {
        (point - self.center).try_normalize().unwrap_or(DVec2::X)
    }

    /// The smallest box around the circle.
    pub fn bounds(&self) -> Bounds {
        Bounds::of(self.center, self.center).grown(self.radius)
    }
}
