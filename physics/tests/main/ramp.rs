//! Ways above the playfield: up, along, down, off the end, and what passes below.

use crate::fixture::*;
use geometry::{Arc, Circle, DVec2, Segment};
use physics::*;
use std::sync::Arc as Shared;

const HALF_WIDTH_M: f64 = 0.022;
/// What presses a ball down, m/s^2.
const PRESS: f64 = 9.81;

fn leg(a: DVec2, b: DVec2) -> Leg {
    Leg::Line(Segment { a, b })
}

fn ramp(path: Vec<Leg>, heights_m: Vec<f64>) -> Part {
    part("ramp", Kind::Ramp(Ramp { path, heights_m, half_width_m: HALF_WIDTH_M, material: WOOD }))
}

/// A level playfield with a straight ramp up the table: 200 mm up to 60 mm, then 200 mm on at that height.
fn straight() -> Layout {
    straight_up_to(0.06)
}

fn straight_up_to(height: f64) -> Layout {
    let mut layout = bare();
    layout.slope_rad = 0.0;
    let (mouth, top, end) = (v(0.25, 0.8), v(0.25, 0.6), v(0.25, 0.4));
    layout.parts = vec![ramp(vec![leg(mouth, top), leg(top, end)], vec![0.0, height, height])];
    layout
}

fn rolling(machine: &mut Machine, center: DVec2, velocity: DVec2) {
    machine.put_ball(center, velocity, [-velocity.y / BALL_RADIUS_M, velocity.x / BALL_RADIUS_M, 0.0]);
}

fn ball(machine: &Machine) -> BallPose {
    machine.pose().balls[0]
}

fn until(machine: &mut Machine, most: usize, so: impl Fn(&BallPose) -> bool) -> Option<usize> {
    (0..most).find(|_| {
        machine.tick(Controls::default(), &[]);
        assert!(machine.penetration_m() < 5e-5, "{} m deep", machine.penetration_m());
        so(&ball(machine))
    })
}

#[test]
fn a_ball_that_rolls_up_loses_what_the_height_costs() {
    let mut machine = machine(straight());
    rolling(&mut machine, v(0.25, 0.85), v(0.0, -1.5));
    let mut before = 0.0;
    until(&mut machine, 1000, |ball| ball.center.y < 0.80).expect("it goes in");
    while ball(&machine).center.y > 0.5 {
        machine.tick(Controls::default(), &[]);
        let now = ball(&machine);
        assert!(now.above && now.height_m >= before && now.height_m - before < 1e-3, "{before}, then {now:?}");
        before = now.height_m;
    }
    let top = ball(&machine);
    let wanted = (1.5_f64 * 1.5 - 10.0 / 7.0 * PRESS * 0.06).sqrt();
    println!("{} m/s at the top, {wanted} by energy", -top.velocity.y);
    assert!((top.height_m - 0.06).abs() < 1e-12);
    assert!((-top.velocity.y / wanted - 1.0).abs() < 0.01, "{} m/s, not {wanted}", -top.velocity.y);
}

#[test]
fn a_slow_ball_comes_back_out_of_the_mouth_as_fast() {
    // So gentle that it never slips: its steepest needs 2/7 of 0.26, and the floor's friction is 0.09.
    let mut machine = machine(straight_up_to(0.035));
    rolling(&mut machine, v(0.25, 0.83), v(0.0, -0.6));
    let highest = until(&mut machine, 2000, |ball| ball.velocity.y > 0.0 && ball.height_m > 0.0);
    assert!(highest.is_some() && ball(&machine).height_m < 0.035);
    until(&mut machine, 2000, |ball| ball.center.y > 0.83).expect("it comes back");
    let back = ball(&machine);
    assert!(!back.above && back.height_m == 0.0);
    assert!((back.velocity.y / 0.6 - 1.0).abs() < 0.02, "{} m/s", back.velocity.y);
}

#[test]
fn a_ball_passes_below_where_the_floor_is_high_and_not_where_it_is_low() {
    for (y, passes) in [(0.5, true), (0.62, true), (0.72, false), (0.79, false)] {
        let mut machine = machine(straight());
        rolling(&mut machine, v(0.15, y), v(1.0, 0.0));
        let over = until(&mut machine, 400, |ball| ball.center.x > 0.32);
        assert_eq!(over.is_some(), passes, "at y = {y}: {:?}", ball(&machine));
        assert!(!ball(&machine).above && ball(&machine).height_m == 0.0, "it never was on it");
    }
    let mut machine = machine(straight());
    rolling(&mut machine, v(0.25, 0.5), v(0.0, 1.0));
    until(&mut machine, 400, |ball| ball.velocity.y < 0.0).expect("the room below the ramp ends where it gets low");
}

