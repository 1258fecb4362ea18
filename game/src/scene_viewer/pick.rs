//! What is under the mouse.

use crate::drawn_scene::DrawnScene;
use geometry::{DVec2, Segment};
use pinball::table::{DrawnLine, DrawnOutline, DrawnPiece, DrawnShape};

/// Chords that stand for an arc.
const CHORDS: usize = 32;

/// The shape at a place, mm, or the nearest within `reach_mm`. Of several the nearest counts, and of those that the place lies in
/// the one that is drawn last.
pub fn shape_at(scene: &DrawnScene, place: DVec2, reach_mm: f64) -> Option<usize> {
    let mut best = None;
    for &number in &scene.things {
        let distance = distance(&scene.drawing.shapes[number], place);
        if distance <= reach_mm && best.is_none_or(|(_, least)| distance <= least) {
            best = Some((number, distance));
        }
    }
    best.map(|(number, _)| number)
}

/// How far a place is from what a shape draws, mm; 0 inside of it.
fn distance(shape: &DrawnShape, place: DVec2) -> f64 {
    let half = if shape.stroke.is_some() { 0.5 * shape.thickness_mm } else { 0.0 };
    let from_line = match &shape.outline {
        DrawnOutline::Circle(circle) => {
            let beyond = place.distance(circle.center) - circle.radius;
            if shape.is_filled { beyond.max(0.0) } else { beyond.abs() }
        }
        DrawnOutline::Lines(lines) => {
            let inside = lines.iter().filter(|line| line.closed && shape.is_filled && surrounds(line, place)).count();
            let outlines = lines.iter().flat_map(chords);
            if inside % 2 == 1 {
                0.0
            } else {
                outlines.map(|chord| from_segment(&chord, place)).fold(f64::INFINITY, f64::min)
            }
        }
    };
    (from_line - half).max(0.0)
}

/// The outline as straight lines.
pub fn chords(line: &DrawnLine) -> Vec<Segment> {
    let of_piece = |piece: &DrawnPiece| match piece {
        DrawnPiece::Line(line) => vec![*line],
        DrawnPiece::Arc(arc) => {
            let at = |step: usize| {
                let angle = (2.0 * step as f64 / CHORDS as f64 - 1.0) * arc.half_angle();
                arc.circle().center + geometry::trig::rotate(arc.middle(), angle) * arc.circle().radius
            };
            (0..CHORDS).map(|step| Segment { a: at(step), b: at(step + 1) }).collect()
        }
    };
    line.pieces.iter().flat_map(of_piece).collect()
}

/// Whether a closed line goes round a place: a ray to the right crosses it an odd number of times.
fn surrounds(line: &DrawnLine, place: DVec2) -> bool {
    let crosses = |chord: &Segment| {
        let (a, b) = (chord.a - place, chord.b - place);
        (a.y > 0.0) != (b.y > 0.0) && a.x + (b.x - a.x) * a.y / (a.y - b.y) > 0.0
    };
    chords(line).iter().filter(|chord| crosses(chord)).count() % 2 == 1
}

fn from_segment(line: &Segment, place: DVec2) -> f64 {
    let along = line.along();
    let part = if along == DVec2::ZERO { 0.0 } else { (place - line.a).dot(along) / along.length_squared() };
    place.distance(line.a + along * part.clamp(0.0, 1.0))
}
