//! Shapes of a scene as outlines that light meets.

use geometry::{Arc, Circle, Core, Segment, Shape};
use pinball::table::{DrawnOutline, DrawnPiece, DrawnShape};
use std::f64::consts::TAU;
use tracer::transport::{Body, Curve, Material};

/// What is drawn stands there: the inside, if it is painted, and the line with its thickness.
pub fn solid(shape: &DrawnShape, material: Material) -> Vec<Body> {
    let half = if shape.stroke.is_some() { 0.5 * shape.thickness_mm } else { 0.0 };
    match &shape.outline {
        DrawnOutline::Circle(circle) if shape.is_filled => {
            vec![Body::of_shape(&Shape::disc(circle.center, circle.radius + half), material)]
        }
        DrawnOutline::Circle(circle) => {
            let rims = [circle.radius + half, circle.radius - half].into_iter().filter(|radius| *radius > 0.0);
            rims.map(|radius| Body::of_shape(&Shape::disc(circle.center, radius), material)).collect()
        }
        DrawnOutline::Lines(lines) => {
            let inside = shape.is_filled && lines.iter().any(|line| line.closed);
            let area = inside.then(|| Body::open(curves(shape), material));
            let pieces = lines.iter().flat_map(|line| &line.pieces);
            let line = pieces.filter(|_| half > 0.0).map(|piece| Body::of_shape(&thick(piece, half), material));
            let thin = (area.is_none() && half == 0.0).then(|| Body::open(curves(shape), material));
            area.into_iter().chain(line).chain(thin).collect()
        }
    }
}

/// The line that is drawn, without its thickness.
pub fn line(shape: &DrawnShape, material: Material) -> Body {
    Body::open(curves(shape), material)
}

/// The area that is drawn; `None` where a line of its outline is open.
pub fn area(shape: &DrawnShape, material: Material) -> Option<Body> {
    is_closed(shape).then(|| Body::enclosed(&curves(shape), material))
}

/// Whether every line of the outline is closed.
pub fn is_closed(shape: &DrawnShape) -> bool {
    match &shape.outline {
        DrawnOutline::Circle(_) => true,
        DrawnOutline::Lines(lines) => lines.iter().all(|line| line.closed),
    }
}

/// The one straight line that a shape is.
pub fn straight(shape: &DrawnShape) -> Option<Segment> {
    match &shape.outline {
        DrawnOutline::Lines(lines) => match lines.as_slice() {
            [line] => match line.pieces.as_slice() {
                [DrawnPiece::Line(line)] => Some(*line),
                _ => None,
            },
            _ => None,
        },
        DrawnOutline::Circle(_) => None,
    }
}

fn curves(shape: &DrawnShape) -> Vec<Curve> {
    match &shape.outline {
        DrawnOutline::Circle(circle) => vec![Curve::Arc(whole(circle))],
        DrawnOutline::Lines(lines) => {
            let curve = |piece: &DrawnPiece| match piece {
                DrawnPiece::Line(line) => Curve::Line(*line),
                DrawnPiece::Arc(arc) => Curve::Arc(*arc),
            };
            lines.iter().flat_map(|line| &line.pieces).map(curve).collect()
        }
    }
}

fn whole(circle: &Circle) -> Arc {
    Arc::new(*circle, 0.0, TAU)
}

fn thick(piece: &DrawnPiece, radius: f64) -> Shape {
    match piece {
        DrawnPiece::Line(Segment { a, b }) => Shape::capsule(*a, *b, radius),
        DrawnPiece::Arc(arc) => Shape { core: Core::Arc(*arc), radius },
    }
}
