//! Bodies: outlines with a material.

use super::{Band, Curve, Material};
use geometry::{Arc, Circle, Core, DVec2, Ray, Segment, Shape, trig};
use std::f64::consts::{PI, TAU};

/// A piece of a body's outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Where it is.
    pub curve: Curve,
    /// The curve's normal points into the body instead of out of it.
    pub inward: bool,
}

/// A thing that light meets: an outline and what it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The pieces of its outline. That of a dielectric is closed.
    pub edges: Vec<Edge>,
    /// What it is made of.
    pub material: Material,
    /// On which wavelengths it acts; all, if nothing is said.
    pub band: Option<Band>,
}

/// A corner of an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corner {
    /// A straight line goes on from here.
    Point(DVec2),
    /// The arc from the corner before to the corner behind goes through here.
    Through(DVec2),
}

impl Body {
    /// An open line: a mirror, a lens, a wall without thickness. What is said of sides holds for both.
    pub fn open(curves: impl IntoIterator<Item = Curve>, material: Material) -> Body {
        let edges = curves.into_iter().map(|curve| Edge { curve, inward: false }).collect();
        Body { edges, material, band: None }
    }

    /// A table's shape: core plus radius. A core without radius is an open line.
    pub fn of_shape(shape: &Shape, material: Material) -> Body {
        let edges = match &shape.core {
            Core::Point(center) => vec![circle(*center, shape.radius)],
            Core::Segment(line) if shape.radius == 0.0 => vec![outer(Curve::Line(*line))],
            Core::Segment(Segment { a, b }) => hull(&disc(*a, shape.radius), &disc(*b, shape.radius)),
            Core::Taper(taper) => {
                let grown = |of: &Circle| disc(of.center, of.radius + shape.radius);
                hull(&grown(&taper.a), &grown(&taper.b))
            }
            Core::Arc(arc) => thick_arc(arc, shape.radius),
        };
        Body { edges, material, band: None }
    }

    /// A closed outline of lines and arcs, either way round; `None` where it holds no area, or an arc has no middle.
    pub fn closed(corners: &[Corner], material: Material) -> Option<Body> {
        let area = area(corners);
        if area == 0.0 || !area.is_finite() {
            return None;
        }
        let count = corners.len();
        let at = |index: usize| corners[index % count];
        let mut edges = Vec::new();
        for index in 0..count {
            let Corner::Point(from) = at(index) else { continue };
            let (curve, left_is_normal) = match (at(index + 1), at(index + 2)) {
                (Corner::Point(to), _) if to == from => continue,
                (Corner::Point(to), _) => (Curve::Line(Segment { a: from, b: to }), true),
                (Corner::Through(through), Corner::Point(to)) => match arc_through(from, through, to) {
                    // Away from the centre is on the right of a way that turns left.
                    Some((arc, sweep)) => (Curve::Arc(arc), sweep < 0.0),
                    None => (Curve::Line(Segment { a: from, b: to }), true),
                },
                (Corner::Through(_), Corner::Through(_)) => return None,
            };
            // Round a positive area (y up) the body is on the left.
            edges.push(Edge { curve, inward: left_is_normal == (area > 0.0) });
        }
        Some(Body { edges, material, band: None })
    }

    /// The area that these curves enclose by the even-odd rule: whatever their order and way round, holes in it too.
    ///
    /// The curves must be closed together. Each is asked at its middle on which of its sides the body is, by the parity of the
    /// curves on a ray from there: `curves^2` crossings in all.
    pub fn enclosed(curves: &[Curve], material: Material) -> Body {
        let edge = |curve: &Curve| Edge { curve: *curve, inward: is_inside(curves, curve) };
        Body { edges: curves.iter().map(edge).collect(), material, band: None }
    }

    /// The same on these wavelengths only.
    pub fn in_band(self, band: Band) -> Body {
        Body { band: Some(band), ..self }
    }
}

/// Whether the side to which a curve's normal points is inside of the curves, by the even-odd rule.
fn is_inside(curves: &[Curve], curve: &Curve) -> bool {
    let (middle, normal) = curve.middle();
    // The ray starts on the curve and leaves along its normal, a little turned so that it meets no corner of a grid.
    let ray = Ray { origin: middle, direction: trig::rotate(normal, 0.137) };
    let count = |other: &Curve| other.crossings(&ray, std::ptr::eq(other, curve));
    curves.iter().map(count).sum::<u32>() % 2 == 1
}

fn outer(curve: Curve) -> Edge {
    Edge { curve, inward: false }
}

fn disc(center: DVec2, radius: f64) -> Circle {
    Circle { center, radius }
}

fn circle(center: DVec2, radius: f64) -> Edge {
    outer(Curve::Arc(Arc::new(disc(center, radius), 0.0, TAU)))
}

