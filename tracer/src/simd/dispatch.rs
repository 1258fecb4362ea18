//! The instruction sets that the inner loops are compiled for, and the choice among them at run time.
//!
//! An inner loop is written once, on plain arrays of [`LANES`] numbers, and compiled once for each [`SimdLevel`]. Only
//! `+ - * / sqrt` and selections are used, and the compiler contracts nothing, so every SIMD level gives the same bits.

/// How many pixels an inner loop takes at a time: one AVX-512 register, two of AVX2, four of SSE2 or NEON.
pub const LANES: usize = 16;

/// One number for each of [`LANES`] pixels.
pub type Lanes = [f32; LANES];

/// An instruction set that this machine has: a value of this type proves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SimdLevel(InstructionSet);

/// The instruction sets that inner loops are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// What every machine of the target has.
    Baseline,
    /// 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// 512 bits.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl SimdLevel {
    /// Every level of this machine, the slowest first.
    pub fn available() -> Vec<SimdLevel> {
        #[allow(unused_mut)]
        let mut paths = vec![SimdLevel(InstructionSet::Baseline)];
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx2") {
                paths.push(SimdLevel(InstructionSet::Avx2));
            }
            if is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512bw")
            {
                paths.push(SimdLevel(InstructionSet::Avx512));
            }
        }
        paths
    }

    /// The fastest level of this machine.
    pub fn best() -> SimdLevel {
        *SimdLevel::available().last().unwrap_or(&SimdLevel(InstructionSet::Baseline))
    }

    /// The name of the instruction set.
    pub fn name(self) -> &'static str {
        match self.0 {
            InstructionSet::Baseline => "baseline",
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx2 => "avx2",
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx512 => "avx512",
        }
    }

    /// The set itself, for the dispatch of [`multiversion!`](crate::multiversion).
    pub fn set(self) -> InstructionSet {
        self.0
    }
}

/// Declares `fn name(simd, ...)` that runs `body`, an `#[inline(always)]` function, compiled for `simd`.
#[macro_export]
macro_rules! multiversion {
    ($(#[$meta:meta])* $vis:vis fn $name:ident($($arg:ident: $type:ty),* $(,)?) = $body:path;) => {
        $(#[$meta])*
        #[allow(clippy::too_many_arguments)]
        $vis fn $name(simd: $crate::simd::dispatch::SimdLevel, $($arg: $type),*) {
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2")]
            #[allow(clippy::too_many_arguments)]
            fn avx2($($arg: $type),*) {
                $body($($arg),*)
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
            #[allow(clippy::too_many_arguments)]
            fn avx512($($arg: $type),*) {
                $body($($arg),*)
            }
            match simd.set() {
                $crate::simd::dispatch::InstructionSet::Baseline => $body($($arg),*),
                // SAFETY: a `SimdLevel` of this set exists only where the machine was found to have it.
                #[cfg(target_arch = "x86_64")]
                $crate::simd::dispatch::InstructionSet::Avx2 => unsafe { avx2($($arg),*) },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                $crate::simd::dispatch::InstructionSet::Avx512 => unsafe { avx512($($arg),*) },
            }
        }
    };
}
pub use crate::multiversion;

/// Asks the memory for what will be read soon: nothing depends on it but time.
#[inline(always)]
pub(crate) fn prefetch<T>(things: &[T]) {
    #[cfg(target_arch = "x86_64")]
    for at in (0..size_of_val(things)).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T1, _mm_prefetch};
        // SAFETY: a hint reads nothing, and the address is within `things`.
        unsafe { _mm_prefetch::<_MM_HINT_T1>(things.as_ptr().cast::<i8>().add(at)) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = things;
}

/// The bits that are set: the numbers of rows, or of blocks of points.
#[inline(always)]
pub(crate) fn set_bits(bits: u16) -> impl Iterator<Item = usize> {
    (0..u16::BITS as usize).filter(move |bit| bits >> bit & 1 == 1)
}

/// The nearest whole number, for a value from 0 to 65,535: 2^23 leaves no room for a fraction, so adding it rounds, and
/// the number is in the lowest bits.
#[inline(always)]
pub(crate) fn round_to_u16(value: f32) -> u16 {
    ((value + 8_388_608.0).to_bits() & 0xffff) as u16
}

/// The smaller number, in one instruction: `f32::min` also has to think about NaN.
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger number, in one instruction.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// `value` brought into [low, high].
#[inline(always)]
pub(crate) fn clamp(value: f32, low: f32, high: f32) -> f32 {
    min(max(value, low), high)
}
