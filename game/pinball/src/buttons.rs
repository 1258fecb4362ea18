//! Buttons: what the player holds down in one tick.

use serde::{Deserialize, Serialize};

/// The set of buttons that are down in one tick: the only thing that a tick reads from outside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Buttons(pub u8);

impl Buttons {
    /// Nothing is down.
    pub const NONE: Buttons = Buttons(0);
    /// The left flipper.
    pub const LEFT: Buttons = Buttons(1);
    /// The right flipper.
    pub const RIGHT: Buttons = Buttons(1 << 1);
    /// The plunger: pulled while it is down, let go when it comes up.
    pub const PLUNGER: Buttons = Buttons(1 << 2);
    /// The left hand pushes the cabinet to the right.
    pub const NUDGE_LEFT: Buttons = Buttons(1 << 3);
    /// The right hand pushes the cabinet to the left.
    pub const NUDGE_RIGHT: Buttons = Buttons(1 << 4);
    /// Both hands push the cabinet forwards.
    pub const NUDGE_UP: Buttons = Buttons(1 << 5);
    /// Both hands pull the cabinet towards the player.
    pub const NUDGE_DOWN: Buttons = Buttons(1 << 7);
    /// Start a game, or add a player before the first ball has been lost.
    pub const START: Buttons = Buttons(1 << 6);
    /// Every button that there is.
    pub const ALL: Buttons = Buttons(u8::MAX);

    /// Whether every button of `other` is down.
    pub fn contains(self, other: Buttons) -> bool {
        self.0 & other.0 == other.0
    }

    /// These buttons with those of `other` held down, or let go.
    #[must_use]
    pub fn with(self, other: Buttons, down: bool) -> Buttons {
        if down { Buttons(self.0 | other.0) } else { Buttons(self.0 & !other.0) }
    }
}

impl std::ops::BitOr for Buttons {
    type Output = Buttons;

    /// The buttons of both.
    fn bitor(self, other: Buttons) -> Buttons {
        Buttons(self.0 | other.0)
    }
}
