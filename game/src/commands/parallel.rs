//! Parallel runs: what commands that work through many games or frames share: threads, a progress bar, a folder for the
//! results and the line that compares them.

use crate::Failure;
use crate::simulation::Digest;
use crate::storage::folder_failure;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::ErrorKind;
use std::path::Path;

/// A pool of `threads` threads; by default one for each core.
///
/// # Errors
/// If the system gives no thread.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build()
        .map_err(|_| Failure::new("the system does not give that many threads; ask for fewer with --threads"))
}

/// A bar of `length` steps on standard error; none is drawn when that is not a terminal.
pub fn progress_bar(length: u64, unit: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr());
    let template = format!("[{{bar:40}}] {{pos}}/{{len}} {unit}, {{eta}} left");
    let style = ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar());
    bar.with_style(style.progress_chars("=> "))
}

/// The line that says what all ticks of these games, each with its seed, come to. The order in which they are given does
/// not matter.
pub fn digest_line(games: &[(u64, Digest)]) -> String {
    let all = Digest::of_seeds(games);
    format!("digest     {all} of {} ticks, games {}", all.ticks(), games.len())
}

/// Makes the folder `dir`, and those that it is in; nothing if it is there.
///
/// # Errors
/// If it cannot be made.
pub fn make_folder(dir: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(dir).map_err(|error| match error.kind() {
        ErrorKind::NotFound => Failure::new(format!("cannot make the folder {}: the system refuses it", dir.display())),
        _ => folder_failure(dir, &error),
    })
}
