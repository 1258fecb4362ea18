//! `caustic check`: every mistake in a table, and what play shows of it; or a line that says it is good.

mod consequences;
mod messages;
mod report;
mod trial;

use super::parallel::pool;
use super::print::{print, print_lines};
use crate::art::{self, PrintCost};
use crate::cli::CheckArgs;
use crate::rules::Review;
use crate::storage::tables;
use crate::table::FILES;
use crate::{Buttons, Failure, Simulation, Table, tell};
use report::{Report, counted};
use std::collections::BTreeSet;
use std::sync::Arc;
use tracer::View;

/// The picture that the art is printed on to see whether it can be, pixels.
const PICTURE: (usize, usize) = (540, 1080);

/// Checks the drawing, the numbers, the art and the rules, and plays the table.
///
/// # Errors
/// Every mistake, one line each.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let report = inspect(args)?;
    let failed = report.errors() > 0;
    if args.json {
        print_lines(report.json().lines())?;
        return if failed { Err(Failure::new(report.counts())) } else { Ok(()) };
    }
    if failed {
        return Err(counted(report.found));
    }
    if !report.found.is_empty() {
        tell(&counted(report.found.clone()));
    }
    print(&report.summary())
}

/// Looks at everything, as far as what was found lets it.
fn inspect(args: &CheckArgs) -> Result<Report, Failure> {
    let mut report = Report::new(&args.table);
    let table = match tables::load(&args.table) {
        Ok(table) => Arc::new(table),
        Err(mistakes) => {
            report.found = mistakes;
            return Ok(report);
        }
    };
    report.table = Some(table.clone());
    report.found.extend(table.warnings.iter().cloned());
    report.found.extend(table.overlaps());
    let review = Review::of(&table);
    let review_messages = review.messages.clone();
    report.found.extend(messages::warnings(&review_messages, &table));
    let complaints = match Simulation::new(table.clone(), 0) {
        Ok(simulation) => first_ball(simulation).into_iter().map(Failure::new).collect(),
        Err(failure) => failure.into_each().collect(),
    };
    report.found.extend(untold(complaints, &review));
    // What the rules have complained about is told once.
    let more = review.findings.into_iter().filter(|finding| !report.found.contains(finding)).collect::<Vec<_>>();
    report.found.extend(more);
    match print_once(&table) {
        Ok(cost) => {
            report.print_mops = Some((cost.operations * 1e-6).ceil());
            report.found.extend(art::letters_warning(&table));
        }
        Err(failure) => report.found.push(failure),
    }
    if report.errors() == 0 && !args.quick {
        let trial = pool(args.threads)?.install(|| trial::play(&table))?;
        let more = trial.findings.into_iter().filter(|finding| !report.found.contains(finding)).collect::<Vec<_>>();
        report.found.extend(more);
        let shown = messages::shown(&trial.messages, &review_messages, &table);
        report.found.extend(shown.into_iter().filter(|one| !report.found.contains(one)).collect::<Vec<_>>());
        report.play = Some((trial.places, trial.bot_score));
    }
    report.found = consequences::once(report.found);
    Ok(report)
}

/// The complaints that are not about a line whose mistake the review has told already, nor say the same of a line that uses a
/// name of another.
fn untold(complaints: Vec<Failure>, review: &Review) -> impl Iterator<Item = Failure> {
    let parts = |failure: &Failure| {
        let sentence = failure.sentences().next()?;
        sentence.split_once(": ").map(|(place, what)| [place.to_string(), what.to_string()])
    };
    let errors = review.findings.iter().filter(|finding| !finding.is_warning());
    let told: BTreeSet<String> = errors.filter_map(parts).flatten().collect();
    complaints
        .into_iter()
        .filter(move |complaint| parts(complaint).is_none_or(|parts| parts.iter().all(|part| !told.contains(part))))
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
