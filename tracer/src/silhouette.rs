//! Occluders as chains of discs: the form in which their shadows are found.
//!
//! From any point outside it, the hull of two discs covers the hull of what the two discs cover, so a capsule or a
//! taper is two discs, and a wall of many capsules is one chain whose links need no light between them. A thick arc is
//! a chain too, of short pieces; between the two discs of a piece, the arc's outer circle bulges out. This module knows
//! no lamp.

use crate::{Group, Occluder};
use geometry::{Arc, Circle, Core, DVec2, Shape};

/// The widest angle of one piece of an arc, radians.
const PIECE_RAD: f64 = 0.35;

/// How far the chord of one fine piece of an arc may be from the arc, mm.
const FINE_SAGITTA_MM: f64 = 0.005;

/// One disc of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Disc {
    /// The middle, mm.
    pub center: DVec2,
    /// The radius, mm, 0 or more.
    pub radius: f64,
    /// What the occluder belongs to.
    pub group: Group,
    /// How the disc hangs on the one before it.
    pub link: Link,
}

/// How a disc hangs on the one before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Link {
    /// It does not: a chain starts here.
    Start,
    /// The hull of both discs is filled.
    Straight,
    /// As `Straight`, and the bulge of this index lies on it.
    Bulge(u32),
}

/// The outer circle of a piece of a thick arc.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bulge {
    /// The arc's outer circle.
    pub outer: Circle,
    /// The unit vector from the circle's middle to the piece's.
    pub middle: DVec2,
    /// Cosine of half of the piece's angle.
    pub cos_half: f64,
    /// How far the piece is from its chord, mm.
    pub sagitta_mm: f64,
    /// Where the same piece lies in [`Silhouettes::fine`], cut so finely that chords will do: first and last vertex.
    pub fine: (usize, usize),
}

/// Every occluder of a scene, as chains.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Silhouettes {
    /// The discs of all chains, one chain after another.
    pub discs: Vec<Disc>,
    /// The bulges of the arcs.
    pub bulges: Vec<Bulge>,
    /// Vertices of the arcs' core lines, mm.
    pub fine: Vec<DVec2>,
}

impl Silhouettes {
    /// Takes the place of what was here; shapes that are not finite cast no shadow.
    pub fn set(&mut self, occluders: &[Occluder]) {
        self.discs.clear();
        self.bulges.clear();
        self.fine.clear();
        for Occluder { shape, group } in occluders {
            self.push(shape, *group);
        }
    }

    fn push(&mut self, shape: &Shape, group: Group) {
        let bounds = shape.bounds();
        if !(bounds.min.is_finite() && bounds.max.is_finite()) {
            return;
        }
        let radius = shape.radius.max(0.0);
        match shape.core {
            Core::Point(center) => self.push_disc(Circle { center, radius }, group, Link::Start),
            Core::Segment(segment) => {
                self.push_hull(Circle { center: segment.a, radius }, Circle { center: segment.b, radius }, group);
            }
            Core::Taper(taper) => {
                let grown = |disc: Circle| Circle { radius: (disc.radius + radius).max(0.0), ..disc };
                self.push_hull(grown(taper.a), grown(taper.b), group);
            }
            Core::Arc(arc) => self.push_arc(&arc, radius, group),
        }
    }

    fn push_disc(&mut self, disc: Circle, group: Group, link: Link) {
        self.discs.push(Disc { center: disc.center, radius: disc.radius, group, link });
    }

    /// The hull of two discs; it goes on with the last chain where one of them is where that ends.
    fn push_hull(&mut self, a: Circle, b: Circle, group: Group) {
        let apart = a.center.distance(b.center);
        if apart <= (a.radius - b.radius).abs() {
            let larger = if a.radius >= b.radius { a } else { b };
            return self.push_disc(larger, group, Link::Start);
        }
        let ends_at = |disc: &Circle| {
            self.discs
                .last()
                .is_some_and(|last| last.group == group && last.center == disc.center && last.radius == disc.radius)
        };
        if ends_at(&a) {
            self.push_disc(b, group, Link::Straight);
        } else if ends_at(&b) {
            self.push_disc(a, group, Link::Straight);
        } else {
            self.push_disc(a, group, Link::Start);
            self.push_disc(b, group, Link::Straight);
        }
    }

    fn push_arc(&mut self, arc: &Arc, radius: f64, group: Group) {
        let Circle { center, radius: core_radius } = arc.circle();
        if core_radius <= 0.0 {
            return self.push_disc(Circle { center, radius }, group, Link::Start);
        }
        let angle = 2.0 * arc.half_angle();
        let pieces = ((angle / PIECE_RAD).ceil() as usize).max(1);
        let half_piece = angle / (2 * pieces) as f64;
        let cos_half = libm::cos(half_piece);
        let fine_step = 2.0 * libm::acos((1.0 - FINE_SAGITTA_MM / core_radius).max(0.0));
        let fine = ((2.0 * half_piece / fine_step).ceil() as usize).max(1);
        self.push_disc(Circle { center: arc.at(0.0), radius }, group, Link::Start);
        for piece in 0..pieces {
            let part = |step: usize| (piece * fine + step) as f64 / (pieces * fine) as f64;
            let first = self.fine.len();
            self.fine.extend((0..=fine).map(|step| arc.at(part(step))));
            let middle = arc.at((piece as f64 + 0.5) / pieces as f64) - center;
            let bulge = Bulge {
                outer: Circle { center, radius: core_radius + radius },
                middle: middle / core_radius,
                cos_half,
                sagitta_mm: core_radius * (1.0 - cos_half),
                fine: (first, first + fine),
            };
            let end = self.fine[first + fine];
            self.push_disc(Circle { center: end, radius }, group, Link::Bulge(self.bulges.len() as u32));
            self.bulges.push(bulge);
        }
    }
}
