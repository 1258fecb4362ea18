//! Whether anything gets through anything, and what a tick costs: shots from everywhere at everything on the table.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::bot::Chance;
use crate::commands::parallel;
use crate::{Failure, Table};
use geometry::DVec2;
use physics::{Command, Controls, Flipper, Kind, Layout, Machine, Trigger};
use rayon::prelude::*;
use std::sync::Arc;

/// Shots that one seed gives, so that the result is the same on any number of threads.
const LOT: u64 = 500;
/// Of these many shots one is at a flipper that moves.
const FLIPPERS_PART: u64 = 10;
/// How long a shot is followed, ticks.
const FOLLOWED: usize = 60;
/// The balls of a crowded table, and how long they are played, ticks.
const CROWD: usize = 6;
const CROWDED: usize = 20_000;

/// What shots came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Tally {
    shots: u64,
    escapes: usize,
    deepest_m: f64,
}

impl Tally {
    fn and(self, other: Tally) -> Tally {
        Tally {
            shots: self.shots + other.shots,
            escapes: self.escapes + other.escapes,
            deepest_m: self.deepest_m.max(other.deepest_m),
        }
    }
}

/// Shoots `shots` balls at *Spectrum* and plays six at once.
///
/// # Errors
/// If the table cannot be read, or a ball came through something.
pub fn rows(shots: u64, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let table = Table::load("spectrum").map_err(Failure::of_many)?;
    let fresh = live(&table)?;
    let pool = parallel::pool(threads)?;
    let flips = shots / FLIPPERS_PART;
    let mut rows = Vec::new();
    for (name, count, at_flippers) in [("shots at everything", shots, false), ("shots at moving flippers", flips, true)]
    {
        let mut tally = Tally::default();
        let ms = time_ms(|| tally = pool.install(|| shoot_all(&fresh, count, at_flippers)));
        let depth_um = (tally.deepest_m * 1e6).max(0.0);
        rows.push(Row {
            bench: "physics",
            variant: format!("{} {name}, {} through, {depth_um:.2} um deep", tally.shots, tally.escapes),
            threads: pool.current_num_threads(),
            ms: ms / tally.shots.max(1) as f64,
            ..Row::default()
        });
        if tally.escapes > 0 || depth_um > 50.0 {
            return Err(Failure::new(format!("of {count} {name} {} came through, up to {depth_um} um", tally.escapes)));
        }
    }
    rows.push(crowd(&fresh));
    Ok(rows)
}

fn live(table: &Table) -> Result<Machine, Failure> {
    let refused = |error| Failure::new(format!("the physics refuses this table: {error:?}"));
    let mut machine = Machine::new(Arc::new(table.layout.clone())).map_err(refused)?;
    machine.tick(Controls::NONE, &[Command::SetFlippers(true), Command::SetKickers(true)]);
    Ok(machine)
}

fn shoot_all(fresh: &Machine, count: u64, at_flippers: bool) -> Tally {
    let lots = (0..count.div_ceil(LOT)).into_par_iter();
    let lot = |lot: u64| {
        let mut chance = Chance::new(lot ^ (u64::from(at_flippers) << 40));
        let shots = LOT.min(count - lot * LOT);
        (0..shots).fold(Tally::default(), |tally, _| tally.and(shoot(fresh, &mut chance, at_flippers)))
    };
    lots.map(lot).reduce(Tally::default, Tally::and)
}

