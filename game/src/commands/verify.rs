//! `caustic verify`: plays recordings again without a screen and compares every stored hash.

use super::parallel::{pool, progress_bar};
use crate::Failure;
use crate::cli::VerifyArgs;
use crate::recording::{self, Recording, Replay};
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::path::Path;

/// Ticks between two steps of the progress bar.
const PROGRESS_TICKS: u64 = 1000;

/// Verifies every file, and prints one line for each, in their order.
///
/// # Errors
/// If any of them fails: how many.
pub fn run(args: &VerifyArgs) -> Result<(), Failure> {
    let bar = progress_bar(0, "ticks");
    let lines: Vec<Result<String, Failure>> = pool(args.threads)?
        .install(|| args.files.par_iter().map(|file| verify(file, args.restore_every, &bar)).collect());
    bar.finish_and_clear();
    for line in &lines {
        match line {
            Ok(line) => println!("{line}"),
            Err(failure) => println!("FAILED {failure}"),
        }
    }
    match lines.iter().filter(|line| line.is_err()).count() {
        0 => Ok(()),
        failed => Err(Failure::new(format!("{failed} of {} recordings failed", lines.len()))),
    }
}

/// Plays one file again; the line that says that it is what was recorded.
fn verify(path: &Path, restore_every: Option<u64>, bar: &ProgressBar) -> Result<String, Failure> {
    let named = |failure: Failure| Failure::new(format!("{}: {failure}", path.display()));
    let recording = Recording::read(path)?;
    bar.inc_length(recording.ticks());
    let mut replay = Replay::new(recording).map_err(named)?;
    while replay.step() {
        if let Some(difference) = replay.difference() {
            return Err(named(Failure::new(difference.to_string())));
        }
        let tick = replay.tick();
        if restore_every.is_some_and(|every| tick.is_multiple_of(every)) {
            replay.save_and_restore().map_err(named)?;
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
