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
    fn step(&mut self) -> bool;
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
            if !source.step() {
                self.reset_to(source.simulation());
                return tick;
            }
            after_tick(source.simulation());
        }
        if ticks > 0 {
            self.current = Arc::new(source.simulation().snapshot());
        }
        ticks
    }

    /// Both snapshots become where the game is: after a jump, or at a source's end, there is nothing to interpolate.
    pub fn reset_to(&mut self, simulation: &Simulation) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Buttons;
    use crate::table::tests::with_rules;

    /// A game that ends after some ticks.
    struct Short {
        simulation: Simulation,
        left: u64,
    }

    impl TickSource for Short {
        fn simulation(&self) -> &Simulation {
            &self.simulation
        }

        fn step(&mut self) -> bool {
            let plays = self.left > 0;
            if plays {
                self.left -= 1;
                self.simulation.tick(Buttons::NONE);
            }
            plays
        }
    }

    fn short(ticks: u64) -> (Short, Timeline) {
        let simulation = Simulation::new(Arc::new(with_rules("", "")), 1).expect("no rules run");
        let timeline = Timeline::new(&simulation);
        (Short { simulation, left: ticks }, timeline)
    }

    fn ticks(timeline: &Timeline) -> (u64, u64) {
        let (previous, current) = timeline.snapshots();
        (previous.tick, current.tick)
    }

    #[test]
    fn the_last_two_ticks_are_kept_however_many_are_played_at_once() {
        let (mut source, mut timeline) = short(100);
        assert_eq!(ticks(&timeline), (0, 0));
        let mut seen = Vec::new();
        for (play, then) in [(1, (0, 1)), (0, (0, 1)), (7, (7, 8)), (1, (8, 9))] {
            assert_eq!(timeline.play(&mut source, play, |game| seen.push(game.ticks())), play);
            assert_eq!(ticks(&timeline), then);
        }
        assert_eq!(seen, (1..=9).collect::<Vec<_>>());
    }

    #[test]
    fn at_the_end_of_its_source_it_stands() {
        let (mut source, mut timeline) = short(5);
        assert_eq!(timeline.play(&mut source, 8, |_| ()), 5);
        assert_eq!(ticks(&timeline), (5, 5));
        assert_eq!(timeline.play(&mut source, 1, |_| ()), 0);
        assert_eq!(ticks(&timeline), (5, 5));
    }
}
