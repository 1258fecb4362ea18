//! Fallen targets: all drop targets of a table are hit in a game, and none is hit again; one that still lies when the first ball of
//! the next game has been played is one that the rules never raise.

use super::finding::{Finding, FindingKind};
use super::switches::Shot;
use super::whole_game::{self, LossPlaces, MOST_BALLS, risen};
use crate::{Buttons, Simulation};
use physics::{Event, EventKind, PartId};
use std::collections::BTreeSet;

/// Drop targets of a table that is tried.
pub const MAX_TARGETS: usize = 16;
/// A ball that is shot at a target has met it by then, ticks.
const HIT_TICKS: usize = 300;
/// A ball that was put into a drain is gone by then, ticks.
const LOSS_TICKS: usize = 200;

/// Targets that stay down, in a game whose first ball waits at the plunger. With a ball there the ball search, which raises all of
/// them, waits too.
pub fn stay_down(begun: &Simulation, places: &LossPlaces, shots: &[(PartId, Shot)]) -> Vec<Finding> {
    let Some(drain) = places.drains.first().copied().filter(|_| !shots.is_empty()) else { return Vec::new() };
    let mut bank = Bank { simulation: begun.clone(), fallen: BTreeSet::new(), raised: BTreeSet::new() };
    for (part, shot) in shots {
        if !bank.fallen.contains(part) {
            bank.hit(*part, *shot);
            bank.lose_balls(drain);
        }
    }
    // A bank of which one stands may be none that is to be raised.
    if shots.iter().any(|(part, _)| !bank.fallen.contains(part)) {
        return Vec::new();
    }
    let game = whole_game::play(&bank.simulation, places, Some(drain), MOST_BALLS);
    let Some(next) = game.next.filter(|_| game.findings.is_empty()) else { return Vec::new() };
    let next = whole_game::play(&next, places, Some(drain), 1);
    let is_raised =
        |part: &PartId| [&bank.raised, &game.raised, &next.raised].iter().any(|raised| raised.contains(part));
    let lying = shots.iter().filter(|(part, _)| next.findings.is_empty() && !is_raised(part));
    lying.map(|(part, shot)| Finding::of_part(FindingKind::NeverRaised, *part, shot.place)).collect()
}

/// Drop targets that are being hit.
struct Bank {
    simulation: Simulation,
    fallen: BTreeSet<PartId>,
    raised: BTreeSet<PartId>,
}

impl Bank {
    /// Shoots a ball at the target.
    fn hit(&mut self, part: PartId, shot: Shot) {
        self.simulation.put_ball(shot.place, shot.velocity);
        for _ in 0..HIT_TICKS {
            self.tick();
            if self.fallen.contains(&part) {
                return;
            }
        }
    }

    /// Puts the balls that are not at the plunger into the drain.
    fn lose_balls(&mut self, drain: (PartId, geometry::DVec2)) {
        for ball in self.simulation.machine().balls() {
            if whole_game::is_away(&self.simulation, &ball) && !ball.held {
                self.simulation.move_ball(ball.id, drain.1);
            }
        }
        (0..LOSS_TICKS).for_each(|_| self.tick());
    }

    fn tick(&mut self) {
        self.simulation.tick(Buttons::NONE);
        let closed = |event: &Event| event.part.filter(|_| event.kind == EventKind::Closed);
        self.fallen.extend(self.simulation.events().filter_map(closed));
        self.raised.extend(risen(&self.simulation));
    }
}
