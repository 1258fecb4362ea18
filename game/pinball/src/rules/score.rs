//! Players, scores and balls: the part of the game that every table shares.

use serde::{Deserialize, Serialize};

/// Most players in a game.
pub const MAX_PLAYERS: usize = 4;
/// Most balls in a game.
pub const MAX_BALLS: u32 = 99;

/// Who plays, with how many points, on which ball.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Score {
    /// Each player's points.
    pub scores: Vec<i64>,
    /// The player at the machine, an index into `scores`.
    pub player: usize,
    /// The ball in play, from 1; 0 when no game is on.
    pub ball: u32,
    /// Balls in a game.
    pub balls: u32,
    /// A game is on.
    pub playing: bool,
    /// The machine has been tilted.
    pub tilted: bool,
}

impl Score {
    /// Begins a game of one player.
    pub fn start(&mut self, balls: u32) {
        *self = Score { scores: vec![0], player: 0, ball: 1, balls, playing: true, tilted: false };
    }

    /// Adds a player, if a game is on and there is room.
    pub fn add_player(&mut self) -> bool {
        let room = self.playing && self.scores.len() < MAX_PLAYERS;
        if room {
            self.scores.push(0);
        }
        room
    }

    /// Gives the machine to the next player, or the next ball to the first one. False, and nothing changes, if the last
    /// player has played the last ball.
    pub fn next_player(&mut self) -> bool {
        if !self.playing {
            return false;
        }
        if self.is_last_turn() {
            return false;
        }
        let last = self.player + 1 >= self.scores.len();
        self.player = if last { 0 } else { self.player + 1 };
        self.ball += u32::from(last);
        self.tilted = false;
        true
    }

    /// Whether the last player plays the last ball.
    pub fn is_last_turn(&self) -> bool {
        self.player + 1 >= self.scores.len() && self.ball >= self.balls
    }

    /// Ends the game; the scores stay to be looked at.
    pub fn game_over(&mut self) {
        self.playing = false;
        self.tilted = false;
        self.ball = 0;
    }

    /// Gives the player at the machine points. None are given when no game is on or the machine is tilted.
    pub fn add(&mut self, points: i64) {
        if self.playing
            && !self.tilted
            && let Some(score) = self.scores.get_mut(self.player)
        {
            *score = score.saturating_add(points).max(0);
        }
    }
}
