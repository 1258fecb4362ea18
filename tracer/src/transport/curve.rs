//! Curves: what outlines are made of, and where rays cross them.
//!
//! A curve is crossed from both sides. A ray that starts on a curve, since it was reflected or bent there, does not meet it
//! again where it starts: it is told which curves it comes from, and no small distance decides.

use geometry::{Arc, Bounds, DVec2, Ray, Segment};

/// A piece of an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// A straight line.
    Line(Segment),
    /// A piece of a circle, up to the whole of it.
    Arc(Arc),
    /// A piece of a parabola.
    Parabola(Parabola),
}

/// A piece of a parabola: `y = curvature x^2` from `-half` to `half`, x along the unit vector `axis` from the vertex, and y
/// along its perpendicular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parabola {
    /// Where x and y are 0.
    pub vertex: DVec2,
    /// The direction of x, of length 1.
    pub axis: DVec2,
    /// y over x^2: one over four focal lengths.
    pub curvature: f64,
    /// How far the curve goes to both sides, x.
    pub half: f64,
}

/// Where a ray crosses a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// How far along the ray, over 0.
    pub distance: f64,
    /// The curve's unit normal there: on the left of a line's way (y up), away from an arc's centre, along a parabola's y
    /// axis. It says nothing of the side from which the ray comes.
    pub normal: DVec2,
}

impl Curve {
    /// Where the ray first crosses the curve. `starts_on` says that its origin lies on the curve: that place does not count.
    pub fn cross(&self, ray: &Ray, starts_on: bool) -> Option<Crossing> {
        let distance = self.distance(ray, starts_on);
        (distance < f64::INFINITY).then(|| Crossing { distance, normal: self.normal_at(ray.at(distance)) })
    }

    /// How far along the ray that is; infinity where it is not.
    #[inline(always)]
    pub fn distance(&self, ray: &Ray, starts_on: bool) -> f64 {
        match self {
            Curve::Line(_) if starts_on => f64::INFINITY,
            Curve::Line(line) => line_distance(line, ray),
            Curve::Arc(arc) => arc_distance(arc, ray, starts_on),
            Curve::Parabola(parabola) => parabola.distance(ray, starts_on),
        }
    }

    /// How often a ray crosses the curve.
    pub fn crossings(&self, ray: &Ray, starts_on: bool) -> u32 {
        let (mut ray, mut on, mut count) = (*ray, starts_on, 0);
        while let Some(crossing) = self.cross(&ray, on) {
            count += 1;
            // A curve may be crossed twice: from the first crossing on the ray starts on it.
            ray.origin = ray.at(crossing.distance);
            on = true;
        }
        count
    }

    /// Its normal at one of its points, as a crossing has it.
    pub fn normal_at(&self, place: DVec2) -> DVec2 {
        match self {
            Curve::Line(line) => line.left_normal().unwrap_or(DVec2::ZERO),
            Curve::Arc(arc) => (place - arc.circle().center).normalize_or_zero(),
            Curve::Parabola(parabola) => parabola.normal_at(place),
        }
    }

    /// The point in its middle, and its normal there.
    pub fn middle(&self) -> (DVec2, DVec2) {
        match self {
            Curve::Line(line) => ((line.a + line.b) * 0.5, line.left_normal().unwrap_or(DVec2::X)),
            Curve::Arc(arc) => (arc.circle().center + arc.middle() * arc.circle().radius, arc.middle()),
            Curve::Parabola(parabola) => (parabola.vertex, parabola.axis.perp()),
        }
    }

    /// The smallest box around the curve.
    pub fn bounds(&self) -> Bounds {
        match self {
            Curve::Line(line) => line.bounds(),
            Curve::Arc(arc) => arc.bounds(),
            Curve::Parabola(parabola) => parabola.bounds(),
        }
    }
}

#[inline(always)]
fn line_distance(line: &Segment, ray: &Ray) -> f64 {
    let along = line.along();
    let denominator = ray.direction.perp_dot(along);
    let to_a = line.a - ray.origin;
    let part = to_a.perp_dot(ray.direction);
    let part = if denominator < 0.0 { -part } else { part };
    if !(part >= 0.0 && part <= denominator.abs()) {
        return f64::INFINITY;
    }
    // A ray along the line does not cross it: the quotient is not a number, or infinite.
    let distance = to_a.perp_dot(along) / denominator;
    if distance > 0.0 { distance } else { f64::INFINITY }
}

