//! Near balls: which balls a ball can meet within a step, so that in a heap of balls not every pair is asked at every
//! impact.
//!
//! Found once at the start of a step, with room for what balls go in it. Only pairs are left out that would be found to be
//! too far apart in any case, so nothing comes out otherwise.

use crate::ball::Ball;
use crate::collision::time_of_impact::FAR_APART_M;
use crate::solver::step::Step;
use geometry::DVec2;

/// Of fewer balls every pair is asked: that is faster than to look who is near.
const MIN_BALLS: usize = 12;
/// How far two balls may go in a step, together, beside what are far apart go in any case, m.
const ROOM_M: f64 = 0.02;
/// Balls that were farther from each other than this at the start are not near, m.
const NEAR_M: f64 = FAR_APART_M + ROOM_M;
/// Far above rounding, far below anything else, m.
const ROUNDING_M: f64 = 1e-6;

/// The balls near each ball, in their order; nothing where every pair is asked.
#[derive(Clone, Debug, Default)]
pub(crate) struct NearBalls {
    /// Where the balls were when it was found.
    starts: Vec<DVec2>,
    /// Each ball with a ball near it, in order.
    pairs: Vec<(usize, usize)>,
    /// Where the pairs of each ball begin, and where the last end.
    firsts: Vec<usize>,
    /// The balls from left to right.
    by_x: Vec<usize>,
}

/// Finds the balls near each ball.
pub(crate) fn find(step: &mut Step) {
    let NearBalls { starts, pairs, firsts, by_x } = &mut step.buffers.near_balls;
    starts.clear();
    pairs.clear();
    firsts.clear();
    by_x.clear();
    let balls = &step.state.balls;
    if balls.len() < MIN_BALLS {
        return;
    }
    starts.extend(balls.iter().map(|ball| ball.center));
    by_x.extend(0..balls.len());
    by_x.sort_unstable_by(|&a, &b| starts[a].x.total_cmp(&starts[b].x).then(a.cmp(&b)));
    for (place, &ball) in by_x.iter().enumerate() {
        // A ball that is nowhere meets nobody.
        let reaches = |other: &&usize| starts[**other].x - starts[ball].x <= NEAR_M;
        for &other in by_x[place + 1..].iter().take_while(reaches) {
            if starts[ball].distance_squared(starts[other]) <= NEAR_M * NEAR_M {
                pairs.extend([(ball, other), (other, ball)]);
            }
        }
    }
    pairs.sort_unstable();
    firsts.extend((0..=balls.len()).map(|ball| pairs.partition_point(|&(first, _)| first < ball)));
}

impl NearBalls {
    /// Whether no ball but those near it can come to any ball with these mean velocities in what is `left`.
    pub fn hold(&self, balls: &[Ball], means: &[DVec2], left: f64) -> bool {
        if self.starts.is_empty() {
            return false;
        }
        let moved = balls.iter().zip(&self.starts).map(|(ball, start)| ball.center.distance_squared(*start));
        let moved = moved.fold(0.0, f64::max).sqrt();
        let path = means.iter().map(|mean| mean.length_squared()).fold(0.0, f64::max).sqrt() * left;
        2.0 * (moved + path) + ROUNDING_M < ROOM_M
    }

    /// The balls near a ball, in order.
    pub fn of(&self, ball: usize) -> impl Iterator<Item = usize> + '_ {
        self.pairs[self.firsts[ball]..self.firsts[ball + 1]].iter().map(|&(_, other)| other)
    }

    /// Whether every pair is to be asked.
    pub fn is_empty(&self) -> bool {
        self.starts.is_empty()
    }
}
