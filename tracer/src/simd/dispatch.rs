//! The instruction sets that the inner loops are compiled for, and the choice among them at run time.
//!
//! An inner loop is written once, on plain arrays of [`LANES`] numbers, and compiled once for each [`Path`]. Only
//! `+ - * / sqrt` and selections are used, and the compiler contracts nothing, so every path gives the same bits.

/// How many pixels an inner loop takes at a time: one AVX-512 register, two of AVX2, four of SSE2 or NEON.
pub const LANES: usize = 16;

/// One number for each of [`LANES`] pixels.
pub type Lanes = [f32; LANES];

/// An instruction set that this machine has: a value of this type proves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Path(Set);

/// The instruction sets that there are clones for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Set {
    /// What every machine of the target has.
    Baseline,
    /// 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// 512 bits.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Path {
    /// Every path of this machine, the slowest first.
    pub fn available() -> Vec<Path> {
        #[allow(unused_mut)]
        let mut paths = vec![Path(Set::Baseline)];
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx2") {
                paths.push(Path(Set::Avx2));
            }
            if is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512bw")
            {
                paths.push(Path(Set::Avx512));
            }
        }
        paths
    }

    /// The fastest path of this machine.
    pub fn best() -> Path {
        *Path::available().last().unwrap_or(&Path(Set::Baseline))
    }

    /// The name of the instruction set.
    pub fn name(self) -> &'static str {
        match self.0 {
            Set::Baseline => "baseline",
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => "avx2",
            #[cfg(target_arch = "x86_64")]
            Set::Avx512 => "avx512",
        }
    }

    /// The set itself, for the dispatch of [`clones!`](crate::clones).
    pub fn set(self) -> Set {
        self.0
    }
}

/// Declares `fn name(path, ...)` that runs `body`, an `#[inline(always)]` function, compiled for `path`.
#[macro_export]
macro_rules! clones {
    ($(#[$meta:meta])* $vis:vis fn $name:ident($($arg:ident: $type:ty),* $(,)?) = $body:path;) => {
        $(#[$meta])*
        #[allow(clippy::too_many_arguments)]
        $vis fn $name(path: $crate::simd::dispatch::Path, $($arg: $type),*) {
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
            match path.set() {
                $crate::simd::dispatch::Set::Baseline => $body($($arg),*),
                // SAFETY: a `Path` of this set exists only where the machine was found to have it.
                #[cfg(target_arch = "x86_64")]
                $crate::simd::dispatch::Set::Avx2 => unsafe { avx2($($arg),*) },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                $crate::simd::dispatch::Set::Avx512 => unsafe { avx512($($arg),*) },
            }
        }
    };
}
pub use crate::clones;

/// Asks the memory for what will be read soon: nothing depends on it but time.
#[inline(always)]
pub(crate) fn fetch<T>(things: &[T]) {
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
pub(crate) fn ones(bits: u16) -> impl Iterator<Item = usize> {
    (0..u16::BITS as usize).filter(move |bit| bits >> bit & 1 == 1)
}

/// The nearest whole number, for a value from 0 to 65,535: 2^23 leaves no room for a fraction, so adding it rounds, and
/// the number is in the lowest bits.
#[inline(always)]
pub(crate) fn rounded(value: f32) -> u16 {
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
