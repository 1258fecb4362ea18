//! What a picture needs to know of a moment: plain data, independent of the simulation it came from.

use crate::lamps::Eye;
use physics::Pose;

/// What a picture needs to know of a moment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Ticks since the game was switched on.
    pub tick: u64,
    /// Where everything is.
    pub pose: Pose,
    /// Each lamp of the table, in its order.
    pub lamps: Vec<LampLight>,
    /// The light that somebody at the table has got used to.
    pub eye: Eye,
    /// What the display shows.
    pub display: Display,
}

/// What a lamp does now.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LampLight {
    /// Brightness, 0 to 1000.
    pub level: u16,
    /// Colour, sRGB.
    pub color: [u8; 3],
}

/// What the display shows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Display {
    /// Each player's score.
    pub scores: Vec<i64>,
    /// The player at the machine, an index into `scores`.
    pub player: usize,
    /// The ball in play, from 1; 0 when no game is on.
    pub ball: u32,
    /// Balls in a game.
    pub balls: u32,
    /// The message's lines, the first the largest; empty when there is none.
    pub message: Vec<String>,
    /// When the message came.
    pub message_tick: u64,
    /// A game is on.
    pub playing: bool,
    /// The machine has been tilted.
    pub tilted: bool,
    /// Progress that the rules want shown: name, done, of how many (the colours collected, say).
    pub progress: Vec<(String, i64, i64)>,
}
