//! `caustic replay`: a recording in a window.

use super::parallel;
use crate::Failure;
use crate::cli::ReplayArgs;
use crate::recording::Replay;
use crate::window::{self, Look};

/// Shows a recording until the window is closed.
///
/// # Errors
/// If the recording cannot be played again, or there is no display.
pub fn run(args: &ReplayArgs) -> Result<(), Failure> {
    let replay = Replay::open(&args.file)?;
    window::watch(replay, Look { size: args.size, fullscreen: args.fullscreen }, parallel::pool(args.threads)?)
}
