//! `caustic play`: a game in a window.

use super::parallel;
use crate::Failure;
use crate::cli::PlayArgs;
use crate::game_app::{self, DisplayOptions, GameOptions};
use crate::storage::tables;
use std::sync::Arc;
use std::time::SystemTime;

/// Plays until the window is closed.
///
/// # Errors
/// If the table cannot be read, the recording cannot be written, or there is no display.
pub fn run(args: PlayArgs) -> Result<(), Failure> {
    let table = Arc::new(tables::load(&args.table).map_err(Failure::of_many)?);
    let seed = args.seed.unwrap_or_else(seed_of_now);
    let game = GameOptions { table, seed, record: args.record, bot: args.bot };
    let options = DisplayOptions {
        size: args.size,
        fullscreen: args.fullscreen,
        light: args.light.resolution(),
        zoom: args.zoom,
    };
    game_app::play(&game, options, parallel::pool(args.threads)?)
}

#[expect(clippy::disallowed_methods, reason = "each game that names no seed is another one")]
fn seed_of_now() -> u64 {
    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(1, |since| since.as_nanos() as u64)
}
