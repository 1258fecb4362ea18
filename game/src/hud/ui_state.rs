//! The UI state: what the application adds to a snapshot of the game, as plain data.

use super::debug_overlay::DebugInfo;
use super::dialog::Dialog;
use super::replay_bar::ReplayProgress;

/// Who is at the machine, if not the player.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Badge {
    /// A recording.
    Replay,
    /// The bot.
    Bot,
}

/// What the application adds to a snapshot.
#[derive(Clone, Default)]
pub struct UiState {
    /// Who is at the machine.
    pub badge: Option<Badge>,
    /// A sentence for the player.
    pub notice: Option<String>,
    /// The dialog over the table.
    pub dialog: Option<&'static Dialog>,
    /// How far a replay is.
    pub replay: Option<ReplayProgress>,
    /// What the debug overlay shows, if it is on.
    pub debug: Option<DebugInfo>,
}
