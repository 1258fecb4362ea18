//! The outline of a shape as a path: the shapes that balls and light meet, as a pen draws them.
//!
//! Round pieces become chords that no eye can tell from the circle.

use geometry::{Arc, Circle, Core, DVec2, Segment, Shape, Taper, trig};
use std::f64::consts::{PI, TAU};
use tiny_skia::{Path, PathBuilder};

/// How far a chord may lie inside its circle, pixels.
const TOLERANCE_PX: f64 = 0.03;

/// The outline of a shape in pixels; `None` for a shape that has no size.
pub fn path(shape: &Shape) -> Option<Path> {
    let mut pen = Pen::default();
    match shape.core {
        Core::Point(center) => pen.circle(Circle { center, radius: shape.radius }),
        Core::Segment(segment) => pen.capsule(segment, shape.radius),
        Core::Arc(arc) => pen.bow(arc, shape.radius),
        Core::Taper(taper) => pen.taper(taper, shape.radius),
    }
    pen.builder.finish()
}

#[derive(Default)]
struct Pen {
    builder: PathBuilder,
    down: bool,
}

impl Pen {
    fn to(&mut self, point: DVec2) {
        let (x, y) = (point.x as f32, point.y as f32);
        if self.down {
            self.builder.line_to(x, y)
        } else {
            self.builder.move_to(x, y)
        }
        self.down = true;
    }

    fn close(&mut self) {
        self.builder.close();
        self.down = false;
    }

    /// On round a circle, from one angle by another.
    fn round(&mut self, circle: Circle, from_rad: f64, by_rad: f64) {
        // A chord over an angle t lies r t^2 / 8 inside its circle, near enough.
        let chord_rad = (8.0 * TOLERANCE_PX / circle.radius.max(TOLERANCE_PX)).sqrt();
        let chords = (by_rad.abs() / chord_rad).ceil().clamp(1.0, 720.0) as u32;
        for chord in 0..=chords {
            let angle = from_rad + by_rad * f64::from(chord) / f64::from(chords);
            self.to(circle.center + trig::direction(angle) * circle.radius);
        }
    }

    fn circle(&mut self, circle: Circle) {
        self.round(circle, 0.0, TAU);
        self.close();
    }

    fn capsule(&mut self, segment: Segment, radius: f64) {
        let way = trig::angle(segment.b - segment.a);
        self.round(Circle { center: segment.b, radius }, way - PI * 0.5, PI);
        self.round(Circle { center: segment.a, radius }, way + PI * 0.5, PI);
        self.close();
    }

    /// A curved wall: its outer side, the end, its inner side, the other end.
    fn bow(&mut self, arc: Arc, radius: f64) {
        let Circle { center, radius: bend } = arc.circle();
        let (outer, inner) = (Circle { center, radius: bend + radius }, Circle { center, radius: bend - radius });
        let (middle, half) = (trig::angle(arc.middle()), arc.half_angle());
        if half >= PI {
            self.circle(outer);
            if inner.radius > 0.0 {
                self.circle(inner);
            }
            return;
        }
        let ends = [middle - half, middle + half].map(|angle| (center + trig::direction(angle) * bend, angle));
        let [first, last] = ends;
        self.round(outer, middle - half, 2.0 * half);
        self.round(Circle { center: last.0, radius }, last.1, PI);
        if inner.radius > 0.0 {
            self.round(inner, middle + half, -2.0 * half);
        }
        self.round(Circle { center: first.0, radius }, first.1 + PI, PI);
        self.close();
    }

    fn taper(&mut self, taper: Taper, extra: f64) {
        let grown = |circle: Circle| Circle { radius: circle.radius + extra, ..circle };
        let taper = Taper { a: grown(taper.a), b: grown(taper.b) };
        let Some(normals) = taper.side_normals() else {
            return self.circle(if taper.a.radius >= taper.b.radius { taper.a } else { taper.b });
        };
        let way = trig::angle(taper.b.center - taper.a.center);
        // From the way that the taper points to where its straight side begins.
        let side = trig::angle(trig::rotate(normals[0], -way)).abs();
        self.round(taper.b, way - side, 2.0 * side);
        self.round(taper.a, way + side, TAU - 2.0 * side);
        self.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every kind of shape, some of them awkward.
    fn shapes() -> Vec<Shape> {
        let circle = |x: f64, y: f64, radius: f64| Circle { center: DVec2::new(x, y), radius };
        let arc = |start_rad: f64, sweep_rad: f64, radius: f64| Shape {
            core: Core::Arc(Arc::new(circle(100.0, 90.0, 40.0), start_rad, sweep_rad)),
            radius,
        };
        let taper = Taper { a: circle(50.0, 60.0, 12.0), b: circle(110.0, 90.0, 6.0) };
        let swallowed = Taper { a: circle(50.0, 60.0, 12.0), b: circle(52.0, 60.0, 3.0) };
        vec![
            Shape::disc(DVec2::new(30.0, 20.0), 9.0),
            Shape::capsule(DVec2::new(10.0, 20.0), DVec2::new(60.0, -15.0), 4.0),
            Shape::capsule(DVec2::new(10.0, 20.0), DVec2::new(10.0, 20.0), 4.0),
            arc(0.4, 2.0, 3.0),
            arc(-2.9, -1.2, 6.0),
            arc(0.0, TAU, 5.0),
            Shape { core: Core::Taper(taper), radius: 2.0 },
            Shape { core: Core::Taper(swallowed), radius: 0.0 },
        ]
    }

    #[test]
    fn an_outline_lies_on_the_surface_that_balls_meet() {
        for shape in shapes() {
            let path = path(&shape).expect("the shape has a size");
            for point in path.points() {
                let (distance, _) = shape.distance(DVec2::new(f64::from(point.x), f64::from(point.y)));
                assert!(distance.abs() < 1e-3, "{point:?} is {distance} px off {shape:?}");
            }
        }
    }

    #[test]
    fn an_outline_encloses_all_of_the_shape() {
        for shape in shapes() {
            let (drawn, bounds) = (path(&shape).expect("the shape has a size").bounds(), shape.bounds());
            let sides = [
                (f64::from(drawn.left()), bounds.min.x),
                (f64::from(drawn.top()), bounds.min.y),
                (f64::from(drawn.right()), bounds.max.x),
                (f64::from(drawn.bottom()), bounds.max.y),
            ];
            assert!(sides.iter().all(|(a, b)| (a - b).abs() < 2.0 * TOLERANCE_PX), "{sides:?} {shape:?}");
        }
    }
}
