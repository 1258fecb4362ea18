//! Every shape against oracles that share no line with it: parry2d where it has the shape, and sphere marching along a
//! distance found by searching the core where it has not.

use geometry::{Arc, Bounds, Circle, Core, DVec2, Ray, Segment, Shape, Taper, trig};
use parry2d_f64::query::{PointQuery, RayCast};
use proptest::prelude::*;

/// Where two ways to the same number may differ: parry's capsule is found by iteration.
const TOLERANCE: f64 = 1e-6;

/// A ray that passes a surface this closely may be said to hit it or to miss it.
const GRAZING: f64 = 1e-5;

fn point() -> impl Strategy<Value = DVec2> {
    (-50.0..50.0, -50.0..50.0).prop_map(|(x, y)| DVec2::new(x, y))
}

fn ray() -> impl Strategy<Value = Ray> {
    (point(), 0.0..std::f64::consts::TAU).prop_map(|(origin, angle)| Ray { origin, direction: trig::direction(angle) })
}

fn circle() -> impl Strategy<Value = Circle> {
    (point(), 0.1..30.0).prop_map(|(center, radius)| Circle { center, radius })
}

fn arc() -> impl Strategy<Value = Arc> {
    (circle(), 0.0..6.3, -7.0..7.0).prop_map(|(circle, start, sweep)| Arc::new(circle, start, sweep))
}

fn shape() -> impl Strategy<Value = Shape> {
    let core = prop_oneof![
        point().prop_map(Core::Point),
        (point(), point()).prop_map(|(a, b)| Core::Segment(Segment { a, b })),
        arc().prop_map(Core::Arc),
        (circle(), circle()).prop_map(|(a, b)| Core::Taper(Taper { a, b })),
    ];
    (core, 0.05..8.0).prop_map(|(core, radius)| Shape { core, radius })
}

/// Signed distance by searching the core for the disc whose edge is nearest.
fn searched_distance(shape: &Shape, at: DVec2) -> f64 {
    let disc = |part: f64| match &shape.core {
        Core::Point(center) => (*center, 0.0),
        Core::Segment(s) => (s.a.lerp(s.b, part), 0.0),
        Core::Arc(arc) => {
            let angle = trig::angle(arc.middle()) + (2.0 * part - 1.0) * arc.half_angle();
            (arc.circle().center + trig::direction(angle) * arc.circle().radius, 0.0)
        }
        Core::Taper(t) => (t.a.center.lerp(t.b.center, part), t.a.radius + (t.b.radius - t.a.radius) * part),
    };
    let distance = |part: f64| {
        let (center, radius) = disc(part.clamp(0.0, 1.0));
        at.distance(center) - radius - shape.radius
    };
    // A coarse look everywhere, then thirds of every place that is nearer than its neighbours: an arc may have two.
    let steps = 48;
    let coarse = |step: i32| distance(f64::from(step) / f64::from(steps));
    let near = (0..=steps).filter(|&step| coarse(step) <= coarse(step - 1) && coarse(step) <= coarse(step + 1));
    let refined = near.map(|step| {
        let part = |step: i32| f64::from(step.clamp(0, steps)) / f64::from(steps);
        let (mut low, mut high) = (part(step - 1), part(step + 1));
        for _ in 0..60 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if distance(a) < distance(b) { high = b } else { low = a }
        }
        distance((low + high) * 0.5)
    });
    refined.fold(f64::MAX, f64::min)
}

/// Where a ray enters a shape, by steps as long as the way is surely free.
fn marched(shape: &Shape, ray: &Ray) -> Option<f64> {
    let mut along = 0.0;
    for _ in 0..4000 {
        let distance = searched_distance(shape, ray.at(along));
        if distance < 1e-10 {
            return Some(along);
        }
        along += distance;
        if along > 300.0 {
            break;
        }
    }
    None
}

/// The shape made thinner and thicker by `GRAZING` agree on whether the ray hits at all and nearly on where.
fn is_clear(shape: &Shape, ray: &Ray) -> bool {
    let hit = |extra: f64| shape.inflated(extra).cast(ray).map(|hit| hit.distance);
    match (hit(-GRAZING), hit(GRAZING)) {
        (Some(a), Some(b)) => (a - b).abs() < 0.02,
        (None, None) => true,
        _ => false,
    }
}

fn assert_same_hit(ours: Option<f64>, theirs: Option<f64>) -> Result<(), TestCaseError> {
    match (ours, theirs) {
        (Some(a), Some(b)) => prop_assert!((a - b).abs() <= TOLERANCE * (1.0 + b), "{a} against {b}"),
        (a, b) => prop_assert!(a.is_none() && b.is_none(), "{a:?} against {b:?}"),
    }
    Ok(())
}

fn parry_ray(ray: &Ray) -> parry2d_f64::query::Ray {
    parry2d_f64::query::Ray::new(ray.origin, ray.direction)
}

