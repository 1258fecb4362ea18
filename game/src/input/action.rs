//! Actions: what a key can be bound to.

use crate::Buttons;

/// What a key does while a game is played.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Holds a button of the machine, as long as the key is down.
    Button(Buttons),
    /// Holds the plunger; the start button when no game is on.
    Plunge,
    /// Does something once, outside the machine.
    Ui(UiAction),
}

/// Something outside the machine that a key does once, when it goes down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UiAction {
    /// Pause, or go on.
    Pause,
    /// Show the keys.
    Help,
    /// Leave, where leaving is offered.
    Quit,
    /// Fill the screen, or not.
    Fullscreen,
    /// Switch the debug overlay.
    DebugOverlay,
    /// Save the frame in the window.
    Screenshot,
    /// Watch the last ball.
    LastBall,
    /// Look closer at the table.
    ZoomIn,
    /// Look at more of the table.
    ZoomOut,
}

/// What a key does once, while a recording is watched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReplayAction {
    /// Stand still, or go on.
    TogglePause,
    /// Go some seconds back.
    SeekBack,
    /// Go some seconds on.
    SeekForward,
    /// Play faster.
    Faster,
    /// Play slower.
    Slower,
}
