//! Nothing on Spectrum holds a ball but what should: a ball that is let go anywhere comes away by itself.

use geometry::DVec2;
use physics::{Command, Controls, Machine};
use rayon::prelude::*;
use std::sync::Arc;

/// From one place to the next that a ball can roll to, m: less than any wall that it cannot get round.
const STEP_M: f64 = 0.004;
/// No place is to the last bit above the middle of a post: a ball lies even there.
const ASIDE_M: f64 = 3e-4;
/// A ball that has lain still for so long is stuck.
const STUCK_TICKS: u32 = 3000;
/// By then the slowest has drained or is held by what may hold it.
const MOST_TICKS: usize = 20_000;

/// Spectrum with its coils live, and no ball on it.
fn live() -> Machine {
    let table = game::storage::tables::load("spectrum").unwrap();
    let mut machine = Machine::new(Arc::new(table.layout.clone())).unwrap();
    machine.tick(Controls::NONE, &[Command::SetFlippers(true), Command::SetCoils(true)]);
    machine
}

fn with_ball(machine: &Machine, place: DVec2) -> Machine {
    let mut machine = machine.clone();
    machine.put_ball(place, DVec2::ZERO, [0.0; 3]);
    machine
}

/// The places of a grid over the playfield to which a ball can come from the middle of the table.
fn reachable(machine: &Machine) -> Vec<DVec2> {
    let size = machine.layout().size_m;
    let (columns, rows) = ((size.x / STEP_M) as usize, (size.y / STEP_M) as usize);
    let place = |at: usize| DVec2::new((at % columns) as f64 + 0.5, (at / columns) as f64 + 0.5) * STEP_M + ASIDE_M;
    let is_free = |at: usize| with_ball(machine, place(at)).penetration_m() < 0.0;
    let start = rows / 2 * columns + columns / 2;
    let (mut seen, mut found) = (vec![false; columns * rows], vec![start]);
    seen[start] = true;
    let mut next = 0;
    while next < found.len() {
        let at = found[next];
        next += 1;
        let (column, row) = (at % columns, at / columns);
        let beside = [
            (column > 0).then(|| at - 1),
            (column + 1 < columns).then(|| at + 1),
            (row > 0).then(|| at - columns),
            (row + 1 < rows).then(|| at + columns),
        ];
        for near in beside.into_iter().flatten() {
            if !std::mem::replace(&mut seen[near], true) && is_free(near) {
                found.push(near);
            }
        }
    }
    found.into_iter().map(place).collect()
}

/// Lets a ball go at every `stride`th place.
fn assert_none_holds_a_ball(stride: usize) {
    let machine = live();
    let places = reachable(&machine);
    let tried: Vec<DVec2> = places.iter().copied().step_by(stride).collect();
    assert!(tried.len() > 500, "a ball can come to {} places", places.len());
    let sticks = |&place: &DVec2| {
        let mut machine = with_ball(&machine, place);
        for _ in 0..MOST_TICKS {
            machine.tick(Controls::NONE, &[]);
            if machine.stuck_ticks().iter().any(|&ticks| ticks >= STUCK_TICKS) {
                return Some((place, machine.balls()[0].center));
            }
            if machine.balls().is_empty() {
                return None;
            }
        }
        None
    };
    let stuck: Vec<(DVec2, DVec2)> = tried.par_iter().filter_map(sticks).collect();
    println!("{} of {} places tried, {} of them hold a ball", tried.len(), places.len(), stuck.len());
    assert!(stuck.is_empty(), "let go at the first, it lies at the second: {stuck:?}");
}

#[test]
fn no_place_of_spectrum_holds_a_ball() {
    assert_none_holds_a_ball(19);
}

#[ignore = "a minute in release: .ci/large runs it"]
#[test]
fn none_of_sixteen_thousand_places_of_spectrum_holds_a_ball() {
    assert_none_holds_a_ball(1);
}
