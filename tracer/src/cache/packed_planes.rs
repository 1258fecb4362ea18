//! Packed planes: two planes of a tile in each 32-bit word, 15 bits a number, and their weighted sums in whole numbers.
//!
//! Two products of 16-bit numbers and their sum are one instruction for every 32 bits of a register. Whole numbers also
//! add up to the same in any order: what was kept first does not show. This module refuses to know what the numbers are.

use crate::simd::dispatch::{LANES, Lanes, max, min, multiversion, round_to_u16, set_bits};
use crate::tile::planes::{AREA, Plane, RowMask};
use std::num::NonZeroU16;

/// The largest number of a plane.
pub(crate) const PLANE_MAX: f32 = 32_767.0;

/// Gains are at most this together, so that no sum of 15-bit numbers times them is beyond 31 bits; each is at most
/// [`PLANE_MAX`].
pub(crate) const MAX_TOTAL_WEIGHT: u32 = 65_535;

/// Two planes of a tile, row by row: one in the lower halves of the words, one in the upper.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct PackedPlanes([u32; AREA]);

/// Which half of which of a list of pairs, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PlaneSlot(NonZeroU16);

impl PlaneSlot {
    /// The one that comes after so many others.
    pub fn after(others: u16) -> PlaneSlot {
        PlaneSlot(NonZeroU16::MIN.saturating_add(others))
    }

    /// The pair's place in the list.
    pub fn index(self) -> usize {
        usize::from(self.0.get() - 1) / 2
    }

    /// How far to the left its numbers are in the words.
    pub fn shift(self) -> u32 {
        u32::from((self.0.get() - 1) % 2) * 16
    }
}

impl PackedPlanes {
    /// Zeros.
    pub const ZERO: PackedPlanes = PackedPlanes([0; AREA]);

    /// Whether all numbers of a half are 0.
    pub fn is_dark(&self, slot: PlaneSlot) -> bool {
        self.0.iter().fold(0, |all, word| all | word) >> slot.shift() & 0xffff == 0
    }

    /// A row of a half.
    #[inline(always)]
    pub fn row(&self, slot: PlaneSlot, row: usize) -> Lanes {
        let (words, shift) = (&self.0[row * LANES..][..LANES], slot.shift());
        let mut out = [0.0; LANES];
        for i in 0..LANES {
            out[i] = (words[i] >> shift & 0xffff) as f32;
        }
        out
    }
}

multiversion! {
    /// Keeps some rows of a plane, times what is seen of it, in steps of `scale`.
    pub(crate) fn encode_rows(
        plane: &Plane, seen: &Plane, rows: RowMask, scale: f32, slot: PlaneSlot, packed: &mut PackedPlanes,
    ) = encode_lanes;
}

#[inline(always)]
fn encode_lanes(plane: &Plane, seen: &Plane, rows: RowMask, scale: f32, slot: PlaneSlot, packed: &mut PackedPlanes) {
    let steps = if scale > 0.0 { 1.0 / scale } else { 0.0 };
    let (shift, other) = (slot.shift(), 0xffff_0000u32.rotate_left(slot.shift()));
    for row in set_bits(rows) {
        let (line, seen, words) = (&plane[row], &seen[row], &mut packed.0[row * LANES..][..LANES]);
        for i in 0..LANES {
            let number = round_to_u16(min(max(line[i], 0.0) * seen[i] * steps, PLANE_MAX));
            words[i] = words[i] & other | u32::from(number) << shift;
        }
    }
}

/// Rows that are summed up in registers.
pub(crate) const ROWS_AT_ONCE: usize = 2;

/// Sums of two rows of three channels.
pub(crate) type Sums = [[[i32; LANES]; ROWS_AT_ONCE]; 3];

/// The gains of a pair's halves, one in the lower half of each word, one in the upper: red, green, blue.
pub(crate) type PackedWeights = [u32; 3];

/// Pairs of planes with their gains: of one plane for all channels, or of a plane for each.
#[derive(Clone, Copy)]
pub(crate) struct WeightedPlanes<'a, const CHANNELS: usize> {
    /// The pairs.
    pub planes: &'a [[PackedPlanes; CHANNELS]],
    /// The gains of each.
    pub weights: &'a [PackedWeights],
}

impl<const CHANNELS: usize> WeightedPlanes<'_, CHANNELS> {
    /// Adds two rows, from `row` on, onto `sums`.
    #[inline(always)]
    pub fn add<M: Madd>(&self, row: usize, sums: &mut Sums) {
        for (packed, weights) in self.planes.iter().zip(self.weights) {
            for (channel, (sums, weights)) in sums.iter_mut().zip(weights).enumerate() {
                let words =
                    &packed[if CHANNELS == 1 { 0 } else { channel }].0.as_chunks::<LANES>().0[row..row + ROWS_AT_ONCE];
                for (sums, words) in sums.iter_mut().zip(words) {
                    M::madd(sums, words, *weights);
                }
            }
        }
    }
}

