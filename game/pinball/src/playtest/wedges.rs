//! Wedges: places where a ball lies between two things whose gap is too narrow for it, however narrow the way there is.
//!
//! A grid finds no pocket that is as narrow as a ball: here its place is reckoned, as that of a ball that touches both.

use super::reach::Reach;
use geometry::{Bounds, DVec2, Shape};
use physics::{BALL_RADIUS_M, Machine};

/// Pairs of shapes that are looked at.
const MOST_PAIRS: usize = 1_000_000;
/// Steps towards the place that touches both, and how far it may be from them after that, m.
const STEPS: usize = 20;
const TOUCHING_M: f64 = 1e-7;
/// A ball is let go so far off the two things that it would touch, m.
const ABOVE_M: f64 = 2e-4;
/// A ball can come to a place if it can come so near, m.
const NEAR_M: f64 = 4e-3;
/// Wedges that are no farther from each other are one, m.
const SAME_M: f64 = 1e-3;

/// The places in wedges that a ball can come to, m.
pub fn places(machine: &Machine, reach: &Reach) -> Vec<DVec2> {
    let all = machine.layout().parts.iter().flat_map(|part| part.kind.surfaces());
    let mut shapes: Vec<(Bounds, Shape)> = all.map(|shape| (shape.bounds(), shape)).collect();
    shapes.sort_by(|one, other| one.0.min.x.total_cmp(&other.0.min.x));
    let mut found: Vec<DVec2> = Vec::new();
    let mut pairs = 0;
    for (index, (bounds, shape)) in shapes.iter().enumerate() {
        let near = bounds.grown(2.0 * BALL_RADIUS_M);
        for (other_bounds, other) in shapes[index + 1..].iter().take_while(|(other, _)| other.min.x <= near.max.x) {
            pairs += 1;
            if pairs > MOST_PAIRS {
                return found;
            }
            if other_bounds.min.y > near.max.y || other_bounds.max.y < near.min.y {
                continue;
            }
            let Some(place) = wedge(shape, other).filter(|place| is_free(machine, reach, *place)) else { continue };
            if found.iter().all(|other| other.distance(place) > SAME_M) {
                found.push(place);
            }
        }
    }
    found
}

/// Where a ball lies between the two, a little off them; none if it does not lie there.
fn wedge(one: &Shape, other: &Shape) -> Option<DVec2> {
    let mut center = between(one, other) - DVec2::new(0.0, BALL_RADIUS_M);
    for _ in 0..STEPS {
        let [(a_m, a), (b_m, b)] = [one.distance(center), other.distance(center)];
        let across = a.perp_dot(b);
        // Towards both at once, by as much as each is too near or too far.
        let [a_m, b_m] = [BALL_RADIUS_M - a_m, BALL_RADIUS_M - b_m];
        let step = DVec2::new(b.y * a_m - a.y * b_m, a.x * b_m - b.x * a_m) / across;
        center += step.clamp_length_max(BALL_RADIUS_M);
        if !center.is_finite() {
            return None;
        }
    }
    let [(a_m, a), (b_m, b)] = [one.distance(center), other.distance(center)];
    let touches = [a_m, b_m].into_iter().all(|distance_m| (distance_m - BALL_RADIUS_M).abs() < TOUCHING_M);
    // What presses on it from both sides together can carry it: straight up lies between their directions.
    let [a, b] = if a.x < b.x { [a, b] } else { [b, a] };
    let up = DVec2::new(0.0, -1.0);
    let lies = a.perp_dot(up) >= 0.0 && up.perp_dot(b) >= 0.0 && a.perp_dot(b) > 0.0;
    // Off both of them by the same.
    let off = (a + b) * (ABOVE_M / (1.0 + a.dot(b)));
    (touches && lies && off.length() < BALL_RADIUS_M).then_some(center + off)
}

/// A place half-way between the two, where they are near each other.
fn between(one: &Shape, other: &Shape) -> DVec2 {
    let bounds = [one.bounds(), other.bounds()];
    let (min, max) = (bounds[0].min.max(bounds[1].min), bounds[0].max.min(bounds[1].max));
    let mut place = (min + max) * 0.5;
    for _ in 0..STEPS {
        let [(a_m, a), (b_m, b)] = [one.distance(place), other.distance(place)];
        place = (place - a * a_m + place - b * b_m) * 0.5;
    }
    place
}

/// Whether there is room for a ball, and one can come there.
fn is_free(machine: &Machine, reach: &Reach, place: DVec2) -> bool {
    machine.depth_in_fixed_m(place) < 0.0 && reach.comes_to(&Shape::disc(place, 0.0), NEAR_M)
}
