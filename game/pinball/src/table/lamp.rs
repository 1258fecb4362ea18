//! Lamps above the floor and lit windows in it.

use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// A lamp or a lit insert.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lamp {
    /// Its id in the drawing.
    pub name: String,
    /// Its fill, sRGB: the colour it has unless the rules give it another.
    pub color: [u8; 3],
    /// Brightness when fully on, relative to the others.
    pub power: f64,
    /// What it is.
    pub kind: LampKind,
}

/// What a lamp is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum LampKind {
    /// A disc or a line above the floor that lights the table and casts shadows.
    Bulb {
        /// The middle, mm.
        center_mm: DVec2,
        /// What of it shines.
        emitter: Emitter,
        /// The height above the floor, mm.
        height_mm: f64,
        /// Where its light ends, mm.
        reach_mm: f64,
        /// The solid group that it stands inside of (a bumper's lamp).
        inside: Option<u16>,
    },
    /// A window in the floor, lit from below: these closed outlines, mm.
    Insert {
        /// Closed polygons, filled by the even-odd rule.
        outlines_mm: Vec<Vec<DVec2>>,
    },
}

/// What of a bulb shines, seen from above; it lies parallel to the floor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Emitter {
    /// A disc.
    Disc {
        /// Its radius, mm; 0 gives hard shadows.
        radius_mm: f64,
    },
    /// A line, every millimetre of it as bright as any other: a neon tube.
    Segment {
        /// From the middle to one end, mm, no shorter than [`Emitter::LEAST_HALF_MM`].
        half_mm: DVec2,
    },
}

impl Emitter {
    /// The shortest half of a line that gives other light than a point, mm.
    pub const LEAST_HALF_MM: f64 = 0.01;
}
