//! Lengths along curves, mm.

use crate::transport::{Curve, Parabola};
use geometry::DVec2;

/// The length of a curve.
pub(super) fn length(curve: &Curve) -> f64 {
    match curve {
        Curve::Line(line) => line.length(),
        Curve::Arc(arc) => 2.0 * arc.half_angle() * arc.circle().radius,
        Curve::Parabola(parabola) => 2.0 * from_vertex(parabola, parabola.half),
    }
}

/// How far along a curve a place on it is.
pub(super) fn along(curve: &Curve, place: DVec2) -> f64 {
    match curve {
        Curve::Line(line) => (place - line.a).dot(line.along()) / line.length(),
        Curve::Arc(arc) => {
            let (from_center, middle) = (place - arc.circle().center, arc.middle());
            let turned = libm::atan2(middle.perp_dot(from_center), middle.dot(from_center));
            (turned + arc.half_angle()) * arc.circle().radius
        }
        Curve::Parabola(parabola) => {
            let x = (place - parabola.vertex).dot(parabola.axis);
            from_vertex(parabola, parabola.half) + from_vertex(parabola, x)
        }
    }
}

/// The signed length of a parabola from its vertex to x: the integral of `sqrt(1 + (2 k x)^2)`.
fn from_vertex(parabola: &Parabola, x: f64) -> f64 {
    let slope = 2.0 * parabola.curvature * x;
    if slope.abs() < 1e-6 {
        return x;
    }
    0.5 * x * ((1.0 + slope * slope).sqrt() + libm::asinh(slope) / slope)
}

/// The normal of a curve at a place, of any length.
pub(super) fn normal(curve: &Curve, place: DVec2) -> DVec2 {
    match curve {
        Curve::Line(line) => line.along().perp(),
        Curve::Arc(arc) => place - arc.circle().center,
        Curve::Parabola(parabola) => {
            let x = (place - parabola.vertex).dot(parabola.axis);
            parabola.axis.perp() - parabola.axis * (2.0 * parabola.curvature * x)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::{Arc, Circle, Segment};

    /// Of short chords along the curve the sum is the way that is told.
    #[test]
    fn ways_along_curves_are_sums_of_chords() {
        let line = Segment { a: DVec2::new(3.0, 1.0), b: DVec2::new(-5.0, 8.0) };
        let arc = Arc::new(Circle { center: DVec2::new(2.0, 3.0), radius: 7.0 }, 2.5, 3.9);
        let axis = DVec2::new(0.6, 0.8);
        let parabola = Parabola { vertex: DVec2::new(1.0, -2.0), axis, curvature: 0.07, half: 12.0 };
        let at = |curve: &Curve, part: f64| match curve {
            Curve::Line(_) => line.a + line.along() * part,
            Curve::Arc(_) => arc.at(part),
            Curve::Parabola(_) => parabola.at((2.0 * part - 1.0) * parabola.half),
        };
        for curve in [Curve::Line(line), Curve::Arc(arc), Curve::Parabola(parabola)] {
            let mut sum = 0.0;
            for step in 0..10_000 {
                let [from, to] = [step, step + 1].map(|step| at(&curve, f64::from(step) / 1e4));
                sum += from.distance(to);
                assert!((along(&curve, to) - sum).abs() < 1e-5, "{curve:?} {step}");
            }
            assert!((length(&curve) - sum).abs() < 1e-5);
        }
    }
}
