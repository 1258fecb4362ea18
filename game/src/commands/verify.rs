//! `caustic verify`: plays recordings again without a screen and compares every stored hash.

use super::parallel::{digest_line, pool, progress_bar};
use super::print::print;
use crate::cli::VerifyArgs;
use crate::recording;
use crate::simulation::Digest;
use crate::storage::recordings;
use crate::{Failure, tell};
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::path::Path;

/// Ticks between two steps of the progress bar.
const PROGRESS_TICKS: u64 = 1000;

/// Verifies every file, and prints one line for each that is good, in their order. With `--salvage` the file is damaged,
/// and what is sound of it is written and verified in its place.
///
/// # Errors
/// If any of them fails: a sentence for each.
pub fn run(args: &VerifyArgs) -> Result<(), Failure> {
    let (Some(out), [file]) = (&args.salvage, args.files.as_slice()) else { return verify_all(args) };
    tell(&recordings::salvage(file, out)?);
    verify_all(&VerifyArgs { files: vec![out.clone()], ..args.clone() })
}

fn verify_all(args: &VerifyArgs) -> Result<(), Failure> {
    let bar = progress_bar(0, "ticks");
    let results: Vec<Result<Verified, Failure>> =
        pool(args.threads)?.install(|| args.files.par_iter().map(|file| verify(file, args, &bar)).collect());
    bar.finish_and_clear();
    let mut failures = Vec::new();
    let mut digests = Vec::new();
    for result in results {
        match result {
            Ok(verified) => {
                print(&verified.line)?;
                digests.extend(verified.digest.map(|digest| (verified.seed, digest)));
            }
            Err(failure) => failures.push(failure),
        }
    }
    if args.digest && failures.is_empty() {
        print(&digest_line(&digests))?;
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

/// What became of one file.
struct Verified {
    /// That it is what was recorded.
    line: String,
    seed: u64,
    /// Of every tick, if it is asked for.
    digest: Option<Digest>,
}

/// Plays one file again.
fn verify(path: &Path, args: &VerifyArgs, bar: &ProgressBar) -> Result<Verified, Failure> {
    let mut replay = recordings::open(path)?;
    let mut digest = args.digest.then(Digest::default);
    bar.inc_length(replay.recording().ticks());
    while replay.difference().is_none() && replay.step() {
        let tick = replay.tick();
        if args.restore_every.is_some_and(|every| tick.is_multiple_of(every)) {
            replay.save_and_restore().map_err(|failure| failure.in_file(path.display()))?;
        }
        if let Some(digest) = &mut digest {
            digest.add(replay.simulation().hash());
        }
        if tick.is_multiple_of(PROGRESS_TICKS) {
            bar.inc(PROGRESS_TICKS);
        }
    }
    if let Some(difference) = replay.difference() {
        return Err(Failure::new(difference.to_string()).in_file(path.display()));
    }
    let (ticks, hash) = (replay.tick(), replay.simulation().hash());
    let score = recording::best_score(replay.simulation());
    let word = if replay.recording().end.is_some() { "ok" } else { "unfinished" };
    let mut line = format!("{word} {} ticks={ticks} score={score} hash={hash:016x}", path.display());
    if let Some(digest) = digest {
        line += &format!(" digest={digest}");
    }
    Ok(Verified { line, seed: replay.recording().header.seed, digest })
}
