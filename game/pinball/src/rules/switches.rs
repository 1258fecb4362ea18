//! Which switches are closed, and what the buttons are called.

use crate::Buttons;
use physics::PartId;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// The switches that have closed and not opened again: those of rollovers and coils with a ball, and of drop targets that
/// are down.
/// Switches that never open (bumpers, spinners, ...) are in here from their first closing on.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Switches {
    closed: BTreeSet<PartId>,
}

impl Switches {
    /// Notes what a switch did.
    pub fn set(&mut self, part: PartId, closed: bool) {
        if closed {
            self.closed.insert(part);
        } else {
            self.closed.remove(&part);
        }
    }

    /// Whether a switch is closed.
    pub fn closed(&self, part: PartId) -> bool {
        self.closed.contains(&part)
    }
}

/// The buttons as the script names them.
pub const BUTTONS: [(Buttons, &str); 8] = [
    (Buttons::LEFT, "left"),
    (Buttons::RIGHT, "right"),
    (Buttons::PLUNGER, "plunger"),
    (Buttons::NUDGE_LEFT, "nudge-left"),
    (Buttons::NUDGE_RIGHT, "nudge-right"),
    (Buttons::NUDGE_UP, "nudge-up"),
    (Buttons::NUDGE_DOWN, "nudge-down"),
    (Buttons::START, "start"),
];

/// What the hands have just done: the script's function that should hear of it, and the button.
pub fn button_edges(before: Buttons, now: Buttons) -> impl Iterator<Item = (&'static str, &'static str)> {
    BUTTONS.into_iter().filter_map(move |(button, name)| match (before.contains(button), now.contains(button)) {
        (false, true) => Some(("on_button", name)),
        (true, false) => Some(("on_release", name)),
        _ => None,
    })
}
