//! Flippers' strokes: what stands still in their way, which they would go through, and strokes that do not go up.

use super::{DEEP_M, called, solid, tip};
use crate::table::Table;
use geometry::{DVec2, Shape};
use physics::{Flipper, FlipperControl, Kind};

/// Angles of a stroke that are looked at.
const STEPS: usize = 64;
/// Places along a flipper's middle, from this part of its length on: at its pivot guides and posts end.
const PLACES: usize = 32;
const FROM: f64 = 0.3;
/// A flipper may rest so much above the level, as the sine of its angle: 10 degrees.
const LEVEL: f64 = 0.17;

/// The flippers in whose stroke something stands or that turn down, each with what to say and that it is a warning.
pub fn findings(table: &Table) -> Vec<(usize, String, bool)> {
    let parts = table.layout.parts.iter().enumerate();
    let flippers = parts.filter_map(|(part, placed)| match &placed.kind {
        Kind::Flipper(flipper) if flipper.control != FlipperControl::Rules => Some((part, flipper)),
        _ => None,
    });
    let stands = |flipper: &Flipper| {
        let (other, place) = in_the_way(table, flipper)?;
        let DVec2 { x, y } = place * 1000.0;
        Some(format!("its stroke goes through {} at {x:.0}, {y:.0} mm; leave its way free", called(table, other)))
    };
    let told = |(part, flipper): (usize, &Flipper)| {
        let all = [wrong_way(flipper), stands(flipper)].into_iter().flatten();
        all.map(move |what| (part, what, true)).collect::<Vec<_>>()
    };
    flippers.flat_map(told).collect()
}

/// What is wrong with a flipper that goes down when its button is held, or whose tip points up before.
fn wrong_way(flipper: &Flipper) -> Option<String> {
    let height = |at: f64| (flipper.base.center.y - tip(flipper, at).y) / flipper.length_m;
    let (rest, held) = (height(0.0), height(1.0));
    let (side, other) = if flipper.control == FlipperControl::Left { ("left", "right") } else { ("right", "left") };
    if held < rest {
        return Some(format!(
            "its tip goes down when its button is held; with data-side=\"{side}\" draw it from its pivot, x1 y1, to the {other}"
        ));
    }
    (rest > LEVEL).then(|| {
        "its tip points up before its button is held; draw it at rest, from its pivot, x1 y1, down to its tip"
            .to_string()
    })
}

/// The first part that stands in the flipper's way, and where.
fn in_the_way(table: &Table, flipper: &Flipper) -> Option<(usize, DVec2)> {
    let reach = flipper.length_m + flipper.tip_radius_m;
    table.layout.parts.iter().enumerate().find_map(|(part, placed)| {
        let shapes = standing(&placed.kind);
        let near = shapes.iter().filter(|shape| shape.distance(flipper.base.center).0 < reach);
        // Walls are drawn round flippers' ends, and their rubber gives way; what is hit by balls would be hit by the flipper.
        let is_wall = matches!(placed.kind, Kind::Wall(_));
        near.filter_map(|shape| place_in(shape, flipper, is_wall)).next().map(|place| (part, place))
    })
}

/// What of a part stands still.
fn standing(kind: &Kind) -> Vec<Shape> {
    match kind {
        Kind::Wall(wall) => wall.shapes.clone(),
        Kind::DropTarget(_) => Vec::new(),
        other => solid(other).into_iter().collect(),
    }
}

/// Where the flipper's middle, or else its rubber, is in the shape at some angle of its stroke.
fn place_in(shape: &Shape, flipper: &Flipper, middle_only: bool) -> Option<DVec2> {
    let part = |step: usize, of: usize| step as f64 / of as f64;
    let tips = (0..=STEPS).map(|step| tip(flipper, part(step, STEPS)));
    let along = |tip: DVec2| {
        let place = move |step: usize| {
            let at = FROM + (1.0 - FROM) * part(step, PLACES);
            let radius = flipper.base.radius + (flipper.tip_radius_m - flipper.base.radius) * at;
            (flipper.base.center.lerp(tip, at), if middle_only { 0.0 } else { radius - DEEP_M })
        };
        (0..=PLACES).map(place)
    };
    let met = tips.flat_map(along).find(|(place, radius)| shape.distance(*place).0 < *radius);
    met.map(|(place, _)| place)
}
