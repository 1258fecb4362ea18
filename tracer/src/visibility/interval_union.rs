//! The interval union: which part of a chord is covered by no interval (Klee's measure problem in one dimension; V.
//! Klee, 1977).
//!
//! 1. A point of the chord is uncovered if as many intervals have ended before it as have begun.
//! 2. So where k have begun, it lies between the k-th smallest end and the (k + 1)-th smallest beginning.
//! 3. The uncovered length is the sum of `max(0, begin[k + 1] - end[k])`, with the chord's own ends at both sides.
//!
//! Which end belongs to which beginning does not matter. So ends and beginnings are sorted independently, by a network
//! of compare-exchange steps, each a `min` and a `max` (D. Knuth, The Art of Computer Programming 3, section 5.3.4): no
//! branch, 16 samples at a time.

use crate::simd::dispatch::{LANES, Lanes, clamp, max, min};

/// The ends of the chord, lane by lane.
type Limits<'a> = (&'a Lanes, &'a Lanes);

/// The uncovered fraction of the chord under `N` intervals, in registers.
#[inline(always)]
pub(crate) fn uncovered<const N: usize>((least, most): Limits, low: &[Lanes], high: &[Lanes], out: &mut Lanes) {
    for i in 0..LANES {
        let (mut begin, mut end) = ([0.0; N], [0.0; N]);
        for k in 0..N {
            begin[k] = low[k][i];
            end[k] = high[k][i];
        }
        for last in (1..N).rev() {
            for k in 0..last {
                (begin[k], begin[k + 1]) = (min(begin[k], begin[k + 1]), max(begin[k], begin[k + 1]));
                (end[k], end[k + 1]) = (min(end[k], end[k + 1]), max(end[k], end[k + 1]));
            }
        }
        let mut gaps = begin[0] - least[i];
        for k in 1..N {
            gaps += max(begin[k] - end[k - 1], 0.0);
        }
        gaps += most[i] - end[N - 1];
        out[i] = clamp(gaps / (most[i] - least[i]), 0.0, 1.0);
    }
}

/// The uncovered fraction of the chord under any number of intervals, sorted in place.
#[inline(always)]
pub(crate) fn uncovered_many((least, most): Limits, low: &mut [Lanes], high: &mut [Lanes], out: &mut Lanes) {
    sort(low);
    sort(high);
    let mut gaps = low[0];
    for i in 0..LANES {
        gaps[i] -= least[i];
    }
    for (begin, end) in low[1..].iter().zip(high.iter()) {
        for i in 0..LANES {
            gaps[i] += max(begin[i] - end[i], 0.0);
        }
    }
    let last = &high[high.len() - 1];
    for i in 0..LANES {
        out[i] = clamp((gaps[i] + most[i] - last[i]) / (most[i] - least[i]), 0.0, 1.0);
    }
}

/// Sorts each lane independently: the same network as in [`uncovered`].
#[inline(always)]
fn sort(rows: &mut [Lanes]) {
    for last in (1..rows.len()).rev() {
        for k in 0..last {
            let (lower, upper) = rows.split_at_mut(k + 1);
            let (a, b) = (&mut lower[k], &mut upper[0]);
            for i in 0..LANES {
                (a[i], b[i]) = (min(a[i], b[i]), max(a[i], b[i]));
            }
        }
    }
}
