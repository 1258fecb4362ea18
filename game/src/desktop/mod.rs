//! The window: keys in, pictures out.
//!
//! The main thread owns the window. It takes each key as it comes, plays the ticks that are due by then, and only then
//! lets the key count: an input is stamped to the millisecond in which it arrives, whatever the picture is doing. A
//! second thread (the painter) makes pictures from snapshots that nobody changes, with a pool of threads that trace
//! light, and the main thread presents them as they are finished. Nothing else in the project names winit or softbuffer.

mod app;
mod icon;
mod opening;
mod painter;
mod screenshot;
mod surface;
mod table_reload;

use crate::cli::LightChoice;
use crate::frame_composer::Picture;
use crate::recording::Replay;
use crate::screen::Size;
use crate::session::{Game, Session, Viewing};
use crate::{Failure, Table};
use app::App;
use std::path::PathBuf;
use std::sync::Arc;
use winit::event_loop::EventLoop;

/// What a window is opened with.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Its size in pixels; by default most of the monitor's height.
    pub size: Option<Size>,
    /// Whether it fills the screen.
    pub fullscreen: bool,
    /// At which resolution light is found.
    pub light: LightChoice,
    /// How much larger than the window the table is drawn, 1 to 4.
    pub zoom: f64,
}

/// Who plays what, and what is written down of it.
#[derive(Clone, Debug)]
pub struct Play {
    /// The table.
    pub table: Arc<Table>,
    /// Seed of the game's random numbers.
    pub seed: u64,
    /// A file to record to, besides the player's own folder.
    pub record: Option<PathBuf>,
    /// The bot plays.
    pub bot: bool,
}

/// What tells the main thread that another thread has something for it.
#[derive(Clone, Copy, Debug)]
struct Wake;

/// Opens a window and plays in it until it is closed.
///
/// # Errors
/// If there is no display, or the game cannot be started.
pub fn play(play: &Play, look: Look, pool: rayon::ThreadPool) -> Result<(), Failure> {
    let events = open_display()?;
    let picture = Picture::new(play.table.clone(), pool)?;
    let game = Game::new(play.table.clone(), play.seed, play.record.as_deref(), play.bot)?;
    run(events, Session::Game(Box::new(game)), picture, look)
}

/// Opens a window and shows a recording in it until it is closed.
///
/// # Errors
/// If there is no display.
pub fn watch(replay: Replay, look: Look, pool: rayon::ThreadPool) -> Result<(), Failure> {
    let events = open_display()?;
    let viewing = Viewing::new(replay);
    let picture = Picture::new(viewing.table().clone(), pool)?;
    run(events, Session::Viewing(Box::new(viewing)), picture, look)
}

fn open_display() -> Result<EventLoop<Wake>, Failure> {
    EventLoop::with_user_event().build().map_err(|error| {
        Failure::new(format!(
            "there is no display to open a window on ({}); caustic frame, caustic dump and caustic simulate work without one",
            reason(&error.to_string())
        ))
    })
}

fn run(events: EventLoop<Wake>, session: Session, picture: Picture, look: Look) -> Result<(), Failure> {
    let mut app = App::new(session, picture, look, events.create_proxy());
    let ended = events.run_app(&mut app);
    app.finish()?;
    ended.map_err(|error| Failure::new(format!("the window failed: {}", reason(&error.to_string()))))
}

/// The reason that winit gives, without the place in its own source that comes before it.
fn reason(error: &str) -> &str {
    let line = error.lines().next().unwrap_or_default();
    let told = if line.contains(".rs:") { line.rsplit(": ").next().unwrap_or(line) } else { line };
    told.trim_end_matches('.')
}

#[cfg(test)]
mod tests {
    use super::reason;

    #[test]
    fn the_reason_is_told_without_the_place_in_a_source_file() {
        let error = "os error at /home/a/winit/mod.rs:765: neither WAYLAND_DISPLAY nor DISPLAY is set.";
        assert_eq!(reason(error), "neither WAYLAND_DISPLAY nor DISPLAY is set");
        assert_eq!(reason("the display hung up\nand more"), "the display hung up");
    }
}
