//! Random numbers with the same bits everywhere: SplitMix64, as a stream and as a counter-based generator.
//!
//! G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014. A stream steps its state
//! by [`GOLDEN_GAMMA`] and scrambles it ([`mix64`]). A counter-based number ([`Key`]) is a pure function of its name
//! (pixel, lamp, sample), so it does not depend on the order in which threads ask for it.
//!
//! No clock and no thread seeds anything: a seed is a number that the caller knows.

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The step of the state: the odd number nearest to 2^64 over the golden ratio (section 3 of the paper).
pub const GOLDEN_GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// The finalizer's multipliers: variant 13 of D. Stafford, "Better bit mixing", 2011, which the paper takes.
const STAFFORD_13: [u64; 2] = [0xbf58_476d_1ce4_e5b9, 0x94d0_49bb_1331_11eb];

/// The first multiplier of MurmurHash3's 64-bit finalizer (A. Appleby, 2011): spreads the parts of a [`Key`]'s name.
const MURMUR_64: u64 = 0xff51_afd7_ed55_8ccd;

/// Scrambles 64 bits: each bit of the result depends on every bit of `bits`, and no two numbers give the same.
pub const fn mix64(bits: u64) -> u64 {
    let bits = (bits ^ (bits >> 30)).wrapping_mul(STAFFORD_13[0]);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(STAFFORD_13[1]);
    bits ^ (bits >> 31)
}

/// Scrambles 32 bits: MurmurHash3's 32-bit finalizer (A. Appleby, 2011).
pub const fn mix32(bits: u32) -> u32 {
    let bits = (bits ^ (bits >> 16)).wrapping_mul(0x85eb_ca6b);
    let bits = (bits ^ (bits >> 13)).wrapping_mul(0xc2b2_ae35);
    bits ^ (bits >> 16)
}

/// The uniform number in [0, 1) of the upper 53 bits, as many as a double's mantissa holds.
pub const fn unit_from_bits(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

/// A stream of random numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// The stream of a seed.
    pub const fn new(seed: u64) -> SplitMix64 {
        SplitMix64 { state: seed }
    }

    /// The next number, uniform over all of `u64`.
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(GOLDEN_GAMMA);
        mix64(self.state)
    }

    /// The next number, uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        unit_from_bits(self.next_u64())
    }

    /// The next number, uniform in [`low`, `high`).
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// The next whole number, uniform from 0 to `count - 1`; 0 if `count` is 0.
    pub fn below(&mut self, count: u64) -> u64 {
        // The high half of a product of 128 bits: biased by less than count / 2^64.
        ((u128::from(self.next_u64()) * u128::from(count)) >> 64) as u64
    }

    /// A point, uniform in the rectangle from the origin to `size`.
    pub fn point_within(&mut self, size: DVec2) -> DVec2 {
        DVec2::new(self.uniform(0.0, size.x), self.uniform(0.0, size.y))
    }
}

/// The name of a random number, hashed part by part; a counter-based generator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key(u64);

impl Key {
    /// The name that begins with a seed and a number.
    pub const fn new(seed: u64, number: u64) -> Key {
        Key(seed).with(number)
    }

    /// The name, with a number added.
    pub const fn with(self, number: u64) -> Key {
        Key(mix64((self.0 ^ number.wrapping_mul(MURMUR_64)).wrapping_add(GOLDEN_GAMMA)))
    }

    /// The name, with a point added.
    pub const fn with_point(self, point: DVec2) -> Key {
        self.with(point.x.to_bits()).with(point.y.to_bits())
    }

    /// The random number of this name, uniform in [0, 1).
    pub const fn unit(self) -> f64 {
        unit_from_bits(self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of seed 1234567, as other implementations of the paper give them.
    #[test]
    fn the_stream_is_that_of_the_paper() {
        let mut stream = SplitMix64::new(1_234_567);
        let expected = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!([(); 3].map(|()| stream.next_u64()), expected);
    }

    #[test]
    fn numbers_below_a_count_are_even_and_below_it() {
        let (mut stream, mut counts) = (SplitMix64::new(5), [0; 10]);
        (0..100_000).for_each(|_| counts[stream.below(10) as usize] += 1);
        assert!(counts.iter().all(|count| (9_500..10_500).contains(count)), "{counts:?}");
        assert_eq!(stream.below(0), 0);
    }

    /// Neighbours in any part of a name have numbers that do not follow from each other.
    #[test]
    fn keys_of_neighbours_are_uncorrelated() {
        let at = |x: u64, y: u64| Key::new(7, x).with(y).unit() - 0.5;
        let pairs = (0..40_000).map(|n| (n % 200, n / 200));
        let (across, down) = pairs.fold((0.0, 0.0), |(across, down), (x, y)| {
            (across + at(x, y) * at(x + 1, y) * 12.0, down + at(x, y) * at(x, y + 1) * 12.0)
        });
        assert!(f64::abs(across / 40_000.0) < 0.02 && f64::abs(down / 40_000.0) < 0.02, "{across} {down}");
    }
}
