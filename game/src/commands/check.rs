//! `caustic check`: every mistake in a table, or a line that says it is good.

use super::print::print;
use crate::art::{self, PrintCost};
use crate::cli::CheckArgs;
use crate::storage::tables;
use crate::table::{FILES, LampKind};
use crate::{Buttons, Failure, Simulation, Table};
use std::sync::Arc;
use tracer::View;

/// The picture that the art is printed on to see whether it can be, pixels.
const PICTURE: (usize, usize) = (540, 1080);

/// Checks the drawing, the numbers, the art and the rules, these with a first ball.
///
/// # Errors
/// Every mistake, one line each.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let table = tables::load(&args.table).map_err(all)?;
    let table = Arc::new(table);
    let complaints = first_ball(Simulation::new(table.clone(), 0)?);
    if !complaints.is_empty() {
        return Err(all(complaints.into_iter().map(Failure::new).collect()));
    }
    let cost = print_once(&table)?;
    print(&summary(&args.table, &table, &cost))
}

/// Prints the art on a small picture; what it costs.
fn print_once(table: &Table) -> Result<PrintCost, Failure> {
    let view = View::fit(PICTURE.0, PICTURE.1, table.size_mm);
    let printed = art::check(table).and_then(|cost| art::floor(table, &view).map(|_| cost));
    printed.map_err(|failure| failure.in_file(table.file(FILES[0])))
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
fn all(mut mistakes: Vec<Failure>) -> Failure {
    if mistakes.len() != 1 {
        mistakes.insert(0, Failure::new(format!("the table has {} mistakes", mistakes.len())));
    }
    Failure::of_many(mistakes)
}

fn summary(name: &str, table: &Table, cost: &PrintCost) -> String {
    let bulbs = table.lamps.iter().filter(|lamp| matches!(lamp.kind, LampKind::Bulb { .. })).count();
    format!(
        "ok {name} title={:?} size_mm={}x{} parts={} lamps={bulbs} inserts={} solids={} print_mops={:.0} hash={:016x}",
        table.title,
        table.size_mm.x,
        table.size_mm.y,
        table.layout.parts.len(),
        table.lamps.len() - bulbs,
        table.solids.len(),
        (cost.operations * 1e-6).ceil(),
        table.hash
    )
}
