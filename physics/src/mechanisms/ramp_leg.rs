//! Leg: a piece of a ramp's path, a line or an arc, by arc length.

use geometry::{Arc, Core, DVec2, Segment, trig};
use serde::{Deserialize, Serialize};

/// A piece of a ramp's path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Leg {
    /// Straight on, from `a` to `b`.
    Line(Segment),
    /// Round a circle: from the arc's first end to its second, or backwards.
    Turn {
        /// The arc.
        arc: Arc,
        /// From its second end to its first.
        backwards: bool,
    },
}

impl Leg {
    /// Its length, m.
    pub fn length(&self) -> f64 {
        match self {
            Leg::Line(line) => line.length(),
            Leg::Turn { arc, .. } => 2.0 * arc.half_angle() * arc.circle().radius,
        }
    }

    /// The place `along` m from its start.
    pub fn at(&self, along: f64) -> DVec2 {
        let part = along / self.length();
        match self {
            Leg::Line(Segment { a, b }) => a.lerp(*b, part),
            Leg::Turn { arc, backwards } => arc.at(if *backwards { 1.0 - part } else { part }),
        }
    }

    /// The unit vector of its direction `along` m from its start.
    pub fn direction_at(&self, along: f64) -> DVec2 {
        match self {
            Leg::Line(line) => line.along().normalize(),
            Leg::Turn { arc, backwards } => {
                let onwards = (self.at(along) - arc.circle().center).normalize().perp();
                if *backwards { -onwards } else { onwards }
            }
        }
    }

    /// The closest place to `point`: how far along, and where.
    pub(crate) fn closest(&self, point: DVec2) -> (f64, DVec2) {
        match self {
            Leg::Line(line) => (line.parameter(point) * line.length(), line.closest(point)),
            Leg::Turn { arc, backwards } => {
                let nearest = arc.closest(point);
                let from_middle = arc.middle().rotate_back(nearest - arc.circle().center);
                let turned = (trig::angle(from_middle) + arc.half_angle()).clamp(0.0, 2.0 * arc.half_angle());
                let along = turned * arc.circle().radius;
                (if *backwards { self.length() - along } else { along }, nearest)
            }
        }
    }

    /// The offset curve that runs `offset` m beside it: over 0 on the side of `perp` of its direction.
    pub fn offset(&self, offset: f64) -> Core {
        match self {
            Leg::Line(Segment { a, b }) => {
                let side = self.direction_at(0.0).perp() * offset;
                Core::Segment(Segment { a: *a + side, b: *b + side })
            }
            Leg::Turn { arc, backwards } => {
                let inwards = if *backwards { -offset } else { offset };
                Core::Arc(arc.with_radius(arc.circle().radius - inwards))
            }
        }
    }

    /// The piece of it between two lengths along.
    pub(crate) fn piece(&self, from: f64, to: f64) -> Leg {
        match self {
            Leg::Line(_) => Leg::Line(Segment { a: self.at(from), b: self.at(to) }),
            Leg::Turn { arc, backwards } => {
                let circle = arc.circle();
                let (low, high) = if *backwards { (self.length() - to, self.length() - from) } else { (from, to) };
                let start = trig::angle(arc.middle()) - arc.half_angle() + low / circle.radius;
                Leg::Turn { arc: Arc::new(circle, start, (high - low) / circle.radius), backwards: *backwards }
            }
        }
    }
}

/// Turning back by the angle of a unit vector.
trait RotateBack {
    fn rotate_back(self, vector: DVec2) -> DVec2;
}

impl RotateBack for DVec2 {
    fn rotate_back(self, vector: DVec2) -> DVec2 {
        DVec2::new(self.dot(vector), self.perp_dot(vector))
    }
}
