//! `caustic verify`: plays recordings again without a screen and compares every stored hash.

use super::parallel::{pool, progress_bar};
use super::print::print;
use crate::Failure;
use crate::cli::VerifyArgs;
use crate::recording::{self, Replay};
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::path::Path;

/// Ticks between two steps of the progress bar.
const PROGRESS_TICKS: u64 = 1000;

/// Verifies every file, and prints one line for each that is good, in their order.
///
/// # Errors
/// If any of them fails: a sentence for each.
pub fn run(args: &VerifyArgs) -> Result<(), Failure> {
    let bar = progress_bar(0, "ticks");
    let lines: Vec<Result<String, Failure>> = pool(args.threads)?
        .install(|| args.files.par_iter().map(|file| verify(file, args.restore_every, &bar)).collect());
    bar.finish_and_clear();
    let mut failures = Vec::new();
    for line in lines {
        match line {
            Ok(line) => print(&line)?,
            Err(failure) => failures.push(failure),
        }
    }
    match failures.as_slice() {
        [] => Ok(()),
        [failure] => Err(failure.clone()),
        many => {
            let count = Failure::new(format!("{} of {} recordings failed", many.len(), args.files.len()));
            Err(Failure::of_many([vec![count], failures].concat()))
        }
    }
}

/// Plays one file again; the line that says that it is what was recorded.
fn verify(path: &Path, restore_every: Option<u64>, bar: &ProgressBar) -> Result<String, Failure> {
    let mut replay = Replay::open(path)?;
    bar.inc_length(replay.recording().ticks());
    while replay.step() {
        if let Some(difference) = replay.difference() {
            return Err(Failure::new(difference.to_string()).in_file(path));
        }
        let tick = replay.tick();
        if restore_every.is_some_and(|every| tick.is_multiple_of(every)) {
            replay.save_and_restore().map_err(|failure| failure.in_file(path))?;
        }
        if tick.is_multiple_of(PROGRESS_TICKS) {
            bar.inc(PROGRESS_TICKS);
        }
    }
    let (ticks, hash) = (replay.tick(), replay.simulation().hash());
    let score = recording::best_score(replay.simulation());
    let word = if replay.recording().end.is_some() { "ok" } else { "unfinished" };
    Ok(format!("{word} {} ticks={ticks} score={score} hash={hash:016x}", path.display()))
}
