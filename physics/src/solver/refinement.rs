//! Refinement of the time of impact, once it is known what hits what: where both are then, and how fast.
//!
//! Refuses to know what happens then.

use crate::solver::gap::gap_at;
use crate::solver::impact_candidate::ImpactCandidate;
use crate::solver::step::{RESTITUTION_THRESHOLD_M_S, Step};

/// Farther than this from where it seemed to be, m, an impact was no impact on the straight path either. The true path
/// bends away by `a t^2 / 8`: in a tick a quarter of a micron at the 2 m/s^2 of gravity and friction, this at 16 m/s^2.
const MAX_BEND_M: f64 = 2e-6;
/// Steps of Newton's method: the gap is so straight in time that the second only mends rounding.
const NEWTON_STEPS: usize = 2;

/// The candidate at its true time of impact.
///
/// It was found on a straight path with the mean velocity of what is left of the step. The true path bends, so at that
/// time a gap is left; Newton's method closes it, `t += gap / closing`.
pub(crate) fn refine(step: &Step, mut candidate: ImpactCandidate, reach: f64) -> ImpactCandidate {
    for _ in 0..NEWTON_STEPS {
        if candidate.time <= 0.0 {
            break;
        }
        let gap = gap_at(step, &candidate);
        if gap.closing <= RESTITUTION_THRESHOLD_M_S || gap.distance.abs() > MAX_BEND_M {
            break;
        }
        candidate.time = (candidate.time + gap.distance / gap.closing).clamp(0.0, reach);
        candidate.normal = gap.normal;
    }
    candidate
}
