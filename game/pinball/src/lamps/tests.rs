//! Filaments and their orders.

use super::{FINE, LampEffect, Mode, filament};

#[test]
fn a_filament_arrives_exactly_and_cools_slower_than_it_heats() {
    let time = |from: i32, to: i32| {
        let mut level = from;
        (1..).find(|_| {
            level = filament(level, to);
            level == to
        })
    };
    let (heating, cooling) = (time(0, 1000 * FINE), time(1000 * FINE, 0));
    assert!(heating.is_some() && heating < cooling, "{heating:?} {cooling:?}");
    assert!(cooling < Some(600), "{cooling:?} ms");
}

#[test]
fn every_mode_keeps_within_its_range_and_repeats_after_its_period() {
    for mode in [Mode::Steady(300), Mode::Blink, Mode::Pulse, Mode::Breathe, Mode::Strobe, Mode::Chase] {
        for (period_ms, shift_ms) in [(1, 0), (7, 3), (1000, 250), (1400, 5000)] {
            let effect = LampEffect { mode, period_ms, shift_ms };
            for tick in 0..2000 {
                assert!(effect.level(tick) <= 1000, "{effect:?} at {tick}");
                assert_eq!(effect.level(tick), effect.level(tick + u64::from(period_ms)), "{effect:?} at {tick}");
            }
        }
    }
}

#[test]
fn a_shifted_lamp_does_the_same_later() {
    let first = LampEffect { mode: Mode::Chase, period_ms: 700, shift_ms: 0 };
    let second = LampEffect { shift_ms: 100, ..first };
    assert!((0..2000).all(|tick| first.level(tick) == second.level(tick + 100)));
}

#[test]
fn a_swell_has_no_jump() {
    let effect = LampEffect { mode: Mode::Pulse, period_ms: 1200, shift_ms: 0 };
    let jump = (0..2400).map(|tick| effect.level(tick).abs_diff(effect.level(tick + 1))).max();
    assert!(jump <= Some(4), "{jump:?}");
}
