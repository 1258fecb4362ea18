//! The seam between the shell and an application: one trait, and plain data in both directions.

use crate::input::Key;
use crate::screen::Size;
use geometry::DVec2;
use std::time::Duration;
use winit::event_loop::EventLoopProxy;

/// An application in a window. The shell calls it on the main thread.
pub trait App {
    /// All that one frame is painted from: it is sent to the painter's thread.
    type FrameInput: Send + 'static;
    /// What the painter tells of a frame.
    type FrameReport: Send + 'static;

    /// Comes up to `now`, the time since the shell was started. Called before every event, and before the shell waits.
    fn update(&mut self, now: Duration, commands: &mut Commands);

    /// Takes an event, which happened at the time of the last update.
    fn event(&mut self, event: Event<Self::FrameReport>, commands: &mut Commands);

    /// What the next frame, of this size, is painted from. Called when a frame is due and the painter is idle.
    fn frame_input(&mut self, size: Size) -> Self::FrameInput;

    /// Whether something moves by itself, so that the application must be updated every few milliseconds.
    fn is_animating(&self) -> bool;
}

/// What the shell tells the application.
#[derive(Clone, Debug, PartialEq)]
pub enum Event<R> {
    /// A key went down or came up.
    Key {
        /// The key.
        key: Key,
        /// It went down.
        down: bool,
    },
    /// The mouse moved, a button went down or came up, or its wheel turned.
    Pointer(Pointer),
    /// The keyboard went to another window.
    FocusLost,
    /// A frame is in the window.
    FrameShown {
        /// What the painter told of it.
        report: R,
        /// What showing it cost.
        timing: FrameTiming,
    },
    /// A sentence for the person at the window: why there is no frame, where a screenshot is.
    Message(String),
}

/// What the mouse did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pointer {
    /// It is here, pixels from the window's upper left corner.
    Moved(DVec2),
    /// Its left button went down.
    Pressed,
    /// Its left button came up.
    Released,
    /// Its wheel was turned, lines away from the person.
    Wheel(f64),
}

/// When a frame came into the window.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameTiming {
    /// When it was there, the time since the shell was started.
    pub shown_at: Duration,
    /// Handing the frame to the window, ms.
    pub present_ms: f64,
    /// From the frame before to this one, ms.
    pub between_ms: f64,
    /// From one frame of the monitor to the next, ms.
    pub monitor_ms: f64,
}

/// What the application asks of the shell.
#[derive(Clone, Debug, Default)]
pub struct Commands {
    /// Something has changed: paint a new frame as soon as one is due.
    pub redraw: bool,
    /// Close the window.
    pub quit: bool,
    /// Fill the screen, or do so no longer.
    pub toggle_fullscreen: bool,
    /// Save the frame in the window.
    pub screenshot: bool,
    waker: Waker,
}

impl Commands {
    /// Nothing asked yet.
    pub(super) fn new(waker: Waker) -> Commands {
        Commands { waker, ..Commands::default() }
    }

    /// What was asked since the last call.
    pub(super) fn take(&mut self) -> Commands {
        let nothing = Commands::new(self.waker.clone());
        std::mem::replace(self, nothing)
    }

    /// What another thread of the application wakes the main thread with.
    pub fn waker(&self) -> Waker {
        self.waker.clone()
    }
}

/// What tells the main thread that another thread has something for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wake;

/// Wakes the main thread from another one; without a window it does nothing.
#[derive(Clone, Debug, Default)]
pub struct Waker(Option<EventLoopProxy<Wake>>);

impl Waker {
    /// Wakes the thread of this event loop.
    pub(super) fn new(proxy: EventLoopProxy<Wake>) -> Waker {
        Waker(Some(proxy))
    }

    /// Wakes the main thread, which then updates the application. Its loop is gone only when the window has been
    /// closed: then nobody waits for anything.
    pub fn wake(&self) {
        if let Some(proxy) = &self.0 {
            let _ = proxy.send_event(Wake);
        }
    }
}
