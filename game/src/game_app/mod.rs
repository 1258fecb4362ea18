//! The game as an application of the desktop's shell: what each key does, what a frame shows, when a table is read
//! again.

mod app;
mod frame_statistics;
mod keys;
mod painter;
mod table_reload;
#[cfg(test)]
mod tests;

use crate::desktop::{Display, WindowOptions};
use crate::frame_composer::{FrameComposer, LightResolution};
use crate::screen::Size;
use crate::session::{LiveGame, ReplaySession, Session};
use crate::storage::recordings::ShownRecording;
use crate::{Failure, Table};
use app::GameApp;
use std::path::PathBuf;
use std::sync::Arc;

/// What the game's window is opened with.
#[derive(Clone, Copy, Debug)]
pub struct DisplayOptions {
    /// Its size in pixels; by default most of the monitor's height.
    pub size: Option<Size>,
    /// Whether it fills the screen.
    pub fullscreen: bool,
    /// At which resolution light is found; by default at the highest that holds the monitor's rate.
    pub light: Option<LightResolution>,
    /// How much larger than the window the table is drawn, 1 to 4.
    pub zoom: f64,
}

/// Who plays what, and what is written down of it.
#[derive(Clone, Debug)]
pub struct GameOptions {
    /// The table.
    pub table: Arc<Table>,
    /// Seed of the game's random numbers.
    pub seed: u64,
    /// A file to record to, besides the player's own folder.
    pub record: Option<PathBuf>,
    /// The bot plays.
    pub bot: bool,
}

/// Opens a window and plays in it until it is closed.
///
/// # Errors
/// If there is no display, or the game cannot be started.
pub fn play(game: &GameOptions, options: DisplayOptions, pool: rayon::ThreadPool) -> Result<(), Failure> {
    let display = Display::open()?;
    let composer = FrameComposer::new(game.table.clone(), pool)?;
    let live = LiveGame::new(game.table.clone(), game.seed, game.record.as_deref(), game.bot)?;
    run(display, Session::Live(Box::new(live)), composer, options)
}

/// Opens a window and shows a recording in it until it is closed.
///
/// # Errors
/// If there is no display.
pub fn watch(recording: ShownRecording, options: DisplayOptions, pool: rayon::ThreadPool) -> Result<(), Failure> {
    let display = Display::open()?;
    let session = ReplaySession::new(recording);
    let composer = FrameComposer::new(session.table().clone(), pool)?;
    run(display, Session::Replay(Box::new(session)), composer, options)
}

fn run(display: Display, session: Session, composer: FrameComposer, options: DisplayOptions) -> Result<(), Failure> {
    let title = session.title(&composer.table().title);
    let window = WindowOptions { title, size: options.size, fullscreen: options.fullscreen };
    let mut app = GameApp::new(session, options, composer.table().origin.as_ref());
    let shown = display.run(&mut app, window, painter::painter(composer));
    let recorded = app.finish();
    shown.and(recorded)
}
