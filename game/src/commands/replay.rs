//! `caustic replay`: a recording in a window.

use super::parallel;
use crate::Failure;
use crate::cli::ReplayArgs;
use crate::game_app::{self, DisplayOptions};
use crate::storage::recordings;

/// Shows a recording until the window is closed.
///
/// # Errors
/// If the recording cannot be played again, or there is no display.
pub fn run(args: &ReplayArgs) -> Result<(), Failure> {
    let recording = recordings::open_to_show(&args.file)?;
    let options = DisplayOptions {
        size: args.size,
        fullscreen: args.fullscreen,
        light: args.light.resolution(),
        zoom: args.zoom,
    };
    game_app::watch(recording, options, parallel::pool(args.threads)?)
}
