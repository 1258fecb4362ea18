//! A ray and what it meets.

use glam::DVec2;

/// A half line: where it starts and which way it goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where the ray starts.
    pub origin: DVec2,
    /// The way it goes; of length 1.
    pub direction: DVec2,
}

impl Ray {
    /// The ray from `origin` through `target`, or `None` where the two are the same point or not finite.
    pub fn towards(origin: DVec2, target: DVec2) -> Option<Ray> {
        let direction = (target - origin).try_normalize()?;
        origin.is_finite().then_some(Ray { origin, direction })
    }

    /// The point at `distance` along the ray.
    pub fn at(&self, distance: f64) -> DVec2 {
        self.origin + self.direction * distance
    }
}

/// Where a ray enters a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// How far along the ray, 0 or more.
    pub distance: f64,
    /// The surface's unit normal there, on the side that the ray came from.
    pub normal: DVec2,
}

impl Hit {
    /// The nearer of two hits.
    pub fn nearer(a: Option<Hit>, b: Option<Hit>) -> Option<Hit> {
        match (a, b) {
            (Some(a), Some(b)) => Some(if b.distance < a.distance { b } else { a }),
            (a, b) => a.or(b),
        }
    }
}
