//! The triangle of a point and a lamp's chord: all that a ray between them can meet.

use geometry::{Arc, Core, DVec2, Shape, Taper};

/// Room for rounding, in parts of the triangle's size.
const MARGIN: f64 = 1e-9;

/// A triangle, which may be as thin as a line.
pub(crate) struct CullingTriangle {
    corners: [DVec2; 3],
    /// Directions, not all of length 1, along which a shape may be shown to be apart.
    axes: [DVec2; 6],
    margin: f64,
}

impl CullingTriangle {
    pub fn new(point: DVec2, a: DVec2, b: DVec2) -> CullingTriangle {
        let (to_a, to_b) = (a - point, b - point);
        let way = (to_a + to_b) * 0.5;
        let axes = [to_a.perp(), to_b.perp(), (b - a).perp(), way, DVec2::X, DVec2::Y]
            .map(|axis| axis.try_normalize().unwrap_or(DVec2::X));
        let margin = MARGIN * (1.0 + to_a.length() + to_b.length() + point.length());
        CullingTriangle { corners: [point, a, b], axes, margin }
    }

    /// Whether some point of `shape` may be in the triangle; `false` is certain. A shape is apart where its whole
    /// extent along an axis is, and where it is a ring round the triangle.
    pub fn may_meet(&self, shape: &Shape) -> bool {
        let apart = self.axes.iter().any(|&axis| {
            let own = extent(self.corners.map(|corner| (corner.dot(axis), 0.0)));
            let (low, high) = extent_of(shape, axis);
            low > own.1 + self.margin || high < own.0 - self.margin
        });
        !apart && !self.is_within_ring(shape)
    }

    fn is_within_ring(&self, shape: &Shape) -> bool {
        let Core::Arc(arc) = &shape.core else { return false };
        let inner = arc.circle().radius - shape.radius - self.margin;
        self.corners.iter().all(|corner| corner.distance(arc.circle().center) < inner)
    }
}

/// The least and the most of places, each with so much to both sides.
fn extent<const N: usize>(places: [(f64, f64); N]) -> (f64, f64) {
    places
        .into_iter()
        .fold((f64::MAX, f64::MIN), |(low, high), (place, room)| (low.min(place - room), high.max(place + room)))
}

/// The extent of a shape along a unit vector.
fn extent_of(shape: &Shape, axis: DVec2) -> (f64, f64) {
    let (low, high) = match &shape.core {
        Core::Point(center) => extent([(center.dot(axis), 0.0)]),
        Core::Segment(segment) => extent([(segment.a.dot(axis), 0.0), (segment.b.dot(axis), 0.0)]),
        Core::Taper(Taper { a, b }) => extent([(a.center.dot(axis), a.radius), (b.center.dot(axis), b.radius)]),
        Core::Arc(arc) => extent_of_arc(arc, axis),
    };
    (low - shape.radius, high + shape.radius)
}

fn extent_of_arc(arc: &Arc, axis: DVec2) -> (f64, f64) {
    let circle = arc.circle();
    let [start, end] = arc.ends();
    let (mut low, mut high) = extent([(start.dot(axis), 0.0), (end.dot(axis), 0.0)]);
    let middle = circle.center.dot(axis);
    if arc.spans(circle.center - axis) {
        low = low.min(middle - circle.radius);
    }
    if arc.spans(circle.center + axis) {
        high = high.max(middle + circle.radius);
    }
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::any_shape;
    use geometry::Ray;
    use geometry::rng::SplitMix64;

    /// A ray between the point and the chord never meets a shape that is called apart.
    #[test]
    fn what_is_called_apart_is_never_met() {
        let (mut random, size) = (SplitMix64::new(5), DVec2::splat(160.0));
        let (mut apart, mut met) = (0, 0);
        for round in 0..20_000 {
            let shape = any_shape(&mut random, size, round);
            let [point, a] = [(); 2].map(|()| random.point_within(size));
            let b = a + random.point_within(size * 0.2) - size * 0.1;
            let may_meet = CullingTriangle::new(point, a, b).may_meet(&shape);
            let hit = (0..=16).any(|step| {
                let target = a + (b - a) * (f64::from(step) / 16.0);
                let far = point.distance(target);
                Ray::towards(point, target).and_then(|ray| shape.cast(&ray)).is_some_and(|hit| hit.distance <= far)
            });
            assert!(may_meet || !hit, "{shape:?} from {point} to {a} {b}");
            apart += u32::from(!may_meet);
            met += u32::from(hit);
        }
        assert!(apart > 8_000 && met > 2_000, "{apart} apart, {met} met");
    }
}
