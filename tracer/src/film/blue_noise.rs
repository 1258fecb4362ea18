//! Blue noise: an order of thresholds without patterns, so that dark gradients have no steps.
//!
//! R. Ulichney, "The void-and-cluster method for dither array generation", 1993. The array is made once, on first use,
//! and is the same on every machine.

use std::sync::OnceLock;

/// Cells along a side; the array repeats.
pub(crate) const MATRIX_SIDE: usize = 64;

const MATRIX_CELLS: usize = MATRIX_SIDE * MATRIX_SIDE;

/// The standard deviation of the Gaussian that measures crowding, cells: Ulichney's 1.5.
const CROWDING_SIGMA: f32 = 1.5;

/// The part of the cells that the first pattern fills: Ulichney's tenth.
const FIRST_PATTERN: usize = 10;

/// Any seed but 0 of the xorshift generator (G. Marsaglia, 2003) that makes the first pattern; another would give
/// another array, as good, and other pixels.
const FIRST_SEED: u64 = 0x9e37_79b9_7f4a_7c15;

/// How far a cell's influence is followed, cells: 4.7 standard deviations.
const KERNEL_REACH: isize = 7;

/// Thresholds in (-0.5, 0.5), evenly spread, row by row.
pub(crate) fn thresholds() -> &'static [f32; MATRIX_CELLS] {
    static THRESHOLDS: OnceLock<Box<[f32; MATRIX_CELLS]>> = OnceLock::new();
    THRESHOLDS.get_or_init(|| {
        let mut thresholds = Box::new([0.0; MATRIX_CELLS]);
        for (cell, rank) in ranks().into_iter().enumerate() {
            thresholds[cell] = (rank as f32 + 0.5) / MATRIX_CELLS as f32 - 0.5;
        }
        thresholds
    })
}

/// A binary pattern of cells, and how crowded each place is.
struct Pattern {
    set: Vec<bool>,
    crowding: Vec<f32>,
    kernel: Vec<f32>,
}

impl Pattern {
    fn new() -> Pattern {
        let side = 2 * KERNEL_REACH + 1;
        let kernel = (0..side * side)
            .map(|at| {
                let (x, y) = ((at % side - KERNEL_REACH) as f32, (at / side - KERNEL_REACH) as f32);
                libm::expf(-(x * x + y * y) / (2.0 * CROWDING_SIGMA * CROWDING_SIGMA))
            })
            .collect();
        Pattern { set: vec![false; MATRIX_CELLS], crowding: vec![0.0; MATRIX_CELLS], kernel }
    }

    fn put(&mut self, cell: usize, present: bool) {
        self.set[cell] = present;
        let sign = if present { 1.0 } else { -1.0 };
        let (cx, cy) = ((cell % MATRIX_SIDE) as isize, (cell / MATRIX_SIDE) as isize);
        for dy in -KERNEL_REACH..=KERNEL_REACH {
            for dx in -KERNEL_REACH..=KERNEL_REACH {
                let x = (cx + dx).rem_euclid(MATRIX_SIDE as isize) as usize;
                let y = (cy + dy).rem_euclid(MATRIX_SIDE as isize) as usize;
                let at = (dy + KERNEL_REACH) * (2 * KERNEL_REACH + 1) + dx + KERNEL_REACH;
                self.crowding[y * MATRIX_SIDE + x] += sign * self.kernel[at as usize];
            }
        }
    }

    /// The tightest cluster, a cell that is set, or the largest void, one that is not.
    fn extreme(&self, present: bool) -> usize {
        let mut best = 0;
        let mut most = f32::MIN;
        for cell in 0..MATRIX_CELLS {
            let crowding = if present { self.crowding[cell] } else { -self.crowding[cell] };
            if self.set[cell] == present && crowding > most {
                (best, most) = (cell, crowding);
            }
        }
        best
    }
}

/// The order in which the cells of the array are filled.
fn ranks() -> Vec<usize> {
    let mut pattern = Pattern::new();
    let first = MATRIX_CELLS / FIRST_PATTERN;
    let mut state = FIRST_SEED;
    let mut placed = 0;
    while placed < first {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        let cell = (state >> 20) as usize % MATRIX_CELLS;
        if !pattern.set[cell] {
            pattern.put(cell, true);
            placed += 1;
        }
    }
    for _ in 0..MATRIX_CELLS {
        let cluster = pattern.extreme(true);
        pattern.put(cluster, false);
        let void = pattern.extreme(false);
        pattern.put(void, true);
        if void == cluster {
            break;
        }
    }
    let start: Vec<usize> = (0..MATRIX_CELLS).filter(|&cell| pattern.set[cell]).collect();
    let mut ranks = vec![0; MATRIX_CELLS];
    for rank in (0..first).rev() {
        let cluster = pattern.extreme(true);
        pattern.put(cluster, false);
        ranks[cluster] = rank;
    }
    for cell in start {
        pattern.put(cell, true);
    }
    for rank in first..MATRIX_CELLS {
        let void = pattern.extreme(false);
        pattern.put(void, true);
        ranks[void] = rank;
    }
    ranks
}
