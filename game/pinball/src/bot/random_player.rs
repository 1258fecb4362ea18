//! A player who flips at random: what the bot is measured against.

use super::flipper_zones::FlipperZones;
use super::rng::BotRng;
use crate::{Buttons, Simulation};

/// Presses each flipper for a random while, again and again, without looking.
#[derive(Clone, Debug)]
pub struct RandomPlayer {
    rng: BotRng,
    /// When each of the buttons changes next.
    changes: [u64; 2],
    down: Buttons,
    starting: bool,
    zones: Option<FlipperZones>,
}

impl RandomPlayer {
    /// The player that this seed gives.
    pub fn new(seed: u64) -> RandomPlayer {
        RandomPlayer {
            rng: BotRng::new(seed ^ 0x7a2d),
            changes: [0; 2],
            down: Buttons::NONE,
            starting: false,
            zones: None,
        }
    }

    /// What it presses in the next tick.
    pub fn buttons(&mut self, simulation: &Simulation) -> Buttons {
        let tick = simulation.ticks();
        for (index, side) in [Buttons::LEFT, Buttons::RIGHT].into_iter().enumerate() {
            if tick >= self.changes[index] {
                let pressed = self.down.contains(side);
                let pause = if pressed { self.rng.between(100, 500) } else { self.rng.between(60, 200) };
                self.down = self.down.with(side, !pressed);
                self.changes[index] = tick + pause;
            }
        }
        self.down.with(Buttons::PLUNGER, self.plunges(simulation)).with(Buttons::START, self.starts(simulation))
    }

    /// Pulls the plunger for the first part of every third second, if a ball is there.
    fn plunges(&mut self, simulation: &Simulation) -> bool {
        let zones = self.zones.get_or_insert_with(|| FlipperZones::new(&simulation.table().layout));
        let pulled = simulation.ticks() % 3000 < zones.pull_ticks.clamp(1, 2900);
        pulled && simulation.pose().balls.iter().any(|ball| zones.waits(ball) || zones.in_lane(ball))
    }

    /// Presses start for a moment every nine seconds while no game is on.
    fn starts(&mut self, simulation: &Simulation) -> bool {
        let moment = simulation.ticks() % 9000;
        if moment == 2000 {
            self.starting = !simulation.display().playing;
        }
        self.starting && (2000..2060).contains(&moment)
    }
}
