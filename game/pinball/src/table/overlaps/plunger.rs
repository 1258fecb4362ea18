//! The plunger's face: what stands still beside it and reaches into it, so that the face is wider than its lane.

use super::called;
use crate::table::Table;
use geometry::DVec2;
use physics::{Kind, Plunger};

/// A face may reach so far into the lane's walls: drawings are round, m.
const ROUNDED_M: f64 = 2e-3;
/// Places on the face that are looked at, from its middle to each end.
const PLACES: usize = 32;

/// The plungers whose face reaches into a wall, each with what to say and that it is a warning.
pub fn findings(table: &Table) -> Vec<(usize, String, bool)> {
    let parts = table.layout.parts.iter().enumerate();
    let plungers = parts.filter_map(|(part, placed)| match &placed.kind {
        Kind::Plunger(plunger) => Some((part, plunger)),
        _ => None,
    });
    let told = |(part, plunger): (usize, &Plunger)| {
        let (other, room_m) = lane(table, plunger)?;
        let [width_mm, free_mm] = [plunger.half_width_m, room_m].map(|half_m| 2000.0 * half_m);
        let what = format!(
            "its face is {width_mm:.1} mm wide and reaches into {}; a stroke-width of {free_mm:.0} fits its lane",
            called(table, other)
        );
        Some((part, what, true))
    };
    plungers.filter_map(told).collect()
}

/// The wall that the face reaches into, and half of the width that the lane has there, if that is less than the face's.
fn lane(table: &Table, plunger: &Plunger) -> Option<(usize, f64)> {
    let walls = table.layout.parts.iter().enumerate().flat_map(|(part, placed)| {
        let shapes = if let Kind::Wall(wall) = &placed.kind { wall.shapes.as_slice() } else { &[] };
        shapes.iter().map(move |shape| (part, shape))
    });
    let walls: Vec<_> = walls.filter(|(_, shape)| shape.distance(plunger.tip).0 < plunger.half_width_m).collect();
    let aside = plunger.direction.perp();
    let away = |place: usize| plunger.half_width_m * place as f64 / PLACES as f64;
    let places =
        (0..=PLACES).flat_map(|place| [1.0, -1.0].map(|side| (away(place), plunger.tip + aside * side * away(place))));
    let blocked = |place: DVec2| walls.iter().find(|(_, shape)| shape.distance(place).0 < 0.0).map(|(part, _)| *part);
    let (part, room_m) = places.into_iter().find_map(|(away, place)| Some((blocked(place)?, away)))?;
    (room_m < plunger.half_width_m - ROUNDED_M && room_m > 0.0).then_some((part, room_m))
}
