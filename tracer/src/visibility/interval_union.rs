//! What intervals leave uncovered.
//!
//! The union of any number of intervals needs their ends sorted, but not their pairs kept: a place that no interval
//! covers, where k have begun, is one where k have ended, so it lies between the k-th end and the next beginning. The
//! gaps are `max(0, begin[k + 1] - end[k])`, and ends and beginnings are sorted by themselves, with `min` and `max`.

use crate::simd::dispatch::{LANES, Lanes, clamp, max, min};

/// The least and the most that an interval of each lane can reach.
type Limits<'a> = (&'a Lanes, &'a Lanes);

/// One minus the union of `N` intervals, in registers.
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

/// One minus the union of any number of intervals, sorted in place.
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

/// Sorts each lane by itself.
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
