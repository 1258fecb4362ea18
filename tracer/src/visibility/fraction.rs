//! The visible fraction of a lamp, sample by sample.
//!
//! Everything lies in the plane of the floor, where occluders are areas and a lamp is a line. From a point P a disc
//! lamp is its *chord*: the diameter that is perpendicular to the line from P to the disc's centre. A tube is its own
//! chord, wherever P is. A convex occluder between P and the chord covers one interval of the chord, bounded by the
//! occluder's two tangents through P ([`crate::visibility::covered_interval`]). The visible fraction is one minus the
//! length of the intervals' union ([`crate::visibility::interval_union`]). Linear lamps were first treated so, with the
//! visible parts of the line found for each point, by T. Nishita, I. Okamura, E. Nakamae, "Shading models for point and
//! linear sources", ACM TOG 4(2), 1985.
//!
//! For a tube the ends of the intervals are weighed by the irradiance from their part of the line before their union is
//! measured ([`ProjectedChord::measure`]). `docs/exact_visibility.md` derives the whole method.

use crate::simd::dispatch::{LANES, Lanes, clamp, multiversion, set_bits};
use crate::tile::planes::Plane;
use crate::visibility::blockers::Blockers;
use crate::visibility::covered_interval::covered_interval;
use crate::visibility::interval_union::{uncovered, uncovered_many};
use crate::visibility::projected_emitter::{ProjectedChord, ProjectedDisc, ProjectedEmitter};

/// Scratch memory for the ends of the intervals that one block of samples sees, as slopes.
#[derive(Clone, Debug, Default)]
pub(crate) struct IntervalScratch {
    low: Vec<Lanes>,
    high: Vec<Lanes>,
}

impl IntervalScratch {
    /// Makes room for `count` intervals a sample.
    pub fn reserve(&mut self, count: usize) {
        if self.low.len() < count {
            self.low.resize(count, [0.0; LANES]);
            self.high.resize(count, [0.0; LANES]);
        }
    }
}

multiversion! {
    /// The visible fraction of `emitter` at those blocks of samples whose bits are set.
    pub(crate) fn visible_fraction(
        blocks: u16, x: &Plane, y: &Plane, emitter: ProjectedEmitter, blockers: &Blockers, scratch: &mut IntervalScratch,
        fraction: &mut Plane,
    ) = visible_fraction_lanes;
}

#[inline(always)]
fn visible_fraction_lanes(
    blocks: u16,
    x: &Plane,
    y: &Plane,
    emitter: ProjectedEmitter,
    blockers: &Blockers,
    scratch: &mut IntervalScratch,
    fraction: &mut Plane,
) {
    // Coherence: the occluder that hid the lamp from the last samples is tested first for the next.
    let mut first = 0;
    for block in set_bits(blocks) {
        let (x, y, out) = (&x[block], &y[block], &mut fraction[block]);
        match emitter {
            ProjectedEmitter::Disc(disc) if disc.radius == 0.0 => hard_shadow(x, y, disc, blockers, out),
            ProjectedEmitter::Disc(disc) => soft_shadow(x, y, disc, blockers, scratch, &mut first, out),
            ProjectedEmitter::Tube(tube) => {
                let (x, y) = tube.turned(x, y);
                soft_shadow(&x, &y, tube, blockers, scratch, &mut first, out);
            }
        }
    }
}

/// The visible fraction of a lamp with a size. Intervals that no lane's chord meets are not kept.
#[inline(always)]
fn soft_shadow<S: ProjectedChord>(
    x: &Lanes,
    y: &Lanes,
    emitter: S,
    blockers: &Blockers,
    scratch: &mut IntervalScratch,
    first: &mut usize,
    out: &mut Lanes,
) {
    let (mut least, mut most) = ([0.0; LANES], [0.0; LANES]);
    for i in 0..LANES {
        (least[i], most[i]) = emitter.limits(x[i], y[i]);
    }
    let mut count = 0;
    for turn in 0..blockers.intervals() {
        // The order: `first`, those before it, those after it.
        let at = if turn == 0 { *first } else { turn - usize::from(turn <= *first) };
        let (begin, end) = (&mut scratch.low[count], &mut scratch.high[count]);
        covered_interval(x, y, emitter, blockers, at, begin, end);
        let (mut met, mut missed) = (0u32, 0u32);
        for i in 0..LANES {
            begin[i] = clamp(begin[i], least[i], most[i]);
            end[i] = clamp(end[i], least[i], most[i]);
            met |= u32::from(end[i] > begin[i]);
            missed |= u32::from(end[i] - begin[i] < most[i] - least[i]);
        }
        if missed == 0 {
            *out = [0.0; LANES];
            *first = at;
            return;
        }
        count += met as usize;
    }
    let (lows, highs) = (&mut scratch.low[..count], &mut scratch.high[..count]);
    if count > 0 {
        emitter.measure(x, y, &mut least, &mut most, lows, highs);
    }
    let limits = (&least, &most);
    match count {
        0 => *out = [1.0; LANES],
        1 => uncovered::<1>(limits, lows, highs, out),
        2 => uncovered::<2>(limits, lows, highs, out),
        3 => uncovered::<3>(limits, lows, highs, out),
        4 => uncovered::<4>(limits, lows, highs, out),
        5 => uncovered::<5>(limits, lows, highs, out),
        6 => uncovered::<6>(limits, lows, highs, out),
        _ => uncovered_many(limits, lows, highs, out),
    }
}

/// The visible fraction of a lamp without size: 0 or 1.
#[inline(always)]
fn hard_shadow(x: &Lanes, y: &Lanes, emitter: ProjectedDisc, blockers: &Blockers, out: &mut Lanes) {
    *out = [1.0; LANES];
    let (mut low, mut high) = ([0.0; LANES], [0.0; LANES]);
    for at in 0..blockers.intervals() {
        covered_interval(x, y, emitter, blockers, at, &mut low, &mut high);
        for i in 0..LANES {
            let covered = (low[i] <= 0.0) & (high[i] >= 0.0);
            out[i] = if covered { 0.0 } else { out[i] };
        }
    }
}
