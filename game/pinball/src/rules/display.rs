//! Display: what the rules show on the display.

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
    /// When the message goes; `None` if it stays until another comes.
    pub message_until: Option<u64>,
    /// A game is on.
    pub playing: bool,
    /// The machine has been tilted.
    pub tilted: bool,
    /// Progress that the rules want shown: name, done, of how many (the colours collected, say).
    pub progress: Vec<(String, i64, i64)>,
}