/// One ball from a free place at 0.05 to 15 m/s, while both flippers flip; no shot where the place is not free.
fn shoot(fresh: &Machine, chance: &mut Chance, at_flippers: bool) -> Tally {
    let mut tally = Tally { shots: 1, ..Tally::default() };
    let mut machine = fresh.clone();
    let (period, press) = (between(chance, 30.0, 90.0) as usize, between(chance, 2.0, 45.0) as usize);
    let hands = |tick: usize| Controls { left: tick % period < press, right: tick % period < press, ..Controls::NONE };
    let phase = if at_flippers { between(chance, 0.0, period as f64) as usize } else { 0 };
    (0..phase).for_each(|tick| machine.tick(hands(tick), &[]));
    let start = if at_flippers { near_flipper(machine.layout(), chance) } else { wander(fresh, chance) };
    let way = geometry::trig::direction(between(chance, 0.0, std::f64::consts::TAU));
    let speed = 0.05 * libm::pow(300.0, chance.unit());
    let spin = [0.0; 3].map(|_: f64| between(chance, -200.0, 200.0));
    machine.put_ball(start, way * speed, spin);
    if machine.overlap_m() > 0.0 {
        return Tally::default();
    }
    for tick in phase..phase + FOLLOWED {
        machine.tick(hands(tick), &[]);
        tally.escapes = tally.escapes.max(machine.escaped());
        tally.deepest_m = tally.deepest_m.max(machine.overlap_m());
    }
    tally
}

/// Where a ball comes to that is thrown into play and left to itself for a while: never where no ball can be.
fn wander(fresh: &Machine, chance: &mut Chance) -> DVec2 {
    let mut machine = fresh.clone();
    let way = geometry::trig::direction(between(chance, 0.0, std::f64::consts::TAU));
    let start = middle(machine.layout());
    machine.put_ball(start, way * between(chance, 1.0, 5.0), [0.0; 3]);
    (0..between(chance, 0.0, 900.0) as usize).for_each(|_| machine.tick(Controls::NONE, &[]));
    machine.pose().balls.first().map_or(start, |ball| ball.center)
}

/// The flippers that buttons move.
fn flippers(layout: &Layout) -> impl Iterator<Item = &Flipper> + Clone {
    layout.parts.iter().filter_map(|part| match &part.kind {
        Kind::Flipper(flipper) if flipper.trigger != Trigger::Rules => Some(flipper),
        _ => None,
    })
}

/// The open field above the flippers.
fn middle(layout: &Layout) -> DVec2 {
    let count = flippers(layout).count().max(1) as f64;
    let pivots = flippers(layout).map(|flipper| flipper.base.center).sum::<DVec2>() / count;
    pivots - DVec2::new(0.0, 0.25 * layout.size_m.y)
}

/// A place within a few centimetres of a flipper, on the side that balls come from.
fn near_flipper(layout: &Layout, chance: &mut Chance) -> DVec2 {
    let which = (chance.unit() * flippers(layout).count() as f64) as usize;
    let Some(flipper) = flippers(layout).nth(which) else { return middle(layout) };
    let along = geometry::trig::direction(flipper.rest_rad) * (flipper.length_m * between(chance, 0.2, 1.1));
    flipper.base.center + along - DVec2::new(between(chance, -0.03, 0.03), between(chance, 0.02, 0.09))
}

/// Six balls at once, kept in play, with flippers that never rest: what the slowest of a hundred ticks takes.
fn crowd(fresh: &Machine) -> Row {
    let mut machine = fresh.clone();
    let chance = &mut Chance::new(6);
    let mut ticks_ms = Vec::with_capacity(CROWDED);
    for tick in 0..CROWDED {
        while machine.pose().balls.len() < CROWD {
            let place = DVec2::new(between(chance, 0.08, 0.38), between(chance, 0.3, 0.75));
            machine.put_ball(place, DVec2::new(between(chance, -2.0, 2.0), -1.0), [0.0; 3]);
        }
        let hands = Controls { left: tick % 170 < 60, right: tick % 230 < 90, ..Controls::NONE };
        ticks_ms.push(time_ms(|| machine.tick(hands, &[])));
    }
    let mean = ticks_ms.iter().sum::<f64>() / CROWDED as f64;
    Row {
        bench: "physics",
        variant: format!("a tick with {CROWD} balls, mean"),
        threads: 1,
        ms: mean,
        ms_99th: Some(quantile(&mut ticks_ms, 0.99)),
        times_real_time: Some(1.0 / mean),
        ..Row::default()
    }
}

/// Evenly in [`low`, `high`).
fn between(chance: &mut Chance, low: f64, high: f64) -> f64 {
    low + (high - low) * chance.unit()
}
