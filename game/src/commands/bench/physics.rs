//! Whether anything gets through anything, and what a tick costs: shots from everywhere at everything on the table.

use super::Row;
use super::clock::{quantile, time_ms};
use super::friction_cone::FrictionCone;
use super::shots::{Aim, Tally, shoot_all};
use crate::bot::BotRng;
use crate::commands::parallel;
use crate::storage::tables;
use crate::{Failure, Table};
use geometry::DVec2;
use physics::{Command, Controls, Machine};
use std::sync::Arc;

/// Of these many shots one is at a flipper that moves.
const FLIPPERS_PART: u64 = 10;
/// Deeper than this a ball is inside of something.
const MOST_DEPTH_UM: f64 = 50.0;
/// The balls of a crowded table, and how long they are played, ticks.
const CROWD: usize = 6;
const CROWDED: usize = 20_000;

/// Shoots `shots` balls at *Spectrum* and plays six at once.
///
/// # Errors
/// If the table cannot be read, a ball came through something, or an impact rubbed harder than its friction allows.
pub fn rows(shots: u64, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let table = tables::load("spectrum").map_err(Failure::of_many)?;
    let fresh = live(&table)?;
    let pool = parallel::pool(threads)?;
    let flips = shots / FLIPPERS_PART;
    let mut rows = Vec::new();
    let mut cone = FrictionCone::default();
    let mut shooting_ms = 0.0;
    for (name, count, aim) in
        [("shots at everything", shots, Aim::Everything), ("shots at moving flippers", flips, Aim::Flippers)]
    {
        let bar = parallel::progress_bar(count, "shots");
        let mut tally = Tally::default();
        let ms = time_ms(|| tally = pool.install(|| shoot_all(&fresh, count, aim, &bar)));
        bar.finish_and_clear();
        let depth_um = (tally.deepest_m * 1e6).max(0.0);
        rows.push(Row {
            bench: "physics",
            variant: format!("{} {name}, {} through, {depth_um:.2} um deep", tally.shots, tally.escapes),
            threads: pool.current_num_threads(),
            ms: ms / tally.shots.max(1) as f64,
            ..Row::default()
        });
        if tally.escapes > 0 || depth_um > MOST_DEPTH_UM {
            let (shots, through) = (tally.shots, tally.escapes);
            return Err(Failure::new(format!("of {shots} {name} {through} came through, up to {depth_um} um")));
        }
        cone = cone.and(tally.cone);
        shooting_ms += ms;
    }
    rows.push(Row {
        bench: "physics",
        variant: format!("{} impacts inside the friction cone, {} outside", cone.impacts - cone.outside, cone.outside),
        threads: pool.current_num_threads(),
        ms: shooting_ms / cone.impacts.max(1) as f64,
        ..Row::default()
    });
    if cone.outside > 0 {
        return Err(Failure::new(format!("{} of {} impacts rubbed too hard", cone.outside, cone.impacts)));
    }
    rows.push(crowd(&fresh));
    rows.extend(super::heap::rows()?);
    Ok(rows)
}

fn live(table: &Table) -> Result<Machine, Failure> {
    let refused = |error| Failure::new(format!("the physics refuses this table: {error:?}"));
    let mut machine = Machine::new(Arc::new(table.layout.clone())).map_err(refused)?;
    machine.tick(Controls::NONE, &[Command::SetFlippers(true), Command::SetCoils(true)]);
    Ok(machine)
}

/// Six balls at once, kept in play, with flippers that never rest: what the slowest of a hundred ticks takes.
fn crowd(fresh: &Machine) -> Row {
    let mut machine = fresh.clone();
    let rng = &mut BotRng::new(6);
    let mut ticks_ms = Vec::with_capacity(CROWDED);
    for tick in 0..CROWDED {
        while machine.pose().balls.len() < CROWD {
            let place = DVec2::new(between(rng, 0.08, 0.38), between(rng, 0.5, 0.7));
            let mut fuller = machine.clone();
            fuller.put_ball(place, DVec2::new(between(rng, -2.0, 2.0), -1.0), [0.0; 3]);
            // A ball in a wall or in another ball would be none that there can be.
            if fuller.penetration_m() < 0.0 {
                machine = fuller;
            }
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
fn between(rng: &mut BotRng, low: f64, high: f64) -> f64 {
    low + (high - low) * rng.unit()
}
