//! What goes into a tick.

use crate::PartId;
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
    /// Bumpers and slingshots kick, or are dead.
    SetKickers(bool),
    /// Fire every coil once to free a ball that is stuck: bumpers and slingshots throw what lies at them, saucers throw
    /// out what they hold, drop targets rise. No switch closes by this alone.
    BallSearch,
}
