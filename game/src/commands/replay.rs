//! `caustic replay`: a recording in a window.

use super::parallel;
use crate::Failure;
use crate::cli::ReplayArgs;
use crate::desktop::{self, Look};
use crate::recording::Replay;

/// Shows a recording until the window is closed.
///
/// # Errors
/// If the recording cannot be played again, or there is no display.
pub fn run(args: &ReplayArgs) -> Result<(), Failure> {
    let replay = Replay::open(&args.file)?;
    let look = Look { size: args.size, fullscreen: args.fullscreen, light: args.light, zoom: args.zoom };
    desktop::watch(replay, look, parallel::pool(args.threads)?)
}
