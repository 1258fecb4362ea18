//! The cabinet rings as a real one does, and only haste tilts it.

use crate::fixture::*;
use geometry::{DVec2, Shape};
use physics::*;

/// The four pushes: their names, and the way that the cabinet goes first.
const PUSHES: [(&str, DVec2); 4] =
    [("to the right", DVec2::X), ("to the left", DVec2::NEG_X), ("forwards", DVec2::NEG_Y), ("backwards", DVec2::Y)];
/// How long a hand is held against the cabinet: longer than the push that it gives.
const HAND_TICKS: usize = 30;

fn pushed(push: usize) -> Controls {
    Controls {
        nudge_left: push == 0,
        nudge_right: push == 1,
        nudge_up: push == 2,
        nudge_down: push == 3,
        ..Controls::default()
    }
}

/// Pushes at these ticks for `ticks`. Returns how often the bob touched, how often the slam switch closed, and where
/// the cabinet was after each tick.
fn shake(push: usize, at: &[usize], ticks: usize) -> (Vec<usize>, usize, Vec<DVec2>) {
    let mut machine = live(bare());
    let (mut touches, mut slams, mut places) = (Vec::new(), 0, Vec::new());
    for tick in 0..ticks {
        let down = at.iter().any(|&start| (start..start + HAND_TICKS).contains(&tick));
        machine.tick(if down { pushed(push) } else { Controls::default() }, &[]);
        for event in machine.events() {
            match event.kind {
                EventKind::TiltBob => touches.push(tick),
                EventKind::Slam => slams += 1,
                _ => {}
            }
        }
        places.push(machine.pose().cabinet_m);
    }
    (touches, slams, places)
}

#[test]
fn a_push_moves_the_cabinet_its_way_by_three_to_five_millimetres() {
    for (push, (name, way)) in PUSHES.iter().enumerate() {
        let (touches, slams, places) = shake(push, &[0], 1000);
        let farthest = places.iter().map(|place| place.length()).fold(0.0, f64::max);
        let first = places[25].dot(*way);
        println!("{name}: {:.2} mm at most, {:.2} mm after 25 ms", farthest * 1e3, first * 1e3);
        assert!((0.003..0.005).contains(&farthest), "{name}: {farthest} m");
        assert!(first > 1e-3 && places[25].perp_dot(*way).abs() < 1e-12, "{name}: {}", places[25]);
        assert_eq!((touches.len(), slams), (0, 0), "{name}");
    }
}

#[test]
fn a_push_lasts_25_ms_and_gives_the_cabinet_half_a_g() {
    for (push, (name, way)) in PUSHES.iter().enumerate() {
        let (_, _, places) = shake(push, &[0], 60);
        let at = |tick: usize| if tick == 0 { 0.0 } else { places[tick - 1].dot(*way) };
        let accelerations: Vec<f64> =
            (1..50).map(|tick| (at(tick + 1) - 2.0 * at(tick) + at(tick - 1)) * 1e6).collect();
        let peak = accelerations.iter().copied().fold(0.0, f64::max) / 9.81;
        let speed = (at(25) - at(24)) * 1e3;
        let mean = speed / 0.025 / 9.81;
        println!("{name}: peak {peak:.2} g, mean {mean:.2} g, {speed:.3} m/s");
        assert!((0.4..0.6).contains(&mean) && peak < 1.25, "{name}: peak {peak} g, mean {mean} g");
        // After the push nothing but the legs acts, and they pull back.
        assert!(accelerations[26..].iter().all(|a| *a < 0.0), "{name}: {:?}", &accelerations[20..30]);
        assert!(accelerations[..18].iter().all(|a| *a > 0.0), "{name}: {:?}", &accelerations[..20]);
    }
}

/// Frequency and damping ratio of a decaying swing: from its zeros and its extremes.
fn ringing(swing: &[f64]) -> (f64, f64) {
    let zeros: Vec<f64> = (1..swing.len())
        .filter(|&tick| swing[tick - 1] < 0.0 && swing[tick] >= 0.0)
        .map(|tick| tick as f64 - swing[tick] / (swing[tick] - swing[tick - 1]))
        .collect();
    let periods = 4;
    let frequency = periods as f64 * 1e3 / (zeros[periods] - zeros[0]);
    let crest = |from: f64, to: f64| swing[from as usize..to as usize].iter().copied().fold(0.0, f64::max);
    let decay = crest(zeros[0], zeros[1]) / crest(zeros[periods - 1], zeros[periods]);
    let decrement = libm::log(decay) / (periods - 1) as f64;
    let full_turn = std::f64::consts::TAU;
    (frequency, decrement / (full_turn * full_turn + decrement * decrement).sqrt())
}

#[test]
fn the_cabinet_rings_at_its_frequencies_and_comes_to_rest() {
    for (push, (name, way)) in PUSHES.iter().enumerate() {
        let (_, _, places) = shake(push, &[0], 3000);
        let swing: Vec<f64> = places[30..].iter().map(|place| place.dot(*way)).collect();
        let (hertz, damping) = ringing(&swing);
        println!("{name}: {hertz:.3} Hz, damping {damping:.4}");
        let (wanted_hertz, wanted_damping) = if push < 2 { (9.3, 0.052) } else { (5.8, 0.055) };
        assert!((hertz / wanted_hertz - 1.0).abs() < 0.03, "{name}: {hertz} Hz");
        assert!((damping / wanted_damping - 1.0).abs() < 0.10, "{name}: {damping}");
        assert!(places[2999].length() < 1e-4, "{name}: it has come to rest");
    }
}

