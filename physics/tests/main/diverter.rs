//! A diverter: a flap that the rules turn, and no button.

use crate::fixture::*;
use geometry::DVec2;
use physics::*;

const PIVOT: DVec2 = DVec2::new(0.25, 0.5);
const TURN_RAD: f64 = 40.0 * std::f64::consts::PI / 180.0;

fn flap() -> Machine {
    let mut layout = bare();
    layout.slope_rad = 0.0;
    layout.parts.push(diverter(PIVOT));
    machine(layout)
}

/// How far it has turned from its rest, rad.
fn turned(machine: &Machine) -> f64 {
    machine.pose().flippers_rad[0].1 - std::f64::consts::FRAC_PI_2
}

fn divert(machine: &mut Machine, on: bool, ticks: usize) {
    machine.tick(Controls::default(), &[Command::Divert(PartId(0), on)]);
    run(machine, ticks, EventKind::Closed);
}

#[test]
fn the_rules_turn_it_there_and_back_and_buttons_do_not() {
    let mut machine = flap();
    let both = Controls { left: true, right: true, ..Controls::default() };
    machine.tick(both, &[Command::SetFlippers(true)]);
    (0..100).for_each(|_| machine.tick(both, &[]));
    assert_eq!(turned(&machine), 0.0);
    machine.tick(Controls::default(), &[Command::SetFlippers(false)]);
    divert(&mut machine, true, 60);
    assert!((turned(&machine) - TURN_RAD).abs() < 5e-3, "{} rad, with dead flippers", turned(&machine));
    divert(&mut machine, false, 150);
    assert!(turned(&machine).abs() < 5e-3, "{} rad", turned(&machine));
}

/// A ball comes at the flap's middle with `speed`, from the side that `side` says. Returns the speed across the flap with
/// which it is first thrown back, below 0; 0 if it is not.
fn bounce(diverted: bool, side: f64, speed: f64) -> f64 {
    let mut machine = flap();
    divert(&mut machine, diverted, 200);
    let along = geometry::trig::direction(std::f64::consts::FRAC_PI_2 + turned(&machine));
    let across = along.perp() * side;
    machine.put_ball(PIVOT + along * 0.025 - across * 0.03, across * speed, [0.0; 3]);
    let (mut deepest, mut thrown) = (f64::NEG_INFINITY, 0.0);
    for _ in 0..150 {
        machine.tick(Controls::default(), &[]);
        deepest = deepest.max(machine.penetration_m());
        let ball = machine.pose().balls[0];
        if thrown == 0.0 {
            thrown = ball.velocity.dot(across).min(0.0);
        }
        let angle = std::f64::consts::FRAC_PI_2 + turned(&machine);
        let passed = (ball.center - PIVOT).dot(geometry::trig::direction(angle).perp() * side) > 0.0;
        let beside = (ball.center - PIVOT).length() < 0.045;
        assert!(!(passed && beside), "{speed} m/s from {side} with {diverted}: it went through");
    }
    assert!(deepest < 5e-5, "{deepest} m deep");
    thrown
}

#[test]
fn no_ball_passes_it_from_either_side_in_either_position() {
    for diverted in [false, true] {
        for side in [-1.0, 1.0] {
            for speed in [0.2, 1.0, 3.0, 8.0, 15.0] {
                bounce(diverted, side, speed);
            }
        }
    }
}

#[test]
fn it_is_rigid_against_its_stops_and_gives_way_the_other_way() {
    // At rest its stop is behind it on the one side; on the other there is only the spring.
    assert!((bounce(false, -1.0, 1.0) + 0.3).abs() < 0.03, "off the stop: {}", bounce(false, -1.0, 1.0));
    let mut machine = flap();
    machine.put_ball(PIVOT + v(0.03, 0.03), v(-2.0, 0.0), [0.0; 3]);
    let mut most: f64 = 0.0;
    for _ in 0..100 {
        machine.tick(Controls::default(), &[]);
        most = most.max(turned(&machine));
    }
    assert!(most > 0.05, "the ball pushes it open by {most} rad");
    run(&mut machine, 400, EventKind::Closed);
    assert!(turned(&machine).abs() < 5e-3, "and the spring shuts it again: {} rad", turned(&machine));
}

#[test]
fn a_flap_that_turns_pushes_the_ball_before_it() {
    let mut machine = flap();
    machine.put_ball(PIVOT + v(-BALL_RADIUS_M - 0.003, 0.03), DVec2::ZERO, [0.0; 3]);
    divert(&mut machine, true, 60);
    let ball = machine.pose().balls[0];
    assert!(ball.velocity.x < -0.5, "{ball:?}");
}

#[test]
fn a_ball_that_lies_at_a_turned_diverter_is_stuck_and_not_cradled() {
    let mut layout = bare();
    layout.parts.push(diverter(v(0.25, 0.3)));
    layout.parts.push(part("wall", walls(vec![geometry::Shape::capsule(v(0.1, 0.36), v(0.35, 0.36), 0.002)], METAL)));
    let mut machine = machine(layout);
    divert(&mut machine, true, 100);
    machine.put_ball(v(0.2099, 0.3445), DVec2::ZERO, [0.0; 3]);
    run(&mut machine, 4000, EventKind::Closed);
    assert!(machine.pose().balls[0].velocity.length() < 1e-3);
    assert!(machine.stuck_ticks()[0] > 1000, "{:?}", machine.pose().balls);
}
