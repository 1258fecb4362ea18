//! The gap between two flippers at rest: balls are lost through it.

use super::{DISCS, called, depth};
use crate::table::Table;
use physics::{BALL_RADIUS_M, Flipper, FlipperControl, Kind};

/// Pairs of flippers that face each other without touching, with less room between their rubbers than a ball needs; each with what to say
/// and that it is a warning.
pub fn findings(table: &Table) -> Vec<(usize, String, bool)> {
    let parts = table.layout.parts.iter().enumerate();
    let flippers = parts.filter_map(|(part, placed)| match &placed.kind {
        Kind::Flipper(flipper) => Some((part, flipper)),
        _ => None,
    });
    let flippers: Vec<(usize, &Flipper)> = flippers.collect();
    let of = |control: FlipperControl| flippers.iter().filter(move |(_, flipper)| flipper.control == control);
    let pairs = of(FlipperControl::Left).flat_map(|left| of(FlipperControl::Right).map(move |right| (*left, *right)));
    pairs.filter_map(|(left, right)| told(table, left, right)).collect()
}

fn told(
    table: &Table,
    (left_part, left): (usize, &Flipper),
    (right_part, right): (usize, &Flipper),
) -> Option<(usize, String, bool)> {
    let tips = [left, right].map(|flipper| super::tip(flipper, 0.0));
    // Each points to the other, and the tips are what is nearest.
    let faces = left.base.center.x < tips[0].x && tips[1].x < right.base.center.x;
    let between =
        left.base.center.x < right.base.center.x && tips[0].distance(tips[1]) < left.length_m.min(right.length_m);
    let gap_m = -depth([left, right], [0.0; 2], DISCS).max(depth([right, left], [0.0; 2], DISCS));
    if !faces || !between || !(0.0..2.0 * BALL_RADIUS_M).contains(&gap_m) {
        return None;
    }
    let (later, earlier) = (left_part.max(right_part), left_part.min(right_part));
    let what = format!(
        "between its tip at rest and that of {} are {:.1} mm: no ball falls through, for it is 27 mm wide; draw them farther \
         apart",
        called(table, earlier),
        gap_m * 1000.0
    );
    Some((later, what, true))
}
