//! One number for all the states that games went through, so that two builds are compared tick for tick by one line.

use std::fmt;
use xxhash_rust::xxh3::xxh3_64;

/// The hashes of all ticks, folded in their order: one bit elsewhere in one tick gives another digest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digest {
    folded: u64,
    ticks: u64,
}

impl Digest {
    /// Folds in the hash of the next tick, [`super::Simulation::hash`].
    pub fn add(&mut self, hash: u64) {
        self.fold(hash, 1);
    }

    /// The digest of games, in this order. Which game a tick belongs to matters: a tick that moves from one to the next
    /// gives another digest.
    pub fn of_games(games: impl IntoIterator<Item = Digest>) -> Digest {
        let mut all = Digest::default();
        for game in games {
            all.fold(game.ticks, 0);
            all.fold(game.folded, game.ticks);
        }
        all
    }

    /// The digest of games, each with its seed. The order in which they are given does not matter.
    pub fn of_seeds(games: &[(u64, Digest)]) -> Digest {
        let mut games = games.to_vec();
        games.sort_by_key(|(seed, digest)| (*seed, digest.folded));
        Digest::of_games(games.into_iter().map(|(_, digest)| digest))
    }

    /// The digest as a number: what it displays, in hexadecimal digits.
    pub fn value(self) -> u64 {
        self.folded
    }

    fn fold(&mut self, hash: u64, ticks: u64) {
        let mut bytes = [0; 16];
        bytes[..8].copy_from_slice(&self.folded.to_le_bytes());
        bytes[8..].copy_from_slice(&hash.to_le_bytes());
        self.folded = xxh3_64(&bytes);
        self.ticks += ticks;
    }

    /// How many ticks are in it.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }
}

impl fmt::Display for Digest {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{:016x}", self.folded)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn digest(hashes: &[u64]) -> Digest {
        let mut digest = Digest::default();
        hashes.iter().for_each(|hash| digest.add(*hash));
        digest
    }

    #[test]
    fn order_count_and_every_bit_matter() {
        let plain = digest(&[1, 2, 3]);
        assert_eq!(plain.ticks(), 3);
        assert_eq!(plain, digest(&[1, 2, 3]));
        for other in [&[1, 3, 2][..], &[1, 2], &[0, 1, 2, 3], &[1, 2, 3 ^ 1 << 63], &[]] {
            assert_ne!(digest(other).to_string(), plain.to_string(), "{other:?}");
        }
    }

    #[test]
    fn a_tick_belongs_to_its_game() {
        let fold = |games: &[&[u64]]| Digest::of_games(games.iter().map(|game| digest(game)));
        let plain = fold(&[&[1, 2], &[3]]);
        assert_eq!(plain.ticks(), 3);
        for other in [fold(&[&[1], &[2, 3]]), fold(&[&[3], &[1, 2]]), fold(&[&[1, 2, 3]]), fold(&[&[1, 2], &[3], &[]])]
        {
            assert_ne!(other.to_string(), plain.to_string());
        }
    }
}