/// How an instruction set multiplies halves of words and adds.
pub(crate) trait Madd {
    /// Adds the products of the words' halves and the halves of `weights`, all of them of 15 bits, onto `sums`.
    fn madd(sums: &mut [i32; LANES], words: &[u32; LANES], weights: u32);
}

/// As it is written: what the others are measured against.
#[cfg(any(test, not(target_arch = "x86_64")))]
pub(crate) struct Plain;

#[cfg(any(test, not(target_arch = "x86_64")))]
impl Madd for Plain {
    #[inline(always)]
    fn madd(sums: &mut [i32; LANES], words: &[u32; LANES], weights: u32) {
        let (low, high) = ((weights & 0x7fff) as i32, (weights >> 16 & 0x7fff) as i32);
        for i in 0..LANES {
            sums[i] += (words[i] & 0x7fff) as i32 * low + (words[i] >> 16 & 0x7fff) as i32 * high;
        }
    }
}

/// Declares how a set of vector instructions does it, a register's width at a time.
#[cfg(target_arch = "x86_64")]
macro_rules! madd {
    ($name:ident, $words:literal, $load:ident, $store:ident, $all:ident, $madd:ident, $add:ident) => {
        /// One instruction for two products and their sum. Only for where the set's features are enabled.
        pub(crate) struct $name;

        impl Madd for $name {
            #[inline(always)]
            fn madd(sums: &mut [i32; LANES], words: &[u32; LANES], weights: u32) {
                use std::arch::x86_64::*;
                for at in (0..LANES).step_by($words) {
                    let (sum, word) = (sums[at..][..$words].as_mut_ptr(), words[at..][..$words].as_ptr());
                    // SAFETY: both hold a register's width, and only functions compiled for the set call this.
                    unsafe {
                        let products = $madd($load(word.cast()), $all(weights as i32));
                        $store(sum.cast(), $add($load(sum.cast_const().cast()), products));
                    }
                }
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
madd!(Wide, 16, _mm512_loadu_si512, _mm512_storeu_si512, _mm512_set1_epi32, _mm512_madd_epi16, _mm512_add_epi32);
#[cfg(target_arch = "x86_64")]
madd!(Middle, 8, _mm256_loadu_si256, _mm256_storeu_si256, _mm256_set1_epi32, _mm256_madd_epi16, _mm256_add_epi32);
#[cfg(target_arch = "x86_64")]
madd!(Narrow, 4, _mm_loadu_si128, _mm_storeu_si128, _mm_set1_epi32, _mm_madd_epi16, _mm_add_epi32);

/// What every machine of the target has.
#[cfg(target_arch = "x86_64")]
pub(crate) type Baseline = Narrow;
/// What every machine of the target has.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) type Baseline = Plain;

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;
    use crate::SimdLevel;
    use crate::simd::dispatch::InstructionSet;
    use geometry::rng::SplitMix64;

    /// Every set multiplies and adds as it is written, up to the largest numbers.
    #[test]
    fn sets_agree_with_what_is_written() {
        #[target_feature(enable = "avx2")]
        fn middle(sums: &mut [i32; LANES], words: &[u32; LANES], weights: u32) {
            Middle::madd(sums, words, weights);
        }
        #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
        fn wide(sums: &mut [i32; LANES], words: &[u32; LANES], weights: u32) {
            Wide::madd(sums, words, weights);
        }
        let mut random = SplitMix64::new(7);
        let mut number = |most: f64| random.uniform(0.0, most + 0.999) as u32;
        for round in 0..2_000 {
            let most = f64::from(PLANE_MAX);
            let words: [u32; LANES] = std::array::from_fn(|_| match round {
                0 => 0x7fff_7fff,
                _ => number(most) << 16 | number(most),
            });
            let weights = if round == 0 { 0x7fff_7fff } else { number(most) << 16 | number(most) };
            let sums = |add: &dyn Fn(&mut [i32; LANES])| {
                let mut sums = [0; LANES];
                add(&mut sums);
                sums
            };
            let plain = sums(&|sums| Plain::madd(sums, &words, weights));
            assert_eq!(plain, sums(&|sums| Narrow::madd(sums, &words, weights)));
            for simd in SimdLevel::available() {
                match simd.set() {
                    InstructionSet::Baseline => {}
                    // SAFETY: a `SimdLevel` of this set exists only where the machine was found to have it.
                    InstructionSet::Avx2 => assert_eq!(plain, sums(&|sums| unsafe { middle(sums, &words, weights) })),
                    // SAFETY: as above.
                    InstructionSet::Avx512 => assert_eq!(plain, sums(&|sums| unsafe { wide(sums, &words, weights) })),
                }
            }
        }
    }
}
