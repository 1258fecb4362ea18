//! Modals: what covers the table, and stops the game while it does.

use crate::hud::{Dialog, KEYS, REPLAY_KEYS};

static PAUSED: Dialog = Dialog { title: "PAUSED", rows: KEYS, foot: "Esc  go on      Q  leave" };
static HELP: Dialog = Dialog { title: "KEYS", rows: KEYS, foot: "H  go on      Q  leave" };
static REPLAY_HELP: Dialog = Dialog { title: "KEYS", rows: REPLAY_KEYS, foot: "H  go on" };

/// The modal that is open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Modal {
    /// None: the game runs.
    #[default]
    None,
    /// The pause.
    Paused,
    /// The keys.
    Help,
}

impl Modal {
    /// The dialog that shows the modal, over a replay or over a game.
    pub fn dialog(self, is_replay: bool) -> Option<&'static Dialog> {
        match self {
            Modal::None => None,
            Modal::Paused => Some(&PAUSED),
            Modal::Help if is_replay => Some(&REPLAY_HELP),
            Modal::Help => Some(&HELP),
        }
    }
}