#[inline(always)]
fn arc_distance(arc: &Arc, ray: &Ray, starts_on: bool) -> f64 {
    let circle = arc.circle();
    let from_center = ray.origin - circle.center;
    // |from_center + t direction|^2 = r^2. The one root from the sum that does not cancel, the other from the product.
    let half = from_center.dot(ray.direction);
    let nearest = from_center - ray.direction * half;
    let square = circle.radius * circle.radius - nearest.length_squared();
    if !(square >= 0.0 || starts_on) {
        return f64::INFINITY;
    }
    let root = (if square > 0.0 { square } else { 0.0 }).sqrt();
    let outer = if half > 0.0 { -half - root } else { root - half };
    let least = least_of_arc(arc);
    let is_met = |distance: f64| distance > 0.0 && (ray.at(distance) - circle.center).dot(arc.middle()) >= least;
    if starts_on {
        // One root is the origin itself, but for rounding. The other is found from the circle and not as twice the way to the
        // middle of the chord: that takes the origin's error for the circle's, and it grows tenfold from one reflection to the
        // next. A ray along the tangent has a chord as long as its rounding.
        return if is_met(outer) { outer } else { f64::INFINITY };
    }
    let product = from_center.length_squared() - circle.radius * circle.radius;
    let inner = if outer == 0.0 { 0.0 } else { product / outer };
    let (near, far) = if inner < outer { (inner, outer) } else { (outer, inner) };
    if is_met(near) {
        near
    } else if is_met(far) {
        far
    } else {
        f64::INFINITY
    }
}

/// How far a point of the arc's circle lies at least along the arc's middle, from the centre, if it is on the arc.
pub(super) fn least_of_arc(arc: &Arc) -> f64 {
    let is_whole = arc.half_angle() == std::f64::consts::PI;
    if is_whole { f64::NEG_INFINITY } else { arc.circle().radius * arc.cos_half_angle() }
}

impl Parabola {
    fn local(&self, vector: DVec2) -> DVec2 {
        DVec2::new(vector.dot(self.axis), vector.dot(self.axis.perp()))
    }

    fn distance(&self, ray: &Ray, starts_on: bool) -> f64 {
        let (o, d) = (self.local(ray.origin - self.vertex), self.local(ray.direction));
        // oy + t dy = k (ox + t dx)^2 is a t^2 + b t + c = 0.
        let k = self.curvature;
        let a = k * d.x * d.x;
        let b = 2.0 * k * o.x * d.x - d.y;
        let c = k * o.x * o.x - o.y;
        let square = b * b - 4.0 * a * c;
        if square < 0.0 && !starts_on {
            return f64::INFINITY;
        }
        // The one root from the sum that does not cancel, the other from the product; a ray along the axis has one.
        let q = -0.5 * (b + square.max(0.0).sqrt().copysign(b));
        let (one, other) = (q / a, c / q);
        let roots = match starts_on {
            // The product of the roots is the origin's rounding: that root is where the ray starts.
            true => [one, f64::NAN],
            false if one < other => [one, other],
            false => [other, one],
        };
        let is_met =
            |distance: &f64| *distance > 0.0 && distance.is_finite() && (o.x + d.x * distance).abs() <= self.half;
        roots.into_iter().find(is_met).unwrap_or(f64::INFINITY)
    }

    fn normal_at(&self, place: DVec2) -> DVec2 {
        let x = (place - self.vertex).dot(self.axis);
        let normal = DVec2::new(-2.0 * self.curvature * x, 1.0).normalize();
        self.axis * normal.x + self.axis.perp() * normal.y
    }

    /// The point at x.
    pub fn at(&self, x: f64) -> DVec2 {
        self.vertex + self.axis * x + self.axis.perp() * (self.curvature * x * x)
    }

