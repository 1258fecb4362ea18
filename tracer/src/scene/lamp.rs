//! A lamp: where it is, what form of it shines, and how much of its light a floor point gets that sees all of it.

use crate::scene::validation;
use crate::{Group, ItemId, Rgb};
use geometry::{DVec2, Segment};

/// What of a lamp shines, seen from above; it lies parallel to the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Emitter {
    /// A disc. A floor point that sees all of it gets the light of its middle.
    Disc {
        /// Its radius, mm; 0 gives hard shadows.
        radius_mm: f64,
    },
    /// A line, every millimetre of it as bright as any other: a neon tube.
    Tube {
        /// From the middle to one end, mm. One that is shorter than [`Lamp::LEAST_HALF_MM`] is a point.
        half_mm: DVec2,
    },
}

/// Something that shines.
///
/// A floor point at distance `d` in the plane from a disc's middle receives
/// `color * visible fraction * reference^2 / (d^2 + height^2) * (1 - (d / reach)^2)^2` for `d < reach`, nothing beyond;
/// `reference` is [`Lamp::REFERENCE_MM`]. From a tube it receives the mean of `reference^2 / (d^2 + height^2)` over
/// the tube's points, where hidden ones count 0; there the reach counts from the tube's closest point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// The caller's name for it.
    pub id: ItemId,
    /// The middle, mm.
    pub center_mm: DVec2,
    /// What of it shines.
    pub emitter: Emitter,
    /// Height above the floor, mm: it softens the falloff near the lamp and says from where a normal is lit.
    pub height_mm: f64,
    /// Where its light ends, mm.
    pub reach_mm: f64,
    /// Irradiance at the reference distance, before the reach takes its part.
    pub color: Rgb,
    /// The group that the lamp is inside of: that group casts no shadow in its light.
    pub inside: Option<Group>,
}

impl Lamp {
    /// The distance at which a lamp's colour is its irradiance, mm.
    pub const REFERENCE_MM: f64 = 100.0;

    /// A lamp in the floor's own plane would be infinitely bright at its middle, so none is lower than this, mm.
    pub const LEAST_HEIGHT_MM: f64 = 0.1;

    /// A tube with a shorter half shines as a point does, mm.
    pub const LEAST_HALF_MM: f64 = 0.01;

    /// The height of lamps that are made without one, mm: a bulb that stands in a post of a table.
    const USUAL_HEIGHT_MM: f64 = 30.0;

    /// The reach of lamps that are made without one, mm: a table's length.
    const USUAL_REACH_MM: f64 = 1000.0;

    /// A disc lamp of the usual height and reach, which is inside of nothing; with the radius 0, a point.
    pub fn disc(id: ItemId, center_mm: DVec2, radius_mm: f64, color: Rgb) -> Lamp {
        let (height_mm, reach_mm) = (Lamp::USUAL_HEIGHT_MM, Lamp::USUAL_REACH_MM);
        Lamp { id, center_mm, emitter: Emitter::Disc { radius_mm }, height_mm, reach_mm, color, inside: None }
    }

    /// A tube, `half_mm` to both sides of its middle, of the usual height and reach, which is inside of nothing.
    pub fn of_tube(id: ItemId, center_mm: DVec2, half_mm: DVec2, color: Rgb) -> Lamp {
        Lamp { emitter: Emitter::Tube { half_mm }, ..Lamp::disc(id, center_mm, 0.0, color) }
    }

    /// What a floor point that sees all of the lamp receives of its colour.
    pub fn falloff(&self, point_mm: DVec2) -> f64 {
        let window = self.range_window(point_mm);
        let height = self.height_mm();
        let reference = Lamp::REFERENCE_MM * Lamp::REFERENCE_MM;
        let arriving = match self.tube() {
            None => reference / (point_mm.distance_squared(self.center_mm) + height * height),
            Some(half) => {
                // The integral of dt / (t^2 + q^2) is atan(t / q) / q, and the difference of two of them is one angle.
                let length = half.length();
                let (from_middle, along) = (point_mm - self.center_mm, half / length);
                let (x, y) = (from_middle.dot(along), from_middle.perp_dot(along));
                let square = y * y + height * height;
                let q = square.sqrt();
                let angle = libm::atan2(2.0 * length * q, square + (x - length) * (x + length));
                reference * angle / (2.0 * length * q)
            }
        };
        arriving * window * window
    }

    /// The range window, before it is squared, that brings the falloff to 0 at the reach: `1 - (d / reach)^2`, where the
    /// point is `d` from the nearest point that shines; 0 beyond the reach.
    pub(crate) fn range_window(&self, point_mm: DVec2) -> f64 {
        let square = point_mm.distance_squared(self.nearest(point_mm));
        (1.0 - square / (self.reach_mm * self.reach_mm)).max(0.0)
    }

    /// The point of a tube that is nearest to `point_mm`; the middle of a disc.
    fn nearest(&self, point_mm: DVec2) -> DVec2 {
        match self.tube() {
            None => self.center_mm,
            Some(half) => Segment { a: self.center_mm - half, b: self.center_mm + half }.closest(point_mm),
        }
    }

    /// The height that its falloff has, mm.
    pub(crate) fn height_mm(&self) -> f64 {
        self.height_mm.abs().max(Lamp::LEAST_HEIGHT_MM)
    }

    /// From the middle to the end of a tube that is long enough to be one, mm.
    pub(crate) fn tube(&self) -> Option<DVec2> {
        match self.emitter {
            Emitter::Tube { half_mm } if half_mm.length_squared() >= Lamp::LEAST_HALF_MM * Lamp::LEAST_HALF_MM => {
                Some(half_mm)
            }
            _ => None,
        }
    }

    /// The radius of the circle round the middle that holds all that shines, mm.
    pub(crate) fn radius_mm(&self) -> f64 {
        match self.emitter {
            Emitter::Disc { radius_mm } => radius_mm.max(0.0),
            Emitter::Tube { .. } => self.tube().map_or(0.0, DVec2::length),
        }
    }

    /// How far from its middle the lamp's light ends, mm.
    pub(crate) fn far_mm(&self) -> f64 {
        self.reach_mm + self.tube().map_or(0.0, DVec2::length)
    }

    /// Whether it gives any light.
    pub(crate) fn shines(&self) -> bool {
        validation::wrong_with_lamp(self).is_none() && self.color.iter().any(|&c| c > 0.0)
    }
}
