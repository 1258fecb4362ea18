//! Sessions: a game that is played live, or a recording that is watched. Each plays the ticks that are due and keeps
//! the last two snapshots.
//!
//! This room refuses to know a window, a key or a thread; it reads the clock only to name a new recording.

mod contact_trail;
mod game_recordings;
mod last_ball;
mod live_game;
mod modal;
mod replay_session;
mod tick_clock;
pub mod zoom;

pub use live_game::LiveGame;
pub use modal::Modal;
pub use replay_session::ReplaySession;
pub use tick_clock::{PlaybackSpeed, TickClock};

use crate::Snapshot;
use crate::hud::{Badge, DebugInfo, FrameTimes, TrailContact, UiState};
use std::sync::Arc;

/// A live game or a replay.
pub enum Session {
    /// A game in play.
    Live(Box<LiveGame>),
    /// A recording that is watched.
    Replay(Box<ReplaySession>),
}

impl Session {
    /// Whether time passes in it.
    pub fn is_moving(&self) -> bool {
        match self {
            Session::Live(_) => true,
            Session::Replay(replay) => !replay.paused,
        }
    }

    /// How fast time passes in it.
    pub fn speed(&self) -> PlaybackSpeed {
        match self {
            Session::Live(_) => PlaybackSpeed::REAL,
            Session::Replay(replay) => replay.speed,
        }
    }

    /// The snapshots of the last two ticks.
    pub fn snapshots(&self) -> (&Arc<Snapshot>, &Arc<Snapshot>) {
        match self {
            Session::Live(game) => game.snapshots(),
            Session::Replay(replay) => replay.snapshots(),
        }
    }

    /// What the application adds to the snapshots; `times` is what the last frames cost, if the debug overlay is on.
    pub fn ui_state(&self, modal: Modal, notice: Option<String>, times: Option<FrameTimes>) -> UiState {
        let (badge, replay, standing) = match self {
            Session::Live(game) => (game.badge(), None, game.notice()),
            Session::Replay(replay) => (Some(Badge::Replay), Some(replay.progress()), replay.notice()),
        };
        let notice = notice.or(standing);
        let dialog = modal.dialog(replay.is_some());
        let debug = times.map(|times| DebugInfo { times, contact_trail: self.contact_trail() });
        UiState { badge, notice, dialog, replay, debug }
    }

    fn contact_trail(&self) -> Vec<TrailContact> {
        match self {
            Session::Live(game) => game.contact_trail(),
            Session::Replay(replay) => replay.contact_trail(),
        }
    }

    /// What went wrong in the session since the last call.
    pub fn complaint(&mut self) -> Option<String> {
        match self {
            Session::Live(game) => game.complaints().pop(),
            Session::Replay(replay) => replay.complaint(),
        }
    }

    /// What the window is called.
    pub fn title(&self, table: &str) -> String {
        match self {
            Session::Live(_) => format!("Caustic \u{2013} {table}"),
            Session::Replay(_) => format!("Caustic \u{2013} {table} (replay)"),
        }
    }
}
