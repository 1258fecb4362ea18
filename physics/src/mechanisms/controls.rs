//! What goes into a tick.

use crate::layout::PartId;
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

/// What the rules ask of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Command {
    /// Put a new ball in the plunger lane (as soon as its place is free).
    AddBall,
    /// Throw out the ball that this saucer holds, if it holds one.
    Eject(PartId),
    /// Raise this drop target (as soon as no ball is in its way).
    Raise(PartId),
    /// Flippers obey their buttons, or hang down.
    SetFlippers(bool),
    /// Bumpers, slingshots, kickbacks and magnets work, or are dead.
    SetKickers(bool),
    /// Shoot this kickback's rod out, unless kickers are dead or it is on its way out already.
    Kick(PartId),
    /// Switch this magnet on or off.
    Magnet(PartId, bool),
    /// Turn this diverter to the end of its stroke, or let its spring turn it back.
    Divert(PartId, bool),
    /// Fire every coil once to free a ball that is stuck: bumpers and slingshots throw what lies at them, kickbacks
    /// shoot, saucers throw out what they hold, drop targets rise, magnets are switched off. No switch closes by this
    /// alone.
    BallSearch,
}
