//! The flipper: how fast it is, and what it does to balls.

use crate::fixture::*;
use physics::*;

fn angle(machine: &Machine) -> f64 {
    machine.pose().flippers_rad[0].1.to_degrees()
}

fn lone_flipper() -> Machine {
    let mut layout = bare();
    layout.parts.push(flipper(true));
    let mut machine = machine(layout);
    machine.tick(Controls::default(), &[Command::SetFlippers(true)]);
    machine
}

#[test]
fn a_flipper_is_up_in_time_and_back_in_time() {
    let mut machine = lone_flipper();
    let up = Controls { left: true, ..Controls::default() };
    let mut arrival = 0;
    let mut fastest: f64 = 0.0;
    let mut last = angle(&machine);
    for tick in 1..200 {
        machine.tick(up, &[]);
        let now = angle(&machine);
        fastest = fastest.max((last - now).to_radians() * 1000.0);
        if arrival == 0 && now <= -23.0 {
            arrival = tick;
        }
        last = now;
    }
    let tip = fastest * 0.0675;
    let mut rest = 0;
    for tick in 1..300 {
        machine.tick(Controls::default(), &[]);
        let now = angle(&machine);
        if (now - 28.0).abs() > 0.5 {
            rest = tick + 1;
        }
    }
    println!("up in {arrival} ms, tip {tip} m/s, back in {rest} ms");
    assert!((19..=26).contains(&arrival), "up in {arrival} ms");
    assert!((85..=100).contains(&rest), "back in {rest} ms");
    assert!((5.0..=6.5).contains(&tip), "tip at {tip} m/s");
}

#[test]
fn longer_presses_lift_higher() {
    let mut last = 0.0;
    for press in [2, 4, 8, 12, 16, 24] {
        let mut machine = lone_flipper();
        let mut peak: f64 = 0.0;
        for tick in 0..150 {
            machine.tick(Controls { left: tick < press, ..Controls::default() }, &[]);
            peak = peak.max(28.0 - angle(&machine));
        }
        println!("{press} ms: {peak} deg");
        assert!(peak > last + 1e-3, "{press} ms lifts by {peak} deg, less by {last}");
        last = peak;
    }
}

#[test]
fn a_ball_lies_still_on_a_raised_flipper() {
    let mut machine = machine(table());
    let up = Controls { left: true, ..Controls::default() };
    machine.tick(up, &[Command::SetFlippers(true)]);
    (0..100).for_each(|_| machine.tick(up, &[]));
    machine.put_ball(v(0.13, 0.87), v(0.0, 0.0), [0.0; 3]);
    (0..2500).for_each(|_| machine.tick(up, &[]));
    let start = machine.pose().balls[0];
    println!("{start:?}");
    assert!(start.velocity.length() < 1e-3, "{start:?}");
    (0..10000).for_each(|_| machine.tick(up, &[]));
    let drift = machine.pose().balls[0].center.distance(start.center);
    assert!(drift < 5e-5, "drifts {drift} m");
}