/// Distance, side and rays of a shape that parry has too.
fn agrees_with_parry(
    shape: &Shape,
    theirs: &(impl RayCast + PointQuery),
    ray: &Ray,
    at: DVec2,
) -> Result<(), TestCaseError> {
    let (distance, normal) = shape.distance(at);
    let projection = theirs.project_local_point(at, false);
    let unsigned = at.distance(projection.point);
    let expected = if projection.is_inside { -unsigned } else { unsigned };
    prop_assert!((distance - expected).abs() <= TOLERANCE * 10.0, "{distance} against {expected}");
    let surface = at - normal * distance;
    prop_assert!(surface.distance(projection.point) <= 1e-4, "{surface} against {}", projection.point);
    let outside = shape.distance(ray.origin).0 > GRAZING;
    if outside && is_clear(shape, ray) {
        let expected = theirs.cast_local_ray(&parry_ray(ray), 1e4, true);
        assert_same_hit(shape.cast(ray).map(|hit| hit.distance), expected)?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn a_disc_is_a_ball(radius in 0.1..30.0, ray in ray(), at in point()) {
        prop_assume!(at.length() > 1e-3);
        agrees_with_parry(&Shape::disc(DVec2::ZERO, radius), &parry2d_f64::shape::Ball::new(radius), &ray, at)?;
    }

    #[test]
    fn a_capsule_is_a_capsule(a in point(), b in point(), radius in 0.1..10.0, ray in ray(), at in point()) {
        prop_assume!(a.distance(b) > 0.1);
        let ours = Shape::capsule(a, b, radius);
        prop_assume!(ours.distance(at).0 + radius > 1e-3);
        agrees_with_parry(&ours, &parry2d_f64::shape::Capsule::new(a, b, radius), &ray, at)?;
    }

    #[test]
    fn a_line_is_a_segment(a in point(), b in point(), ray in ray()) {
        let theirs = parry2d_f64::shape::Segment::new(a, b);
        let ends = [a, b].map(|end| (end - ray.origin).perp_dot(ray.direction).abs());
        prop_assume!(ends[0] > GRAZING && ends[1] > GRAZING);
        let expected = theirs.cast_local_ray(&parry_ray(&ray), 1e4, true);
        assert_same_hit(Shape::capsule(a, b, 0.0).cast(&ray).map(|hit| hit.distance), expected)?;
    }

    #[test]
    fn the_distance_of_any_shape_is_that_of_its_nearest_disc(shape in shape(), at in point()) {
        let (ours, expected) = (shape.distance(at).0, searched_distance(&shape, at));
        prop_assert!((ours - expected).abs() <= TOLERANCE, "{ours} against {expected}");
    }

    #[test]
    fn any_shape_is_hit_where_marching_hits_it(shape in shape(), ray in ray()) {
        prop_assume!(searched_distance(&shape, ray.origin) > GRAZING && is_clear(&shape, &ray));
        assert_same_hit(shape.cast(&ray).map(|hit| hit.distance), marched(&shape, &ray))?;
    }

    #[test]
    fn a_ray_from_inside_enters_nothing(shape in shape(), ray in ray()) {
        if searched_distance(&shape, ray.origin) < -GRAZING && !matches!(shape.core, Core::Arc(_)) {
            prop_assert_eq!(shape.cast(&ray), None);
        }
    }

    #[test]
    fn a_hit_lies_on_the_surface_and_faces_the_ray(shape in shape(), ray in ray()) {
        if let Some(hit) = shape.cast(&ray) {
            prop_assert!(searched_distance(&shape, ray.at(hit.distance)).abs() < 1e-6);
            prop_assert!((hit.normal.length() - 1.0).abs() < 1e-9);
            prop_assert!(hit.normal.dot(ray.direction) <= 1e-9, "{}", hit.normal);
            let stepped = searched_distance(&shape, ray.at(hit.distance) + hit.normal * 1e-3);
            prop_assert!((stepped - 1e-3).abs() < 1e-4, "the normal leads to {stepped}");
        }
    }

    #[test]
    fn nothing_of_a_core_is_nearer_than_its_closest_point(arc in arc(), a in point(), b in point(), at in point()) {
        let segment = Segment { a, b };
        for step in 0..=200 {
            let part = f64::from(step) / 200.0;
            prop_assert!(at.distance(segment.closest(at)) <= at.distance(a.lerp(b, part)) + 1e-9);
            prop_assert!(at.distance(arc.closest(at)) <= at.distance(arc.at(part)) + 1e-9);
        }
        prop_assert!(a.distance(segment.closest(at)) + segment.closest(at).distance(b) <= a.distance(b) + 1e-9);
    }

    #[test]
    fn the_bounds_hold_the_shape_and_no_more(shape in shape()) {
        let Bounds { min, max } = shape.bounds();
        // From far outside, straight at each side of the box: the surface is exactly there.
        for (direction, side) in [(DVec2::X, min.x), (DVec2::NEG_X, -max.x), (DVec2::Y, min.y), (DVec2::NEG_Y, -max.y)] {
            let extreme = farthest(&shape, -direction);
            prop_assert!((extreme.dot(direction) - side).abs() < 1e-4, "{} against {side}", extreme.dot(direction));
        }
    }

    #[test]
    fn a_shape_in_another_unit_is_hit_at_the_same_place(shape in shape(), ray in ray(), factor in 0.001..10.0) {
        prop_assume!(is_clear(&shape, &ray) && shape.distance(ray.origin).0 > GRAZING);
        let scaled = Ray { origin: ray.origin * factor, ..ray };
        let hit = shape.scaled(factor).cast(&scaled).map(|hit| hit.distance / factor);
        assert_same_hit(hit, shape.cast(&ray).map(|hit| hit.distance))?;
    }
}

/// The place of a shape that lies farthest in a direction, by trying every part of its core.
fn farthest(shape: &Shape, direction: DVec2) -> DVec2 {
    let steps = 4000;
    let surface = |part: f64| match &shape.core {
        Core::Point(center) => *center,
        Core::Segment(s) => s.a.lerp(s.b, part),
        Core::Arc(arc) => arc.at(part),
        Core::Taper(t) => {
            t.a.center.lerp(t.b.center, part) + direction * (t.a.radius + (t.b.radius - t.a.radius) * part)
        }
    };
    (0..=steps)
        .map(|step| surface(f64::from(step) / f64::from(steps)) + direction * shape.radius)
        .max_by(|a, b| a.dot(direction).total_cmp(&b.dot(direction)))
        .unwrap_or(DVec2::ZERO)
}