#[test]
fn a_ball_that_comes_off_the_end_falls_in_its_time_and_closes_the_switch_once() {
    let mut machine = machine(straight());
    rolling(&mut machine, v(0.25, 0.85), v(0.0, -1.8));
    let (mut off, mut down, mut closed, mut before) = (None, None, 0, 0.0_f64);
    for tick in 0..1500 {
        machine.tick(Controls::default(), &[]);
        closed += machine.events().iter().filter(|event| event.kind == EventKind::Closed).count();
        let now = ball(&machine);
        assert!((now.height_m - before).abs() < 2e-3, "from {before} to {}", now.height_m);
        off = off.or((now.center.y < 0.4).then_some(tick));
        down = down.or((off.is_some() && now.height_m < 1e-3).then_some(tick));
        before = now.height_m;
    }
    let fall = (down.expect("it lands") - off.expect("it comes off")) as f64 * 1e-3;
    let wanted = (2.0 * 0.06 / PRESS).sqrt();
    assert!((fall - wanted).abs() < 3e-3, "it falls for {fall} s, not {wanted}");
    assert_eq!(closed, 1);
    assert_eq!(ball(&machine).height_m, 0.0, "it has stopped bouncing");
}

/// Up, half a turn, and down again to another way that is joined to it.
fn winding() -> Layout {
    let mut layout = bare();
    let turn = |start: f64| Arc::new(Circle { center: v(0.25, 0.5), radius: 0.06 }, start, std::f64::consts::PI);
    let (up, down) = (0.19, 0.31);
    layout.parts = vec![
        ramp(
            vec![leg(v(up, 0.75), v(up, 0.5)), Leg::Turn { arc: turn(std::f64::consts::PI), backwards: false }],
            vec![0.0, 0.05, 0.05],
        ),
        ramp(vec![leg(v(down, 0.5), v(down, 0.7)), leg(v(down, 0.7), v(down, 0.8))], vec![0.05, 0.03, 0.03]),
    ];
    layout
}

#[test]
fn a_ball_goes_round_a_turn_and_over_to_the_next_way() {
    let mut machine = machine(winding());
    rolling(&mut machine, v(0.19, 0.8), v(0.0, -2.2));
    let mut switches = Vec::new();
    for _ in 0..2000 {
        machine.tick(Controls::default(), &[]);
        assert!(machine.penetration_m() < 5e-5);
        let closed = machine.events().iter().filter(|event| event.kind == EventKind::Closed);
        switches.extend(closed.filter_map(|event| event.part));
    }
    assert_eq!(switches, [PartId(0), PartId(1)], "{:?}", ball(&machine));
    assert!(ball(&machine).center.x > 0.28 && ball(&machine).center.y > 0.8, "it has gone on: {:?}", ball(&machine));
}

#[test]
fn a_wide_way_that_goes_on_in_a_narrow_one_leads_every_ball_into_it() {
    let mut layout = straight();
    let narrow = Ramp {
        path: vec![leg(v(0.25, 0.4), v(0.25, 0.2))],
        heights_m: vec![0.06, 0.05],
        half_width_m: 0.015,
        material: WOOD,
    };
    layout.parts.push(part("wires", Kind::Ramp(narrow)));
    let mut chance = Chance(9);
    let mut through = 0;
    for _ in 0..200 {
        let mut machine = machine(layout.clone());
        let aside = chance.between(-0.008, 0.008);
        rolling(&mut machine, v(0.25 + aside, 0.85), v(chance.between(-0.3, 0.3), chance.between(-5.0, -1.8)));
        let end = until(&mut machine, 2500, |ball| ball.center.y < 0.19 || ball.center.y > 0.9);
        assert!(end.is_some(), "it goes through or comes back: {:?}", ball(&machine));
        through += u32::from(ball(&machine).center.y < 0.19);
    }
    println!("{through} of 200 go through, the others bounce back");
    assert!(through > 120, "{through} of 200");
}

