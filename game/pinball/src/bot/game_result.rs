//! Game result: what came of one game of a run of self-play.

/// One of the games of a self-play run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GameResult {
    /// From the game before, or from the switching on, until the next or the end of the run, ticks.
    pub ticks: u64,
    /// The best score of the players.
    pub score: i64,
    /// The game came to its end.
    pub over: bool,
}
