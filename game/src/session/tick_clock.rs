//! From real time to ticks, in whole nanoseconds.

/// A tick, ns.
const TICK_NS: u64 = 1_000_000_000 / physics::TICKS_PER_SECOND as u64;
/// After a longer gap than this (the process was stopped, the machine slept) the game goes on from where it was, ns.
const LONGEST_GAP_NS: u64 = 100_000_000;

/// How fast a replay runs, in eighths of real time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlaybackSpeed(u64);

impl PlaybackSpeed {
    /// Real time.
    pub const REAL: PlaybackSpeed = PlaybackSpeed(8);
    const SLOWEST: u64 = 1;
    const FASTEST: u64 = 64;

    /// Twice as fast, up to eight times real time.
    pub fn faster(self) -> PlaybackSpeed {
        PlaybackSpeed((self.0 * 2).min(PlaybackSpeed::FASTEST))
    }

    /// Half as fast, down to an eighth of real time.
    pub fn slower(self) -> PlaybackSpeed {
        PlaybackSpeed((self.0 / 2).max(PlaybackSpeed::SLOWEST))
    }

    /// As it is told: `x1/4`, `x1`, `x8`.
    pub fn label(self) -> String {
        if self.0 >= 8 { format!("\u{d7}{}", self.0 / 8) } else { format!("\u{d7}1/{}", 8 / self.0) }
    }
}

/// Real time that has not been played yet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TickClock {
    /// Always less than a tick between calls.
    owed_ns: u64,
    /// What is left of an eighth of a nanosecond.
    eighths: u64,
}

impl TickClock {
    /// The ticks that are due when `elapsed_ns` of real time have gone by at this speed.
    pub fn ticks(&mut self, elapsed_ns: u64, speed: PlaybackSpeed) -> u64 {
        let eighths = elapsed_ns.min(LONGEST_GAP_NS) * speed.0 + self.eighths;
        self.eighths = eighths % 8;
        self.owed_ns += eighths / 8;
        let ticks = self.owed_ns / TICK_NS;
        self.owed_ns %= TICK_NS;
        ticks
    }

    /// How far real time is from the last tick to the next, 0 to 1.
    pub fn alpha(&self) -> f64 {
        self.owed_ns as f64 / TICK_NS as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_time_is_lost_however_it_is_cut() {
        let mut clock = TickClock::default();
        let cuts = (0..10_000_u64).map(|i| i * 7919 % 16_000_003);
        let (ticks, elapsed) = cuts.fold((0, 0), |(t, e), cut| (t + clock.ticks(cut, PlaybackSpeed::REAL), e + cut));
        assert_eq!(ticks, elapsed / TICK_NS);
    }

    #[test]
    fn an_eighth_of_real_time_is_exact_over_an_hour_of_single_milliseconds() {
        let mut clock = TickClock::default();
        let slowest = PlaybackSpeed::REAL.slower().slower().slower().slower();
        let ticks: u64 = (0..3_600_000).map(|_| clock.ticks(1_000_001, slowest)).sum();
        assert_eq!(ticks, 3_600_000 * 1_000_001 / 8 / TICK_NS);
    }

    #[test]
    fn a_long_stop_is_not_caught_up() {
        assert_eq!(TickClock::default().ticks(60_000_000_000, PlaybackSpeed::REAL), 100);
    }

    #[test]
    fn speeds_double_and_halve_between_an_eighth_and_eight() {
        let fastest = (0..9).fold(PlaybackSpeed::REAL, |speed, _| speed.faster());
        let slowest = (0..9).fold(PlaybackSpeed::REAL, |speed, _| speed.slower());
        assert_eq!((fastest.label(), slowest.label()), ("\u{d7}8".to_string(), "\u{d7}1/8".to_string()));
        assert_eq!(slowest.faster().faster().faster(), PlaybackSpeed::REAL);
    }
}
