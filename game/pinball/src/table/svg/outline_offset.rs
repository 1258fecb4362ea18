//! Outline offset: a polygon grown by a radius, the top of a solid whose edge is a line with a thickness.

use geometry::{DVec2, Segment, trig};

/// How much nearer to an edge than the radius a point of the rim may be, mm.
const SLACK_MM: f64 = 0.01;
/// The angle between points round a corner, rad.
const STEP_RAD: f64 = 0.35;

/// The outline of everything within `radius` of a closed polygon or inside it. Points of the naive offset that lie too
/// near another edge are where it crosses itself, and are left out.
pub(in crate::table) fn offset(polygon: &[DVec2], radius: f64) -> Vec<DVec2> {
    if radius <= 0.0 || polygon.len() < 3 {
        return polygon.to_vec();
    }
    let count = polygon.len();
    let edges: Vec<Segment> =
        (0..count).map(|index| Segment { a: polygon[index], b: polygon[(index + 1) % count] }).collect();
    // With y down a positive area is clockwise on the screen, and outward is to the right of the way.
    let orientation = area(polygon).signum();
    let outward = |edge: &Segment| edge.left_normal().map_or(DVec2::ZERO, |normal| normal * -orientation);
    let mut rim = Vec::new();
    for (index, edge) in edges.iter().enumerate() {
        let (before, after) = (outward(edge), outward(&edges[(index + 1) % count]));
        corner(&mut rim, edge.b, [before, after], radius, orientation);
    }
    rim.retain(|&point| edges.iter().all(|edge| edge.closest(point).distance(point) >= radius - SLACK_MM));
    if rim.len() < 3 { polygon.to_vec() } else { rim }
}

/// Points round a corner that sticks out, or the one point where the offset edges meet where it is dented.
fn corner(rim: &mut Vec<DVec2>, at: DVec2, [before, after]: [DVec2; 2], radius: f64, orientation: f64) {
    let (turn, cos) = (before.perp_dot(after), before.dot(after));
    if turn * orientation < 0.0 && cos > -0.999 {
        rim.push(at + (before + after) * (radius / (1.0 + cos)));
        return;
    }
    let turn_rad = libm::atan2(turn, cos);
    let steps = (turn_rad.abs() / STEP_RAD).ceil().max(1.0) as usize;
    let inherited = |step: usize| trig::rotate(before, turn_rad * step as f64 / steps as f64);
    rim.extend((0..=steps).map(|step| at + inherited(step) * radius));
}

fn area(polygon: &[DVec2]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(polygon: &[DVec2], point: DVec2) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        let edges = polygon.iter().zip(next).map(|(&a, &b)| Segment { a, b });
        edges.map(|edge| edge.closest(point).distance(point)).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn every_point_of_the_rim_is_a_radius_away_either_way_round() {
        let l_shape = [(0.0, 0.0), (40.0, 0.0), (40.0, 10.0), (10.0, 10.0), (10.0, 30.0), (0.0, 30.0)];
        let mut polygon: Vec<DVec2> = l_shape.into_iter().map(DVec2::from).collect();
        for _ in 0..2 {
            let rim = offset(&polygon, 3.0);
            assert!(rim.iter().all(|&point| (distance(&polygon, point) - 3.0).abs() < 0.011));
            // A strip along each side, a quarter disc at each of five corners, and the square where two strips overlap.
            let full = 600.0 + 3.0 * 140.0 + 5.0 / 4.0 * 9.0 * std::f64::consts::PI - 9.0;
            assert!((0.0..1.0).contains(&(full - area(&rim).abs())), "{} is not {full}", area(&rim).abs());
            polygon.reverse();
        }
    }
}
