//! Which resolution of light holds the monitor's rate.
//!
//! Half of it as soon as the full one is too slow for a while; back when there has been ample room for the full one for
//! a while, and the longer the more often that has been a mistake. It reads no clock: it is told what each frame took.

use super::LightResolution;

/// The part of a frame's time that may be used to draw it: the rest is for the game and for showing it.
const ROOM: f64 = 0.9;
/// The part that the full resolution must be expected to need, for it to be tried again.
const AMPLE: f64 = 0.65;
/// How long a need is averaged over, ms.
const AVERAGED_MS: f64 = 400.0;
/// How long it must be too slow, ms.
const SLOW_MS: f64 = 800.0;
/// How long there must be ample room at first, ms, and at most.
const PATIENCE_MS: [f64; 2] = [5_000.0, 300_000.0];
/// The full resolution was no mistake if it has been held this long, ms.
const HELD_MS: f64 = 30_000.0;
/// Frames after a change that say nothing: art is rasterized for them.
const UNSETTLED: u32 = 5;
/// No frame counts for more than this many times its time: one that waited for the system is no reason.
const MOST_NEED: f64 = 3.0;
/// How many times as long as at half the resolution a frame takes at the full one, until that has been measured.
const USUAL_RATIO: f64 = 2.0;

/// The choice, and what it is made by.
#[derive(Clone, Copy, Debug)]
pub struct DynamicResolution {
    light: LightResolution,
    /// The part of a frame's time that drawing it needs, averaged.
    need: Option<f64>,
    /// How long it has been a reason for a change, ms.
    reason_ms: f64,
    /// How long ago the last change was, ms.
    since_ms: f64,
    unsettled: u32,
    patience_ms: f64,
    /// What the full resolution needed when it was given up.
    full_need: f64,
    /// How many times as much it needs as half of it.
    ratio: f64,
    /// Half the resolution was measured to need more: it is not tried again.
    useless: bool,
}

impl Default for DynamicResolution {
    fn default() -> DynamicResolution {
        DynamicResolution {
            light: LightResolution::Full,
            need: None,
            reason_ms: 0.0,
            since_ms: 0.0,
            unsettled: UNSETTLED,
            patience_ms: PATIENCE_MS[0],
            full_need: 0.0,
            ratio: USUAL_RATIO,
            useless: false,
        }
    }
}

impl DynamicResolution {
    /// The resolution of the next frame.
    pub fn light(&self) -> LightResolution {
        self.light
    }

    /// A frame took `drawn_ms` to draw, where the monitor shows one every `budget_ms`.
    pub fn judge(&mut self, drawn_ms: f64, budget_ms: f64) {
        if !(drawn_ms.is_finite() && drawn_ms >= 0.0 && budget_ms > 0.0) {
            return;
        }
        let passed_ms = drawn_ms.clamp(budget_ms, MOST_NEED * budget_ms);
        self.since_ms += passed_ms;
        if self.unsettled > 0 {
            self.unsettled -= 1;
            return;
        }
        let need = (drawn_ms / budget_ms).min(MOST_NEED);
        let before = self.need.unwrap_or(need);
        let need = before + (need - before) * (passed_ms / AVERAGED_MS).min(1.0);
        self.need = Some(need);
        match self.light {
            LightResolution::Full => self.look_at_full(need, passed_ms),
            LightResolution::Half => self.look_at_half(need, passed_ms),
        }
    }

    fn look_at_full(&mut self, need: f64, passed_ms: f64) {
        self.reason_ms = if need > ROOM { self.reason_ms + passed_ms } else { 0.0 };
        if self.since_ms > HELD_MS {
            self.patience_ms = PATIENCE_MS[0];
        }
        if self.reason_ms >= SLOW_MS && !self.useless {
            self.full_need = need;
            self.change(LightResolution::Half);
        }
    }

    fn look_at_half(&mut self, need: f64, passed_ms: f64) {
        if self.full_need > 0.0 && self.since_ms > 2.0 * AVERAGED_MS {
            if need > self.full_need {
                self.useless = true;
                return self.change(LightResolution::Full);
            }
            self.ratio = (self.full_need / need.max(1e-3)).clamp(1.2, 6.0);
            self.full_need = 0.0;
        }
        self.reason_ms = if need * self.ratio < AMPLE { self.reason_ms + passed_ms } else { 0.0 };
        if self.reason_ms >= self.patience_ms {
            // If it is not held, the next try waits twice as long.
            self.patience_ms = (2.0 * self.patience_ms).min(PATIENCE_MS[1]);
            self.change(LightResolution::Full);
        }
    }

