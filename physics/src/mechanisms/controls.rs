//! Controls: what the player's hands do.

use serde::{Deserialize, Serialize};

/// What the player's hands do in one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Controls {
    /// The left flipper button is down.
    pub left: bool,
    /// The right flipper button is down.
    pub right: bool,
    /// The plunger is being pulled; letting go shoots.
    pub plunger: bool,
    /// The cabinet is pushed to the right (by the left hand). A push starts when this becomes true.
    pub nudge_left: bool,
    /// The cabinet is pushed to the left (by the right hand).
    pub nudge_right: bool,
    /// The cabinet is pushed forwards, away from the player.
    pub nudge_up: bool,
    /// The cabinet is pulled backwards, towards the player.
    pub nudge_down: bool,
}

impl Controls {
    /// Hands off.
    pub const NONE: Controls = Controls {
        left: false,
        right: false,
        plunger: false,
        nudge_left: false,
        nudge_right: false,
        nudge_up: false,
        nudge_down: false,
    };
}