    fn bounds(&self) -> Bounds {
        // The control triangle of the piece as a quadratic curve holds it: its ends and where their tangents meet.
        let [a, b] = [self.at(-self.half), self.at(self.half)];
        let tip = self.vertex - self.axis.perp() * (self.curvature * self.half * self.half);
        Bounds::of(a, b).union(Bounds::of(tip, tip))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Circle;
    use geometry::rng::SplitMix64;

    fn ray(origin: DVec2, direction: DVec2) -> Ray {
        Ray { origin, direction: direction.normalize() }
    }

    /// A reflected ray met its own mirror again by the rounding of its origin; and where it met the mirror was off by ten times
    /// the rounding of where it came from, until after 16 reflections it left a closed mirror.
    #[test]
    fn a_ray_does_not_meet_the_curve_where_it_starts() {
        let mut random = SplitMix64::new(1);
        let circle = Circle { center: DVec2::new(3.0, -7.0), radius: 5.0 };
        let arc = Curve::Arc(Arc::new(circle, 0.0, 7.0));
        for _ in 0..10_000 {
            let outward = geometry::trig::direction(random.uniform(0.0, std::f64::consts::TAU));
            let origin = circle.center + outward * circle.radius;
            let direction = geometry::trig::direction(random.uniform(0.0, std::f64::consts::TAU));
            let crossing = arc.cross(&Ray { origin, direction }, true);
            let chord = -2.0 * direction.dot(outward) * circle.radius;
            // Nearly along the tangent the rounding of the radius is large against the chord.
            let slack = 1e-12 + 1e-13 / chord.abs();
            match crossing {
                Some(crossing) => {
                    assert!((crossing.distance - chord).abs() < slack && chord > -slack);
                    let at = origin + direction * crossing.distance;
                    assert!((at.distance(circle.center) - circle.radius).abs() < 1e-14 * 8.0, "it lies on the circle");
                }
                None => assert!(chord < slack),
            }
        }
    }

    /// y = x^2 / 4f reflects what comes along its axis through the focus at (0, f).
    #[test]
    fn a_parabola_has_its_points_and_normals() {
        let parabola = Parabola { vertex: DVec2::new(1.0, 2.0), axis: DVec2::X, curvature: 0.125, half: 6.0 };
        let focus = DVec2::new(1.0, 4.0);
        for x in [-5.0, -1.0, 0.0, 0.5, 5.9] {
            let down = ray(DVec2::new(1.0 + x, 50.0), DVec2::NEG_Y);
            let crossing = Curve::Parabola(parabola).cross(&down, false).expect("it is below");
            let point = down.at(crossing.distance);
            assert!((point - parabola.at(x)).length() < 1e-12);
            let out = down.direction - crossing.normal * (2.0 * down.direction.dot(crossing.normal));
            assert!(out.perp_dot(focus - point).abs() < 1e-12 * (focus - point).length() * 100.0);
        }
        assert_eq!(Curve::Parabola(parabola).cross(&ray(DVec2::new(7.1, 50.0), DVec2::NEG_Y), false), None);
    }

    #[test]
    fn crossings_lie_within_the_bounds_and_in_order() {
        let mut random = SplitMix64::new(2);
        for _ in 0..5_000 {
            let mut point = || DVec2::new(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0));
            let (a, b, c, origin, target) = (point(), point(), point(), point(), point());
            let circle = Circle { center: a, radius: b.length() };
            let curves = [
                Curve::Line(Segment { a, b }),
                Curve::Arc(Arc::new(circle, c.x, c.y)),
                Curve::Parabola(Parabola { vertex: a, axis: b.normalize(), curvature: c.x, half: c.y.abs() }),
            ];
            let ray = ray(origin, target - origin);
            for curve in curves {
                let Some(crossing) = curve.cross(&ray, false) else { continue };
                let at = ray.at(crossing.distance);
                assert!(curve.bounds().grown(1e-6).contains(at), "{curve:?} {at}");
                // From just before the crossing it is found again, from just behind it is not.
                let shifted = |by: f64| Ray { origin: ray.at(crossing.distance + by), ..ray };
                let again = curve.cross(&shifted(-1e-4), false).expect("it is ahead");
                assert!((again.distance - 1e-4).abs() < 1e-5, "{curve:?}");
                assert!(curve.cross(&shifted(1e-4), false).is_none_or(|next| next.distance > 1e-6));
            }
        }
    }
}
