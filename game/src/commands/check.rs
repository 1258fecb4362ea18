//! `caustic check`: every mistake in a table, or a line that says it is good.

use super::print::print;
use crate::cli::CheckArgs;
use crate::storage::tables;
use crate::table::LampKind;
use crate::{Failure, Simulation, Table, tell};
use std::sync::Arc;

/// Checks the drawing, the numbers, the art and the rules.
///
/// # Errors
/// Every mistake, one line each.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let table = tables::load(&args.table).map_err(|mistakes| all(&mistakes))?;
    let table = Arc::new(table);
    let mut simulation = Simulation::new(table.clone(), 0)?;
    let complaints = simulation.complaints();
    if !complaints.is_empty() {
        return Err(all(&complaints.into_iter().map(Failure::new).collect::<Vec<_>>()));
    }
    table.warnings.iter().for_each(tell);
    print(&summary(&args.table, &table))
}

/// One sentence a line, below how many there are.
fn all(failures: &[Failure]) -> Failure {
    let lines: Vec<String> = failures.iter().map(ToString::to_string).collect();
    let warnings = failures.iter().filter(|failure| failure.is_warning()).count();
    let counted = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let mistakes = counted(failures.len() - warnings, "mistake");
    let head = match (failures.len(), warnings) {
        (1, _) => return Failure::new(lines.concat()),
        (_, 0) => mistakes,
        _ => format!("{mistakes} and {}", counted(warnings, "warning")),
    };
    Failure::new(format!("the table has {head}\n{}", lines.join("\n")))
}

fn summary(name: &str, table: &Table) -> String {
    let bulbs = table.lamps.iter().filter(|lamp| matches!(lamp.kind, LampKind::Bulb { .. })).count();
    format!(
        "ok {name} title={:?} size_mm={}x{} parts={} lamps={bulbs} inserts={} solids={} warnings={} hash={:016x}",
        table.title,
        hundredths(table.size_mm.x),
        hundredths(table.size_mm.y),
        table.layout.parts.len(),
        table.lamps.len() - bulbs,
        table.solids.len(),
        table.warnings.len(),
        table.hash
    )
}

/// A length to a hundredth of a millimetre.
fn hundredths(mm: f64) -> f64 {
    (mm * 100.0).round() / 100.0
}
