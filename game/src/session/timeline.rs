//! The timeline: plays ticks, and keeps the snapshots of the last two, between which a frame is interpolated.
//!
//! Live play, a replay and a rerun differ only in where a tick's buttons come from: each is a [`TickSource`].

use crate::{Simulation, Snapshot};
use std::sync::Arc;

/// A game that can be played on tick by tick: its buttons come from a player, a bot, a recording or memory.
pub trait TickSource {
    /// The game.
    fn simulation(&self) -> &Simulation;

    /// Plays one tick; `false`, with nothing done, where there is none to play.
    fn tick(&mut self) -> bool;
}

/// The last two snapshots of a game that is played on.
#[derive(Clone, Debug)]
pub struct Timeline {
    previous: Arc<Snapshot>,
    current: Arc<Snapshot>,
}

impl Timeline {
    /// A timeline that stands where the game is.
    pub fn new(simulation: &Simulation) -> Timeline {
        let current = Arc::new(simulation.snapshot());
        Timeline { previous: current.clone(), current }
    }

    /// Plays `ticks` ticks, fewer where the source ends, and calls `after_tick` with the game after each. Gives the
    /// number of ticks played.
    pub fn play(&mut self, source: &mut impl TickSource, ticks: u64, mut after_tick: impl FnMut(&Simulation)) -> u64 {
        for tick in 0..ticks {
            if tick + 1 == ticks {
                self.previous = Arc::new(source.simulation().snapshot());
            }
            if !source.tick() {
                self.stand(source.simulation());
                return tick;
            }
            after_tick(source.simulation());
        }
        if ticks > 0 {
            self.current = Arc::new(source.simulation().snapshot());
        }
        ticks
    }

    /// Stands where the game is: after a jump, or at a source's end, there is nothing to interpolate.
    pub fn stand(&mut self, simulation: &Simulation) {
        *self = Timeline::new(simulation);
    }

    /// The snapshots of the last two ticks, the earlier first; the same one twice where the game stands.
    pub fn snapshots(&self) -> (&Arc<Snapshot>, &Arc<Snapshot>) {
        (&self.previous, &self.current)
    }

    /// The snapshot of the last tick.
    pub fn current(&self) -> &Snapshot {
        &self.current
    }
}
