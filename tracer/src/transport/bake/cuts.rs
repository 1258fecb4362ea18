//! Where other surfaces meet a wall.

use super::wall_curve::{along, length};
use crate::transport::{Curve, EdgeId, Surfaces};
use geometry::{Arc, DVec2, Ray, Segment};

/// A curve that ends so near to a wall meets it, mm.
const TOUCH_MM: f64 = 1e-6;

/// Straight pieces that a parabola is taken for.
const PARABOLA_PIECES: usize = 256;

/// The two ends of a wall and all places between where other edges meet it, mm from its beginning, in order.
pub(super) fn cuts(surfaces: &Surfaces, edges: EdgeId, wall: EdgeId) -> Vec<f64> {
    let curve = surfaces.curve(wall);
    let near = curve.bounds().grown(2.0 * TOUCH_MM);
    let mut places = Vec::new();
    for other in (0..edges).filter(|other| *other != wall) {
        let other = surfaces.curve(other);
        if near.overlaps(&other.bounds()) {
            meetings(curve, other, &mut places);
        }
    }
    let length = length(curve);
    let mut cuts: Vec<f64> = places.into_iter().map(|place| along(curve, place)).collect();
    cuts.retain(|at| *at > TOUCH_MM && *at < length - TOUCH_MM);
    cuts.extend([0.0, length]);
    cuts.sort_unstable_by(f64::total_cmp);
    cuts.dedup();
    cuts
}

/// Adds the places where two curves meet.
fn meetings(curve: &Curve, other: &Curve, places: &mut Vec<DVec2>) {
    match (curve, other) {
        (_, Curve::Line(line)) => crossings(curve, line, places),
        (Curve::Line(line), _) => crossings(other, line, places),
        (Curve::Arc(one), Curve::Arc(other)) => circle_meetings(one, other, places),
        (_, Curve::Parabola(parabola)) | (Curve::Parabola(parabola), _) => {
            let against = if matches!(other, Curve::Parabola(_)) { curve } else { other };
            let at = |step: usize| parabola.at((2.0 * step as f64 / PARABOLA_PIECES as f64 - 1.0) * parabola.half);
            for step in 0..PARABOLA_PIECES {
                crossings(against, &Segment { a: at(step), b: at(step + 1) }, places);
            }
        }
    }
}

/// The places where a line, a touch longer than it is, crosses a curve.
fn crossings(curve: &Curve, line: &Segment, places: &mut Vec<DVec2>) {
    let Some(mut ray) = Ray::towards(line.a, line.b) else { return };
    ray.origin = ray.at(-TOUCH_MM);
    let (mut left, mut starts_on) = (line.length() + 2.0 * TOUCH_MM, false);
    while let Some(crossing) = curve.cross(&ray, starts_on) {
        left -= crossing.distance;
        if left < 0.0 {
            return;
        }
        ray.origin = ray.at(crossing.distance);
        places.push(ray.origin);
        starts_on = true;
    }
}

/// The places where two arcs meet.
fn circle_meetings(one: &Arc, other: &Arc, places: &mut Vec<DVec2>) {
    let (a, b) = (one.circle(), other.circle());
    let between = b.center - a.center;
    let square = between.length_squared();
    if square == 0.0 {
        // Pieces of one circle meet in their ends.
        let ends = other.ends().into_iter().filter(|end| (end.distance(a.center) - a.radius).abs() < TOUCH_MM);
        places.extend(ends.filter(|end| one.spans(*end)));
        return;
    }
    // Along the line of the centres, and across it.
    let part = 0.5 + 0.5 * (a.radius * a.radius - b.radius * b.radius) / square;
    let across = a.radius * a.radius / square - part * part;
    if across < -TOUCH_MM {
        return;
    }
    let middle = a.center + between * part;
    for side in [-1.0, 1.0] {
        let place = middle + between.perp() * (side * across.max(0.0).sqrt());
        if one.closest(place).distance(place) < 2.0 * TOUCH_MM && other.closest(place).distance(place) < 2.0 * TOUCH_MM
        {
            places.push(place);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transport::{Body, Material, Parabola};
    use geometry::Circle;
    use std::f64::consts::TAU;

    fn found(wall: Curve, others: &[Curve]) -> Vec<f64> {
        let curves = std::iter::once(wall).chain(others.iter().copied());
        let surfaces = Surfaces::new(&[Body::open(curves, Material::Absorber)], 1e-6);
        cuts(&surfaces, others.len() as EdgeId + 1, 0)
    }

    fn line(a: (f64, f64), b: (f64, f64)) -> Curve {
        Curve::Line(Segment { a: DVec2::new(a.0, a.1), b: DVec2::new(b.0, b.1) })
    }

    fn circle(x: f64, y: f64, radius: f64) -> Curve {
        Curve::Arc(Arc::new(Circle { center: DVec2::new(x, y), radius }, 1.0, TAU))
    }

    /// Lines that end on a wall, cross it, miss it; circles through it; a parabola.
    #[test]
    fn walls_are_cut_where_they_are_met() {
        let wall = line((0.0, 0.0), (100.0, 0.0));
        let parabola = Parabola { vertex: DVec2::new(80.0, -1.0), axis: DVec2::X, curvature: 0.01, half: 12.0 };
        let others = [
            line((10.0, 0.0), (12.0, 50.0)),
            line((20.0, -7.0), (20.0, 7.0)),
            line((30.0, 0.1), (30.0, 9.0)),
            line((100.0, 0.0), (100.0, 9.0)),
            circle(50.0, 3.0, 5.0),
            Curve::Parabola(parabola),
        ];
        let expected = [0.0, 10.0, 20.0, 46.0, 54.0, 70.0, 90.0, 100.0];
        let found = found(wall, &others);
        assert_eq!(found.len(), expected.len(), "{found:?}");
        found.iter().zip(expected).for_each(|(found, expected)| assert!((found - expected).abs() < 1e-5));
    }

    #[test]
    fn circles_are_cut_by_lines_and_circles() {
        let wall = Curve::Arc(Arc::new(Circle { center: DVec2::ZERO, radius: 10.0 }, 0.0, TAU));
        let others = [line((-10.0, 0.0), (10.0, 0.0)), circle(0.0, 12.0, 10.0), circle(40.0, 0.0, 3.0)];
        let found = found(wall, &others);
        // The end of the line at (10, 0) is the circle's beginning.
        assert_eq!(found.len(), 5, "{found:?}");
        let quarter = 10.0 * libm::asin(0.6);
        for (found, expected) in found.iter().zip([0.0, quarter, 31.4159265 - quarter, 31.4159265, 62.831853]) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }
}
