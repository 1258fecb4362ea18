//! Frame statistics: how many pictures a second there are, the longest time between two, and how long an input takes to
//! its picture. It reads no clock: it is told when what happened.

use crate::hud::FrameRates;
use std::collections::VecDeque;
use std::time::Duration;

/// Pictures are counted over this time.
const COUNTED: Duration = Duration::from_secs(1);
/// The longest time between two pictures is remembered this long.
const REMEMBERED: Duration = Duration::from_secs(5);
/// Latencies are told of this many last inputs.
const INPUTS: usize = 200;
/// No more inputs than this wait for their picture.
const WAITING: usize = 64;

/// When the last pictures came, and how long the last inputs took.
#[derive(Default)]
pub struct FrameStatistics {
    /// When pictures came into the window, the newest last.
    shown: VecDeque<Duration>,
    /// Inputs that no picture shows yet: when they came, and the tick that they count from.
    waiting: VecDeque<(Duration, u64)>,
    /// How long inputs took to their picture, the newest last, ms.
    latencies_ms: VecDeque<f64>,
}

impl FrameStatistics {
    /// An input came, which counts from `tick` on.
    pub fn input(&mut self, came: Duration, tick: u64) {
        self.waiting.push_back((came, tick));
        if self.waiting.len() > WAITING {
            self.waiting.pop_front();
        }
    }

    /// What was to be seen of inputs is no longer to come: the game stands still, or something else is watched.
    pub fn forget_inputs(&mut self) {
        self.waiting.clear();
    }

    /// A picture of `tick` came into the window.
    pub fn shown(&mut self, at: Duration, tick: u64) {
        self.shown.push_back(at);
        while self.shown.front().is_some_and(|first| at.saturating_sub(*first) > REMEMBERED) {
            self.shown.pop_front();
        }
        while let Some((came, _)) = self.waiting.pop_front_if(|(_, from)| *from <= tick) {
            self.latencies_ms.push_back(ms(at.saturating_sub(came)));
        }
        while self.latencies_ms.len() > INPUTS {
            self.latencies_ms.pop_front();
        }
    }

    /// What the debug overlay tells of them.
    pub fn rates(&self) -> FrameRates {
        let mut latencies_ms: Vec<f64> = self.latencies_ms.iter().copied().collect();
        latencies_ms.sort_by(f64::total_cmp);
        FrameRates {
            frames_per_s: self.frames_per_s(),
            longest_ms: self.between_ms().fold(0.0, f64::max),
            latency_median_ms: quantile(&latencies_ms, 0.5),
            latency_99th_ms: quantile(&latencies_ms, 0.99),
        }
    }

    fn frames_per_s(&self) -> f64 {
        let Some(last) = self.shown.back() else { return 0.0 };
        let counted = self.shown.iter().filter(|at| last.saturating_sub(**at) <= COUNTED);
        let (mut count, mut first) = (0, *last);
        counted.for_each(|at| (count, first) = (count + 1, first.min(*at)));
        let span_s = (*last - first).as_secs_f64();
        if span_s > 0.0 { f64::from(count - 1) / span_s } else { 0.0 }
    }

    fn between_ms(&self) -> impl Iterator<Item = f64> {
        self.shown.iter().zip(self.shown.iter().skip(1)).map(|(one, next)| ms(next.saturating_sub(*one)))
    }
}

fn ms(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1000.0
}

/// The value that this part of the sorted values does not exceed: the nearest rank.
fn quantile(sorted: &[f64], part: f64) -> Option<f64> {
    let rank = (sorted.len() as f64 * part).ceil() as usize;
    sorted.get(rank.saturating_sub(1)).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at_ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    #[test]
    fn an_input_has_its_picture_when_one_is_shown_that_contains_its_tick() {
        let mut statistics = FrameStatistics::default();
        statistics.input(at_ms(100), 101);
        statistics.shown(at_ms(110), 100);
        assert_eq!(statistics.rates().latency_median_ms, None, "that picture is older than the input");
        statistics.shown(at_ms(125), 112);
        statistics.shown(at_ms(140), 128);
        assert_eq!(statistics.rates().latency_median_ms, Some(25.0));
        for input in 0..99 {
            let came = 1000 + 20 * input;
            statistics.input(at_ms(came), came + 1);
            statistics.shown(at_ms(came + 10), came + 5);
        }
        let rates = statistics.rates();
        assert_eq!((rates.latency_median_ms, rates.latency_99th_ms), (Some(10.0), Some(10.0)), "one of a hundred");
        statistics.input(at_ms(5000), 5001);
        statistics.shown(at_ms(5090), 5001);
        assert_eq!(statistics.rates().latency_99th_ms, Some(25.0), "the second of a hundred and one");
    }

    #[test]
    fn pictures_are_counted_over_a_second_and_a_freeze_is_told_for_five() {
        let mut statistics = FrameStatistics::default();
        (0..=50).for_each(|frame| statistics.shown(at_ms(20 * frame), 0));
        assert_eq!((statistics.rates().frames_per_s, statistics.rates().longest_ms), (50.0, 20.0));
        (0..=200).for_each(|frame| statistics.shown(at_ms(1450 + 10 * frame), 0));
        assert_eq!((statistics.rates().frames_per_s, statistics.rates().longest_ms), (100.0, 450.0));
        (0..=500).for_each(|frame| statistics.shown(at_ms(3460 + 10 * frame), 0));
        assert_eq!(statistics.rates().longest_ms, 10.0);
    }

    #[test]
    fn inputs_that_never_get_a_picture_are_not_kept_for_ever() {
        let mut statistics = FrameStatistics::default();
        (0..1000).for_each(|tick| statistics.input(at_ms(tick), u64::MAX));
        assert_eq!(statistics.waiting.len(), WAITING);
        statistics.forget_inputs();
        statistics.shown(at_ms(2000), u64::MAX);
        assert_eq!(statistics.rates().latency_median_ms, None);
    }
}