#[test]
fn three_firm_pushes_a_second_apart_do_not_tilt_and_three_in_a_hurry_do_but_do_not_slam() {
    for (push, (name, _)) in PUSHES.iter().enumerate() {
        let (touches, slams, _) = shake(push, &[100, 1100, 2100], 4000);
        assert_eq!((touches.len(), slams), (0, 0), "{name}");
        for gap in [40, 60, 80, 120, 160, 200, 240, 280, 290, 300] {
            let (touches, slams, _) = shake(push, &[100, 100 + gap, 100 + 2 * gap], 4000);
            assert!(!touches.is_empty(), "{name}, {gap} ms apart");
            assert_eq!(slams, 0, "{name}, {gap} ms apart");
        }
    }
}

#[test]
fn five_pushes_within_600_ms_slam_once() {
    for (push, (name, _)) in PUSHES.iter().enumerate() {
        for gap in [50, 80, 100, 120, 150] {
            let pushes: Vec<usize> = (0..5).map(|number| 100 + number * gap).collect();
            let (touches, slams, _) = shake(push, &pushes, 3000);
            assert!(!touches.is_empty() && slams == 1, "{name}, {gap} ms apart: {slams} slams, bob at {touches:?}");
        }
        let calm: Vec<usize> = (0..8).map(|number| 100 + number * 500).collect();
        assert_eq!(shake(push, &calm, 5000).1, 0, "{name}: eight pushes half a second apart");
    }
}

#[test]
fn no_three_pushes_slam_however_they_are_mixed() {
    for mixed in [[0, 2, 1], [0, 2, 0], [2, 3, 2], [1, 3, 2]] {
        for gap in [1, 5, 12, 24, 25, 30, 40] {
            let mut machine = live(bare());
            for tick in 0..1000 {
                let down = |number: usize| (number * gap..number * gap + HAND_TICKS).contains(&tick);
                let of = |push: usize| (0..3).any(|number| mixed[number] == push && down(number));
                let controls = Controls {
                    nudge_left: of(0),
                    nudge_right: of(1),
                    nudge_up: of(2),
                    nudge_down: of(3),
                    ..Controls::default()
                };
                machine.tick(controls, &[]);
                let slam = machine.events().iter().any(|event| event.kind == EventKind::Slam);
                assert!(!slam, "{mixed:?}, {gap} ms apart");
            }
        }
    }
}

#[test]
fn a_bob_that_goes_on_swinging_counts_every_300_ms_and_no_oftener() {
    let pushes: Vec<usize> = (0..12).map(|number| 100 + number * 110).collect();
    let (touches, _, _) = shake(0, &pushes, 3000);
    assert!(touches.len() > 2, "{touches:?}");
    assert!(touches.windows(2).all(|pair| pair[1] - pair[0] >= 300), "{touches:?}");
}

#[test]
fn a_free_ball_stays_where_it_is_when_the_cabinet_moves() {
    for (push, (name, _)) in PUSHES.iter().enumerate() {
        let mut layout = bare();
        layout.slope_rad = 0.0;
        let mut machine = live(layout);
        machine.put_ball(v(0.25, 0.5), DVec2::ZERO, [0.0; 3]);
        let (mut ball, mut cabinet): (f64, f64) = (0.0, 0.0);
        for tick in 0..60 {
            machine.tick(if tick < HAND_TICKS { pushed(push) } else { Controls::default() }, &[]);
            let pose = machine.pose();
            ball = ball.max((pose.balls[0].center + pose.cabinet_m - v(0.25, 0.5)).length());
            cabinet = cabinet.max(pose.cabinet_m.length());
        }
        assert!(ball < 0.3 * cabinet, "{name}: the ball moves {ball} m, the cabinet {cabinet} m; rolling would be 2/7");
    }
}

/// What a guide throws a ball that lies at it, by the time at which the cabinet is back where it stands.
#[test]
fn a_ball_that_touches_metal_moves_by_six_to_ten_millimetres() {
    for (push, (name, way)) in PUSHES.iter().enumerate() {
        let mut layout = bare();
        layout.slope_rad = 0.0;
        let (ball, across) = (v(0.25, 0.5), way.perp() * 0.1);
        let foot = ball - *way * (BALL_RADIUS_M + 0.002);
        layout.parts.push(part("guide", walls(vec![Shape::capsule(foot - across, foot + across, 0.002)], METAL)));
        let mut machine = live(layout);
        machine.put_ball(ball, DVec2::ZERO, [0.0; 3]);
        let mut moved = 0.0;
        for tick in 0..200 {
            machine.tick(if tick < HAND_TICKS { pushed(push) } else { Controls::default() }, &[]);
            let pose = machine.pose();
            moved = (pose.balls[0].center - ball).dot(*way);
            if tick > 20 && pose.cabinet_m.dot(*way) <= 0.0 {
                break;
            }
        }
        println!("{name}: {:.2} mm", moved * 1e3);
        assert!((0.006..0.010).contains(&moved), "{name}: {moved} m");
    }
}
