//! Core plus radius: the one kind of surface there is.

use crate::{Arc, Bounds, Circle, Hit, Ray, Segment, Taper};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What a shape is drawn around.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Core {
    /// One point: with a radius, a disc.
    Point(DVec2),
    /// A straight line: with a radius, a capsule.
    Segment(Segment),
    /// A piece of a circle's line: with a radius, a curved wall with round ends.
    Arc(Arc),
    /// The hull of two discs: a flipper.
    Taper(Taper),
}

/// A core and everything within `radius` of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// What the shape is drawn around.
    pub core: Core,
    /// How far the surface is from the core, 0 or more.
    pub radius: f64,
}

impl Shape {
    /// A disc.
    pub fn disc(center: DVec2, radius: f64) -> Shape {
        Shape { core: Core::Point(center), radius }
    }

    /// A straight wall, `2 * radius` thick, with round ends.
    pub fn capsule(a: DVec2, b: DVec2, radius: f64) -> Shape {
        Shape { core: Core::Segment(Segment { a, b }), radius }
    }

    /// The same core with `extra` more radius: the places of a disc's centre when the disc touches this shape.
    pub fn inflated(self, extra: f64) -> Shape {
        Shape { radius: self.radius + extra, ..self }
    }

    /// The shape in another unit: every length times `factor`, which is over 0.
    pub fn scaled(self, factor: f64) -> Shape {
        let circle = |c: Circle| Circle { center: c.center * factor, radius: c.radius * factor };
        let core = match self.core {
            Core::Point(center) => Core::Point(center * factor),
            Core::Segment(s) => Core::Segment(Segment { a: s.a * factor, b: s.b * factor }),
            Core::Arc(arc) => Core::Arc(arc.scaled(factor)),
            Core::Taper(t) => Core::Taper(Taper { a: circle(t.a), b: circle(t.b) }),
        };
        Shape { core, radius: self.radius * factor }
    }

    /// Signed distance of `point` from the surface (negative inside; a thin core has no inside beyond its radius) and
    /// the unit normal there, away from the core.
    pub fn distance(&self, point: DVec2) -> (f64, DVec2) {
        match &self.core {
            Core::Point(center) => self.from(point, *center, || DVec2::X),
            Core::Segment(segment) => {
                self.from(point, segment.closest(point), || segment.left_normal().unwrap_or(DVec2::X))
            }
            Core::Arc(arc) => self.from(point, arc.closest(point), || arc.circle().outward(point)),
            Core::Taper(taper) => {
                let (distance, normal) = taper.distance(point);
                (distance - self.radius, normal)
            }
        }
    }

    /// Distance and normal where the core's nearest point is `closest`; on the core itself the normal is `fallback`.
    fn from(&self, point: DVec2, closest: DVec2, fallback: impl FnOnce() -> DVec2) -> (f64, DVec2) {
        let away = point - closest;
        (away.length() - self.radius, away.try_normalize().unwrap_or_else(fallback))
    }

    /// Where the ray first enters the shape. A ray that starts inside is already in and enters nothing; a core without
    /// radius is a line, met from both sides.
    pub fn cast(&self, ray: &Ray) -> Option<Hit> {
        match &self.core {
            Core::Point(center) => Circle { center: *center, radius: self.radius }.cast(ray),
            Core::Segment(segment) => self.cast_capsule(segment, ray),
            Core::Arc(arc) => self.cast_thick_arc(arc, ray),
            Core::Taper(taper) => {
                let grow = |disc: Circle| Circle { radius: disc.radius + self.radius, ..disc };
                Taper { a: grow(taper.a), b: grow(taper.b) }.cast(ray)
            }
        }
    }

    fn cast_capsule(&self, segment: &Segment, ray: &Ray) -> Option<Hit> {
        if self.radius == 0.0 {
            return segment.cast(ray);
        }
        let end = |center| Circle { center, radius: self.radius };
        Taper { a: end(segment.a), b: end(segment.b) }.cast(ray)
    }

    fn cast_thick_arc(&self, arc: &Arc, ray: &Ray) -> Option<Hit> {
        if self.radius == 0.0 {
            return arc.cast(ray);
        }
        if self.distance(ray.origin).0 < 0.0 {
            return None;
        }
        let radius = arc.circle().radius;
        let mut first = arc.with_radius(radius + self.radius).cast_from_outside(ray);
        if radius > self.radius {
            first = Hit::nearer(first, arc.with_radius(radius - self.radius).cast_from_inside(ray));
        }
        for end in arc.ends() {
            first = Hit::nearer(first, Circle { center: end, radius: self.radius }.cast(ray));
        }
        first
    }

    /// The smallest box around the core, grown by the radius.
    pub fn bounds(&self) -> Bounds {
        let core = match &self.core {
            Core::Point(center) => Bounds::of(*center, *center),
            Core::Segment(segment) => segment.bounds(),
            Core::Arc(arc) => arc.bounds(),
            Core::Taper(taper) => taper.bounds(),
        };
        core.grown(self.radius)
    }
}
