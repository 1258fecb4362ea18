//! Occluders as chains of discs: the form in which their shadows are found.
//!
//! Seen from a point outside it, the convex hull of two discs spans from the outermost tangent of the two discs to the
//! other outermost. So a capsule or a taper is two discs, and a wall of many capsules is one chain of discs without
//! gaps between its links. A thick arc is a chain too, of short pieces; between the two discs of a piece, the arc's
//! outer circle bulges out. This module knows no lamp.

use crate::scene::validation;
use crate::{Group, Occluder};
use geometry::{Arc, Circle, Core, DVec2, Shape};
use std::ops::Range;

/// The widest angle of one piece of an arc, radians (20 degrees).
const PIECE_RAD: f64 = 0.35;

/// The largest sagitta of a fine piece of an arc, mm: less than a tenth of a pixel at any size that is played.
const FINE_SAGITTA_MM: f64 = 0.008;

/// Walls are cut into pieces of this length, mm: both ends of a short piece are more often between a lamp and a tile,
/// and then the cheap path of [`crate::visibility::blockers`] takes it.
const PIECE_MM: f64 = 50.0;

/// A wall is not cut into more pieces than this for the cheap path's sake.
const MOST_PIECES: f64 = 64.0;

/// The longest piece of a wall, mm: single precision resolves a micrometre of it.
const LONGEST_MM: f64 = 1e4;

/// One disc of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Disc {
    /// The middle, mm.
    pub center: DVec2,
    /// The radius, mm, 0 or more.
    pub radius: f64,
    /// What the occluder belongs to.
    pub group: Group,
    /// How the disc is linked to the disc before it.
    pub link: Link,
}

/// How a disc is linked to the disc before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Link {
    /// Not at all: a chain starts here.
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
    /// The radius of the inner circle, mm; below 0 where the arc is thicker than its circle.
    pub inner_mm: f64,
    /// The unit vector from the circle's middle to the piece's.
    pub middle: DVec2,
    /// Cosine of half of the piece's angle.
    pub cos_half: f64,
    /// How far the piece is from its chord, mm.
    pub sagitta_mm: f64,
    /// The same piece as a chain of finer ones, so fine that their chords would do: which of [`DiscChains::discs`].
    /// Empty for a piece that is fine already.
    pub fine: Range<usize>,
}

/// Every occluder of a scene, as chains.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct DiscChains {
    /// The discs of all chains, one chain after another; then those of the fine chains of arcs.
    pub discs: Vec<Disc>,
    /// How many of the discs are not of fine chains.
    pub coarse: usize,
    /// The bulges of the arcs.
    pub bulges: Vec<Bulge>,
    /// Fine chains, until all coarse ones are there.
    waiting: Vec<Disc>,
}

impl DiscChains {
    /// Takes the place of what was here; shapes beyond the [`limits`] cast no shadow.
    pub fn set(&mut self, occluders: &[Occluder]) {
        self.discs.clear();
        self.bulges.clear();
        for Occluder { shape, group, .. } in occluders {
            self.push(shape, *group);
        }
        self.coarse = self.discs.len();
        self.discs.append(&mut self.waiting);
        for bulge in &mut self.bulges {
            bulge.fine = bulge.fine.start + self.coarse..bulge.fine.end + self.coarse;
        }
    }

    fn push(&mut self, shape: &Shape, group: Group) {
        if validation::wrong_with_shape(shape).is_some() {
            return;
        }
        let radius = shape.radius.max(0.0);
        match shape.core {
            Core::Point(center) => self.push_disc(Circle { center, radius }, group, Link::Start),
            Core::Segment(segment) => {
                self.push_wall(Circle { center: segment.a, radius }, Circle { center: segment.b, radius }, group);
            }
            Core::Taper(taper) => {
                let grown = |disc: Circle| Circle { radius: (disc.radius + radius).max(0.0), ..disc };
                self.push_wall(grown(taper.a), grown(taper.b), group);
            }
            Core::Arc(arc) => self.push_arc(&arc, radius, group),
        }
    }

    fn push_disc(&mut self, disc: Circle, group: Group, link: Link) {
        self.discs.push(Disc { center: disc.center, radius: disc.radius, group, link });
    }

    /// The hull of two discs, cut into pieces that are not too long: what is far from a lamp is left out, and single
    /// precision can tell what is near.
    fn push_wall(&mut self, a: Circle, b: Circle, group: Group) {
        let length = a.center.distance(b.center);
        let pieces = (length / PIECE_MM).min(MOST_PIECES).max(length / LONGEST_MM).ceil().max(1.0);
        let between = |part: f64| Circle {
            center: a.center + (b.center - a.center) * part,
            radius: a.radius + (b.radius - a.radius) * part,
        };
        for piece in 0..pieces as usize {
            let (from, to) = (piece as f64 / pieces, (piece as f64 + 1.0) / pieces);
            let begin = if piece == 0 { a } else { between(from) };
            self.push_hull(begin, if to < 1.0 { between(to) } else { b }, group);
        }
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
        let fine_step = 2.0 * libm::acos((1.0 - FINE_SAGITTA_MM / core_radius).max(0.0));
        let fine = ((angle / pieces as f64 / fine_step).ceil() as usize).max(1);
        let parts = pieces * fine;
        let disc = |part: usize, link| {
            let center = arc.at(part as f64 / parts as f64);
            Disc { center, radius, group, link }
        };
        self.discs.push(disc(0, Link::Start));
        for piece in 0..pieces {
            let first = self.waiting.len();
            self.waiting.push(disc(piece * fine, Link::Start));
            for part in piece * fine..(piece + 1) * fine {
                let link = self.push_bulge(arc, radius, part as f64 + 0.5, parts, 1, 0..0);
                self.waiting.push(disc(part + 1, link));
            }
            let middle = (piece as f64 + 0.5) * fine as f64;
            let link = self.push_bulge(arc, radius, middle, parts, fine, first..self.waiting.len());
            self.discs.push(disc((piece + 1) * fine, link));
        }
    }

    /// The bulge of the piece of `arc` of `wide` parts of `parts` whose middle is at part `middle`.
    fn push_bulge(
        &mut self,
        arc: &Arc,
        radius: f64,
        middle: f64,
        parts: usize,
        wide: usize,
        fine: Range<usize>,
    ) -> Link {
        let Circle { center, radius: core_radius } = arc.circle();
        let cos_half = libm::cos(arc.half_angle() * wide as f64 / parts as f64);
        self.bulges.push(Bulge {
            outer: Circle { center, radius: core_radius + radius },
            inner_mm: core_radius - radius,
            middle: (arc.at(middle / parts as f64) - center) / core_radius,
            cos_half,
            sagitta_mm: core_radius * (1.0 - cos_half),
            fine,
        });
        Link::Bulge(self.bulges.len() as u32 - 1)
    }
}
