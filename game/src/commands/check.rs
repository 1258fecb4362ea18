//! `caustic check`: every mistake in a table, or a line that says it is good.

use super::print::print;
use crate::art::{self, PrintCost};
use crate::cli::CheckArgs;
use crate::storage::tables;
use crate::table::{FILES, LampKind};
use crate::{Failure, Simulation, Table, tell};
use std::sync::Arc;
use tracer::View;

/// The picture that the art is printed on to see whether it can be, pixels.
const PICTURE: (usize, usize) = (540, 1080);

/// Checks the drawing, the numbers, the art and the rules.
///
/// # Errors
/// Every mistake, one line each.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let table = tables::load(&args.table).map_err(counted)?;
    let table = Arc::new(table);
    let mut simulation = Simulation::new(table.clone(), 0)?;
    let complaints = simulation.complaints();
    let found = table.warnings.iter().cloned().chain(complaints.iter().map(Failure::new)).collect();
    if !complaints.is_empty() {
        return Err(counted(found));
    }
    let cost = print_once(&table)?;
    if !found.is_empty() {
        tell(&counted(found));
    }
    print(&summary(&args.table, &table, &cost))
}

/// Prints the art on a small picture; what it costs.
fn print_once(table: &Table) -> Result<PrintCost, Failure> {
    let view = View::fit(PICTURE.0, PICTURE.1, table.size_mm);
    let printed = art::check(table).and_then(|cost| art::floor(table, &view).map(|_| cost));
    printed.map_err(|failure| failure.in_file(table.file(FILES[0])))
}

/// One sentence a line; below several stands how many there are.
fn counted(mut found: Vec<Failure>) -> Failure {
    let warnings = found.iter().filter(|failure| failure.is_warning()).count();
    let several = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let counts = [(found.len() - warnings, "error"), (warnings, "warning")];
    if found.len() > 1 {
        let counts: Vec<String> = counts.iter().filter(|one| one.0 > 0).map(|one| several(one.0, one.1)).collect();
        found.push(Failure::new(counts.join(", ")));
    }
    Failure::of_many(found)
}

fn summary(name: &str, table: &Table, cost: &PrintCost) -> String {
    let bulbs = table.lamps.iter().filter(|lamp| matches!(lamp.kind, LampKind::Bulb { .. })).count();
    format!(
        "ok {name} title={:?} size_mm={}x{} parts={} lamps={bulbs} inserts={} solids={} warnings={} print_mops={:.0} \
         hash={:016x}",
        table.title,
        hundredths(table.size_mm.x),
        hundredths(table.size_mm.y),
        table.layout.parts.len(),
        table.lamps.len() - bulbs,
        table.solids.len(),
        table.warnings.len(),
        (cost.operations * 1e-6).ceil(),
        table.hash
    )
}

/// A length to a hundredth of a millimetre.
fn hundredths(mm: f64) -> f64 {
    (mm * 100.0).round() / 100.0
}
