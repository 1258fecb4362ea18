//! The hull of two discs: a flipper seen from above.

use crate::{Bounds, Circle, Hit, Ray, Segment};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The convex hull of two discs. Where one disc holds the other, it is that disc alone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Taper {
    /// The disc at one end (a flipper's base).
    pub a: Circle,
    /// The disc at the other end (a flipper's tip).
    pub b: Circle,
}

impl Taper {
    /// The outward unit normals of the two straight sides (left and right of the way from `a` to `b`, y up), or `None`
    /// where one disc holds the other and there are no sides.
    pub fn side_normals(&self) -> Option<[DVec2; 2]> {
        let along = self.b.center - self.a.center;
        let length_squared = along.length_squared();
        let shrink = self.a.radius - self.b.radius;
        let rise_squared = length_squared - shrink * shrink;
        if rise_squared <= 0.0 {
            return None;
        }
        let lean = along * (shrink / length_squared);
        let across = along.perp() * (rise_squared.sqrt() / length_squared);
        Some([lean + across, lean - across])
    }

    /// The straight side with outward unit normal `normal`, one of [`Taper::side_normals`].
    pub fn side(&self, normal: DVec2) -> Segment {
        Segment { a: self.a.center + normal * self.a.radius, b: self.b.center + normal * self.b.radius }
    }

    /// The disc that holds the other, where there are no sides.
    fn larger(&self) -> Circle {
        if self.a.radius >= self.b.radius { self.a } else { self.b }
    }

    /// Signed distance from the outline (negative inside) and the outward unit normal there.
    pub fn distance(&self, point: DVec2) -> (f64, DVec2) {
        let from_disc = |disc: &Circle| (point.distance(disc.center) - disc.radius, disc.outward(point));
        let Some(normals) = self.side_normals() else { return from_disc(&self.larger()) };
        let along = self.b.center - self.a.center;
        let left = (point - self.a.center).dot(along.perp()) >= 0.0;
        let normal = normals[usize::from(!left)];
        let side = self.side(normal);
        let way = side.along();
        let offset = (point - side.a).dot(way);
        if offset < 0.0 {
            from_disc(&self.a)
        } else if offset > way.length_squared() {
            from_disc(&self.b)
        } else {
            ((point - side.a).dot(normal), normal)
        }
    }

    /// Where the ray enters the hull from outside.
    pub fn cast(&self, ray: &Ray) -> Option<Hit> {
        let Some(normals) = self.side_normals() else { return self.larger().cast(ray) };
        let mut first = Hit::nearer(self.a.cast(ray), self.b.cast(ray));
        for normal in normals {
            if ray.direction.dot(normal) < 0.0 {
                let side = self.side(normal).cast(ray).map(|hit| Hit { normal, ..hit });
                first = Hit::nearer(first, side);
            }
        }
        first.filter(|_| self.distance(ray.origin).0 >= 0.0)
    }

    /// The smallest box around the hull.
    pub fn bounds(&self) -> Bounds {
        self.a.bounds().union(self.b.bounds())
    }
}
