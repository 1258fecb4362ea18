//! `caustic check`: every mistake in a table, or a line that says it is good.

use super::print::print;
use crate::cli::CheckArgs;
use crate::storage::tables;
use crate::table::LampKind;
use crate::{Buttons, Failure, Simulation, Table};
use std::sync::Arc;

/// Checks the drawing, the numbers, the art and the rules, these with a first ball.
///
/// # Errors
/// Every mistake, one line each.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let table = tables::load(&args.table).map_err(|mistakes| all(&mistakes))?;
    let table = Arc::new(table);
    let complaints = first_ball(Simulation::new(table.clone(), 0)?);
    if !complaints.is_empty() {
        return Err(all(&complaints));
    }
    print(&summary(&args.table, &table))
}

/// Starts a game, shoots its first ball and moves the flippers, without an eye on it; what the rules complain about.
fn first_ball(mut simulation: Simulation) -> Vec<String> {
    let flippers = [Buttons::LEFT, Buttons::NONE, Buttons::RIGHT, Buttons::NONE];
    let flips = flippers.iter().cycle().take(20).map(|buttons| (*buttons, 250));
    let shot = [(Buttons::START, 100), (Buttons::NONE, 2000), (Buttons::PLUNGER, 1200)];
    for (buttons, ticks) in shot.into_iter().chain(flips) {
        (0..ticks).for_each(|_| simulation.tick(buttons));
    }
    simulation.complaints()
}

/// One sentence a line.
fn all(mistakes: &[impl ToString]) -> Failure {
    let lines: Vec<String> = mistakes.iter().map(ToString::to_string).collect();
    match lines.as_slice() {
        [line] => Failure::new(line),
        lines => Failure::new(format!("the table has {} mistakes\n{}", lines.len(), lines.join("\n"))),
    }
}

fn summary(name: &str, table: &Table) -> String {
    let bulbs = table.lamps.iter().filter(|lamp| matches!(lamp.kind, LampKind::Bulb { .. })).count();
    format!(
        "ok {name} title={:?} size_mm={}x{} parts={} lamps={bulbs} inserts={} solids={} hash={:016x}",
        table.title,
        table.size_mm.x,
        table.size_mm.y,
        table.layout.parts.len(),
        table.lamps.len() - bulbs,
        table.solids.len(),
        table.hash
    )
}
