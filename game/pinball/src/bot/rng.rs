//! The random number generator of bot and players: its numbers never touch the game's.

use geometry::rng::SplitMix64;

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub struct BotRng(SplitMix64);

impl BotRng {
    /// The stream that belongs to this seed.
    pub fn new(seed: u64) -> BotRng {
        BotRng(SplitMix64::new(seed))
    }

    /// Evenly in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0.unit()
    }

    /// Evenly in `low..=high`.
    pub fn between(&mut self, low: u64, high: u64) -> u64 {
        low + (self.unit() * (high - low + 1) as f64) as u64
    }

    /// Around 0, about normal, with this standard deviation (the sum of three even numbers: never beyond 3 of them).
    pub fn error(&mut self, deviation: f64) -> f64 {
        (self.unit() + self.unit() + self.unit() - 1.5) * 2.0 * deviation
    }
}
