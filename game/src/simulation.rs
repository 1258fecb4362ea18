//! A game in play: the machine, the rules and the lamps, one tick at a time.
//!
//! A tick reads one [`Buttons`] and nothing else. Everything that can change what happens next is in [`Simulation::hash`]
//! and in [`Simulation::save`].

use crate::{Buttons, Failure, Table};
use physics::{Contact, Event, Pose};
use std::sync::Arc;

/// The version of everything that decides what a recording replays to. Raised whenever the same inputs would give
/// another game.
pub const SIMULATION_VERSION: u32 = 1;

/// A game in play. A clone goes on exactly as the original does.
#[derive(Clone)]
pub struct Simulation {
    table: Arc<Table>,
}

/// The parts of the state, hashed one by one so that a difference can be named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hashes {
    /// The balls.
    pub balls: u64,
    /// Everything else that moves.
    pub mechanisms: u64,
    /// Score, players, the rules' own state and random numbers.
    pub rules: u64,
    /// The lamps.
    pub lamps: u64,
}

impl Simulation {
    /// A machine that has just been switched on and waits for [`Buttons::START`].
    ///
    /// # Errors
    /// If the rules do not run, with file and line.
    pub fn new(table: Arc<Table>, _seed: u64) -> Result<Simulation, Failure> {
        Ok(Simulation { table })
    }

    /// The table that is played.
    pub fn table(&self) -> &Arc<Table> {
        &self.table
    }

    /// One millisecond.
    pub fn tick(&mut self, _buttons: Buttons) {}

    /// Ticks since the machine was switched on.
    pub fn ticks(&self) -> u64 {
        0
    }

    /// What happened in the last tick.
    pub fn events(&self) -> &[Event] {
        &[]
    }

    /// The impacts of the last tick.
    pub fn contacts(&self) -> &[Contact] {
        &[]
    }

    /// Where everything is now (cheaper than [`Simulation::snapshot`]).
    pub fn pose(&self) -> Pose {
        Pose::default()
    }

    /// The machine alone, to look ahead with: a bot plays its clone.
    pub fn machine(&self) -> &physics::Machine {
        todo!()
    }

    /// What a picture needs to know of this moment.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot::default()
    }

    /// What the rules have complained about since the last call, one sentence each with file and line.
    pub fn complaints(&mut self) -> Vec<String> {
        Vec::new()
    }

    /// Of everything that can change what happens next.
    pub fn hashes(&self) -> Hashes {
        Hashes { balls: 0, mechanisms: 0, rules: 0, lamps: 0 }
    }

    /// All of [`Simulation::hashes`] in one.
    pub fn hash(&self) -> u64 {
        0
    }

    /// Everything that can change what happens next.
    pub fn save(&self) -> Vec<u8> {
        Vec::new()
    }

    /// The simulation that [`Simulation::save`] wrote, on the same table.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this table.
    pub fn restore(table: Arc<Table>, _bytes: &[u8]) -> Result<Simulation, Failure> {
        Simulation::new(table, 0)
    }
}

/// What a picture needs to know of a moment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Ticks since the game was switched on.
    pub tick: u64,
    /// Where everything is.
    pub pose: Pose,
    /// Each lamp of the table, in its order.
    pub lamps: Vec<LampLight>,
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
