//! What the window shows: a game in play or a recording, and what lies over it.

mod contact_trail;
mod last_ball;
mod live_game;
mod replay_session;
mod tick_clock;
pub mod zoom;

pub use live_game::Game;
pub use replay_session::Viewing;
pub use tick_clock::{Clock, Speed};

use crate::Snapshot;
use crate::hud::{Badge, Card, Chrome, Debug, KEYS, REPLAY_KEYS, Times};
use std::sync::Arc;

/// A game or a recording.
pub enum Session {
    /// A game in play.
    Game(Box<Game>),
    /// A recording that is watched.
    Viewing(Box<Viewing>),
}

static PAUSED: Card = Card { title: "PAUSED", rows: KEYS, foot: "Esc  go on      Q  leave" };
static HELP: Card = Card { title: "KEYS", rows: KEYS, foot: "H  go on      Q  leave" };
static REPLAY_HELP: Card = Card { title: "KEYS", rows: REPLAY_KEYS, foot: "H  go on" };

/// What covers the table, and stops the game while it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cover {
    /// Nothing.
    None,
    /// The pause.
    Paused,
    /// The keys.
    Help,
}

/// The last two ticks.
pub fn snapshots(session: &Session) -> (&Arc<Snapshot>, &Arc<Snapshot>) {
    match session {
        Session::Game(game) => game.snapshots(),
        Session::Viewing(viewing) => viewing.snapshots(),
    }
}

/// What the window adds to the moment; `overlay` is what the last pictures cost, if that is to be shown.
pub fn chrome(session: &Session, cover: Cover, notice: Option<String>, overlay: Option<Times>) -> Chrome {
    let (badge, seek, help) = match session {
        Session::Game(game) => (game.badge(), None, &HELP),
        Session::Viewing(viewing) => (Some(Badge::Replay), Some(viewing.progress()), &REPLAY_HELP),
    };
    let card = match cover {
        Cover::None => None,
        Cover::Paused => Some(&PAUSED),
        Cover::Help => Some(help),
    };
    let debug = overlay.map(|times| {
        let touches = match session {
            Session::Game(game) => game.touches(),
            Session::Viewing(viewing) => viewing.touches(),
        };
        Debug { times, touches }
    });
    Chrome { badge, notice, card, seek, debug }
}

/// What went wrong in the session since the last call.
pub fn complaint(session: &mut Session) -> Option<String> {
    match session {
        Session::Game(game) => game.complaints().pop(),
        Session::Viewing(viewing) => viewing.complaint(),
    }
}

/// What the window is called.
pub fn title(session: &Session, table: &str) -> String {
    match session {
        Session::Game(_) => format!("Caustic \u{2013} {table}"),
        Session::Viewing(_) => format!("Caustic \u{2013} {table} (replay)"),
    }
}
