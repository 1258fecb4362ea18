//! The last ball, kept so that it can be watched again: the state in which it began and every button since.

use crate::simulation::Display;
use crate::{Buttons, Simulation};
use pinball::timeline::TickSource;

/// A ball that takes longer is kept from here on, ticks (half an hour).
const LONGEST_TICKS: usize = 1_800_000;
/// A ball that is shorter than this is not worth another look, ticks.
const SHORTEST_TICKS: usize = 1_500;

/// The ball in play and the one before it.
pub struct LastBall {
    turn: Turn,
    current: Ball,
    before: Option<Ball>,
}

/// Whose ball it is: player and number.
type Turn = (bool, usize, u32);

#[derive(Clone)]
struct Ball {
    start: Simulation,
    buttons: Vec<Buttons>,
}

impl LastBall {
    /// Nothing has been played yet.
    pub fn new(simulation: &Simulation) -> LastBall {
        LastBall { turn: (false, 0, 0), current: Ball::starting(simulation), before: None }
    }

    /// A tick was played with these buttons.
    pub fn push(&mut self, buttons: Buttons) {
        if self.current.buttons.len() < LONGEST_TICKS {
            self.current.buttons.push(buttons);
        }
    }

    /// Looks whether another ball is in play now.
    pub fn look(&mut self, simulation: &Simulation, display: &Display) {
        let turn = (display.playing, display.player, display.ball);
        if turn == self.turn {
            return;
        }
        let ended = std::mem::replace(&mut self.current, Ball::starting(simulation));
        if self.turn.0 && ended.buttons.len() >= SHORTEST_TICKS {
            self.before = Some(ended);
        }
        self.turn = turn;
    }

    /// The last ball that was lost; before that, the ball in play up to now.
    pub fn rerun(&self) -> Option<Rerun> {
        let in_play = (self.turn.0 && self.current.buttons.len() >= SHORTEST_TICKS).then_some(&self.current);
        let ball = self.before.as_ref().or(in_play)?.clone();
        Some(Rerun { simulation: ball.start, buttons: ball.buttons, played: 0 })
    }
}

impl Ball {
    fn starting(simulation: &Simulation) -> Ball {
        Ball { start: simulation.clone(), buttons: Vec::new() }
    }
}

/// A ball that is being shown again.
pub struct Rerun {
    simulation: Simulation,
    buttons: Vec<Buttons>,
    played: usize,
}

impl Rerun {
    /// Whether everything has been shown.
    pub fn is_over(&self) -> bool {
        self.played >= self.buttons.len()
    }
}

impl TickSource for Rerun {
    fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    fn step(&mut self) -> bool {
        let Some(&buttons) = self.buttons.get(self.played) else { return false };
        self.simulation.tick(buttons);
        self.played += 1;
        true
    }
}