#[test]
fn no_energy_is_made_above_the_playfield() {
    let gravity = PRESS * libm::sin(6.5_f64.to_radians());
    let press = PRESS * libm::cos(6.5_f64.to_radians());
    let energy = |ball: &BallPose| {
        let spin: f64 = ball.spin.iter().map(|s| s * s).sum();
        0.5 * ball.velocity.length_squared() + 0.2 * BALL_RADIUS_M * BALL_RADIUS_M * spin
            - gravity * (ball.center.y - 2.0)
            + press * ball.height_m
    };
    let mut chance = Chance(8);
    for _ in 0..40 {
        let mut machine = machine(winding());
        rolling(&mut machine, v(0.19, 0.8), v(chance.between(-0.3, 0.3), chance.between(-2.6, -1.0)));
        let mut before = energy(&ball(&machine));
        let mut start = before;
        for _ in 0..1500 {
            machine.tick(Controls::default(), &[]);
            let now = ball(&machine);
            let after = energy(&now);
            if now.above && now.height_m > 1e-4 {
                assert!(after <= before + 2e-4 * before, "{before} to {after} J/kg at {now:?}");
                assert!(after <= start * 1.002, "{start} to {after} J/kg at {now:?}");
            } else {
                start = after;
            }
            before = after;
        }
    }
}

#[test]
fn a_ball_that_falls_on_another_pushes_it_away_and_neither_sinks_in() {
    let mut machine = machine(straight());
    machine.put_ball(v(0.253, 0.385), DVec2::ZERO, [0.0; 3]);
    rolling(&mut machine, v(0.25, 0.85), v(0.0, -0.96));
    for _ in 0..3000 {
        machine.tick(Controls::default(), &[]);
        assert!(machine.penetration_m() < 5e-5, "{} m", machine.penetration_m());
    }
    let balls = machine.pose().balls;
    assert!(balls.iter().all(|ball| ball.height_m == 0.0), "{balls:?}");
    assert!(balls[0].center.distance(v(0.253, 0.385)) > 0.01, "it was pushed");
}

#[test]
fn balls_that_follow_each_other_off_the_end_do_not_sink_into_each_other() {
    for behind in [0.028, 0.04, 0.06] {
        let mut machine = machine(straight());
        for ball in 0..3 {
            rolling(&mut machine, v(0.25, 0.85 + behind * f64::from(ball)), v(0.0, -0.97));
        }
        for _ in 0..4000 {
            machine.tick(Controls::default(), &[]);
            assert!(machine.penetration_m() < 5e-5, "{behind} m apart: {} m deep", machine.penetration_m());
        }
        assert!(machine.pose().balls.iter().all(|ball| ball.height_m == 0.0), "{:?}", machine.pose().balls);
    }
}

#[test]
fn a_machine_saved_on_a_ramp_goes_on_as_if_nothing_had_been() {
    let layout = Shared::new(winding());
    let mut machine = Machine::new(layout.clone()).expect("fixture");
    rolling(&mut machine, v(0.19, 0.8), v(0.1, -2.2));
    for _ in 0..1200 {
        let mut restored = Machine::restore(layout.clone(), &machine.save()).expect("just saved");
        machine.tick(Controls::default(), &[]);
        restored.tick(Controls::default(), &[]);
        assert_eq!(restored.hashes(), machine.hashes());
    }
}

#[test]
fn ways_that_cannot_be_are_refused() {
    type Spoil = fn(&mut Ramp);
    let spoils: [Spoil; 5] = [
        |ramp| ramp.heights_m.truncate(2),
        |ramp| ramp.half_width_m = 0.012,
        |ramp| ramp.path[1] = leg(v(0.3, 0.6), v(0.3, 0.4)),
        |ramp| ramp.heights_m[1] = -0.01,
        |ramp| ramp.path.clear(),
    ];
    for (index, spoil) in spoils.into_iter().enumerate() {
        let mut layout = straight();
        let Kind::Ramp(ramp) = &mut layout.parts[0].kind else { unreachable!("it is a ramp") };
        spoil(ramp);
        let error = Machine::new(Shared::new(layout)).expect_err("this cannot be");
        assert!(matches!(&error, Error::Layout(_, text) if !text.is_empty()), "{index}: {error:?}");
    }
}