    fn change(&mut self, light: LightResolution) {
        (self.light, self.need, self.reason_ms, self.since_ms, self.unsettled) = (light, None, 0.0, 0.0, UNSETTLED);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_that_needs_more_is_given_up_for_good() {
        let (quality, changes) = run(120.0, |_| 1.2 * BUDGET_MS, |_| 2.0 * BUDGET_MS);
        assert_eq!(quality.light(), LightResolution::Full);
        assert_eq!(changes.len(), 2, "{changes:?}");
    }

    const BUDGET_MS: f64 = 1000.0 / 60.0;

    /// Runs for some seconds on a machine that needs `full_ms(seconds)` for a frame and `half_ms(seconds)` at half the
    /// resolution; gives the times of the changes, s.
    fn run(seconds: f64, full_ms: impl Fn(f64) -> f64, half_ms: impl Fn(f64) -> f64) -> (DynamicResolution, Vec<f64>) {
        let (mut quality, mut now_s, mut changes) = (DynamicResolution::default(), 0.0, Vec::new());
        while now_s < seconds {
            let light = quality.light();
            let drawn_ms = if light == LightResolution::Full { full_ms(now_s) } else { half_ms(now_s) };
            quality.judge(drawn_ms, BUDGET_MS);
            now_s += drawn_ms.max(BUDGET_MS) / 1000.0;
            if quality.light() != light {
                changes.push(now_s);
            }
        }
        (quality, changes)
    }

    #[test]
    fn a_fast_machine_stays_at_the_full_resolution() {
        let (quality, changes) = run(600.0, |_| 11.0, |_| 5.0);
        assert_eq!((quality.light(), changes), (LightResolution::Full, vec![]));
    }

    #[test]
    fn a_slow_machine_goes_to_half_within_two_seconds_and_stays() {
        let (quality, changes) = run(600.0, |_| 24.0, |_| 10.0);
        assert_eq!((quality.light(), changes.len()), (LightResolution::Half, 1));
        assert!(changes[0] < 2.0, "{changes:?}");
    }

    #[test]
    fn one_slow_moment_is_no_reason() {
        let hitch = |now_s: f64| if (7.0..7.4).contains(&now_s) || (9.0..9.02).contains(&now_s) { 300.0 } else { 9.0 };
        assert!(run(60.0, hitch, |_| 4.0).1.is_empty());
    }

    #[test]
    fn it_comes_back_when_there_is_ample_room_again() {
        let busy = |now_s: f64| (10.0..40.0).contains(&now_s);
        let full = |now_s: f64| if busy(now_s) { 25.0 } else { 8.0 };
        let half = |now_s: f64| if busy(now_s) { 11.0 } else { 3.6 };
        let (quality, changes) = run(120.0, full, half);
        assert_eq!((quality.light(), changes.len()), (LightResolution::Full, 2), "{changes:?}");
        assert!((10.0..12.5).contains(&changes[0]) && (45.0..50.0).contains(&changes[1]), "{changes:?}");
    }

    /// Half looks cheap, and the full resolution is not: each try costs a second, so tries must become rare.
    #[test]
    fn it_does_not_flap_where_half_promises_too_much() {
        let noise = |now_s: f64| 1.0 + 0.2 * (now_s * 7.3 - (now_s * 7.3).floor());
        let half = |now_s: f64| if now_s < 4.0 { 8.0 } else { 3.0 * noise(now_s) };
        let (_, changes) = run(600.0, |now_s| 17.0 * noise(now_s), half);
        assert!(changes.len() <= 14, "{changes:?}");
        let last: Vec<f64> = changes.iter().copied().filter(|at| *at > 300.0).collect();
        assert!(last.len() <= 4, "{changes:?}");
    }

    #[test]
    fn on_the_edge_it_settles() {
        let wave = |now_s: f64| if now_s % 6.0 < 3.0 { 16.4 } else { 13.0 };
        let (_, changes) = run(600.0, wave, |now_s| wave(now_s) * 0.5);
        assert!(changes.len() <= 1, "{changes:?}");
    }

    #[test]
    fn nonsense_is_not_judged() {
        let mut quality = DynamicResolution::default();
        for (drawn_ms, budget_ms) in [(f64::NAN, 16.0), (-1.0, 16.0), (5.0, 0.0), (f64::INFINITY, 16.0)] {
            (0..1000).for_each(|_| quality.judge(drawn_ms, budget_ms));
        }
        assert_eq!(quality.light(), LightResolution::Full);
    }
}
