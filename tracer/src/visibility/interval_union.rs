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

/// Rows at most that are sorted by neighbours: with few of them that is as fast.
const FEW_ROWS: usize = 16;

/// Sorts each lane independently: the same network as in [`uncovered`], or where it would take long, for it grows with the
/// square of the rows, one by merging (n log^2 n; K. Batcher, 1968, as algorithm M of Knuth's section 5.2.2).
#[inline(always)]
fn sort(rows: &mut [Lanes]) {
    if rows.len() > FEW_ROWS {
        return sort_by_merging(rows);
    }
    for last in (1..rows.len()).rev() {
        for k in 0..last {
            exchange(rows, k, k + 1);
        }
    }
}

/// See [`sort`].
#[inline(always)]
fn sort_by_merging(rows: &mut [Lanes]) {
    let half = rows.len().next_power_of_two() / 2;
    let mut p = half;
    while p > 0 {
        let (mut q, mut r, mut distance) = (half, 0, p);
        loop {
            for k in (0..rows.len() - distance).filter(|k| k & p == r) {
                exchange(rows, k, k + distance);
            }
            if q == p {
                break;
            }
            (distance, q, r) = (q - p, q / 2, p);
        }
        p /= 2;
    }
}

/// Puts the smaller of two rows first, lane by lane.
#[inline(always)]
fn exchange(rows: &mut [Lanes], first: usize, second: usize) {
    let (lower, upper) = rows.split_at_mut(second);
    let (a, b) = (&mut lower[first], &mut upper[0]);
    for i in 0..LANES {
        (a[i], b[i]) = (min(a[i], b[i]), max(a[i], b[i]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A recording whose look had its solids thirty times took a minute for a picture: the rows were sorted by neighbours.
    #[test]
    fn rows_of_every_number_are_sorted_in_each_lane() {
        for count in 0..200_usize {
            let mut rows: Vec<Lanes> =
                (0..count).map(|k| std::array::from_fn(|lane| ((k * 37 + lane * 11) % 101) as f32 - 50.0)).collect();
            let mut lanes: Vec<Vec<f32>> = (0..LANES).map(|lane| rows.iter().map(|row| row[lane]).collect()).collect();
            lanes.iter_mut().for_each(|lane| lane.sort_by(f32::total_cmp));
            sort(&mut rows);
            for (lane, expected) in lanes.iter().enumerate() {
                let sorted: Vec<f32> = rows.iter().map(|row| row[lane]).collect();
                assert_eq!(&sorted, expected, "{count} rows, lane {lane}");
            }
        }
    }
}