/// The outline of the hull of two discs: two lines and two arcs, or the larger disc.
fn hull(a: &Circle, b: &Circle) -> Vec<Edge> {
    let taper = geometry::Taper { a: *a, b: *b };
    let Some(normals) = taper.side_normals() else {
        let larger = if a.radius >= b.radius { a } else { b };
        return vec![circle(larger.center, larger.radius)];
    };
    let lines = normals.map(|normal| {
        let side = taper.side(normal);
        Edge { curve: Curve::Line(side), inward: side.along().perp().dot(normal) < 0.0 }
    });
    // From the side on the left of the way from a to b round a to the one on the right, and on round b.
    let [left, right] = normals.map(trig::angle);
    let turn = (right - left).rem_euclid(TAU);
    let ends = [Curve::Arc(Arc::new(*a, left, turn)), Curve::Arc(Arc::new(*b, right, TAU - turn))];
    lines.into_iter().chain(ends.into_iter().map(outer)).collect()
}

/// The outline of a curved wall with round ends.
fn thick_arc(arc: &Arc, radius: f64) -> Vec<Edge> {
    if radius == 0.0 {
        return vec![outer(Curve::Arc(*arc))];
    }
    let Circle { radius: middle, .. } = arc.circle();
    let mut edges = vec![outer(Curve::Arc(arc.with_radius(middle + radius)))];
    if middle > radius {
        edges.push(Edge { curve: Curve::Arc(arc.with_radius(middle - radius)), inward: true });
    }
    if arc.half_angle() < PI {
        let start = trig::angle(arc.middle()) - arc.half_angle();
        let end = trig::angle(arc.middle()) + arc.half_angle();
        let [a, b] = arc.ends();
        edges.push(outer(Curve::Arc(Arc::new(disc(a, radius), start, -PI))));
        edges.push(outer(Curve::Arc(Arc::new(disc(b, radius), end, PI))));
    }
    edges
}

/// The arc from `from` through `through` to `to`, and how far it turns, rad, positive to the left (y up).
pub fn arc_through(from: DVec2, through: DVec2, to: DVec2) -> Option<(Arc, f64)> {
    let (a, b) = (through - from, to - from);
    let twice_area = a.perp_dot(b);
    let longest = a.length_squared().max(b.length_squared()).max((b - a).length_squared());
    if twice_area.abs() <= 1e-12 * longest {
        return None;
    }
    let offset = (a * b.length_squared() - b * a.length_squared()).perp() / (2.0 * twice_area);
    let center = from + offset;
    let start = trig::angle(from - center);
    let whole = (trig::angle(to - center) - start).rem_euclid(TAU);
    // The middle point lies on the left of the chord if the arc turns right.
    let sweep = if twice_area > 0.0 { whole } else { whole - TAU };
    Some((Arc::new(disc(center, offset.length()), start, sweep), sweep))
}

/// The area inside of an outline, positive if it goes round to the left (y up): the polygon's and the arcs' segments.
fn area(corners: &[Corner]) -> f64 {
    let count = corners.len();
    let mut sum = 0.0;
    for index in 0..count {
        let Corner::Point(from) = corners[index] else { continue };
        let (next, after) = (corners[(index + 1) % count], corners[(index + 2) % count]);
        match (next, after) {
            (Corner::Point(to), _) => sum += 0.5 * from.perp_dot(to),
            (Corner::Through(through), Corner::Point(to)) => {
                sum += 0.5 * from.perp_dot(to);
                if let Some((arc, sweep)) = arc_through(from, through, to) {
                    let radius = arc.circle().radius;
                    sum += 0.5 * radius * radius * (sweep - libm::sin(sweep));
                }
            }
            _ => return f64::NAN,
        }
    }
    sum
}

#[cfg(test)]
mod enclosed_tests {
    use super::*;
    use geometry::rng::SplitMix64;

    /// A ring of glass, its inner rim the other way round, or the same: a point between is in it, one in the hole is not.
    #[test]
    fn a_hole_is_no_glass_whichever_way_it_is_drawn() {
        let rim = |radius: f64, turn: f64| {
            let circle = disc(DVec2::new(3.0, 4.0), radius);
            [Curve::Arc(Arc::new(circle, 0.3, turn * PI)), Curve::Arc(Arc::new(circle, 0.3 + turn * PI, turn * PI))]
        };
        for turn in [1.0, -1.0] {
            let curves: Vec<Curve> = rim(20.0, 1.0).into_iter().chain(rim(8.0, turn)).collect();
            let ring = Body::enclosed(&curves, Material::Absorber);
            assert_eq!(ring.edges.iter().map(|edge| edge.inward).collect::<Vec<_>>(), [false, false, true, true]);
        }
    }

