//! The desktop: a shell around an application, which opens a window, takes its events, and shows its frames.
//!
//! The main thread owns the window. It takes each key as it comes, lets the application come up to that moment, and
//! only then hands the key on: an input is stamped to the millisecond in which it arrives, whatever the painter is
//! doing. A second thread (the painter) paints frames from data that nobody changes, and the main thread presents them
//! as they are finished.
//!
//! An [`App`] is the game, or a scene viewer (`game/examples/scene_window.rs`). This room refuses to know a game, and
//! nothing else in the project names winit or softbuffer.

mod app;
mod frame_pipeline;
mod icon;
mod key_codes;
mod painter_thread;
mod pointer;
mod scale_factor;
mod screenshot;
mod shell;
mod shell_window;
mod surface;

pub use app::{App, Commands, Event, FrameTiming, Pointer, Waker};
pub use shell_window::WindowOptions;

use crate::{Failure, interrupt};
use app::Wake;
use shell::Shell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use tracer::Frame;
use winit::event_loop::EventLoop;

/// The connection to a display, on which one window can be opened.
pub struct Display(EventLoop<Wake>);

impl Display {
    /// Connects to the display of this session.
    ///
    /// # Errors
    /// If there is none, or what the environment says of its scale is no scale.
    pub fn open() -> Result<Display, Failure> {
        scale_factor::check(std::env::var_os(scale_factor::VARIABLE).as_deref())?;
        let events = EventLoop::with_user_event().build().map_err(|error| {
            Failure::new(format!(
                "there is no display to open a window on ({}); caustic frame, caustic dump, caustic render and caustic simulate work without one",
                reason(&error.to_string())
            ))
        })?;
        Ok(Display(events))
    }

    /// Opens a window and runs `app` in it until it is closed, or the program is asked to end. `painter` paints the application's frames, on a thread
    /// of its own: it fills the frame that it is given, which holds the pixels of an older one.
    ///
    /// # Errors
    /// If no window can be opened, or it fails.
    pub fn run<A, P>(self, app: &mut A, options: WindowOptions, painter: P) -> Result<(), Failure>
    where
        A: App,
        P: FnMut(A::FrameInput, &mut Frame) -> Result<A::FrameReport, Failure> + Send + 'static,
    {
        let mut shell = Shell::new(app, options, Box::new(painter), self.0.create_proxy());
        let waker = Waker::new(self.0.create_proxy());
        interrupt::listen(move || waker.wake())?;
        let events = self.0;
        // winit panics where the display hangs up on it: what was played must not be lost with the window.
        let ended = catch_unwind(AssertUnwindSafe(|| events.run_app(&mut shell)));
        shell.failure().map_or(Ok(()), Err)?;
        let ended = ended.map_err(|_| Failure::new("the display hung up; what was played until then is kept"))?;
        ended.map_err(|error| Failure::new(format!("the window failed: {}", reason(&error.to_string()))))
    }
}

/// The reason that winit gives, without the place in its own source that comes before it.
fn reason(error: &str) -> &str {
    let line = error.lines().next().unwrap_or_default();
    let told = if line.contains(".rs:") { line.rsplit(": ").next().unwrap_or(line) } else { line };
    match told.trim_end_matches('.') {
        none if none.starts_with("neither ") => "DISPLAY and WAYLAND_DISPLAY name none",
        "Failed to open connection to X server" => "what DISPLAY names does not answer",
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::reason;

    #[test]
    fn the_reason_is_told_without_the_place_in_a_source_file() {
        let error = "os error at /home/a/winit/mod.rs:765: neither WAYLAND_DISPLAY nor DISPLAY is set.";
        assert_eq!(reason(error), "DISPLAY and WAYLAND_DISPLAY name none");
        assert_eq!(reason("the display hung up\nand more"), "the display hung up");
    }
}
