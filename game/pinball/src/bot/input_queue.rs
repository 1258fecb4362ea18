//! The bot's hands: what they hold, and what they are about to do.

use super::rng::Chance;
use crate::Buttons;

/// Standard deviation of the moment at which a finger moves, in ticks (ms).
const TIMING_ERROR: f64 = 4.0;

/// Hands that do what was decided, a little early or late.
#[derive(Clone, Debug, Default)]
pub(super) struct Hands {
    down: Buttons,
    /// Moves to come, the next one first.
    moves: Vec<Move>,
}

/// A finger's move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Move {
    /// The tick at which it is made.
    pub tick: u64,
    /// The buttons that go down or come up.
    pub buttons: Buttons,
    /// They go down.
    pub down: bool,
}

impl Hands {
    /// What is held at `tick`.
    pub fn at(&mut self, tick: u64) -> Buttons {
        while let Some(&next) = self.moves.first().filter(|next| next.tick <= tick) {
            self.down = self.down.with(next.buttons, next.down);
            self.moves.remove(0);
        }
        self.down
    }

    /// What is held now.
    pub fn held(&self) -> Buttons {
        self.down
    }

    /// Whether a move is still to come.
    pub fn busy(&self) -> bool {
        !self.moves.is_empty()
    }

    /// Forgets what was to be done and does this instead, each move with a human error, none before `now`.
    pub fn intend(&mut self, moves: &[Move], now: u64, chance: &mut Chance) {
        self.moves.clear();
        for wanted in moves {
            let error = chance.error(TIMING_ERROR).round() as i64;
            let previous = self.moves.last().map_or(now, |before| before.tick);
            let tick = wanted.tick.saturating_add_signed(error).max(previous);
            self.moves.push(Move { tick, ..*wanted });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(tick: u64, down: bool) -> Move {
        Move { tick, buttons: Buttons::LEFT, down }
    }

    #[test]
    fn moves_come_in_their_order_a_little_early_or_late() {
        let mut chance = Chance::new(5);
        let mut moments = Vec::new();
        for _ in 0..200 {
            let mut hands = Hands::default();
            hands.intend(&[press(100, true), press(103, false)], 98, &mut chance);
            let held: Vec<bool> = (98..140).map(|tick| hands.at(tick).contains(Buttons::LEFT)).collect();
            assert!(!hands.busy() && hands.held() == Buttons::NONE);
            moments.extend(held.iter().position(|down| *down));
        }
        let (first, last) = (moments.iter().min().unwrap(), moments.iter().max().unwrap());
        assert!(*first == 0 && (6..=14).contains(last), "presses from {first} to {last} ticks after they could be");
    }

    #[test]
    fn a_new_intention_replaces_the_old_one() {
        let mut chance = Chance::new(1);
        let mut hands = Hands::default();
        hands.intend(&[press(50, true)], 0, &mut chance);
        hands.intend(&[], 10, &mut chance);
        assert_eq!(hands.at(90), Buttons::NONE);
    }
}
