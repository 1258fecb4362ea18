//! The bot's input queue: which buttons are down, and which changes are to come.

use super::rng::BotRng;
use crate::Buttons;

/// Standard deviation of the moment at which a finger moves, in ticks (ms).
const TIMING_ERROR: f64 = 4.0;

/// An input queue: it presses and lets go as decided, a little early or late, as hands do.
#[derive(Clone, Debug, Default)]
pub(super) struct InputQueue {
    down: Buttons,
    /// Moves to come, the next one first.
    moves: Vec<ButtonChange>,
}

/// A change of buttons: the move of a finger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ButtonChange {
    /// The tick at which it is made.
    pub tick: u64,
    /// The buttons that go down or come up.
    pub buttons: Buttons,
    /// They go down.
    pub down: bool,
}

impl InputQueue {
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
    pub fn is_pending(&self) -> bool {
        !self.moves.is_empty()
    }

    /// Forgets what was to be done and does this instead, each move with a human error, none before `now`.
    pub fn replace(&mut self, moves: &[ButtonChange], now: u64, rng: &mut BotRng) {
        self.moves.clear();
        for wanted in moves {
            let error = rng.error(TIMING_ERROR).round() as i64;
            let previous = self.moves.last().map_or(now, |before| before.tick);
            let tick = wanted.tick.saturating_add_signed(error).max(previous);
            self.moves.push(ButtonChange { tick, ..*wanted });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(tick: u64, down: bool) -> ButtonChange {
        ButtonChange { tick, buttons: Buttons::LEFT, down }
    }

    #[test]
    fn moves_come_in_their_order_a_little_early_or_late() {
        let mut rng = BotRng::new(5);
        let mut moments = Vec::new();
        for _ in 0..200 {
            let mut input_queue = InputQueue::default();
            input_queue.replace(&[press(100, true), press(103, false)], 98, &mut rng);
            let held: Vec<bool> = (98..140).map(|tick| input_queue.at(tick).contains(Buttons::LEFT)).collect();
            assert!(!input_queue.is_pending() && input_queue.held() == Buttons::NONE);
            moments.extend(held.iter().position(|down| *down));
        }
        let (first, last) = (moments.iter().min().unwrap(), moments.iter().max().unwrap());
        assert!(*first == 0 && (6..=14).contains(last), "presses from {first} to {last} ticks after they could be");
    }

    #[test]
    fn a_new_intention_replaces_the_old_one() {
        let mut rng = BotRng::new(1);
        let mut input_queue = InputQueue::default();
        input_queue.replace(&[press(50, true)], 0, &mut rng);
        input_queue.replace(&[], 10, &mut rng);
        assert_eq!(input_queue.at(90), Buttons::NONE);
    }
}
