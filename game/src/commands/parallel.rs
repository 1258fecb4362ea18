//! What commands that work through many games share: threads and a progress bar.

use crate::Failure;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A pool of `threads` threads; by default one for each core.
///
/// # Errors
/// If the system gives no thread.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build()
        .map_err(|error| Failure::new(format!("cannot start threads: {error}; ask for fewer with --threads")))
}

/// A bar of `length` steps on standard error; none is drawn when that is not a terminal.
pub fn progress_bar(length: u64, unit: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr());
    let template = format!("[{{bar:40}}] {{pos}}/{{len}} {unit}, {{eta}} left");
    let style = ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar());
    bar.with_style(style.progress_chars("=> "))
}
