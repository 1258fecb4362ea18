//! Flippers' strokes: what stands still in their way, which they would go through.

use super::{called, solid, tip};
use crate::table::Table;
use geometry::{DVec2, Shape};
use physics::{Flipper, FlipperControl, Kind};

/// Angles of a stroke that are looked at.
const STEPS: usize = 64;
/// Places along a flipper's middle, from this part of its length on: at its pivot guides and posts end.
const PLACES: usize = 32;
const FROM: f64 = 0.3;

/// The flippers in whose stroke something stands, each with what to say and that it is a warning.
pub fn findings(table: &Table) -> Vec<(usize, String, bool)> {
    let parts = table.layout.parts.iter().enumerate();
    let flippers = parts.filter_map(|(part, placed)| match &placed.kind {
        Kind::Flipper(flipper) if flipper.control != FlipperControl::Rules => Some((part, flipper)),
        _ => None,
    });
    let told = |(part, flipper): (usize, &Flipper)| {
        let (other, place) = in_the_way(table, flipper)?;
        let DVec2 { x, y } = place * 1000.0;
        let what = format!("its stroke goes through {} at {x:.0}, {y:.0} mm; leave its way free", called(table, other));
        Some((part, what, true))
    };
    flippers.filter_map(told).collect()
}

/// The first part that stands in the flipper's way, and where.
fn in_the_way(table: &Table, flipper: &Flipper) -> Option<(usize, DVec2)> {
    let reach = flipper.length_m + flipper.tip_radius_m;
    table.layout.parts.iter().enumerate().find_map(|(part, placed)| {
        let shapes = standing(&placed.kind);
        let near = shapes.iter().filter(|shape| shape.distance(flipper.base.center).0 < reach);
        near.filter_map(|shape| place_in(shape, flipper)).next().map(|place| (part, place))
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

/// Where the flipper's middle is in the shape at some angle of its stroke.
fn place_in(shape: &Shape, flipper: &Flipper) -> Option<DVec2> {
    let part = |step: usize, of: usize| step as f64 / of as f64;
    let tips = (0..=STEPS).map(|step| tip(flipper, part(step, STEPS)));
    let along = |tip: DVec2| {
        let place = move |step: usize| flipper.base.center.lerp(tip, FROM + (1.0 - FROM) * part(step, PLACES));
        (0..=PLACES).map(place)
    };
    tips.flat_map(along).find(|place| shape.distance(*place).0 < 0.0)
}
