//! Landmarks: points of all surfaces, by which things are found that lie between the rays of a beam.

use crate::transport::{Body, Curve, EdgeId};
use geometry::DVec2;

/// Points of edges, by x.
pub(super) struct Landmarks {
    points: Vec<(DVec2, EdgeId)>,
}

impl Landmarks {
    /// The ends and the middles of all edges.
    pub fn new(bodies: &[Body]) -> Landmarks {
        let edges = bodies.iter().flat_map(|body| &body.edges).zip(0..);
        let mut points: Vec<(DVec2, EdgeId)> = edges
            .flat_map(|(edge, number)| points_of(&edge.curve).into_iter().map(move |point| (point, number)))
            .collect();
        points.sort_by(|(one, _), (other, _)| one.x.total_cmp(&other.x));
        Landmarks { points }
    }

    /// Whether a point lies within a convex outline whose corners go round, but for points of these edges.
    pub fn any_within(&self, outline: &[DVec2; 4], but: &[EdgeId]) -> bool {
        let low = outline.iter().fold(DVec2::INFINITY, |low, corner| low.min(*corner));
        let high = outline.iter().fold(DVec2::NEG_INFINITY, |high, corner| high.max(*corner));
        let first = self.points.partition_point(|(point, _)| point.x < low.x);
        let near = self.points[first..].iter().take_while(|(point, _)| point.x <= high.x);
        near.filter(|(point, edge)| (low.y..=high.y).contains(&point.y) && !but.contains(edge))
            .any(|(point, _)| is_within(*point, outline))
    }
}

/// Points of a curve: what is smaller than a beam has one of them in it.
fn points_of(curve: &Curve) -> Vec<DVec2> {
    match curve {
        Curve::Line(line) => vec![line.a, line.b, (line.a + line.b) * 0.5],
        Curve::Arc(arc) => [arc.ends().to_vec(), vec![curve.middle().0]].concat(),
        Curve::Parabola(parabola) => [-1.0, 0.0, 1.0].map(|part| parabola.at(part * parabola.half)).to_vec(),
    }
}

/// Whether all sides are passed on the same hand; rays that begin in one point have no side between.
fn is_within(point: DVec2, outline: &[DVec2; 4]) -> bool {
    let sides = (0..4).map(|at| (outline[at], outline[(at + 1) % 4])).filter(|(from, to)| from != to);
    let hands = sides.map(|(from, to)| (to - from).perp_dot(point - from));
    hands.clone().all(|hand| hand > 0.0) || hands.clone().all(|hand| hand < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transport::Material;
    use geometry::Shape;

    /// A small disc between two rays is found, one beside them is not, nor is one whose edge is asked for.
    #[test]
    fn what_lies_between_rays_is_found() {
        let disc = |x: f64, y: f64| Body::of_shape(&Shape::disc(DVec2::new(x, y), 0.5), Material::Absorber);
        let bodies = [disc(50.0, 1.0), disc(50.0, 30.0)];
        let landmarks = Landmarks::new(&bodies);
        let outline = [(0.0, -2.0), (100.0, -4.0), (100.0, 4.0), (0.0, 2.0)].map(|(x, y)| DVec2::new(x, y));
        assert!(landmarks.any_within(&outline, &[]));
        let own: Vec<EdgeId> = (0..bodies[0].edges.len() as EdgeId).collect();
        assert!(!landmarks.any_within(&outline, &own));
        assert!(!Landmarks::new(&bodies[1..]).any_within(&outline, &[]));
        let from_a_point = [DVec2::ZERO, outline[1], outline[2], DVec2::ZERO];
        assert!(landmarks.any_within(&from_a_point, &[]));
    }
}
