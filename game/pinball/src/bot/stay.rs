//! A ball's stay: for how long it has been about one place, though it may hop there.

use geometry::DVec2;

/// A ball that has not moved farther has come to rest when so much time has passed, m and ticks.
const REST_M: f64 = 0.002;
const REST_TICKS: u64 = 500;
/// Places where it comes to rest that are no farther from each other are one, m.
const SAME_M: f64 = 0.03;
/// A ball that comes farther has come away, m.
const AWAY_M: f64 = 0.15;

/// About which place a ball is, and since when.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stay {
    place: DVec2,
    since: u64,
    /// Where it was when it last moved, and when.
    moved: (DVec2, u64),
}

impl Stay {
    /// It begins here and now.
    pub fn new(center: DVec2, tick: u64) -> Stay {
        Stay { place: center, since: tick, moved: (center, tick) }
    }

    /// How long the ball, which is here now, has been about one place, ticks.
    pub fn look(&mut self, center: DVec2, tick: u64) -> u64 {
        if self.moved.0.distance(center) > REST_M {
            self.moved = (center, tick);
        }
        let rests = tick - self.moved.1 >= REST_TICKS;
        if self.place.distance(center) > if rests { SAME_M } else { AWAY_M } {
            (self.place, self.since) = (center, tick);
        }
        tick - self.since
    }
}

#[cfg(test)]
mod tests {
    use super::Stay;
    use geometry::DVec2;

    /// How long a ball has been about one place that goes from each of these to the next, x in m and ticks there.
    fn longest(path: &[(f64, u64)]) -> u64 {
        let mut stay = Stay::new(DVec2::ZERO, 0);
        let mut tick = 0;
        let ticks = path.iter().flat_map(|&(x, ticks)| std::iter::repeat_n(x, ticks as usize));
        ticks.fold(0, |longest, x| {
            tick += 1;
            longest.max(stay.look(DVec2::new(x, 0.0), tick))
        })
    }

    #[test]
    fn a_hop_and_back_is_one_stay() {
        assert_eq!(longest(&[(0.0, 5000), (0.1, 400), (0.02, 5000)]), 10_400);
        assert!(longest(&[(0.0, 5000), (0.2, 400), (0.0, 5000)]) < 6000, "it was away");
        assert!(longest(&[(0.0, 5000), (0.04, 5000)]) < 6000, "it lies elsewhere");
    }
}
