//! Validation: whether numbers, shapes and materials can be at all.
//!
//! Each check returns what is wrong as one sentence. Refuses to know which part the number belongs to.

use crate::part::material::Material;
use geometry::{Arc, Circle, Core, DVec2, Segment, Shape};

/// The largest number that a drawing can mean, in SI units: more is a slip of the pen.
const MAX_NUMBER_SI: f64 = 1e6;
/// How far from 1 the length of a unit vector may be: the rounding of a drawing's decimals.
const UNIT_TOLERANCE: f64 = 1e-6;

/// What is wrong, as one sentence.
pub(crate) type Checked = Result<(), String>;

pub(crate) fn finite(what: &str, number: f64) -> Checked {
    if number.abs() <= MAX_NUMBER_SI {
        Ok(())
    } else {
        Err(format!("{what} must be a number of reasonable size, not {number}"))
    }
}

pub(crate) fn positive(what: &str, number: f64) -> Checked {
    finite(what, number)?;
    if number > 0.0 { Ok(()) } else { Err(format!("{what} must be more than 0, not {number}")) }
}

pub(crate) fn not_negative(what: &str, number: f64) -> Checked {
    finite(what, number)?;
    if number >= 0.0 { Ok(()) } else { Err(format!("{what} must be 0 or more, not {number}")) }
}

pub(crate) fn at_most(what: &str, number: f64, most: f64) -> Checked {
    if number <= most { Ok(()) } else { Err(format!("{what} must be {most} or less, not {number}")) }
}

pub(crate) fn point(what: &str, point: DVec2) -> Checked {
    finite(what, point.x)?;
    finite(what, point.y)
}

pub(crate) fn unit(what: &str, vector: DVec2) -> Checked {
    point(what, vector)?;
    if (vector.length() - 1.0).abs() < UNIT_TOLERANCE {
        Ok(())
    } else {
        Err(format!("{what} must be a vector of length 1"))
    }
}

pub(crate) fn material(material: &Material) -> Checked {
    not_negative("the restitution", material.restitution)?;
    at_most("the restitution", material.restitution, 1.0)?;
    not_negative("the falloff", material.falloff_s_per_m)?;
    not_negative("the friction", material.friction)
}

pub(crate) fn segment(segment: &Segment) -> Checked {
    point("an end", segment.a)?;
    point("an end", segment.b)?;
    positive("the length", segment.length())
}

pub(crate) fn circle(circle: &Circle) -> Checked {
    point("the centre", circle.center)?;
    positive("the radius", circle.radius)
}

pub(crate) fn arc(arc: &Arc) -> Checked {
    circle(&arc.circle())?;
    finite("the arc's angle", arc.half_angle())?;
    point("the arc's middle", arc.middle())
}

pub(crate) fn shape(shape: &Shape) -> Checked {
    not_negative("the thickness", shape.radius)?;
    match &shape.core {
        Core::Point(center) => point("the centre", *center),
        Core::Segment(ends) => {
            point("an end", ends.a)?;
            point("an end", ends.b)
        }
        Core::Arc(core) => arc(core),
        Core::Taper(taper) => circle(&taper.a).and(circle(&taper.b)),
    }
}
