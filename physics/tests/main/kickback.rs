//! Rods: a kickback shoots when the rules say so, a plunger as far as it is pulled.

use crate::fixture::*;
use geometry::{DVec2, Shape};
use physics::*;

/// The table's kickback at the lower end of a lane, and a ball that rolls down to it.
fn lane() -> Machine {
    let mut layout = bare();
    let tip = v(0.06, 1.0);
    layout.parts.push(part("kickback", Kind::Kickback(kickback(tip))));
    let side = |x: f64| Shape::capsule(v(x, 0.3), v(x, 1.06), 0.002);
    layout.parts.push(part("lane", walls(vec![side(tip.x - 0.017), side(tip.x + 0.017)], METAL)));
    live(layout)
}

fn kick(machine: &mut Machine) {
    machine.tick(Controls::default(), &[Command::Kick(PartId(0))]);
}

fn out(machine: &Machine) -> f64 {
    machine.pose().extensions[0].1
}

#[test]
fn its_switch_closes_when_a_ball_comes_to_it_and_it_waits_for_the_rules() {
    let mut machine = lane();
    machine.put_ball(v(0.06, 0.97), DVec2::ZERO, [0.0; 3]);
    assert_eq!(run(&mut machine, 3000, EventKind::Closed), 1, "once, though the ball bounces a little");
    let ball = machine.pose().balls[0];
    assert!(ball.velocity.length() < 1e-3 && (ball.center.y - (1.0 - BALL_RADIUS_M)).abs() < 1e-4, "{ball:?}");
    assert_eq!(out(&machine), 0.0);
}

#[test]
fn it_throws_what_lies_on_it_at_its_speed_and_goes_back() {
    let mut machine = lane();
    machine.put_ball(v(0.06, 0.95), DVec2::ZERO, [0.0; 3]);
    run(&mut machine, 2000, EventKind::Closed);
    kick(&mut machine);
    let (mut fastest, mut farthest, mut ticks, mut opened) = (0.0_f64, 0.0_f64, 0, 0);
    for tick in 0..120 {
        machine.tick(Controls::default(), &[]);
        opened += machine.events().iter().filter(|event| event.kind == EventKind::Opened).count();
        let speed = -machine.pose().balls[0].velocity.y;
        if speed > fastest {
            (fastest, ticks) = (speed, tick);
        }
        farthest = farthest.max(out(&machine));
        assert!(machine.penetration_m() < 5e-5);
    }
    println!("{fastest} m/s after {ticks} ms");
    assert!((fastest / 3.5 - 1.0).abs() < 0.02, "{fastest} m/s");
    // Evenly accelerated over 25 mm to 3.5 m/s: 2 s / v.
    assert!((12..=17).contains(&ticks), "{ticks} ms");
    assert!(farthest == 1.0 && out(&machine) == 0.0 && opened == 1);
    assert_eq!(machine.pose().balls.len(), 1);
}

#[test]
fn a_ball_that_meets_it_on_its_way_out_is_thrown_back_too() {
    for delay in 0..12 {
        let mut machine = lane();
        machine.put_ball(v(0.06, 0.98 - BALL_RADIUS_M), v(0.0, 2.0), [0.0; 3]);
        (0..delay).for_each(|_| machine.tick(Controls::default(), &[]));
        kick(&mut machine);
        run(&mut machine, 40, EventKind::Closed);
        let ball = machine.pose().balls[0];
        assert!(ball.velocity.y < -0.5 && ball.center.y < 0.98, "kicked after {delay} ms: {ball:?}");
    }
}

#[test]
fn it_is_dead_while_kickers_are_and_fires_in_a_ball_search() {
    let mut machine = lane();
    machine.put_ball(v(0.06, 0.95), DVec2::ZERO, [0.0; 3]);
    run(&mut machine, 2000, EventKind::Closed);
    machine.tick(Controls::default(), &[Command::SetCoils(false), Command::Kick(PartId(0))]);
    run(&mut machine, 100, EventKind::Closed);
    assert!(out(&machine) == 0.0 && machine.pose().balls[0].velocity.length() < 1e-3);
    machine.tick(Controls::default(), &[Command::BallSearch]);
    run(&mut machine, 30, EventKind::Closed);
    assert!(machine.pose().balls[0].velocity.y < -3.0);
}

/// A ball on the table's plunger, pulled by this part of its stroke and let go: ticks until it is launched, and its speed.
fn plunged(pull: f64) -> (usize, f64) {
    let mut machine = live(table());
    machine.tick(Controls::default(), &[Command::AddBall]);
    run(&mut machine, 1500, EventKind::Fed);
    for _ in 0..(pull * 800.0) as usize {
        machine.tick(Controls { plunger: true, ..Controls::default() }, &[]);
    }
    for tick in 0..200 {
        machine.tick(Controls::default(), &[]);
        if machine.events().iter().any(|event| event.kind == EventKind::Launched) {
            return (tick, -machine.pose().balls[0].velocity.y);
        }
    }
    panic!("never launched after a pull of {pull}");
}

#[test]
fn a_plunger_strikes_about_30_ms_after_it_is_let_go_in_proportion_to_its_pull() {
    for pull in [0.2, 0.4, 0.6, 0.8, 1.0] {
        let (ticks, speed) = plunged(pull);
        println!("{pull}: {ticks} ms, {speed} m/s");
        assert!((27..=33).contains(&ticks), "{pull}: {ticks} ms");
        assert!((speed / (3.5 * pull) - 1.0).abs() < 0.01, "{pull}: {speed} m/s");
    }
    assert!((3.0..4.0).contains(&plunged(1.0).1));
}