    /// The same outline by its corners in order and by its lines in any order.
    #[test]
    fn the_order_of_the_curves_does_not_matter() {
        let mut random = SplitMix64::new(4);
        for _ in 0..200 {
            let count = 3 + (random.next_u64() % 8) as usize;
            // A star-shaped polygon: every angle once.
            let corner = |index: usize, random: &mut SplitMix64| {
                trig::direction(TAU * index as f64 / count as f64) * random.uniform(5.0, 50.0)
            };
            let corners: Vec<DVec2> = (0..count).map(|index| corner(index, &mut random)).collect();
            let by_corners =
                Body::closed(&corners.iter().map(|at| Corner::Point(*at)).collect::<Vec<_>>(), Material::Absorber);
            let by_corners = by_corners.expect("it has an area");
            let mut curves: Vec<Curve> = by_corners.edges.iter().map(|edge| edge.curve).collect();
            curves.rotate_left(count / 2);
            let mut enclosed = Body::enclosed(&curves, Material::Absorber);
            enclosed.edges.rotate_right(count / 2);
            assert_eq!(by_corners, enclosed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Ray;
    use geometry::rng::SplitMix64;

    /// Rays from far away meet the outline where [`Shape::cast`] says, from outside.
    #[test]
    fn a_shape_and_its_outline_are_met_at_the_same_place() {
        let mut random = SplitMix64::new(7);
        let arc = Arc::new(disc(DVec2::new(1.0, 2.0), 9.0), 0.4, 2.1);
        let taper = geometry::Taper { a: disc(DVec2::new(-8.0, 1.0), 4.0), b: disc(DVec2::new(7.0, 5.0), 1.5) };
        let shapes = [
            Shape::disc(DVec2::new(3.0, 4.0), 5.0),
            Shape::capsule(DVec2::new(-3.0, 4.0), DVec2::new(6.0, -2.0), 1.5),
            Shape { core: Core::Arc(arc), radius: 1.25 },
            Shape { core: Core::Arc(arc), radius: 0.0 },
            Shape { core: Core::Taper(taper), radius: 0.5 },
        ];
        for shape in shapes {
            let body = Body::of_shape(&shape, Material::Absorber);
            let (mut met, mut grazes) = (0, 0);
            for _ in 0..5_000 {
                let origin = trig::direction(random.uniform(0.0, TAU)) * 50.0;
                let target = DVec2::new(random.uniform(-12.0, 12.0), random.uniform(-12.0, 12.0));
                let ray = Ray::towards(origin, target).expect("they differ");
                let crossings = body.edges.iter().filter_map(|edge| Some((edge, edge.curve.cross(&ray, false)?)));
                let first = crossings.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance));
                match (first, shape.cast(&ray)) {
                    (Some((edge, crossing)), Some(hit)) => {
                        met += 1;
                        assert!((crossing.distance - hit.distance).abs() < 1e-6, "{shape:?}");
                        let outward = if edge.inward { -crossing.normal } else { crossing.normal };
                        if shape.radius > 0.0 {
                            assert!((outward - hit.normal).length() < 1e-6, "{shape:?}");
                        }
                    }
                    (None, None) => {}
                    _ => grazes += 1,
                }
            }
            assert!(met > 500 && grazes == 0, "{met} {grazes}");
        }
    }

    #[test]
    fn an_arc_goes_through_its_three_points() {
        let mut random = SplitMix64::new(8);
        for _ in 0..1_000 {
            let mut point = || DVec2::new(random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0));
            let (from, through, to) = (point(), point(), point());
            let (arc, sweep) = arc_through(from, through, to).expect("they are not in line");
            let circle = arc.circle();
            let tolerance = 1e-9 * (1.0 + circle.radius);
            for place in [from, through, to] {
                assert!((place.distance(circle.center) - circle.radius).abs() < tolerance * 10.0);
            }
            assert!(arc.spans(through));
            let [start, end] = if sweep > 0.0 { arc.ends() } else { [arc.ends()[1], arc.ends()[0]] };
            assert!(start.distance(from) < tolerance * 1e3 && end.distance(to) < tolerance * 1e3, "{sweep}");
        }
    }

    #[test]
    fn a_closed_outline_has_its_normals_outside_whichever_way_it_goes_round() {
        let lens = |flip: bool| {
            let mut corners = vec![
                Corner::Point(DVec2::new(-5.0, 0.0)),
                Corner::Through(DVec2::new(0.0, 2.0)),
                Corner::Point(DVec2::new(5.0, 0.0)),
                Corner::Point(DVec2::new(0.0, -4.0)),
            ];
            if flip {
                corners.reverse();
            }
            Body::closed(&corners, Material::glass(super::super::spectrum::Dispersion::Constant(1.5)))
                .expect("it has area")
        };
        for body in [lens(false), lens(true)] {
            assert_eq!(body.edges.len(), 3);
            for edge in &body.edges {
                // A ray from the middle crosses each edge on its way out.
                let target = match edge.curve {
                    Curve::Line(line) => (line.a + line.b) * 0.5,
                    Curve::Arc(arc) => arc.at(0.5),
                    Curve::Parabola(_) => unreachable!("there is none"),
                };
                let ray = Ray::towards(DVec2::new(0.0, -0.5), target).expect("they differ");
                let crossing = edge.curve.cross(&ray, false).expect("it is there");
                let outward = if edge.inward { -crossing.normal } else { crossing.normal };
                assert!(outward.dot(ray.direction) > 0.0, "{edge:?}");
            }
        }
        let flat = [Corner::Point(DVec2::ZERO), Corner::Point(DVec2::X), Corner::Point(DVec2::X * 2.0)];
        assert_eq!(Body::closed(&flat, Material::Absorber), None);
    }
}
