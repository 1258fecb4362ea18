//! A magnet holds what is slow, bends what is fast, and lets go when it is switched off.

use crate::fixture::*;
use geometry::DVec2;
use physics::*;

const MIDDLE: DVec2 = DVec2::new(0.25, 0.5);

fn table_with_magnet(slope_rad: f64, on: bool) -> Machine {
    let mut layout = with(Kind::Magnet(magnet(MIDDLE)));
    layout.slope_rad = slope_rad;
    let mut machine = live(layout);
    machine.tick(Controls::default(), &[Command::Magnet(PartId(0), on)]);
    machine
}

/// A ball that rolls at this velocity.
fn roll(machine: &mut Machine, center: DVec2, velocity: DVec2) {
    let spin = [-velocity.y / BALL_RADIUS_M, velocity.x / BALL_RADIUS_M, 0.0];
    machine.put_ball(center, velocity, spin);
}

#[test]
fn a_slow_ball_comes_to_rest_in_the_middle_and_is_held_on_the_slope() {
    for (x, speed) in [(0.25, 0.1), (0.262, 0.2), (0.23, 0.35)] {
        let mut machine = table_with_magnet(0.113, true);
        roll(&mut machine, v(x, 0.44), v(0.0, speed));
        assert_eq!(run(&mut machine, 3000, EventKind::Closed), 1, "from {x} at {speed} m/s");
        let ball = machine.pose().balls[0];
        let away = ball.center.distance(MIDDLE);
        println!("from {x} at {speed} m/s: {:.2} mm from the middle", away * 1e3);
        assert!(away < 0.006 && ball.velocity.length() < 1e-3 && !ball.held, "{ball:?}");
        let before = ball.center;
        assert_eq!(run(&mut machine, 10_000, EventKind::Opened), 0);
        assert!(machine.pose().balls[0].center.distance(before) < 1e-5, "it stays where it is");
        assert_eq!(machine.stuck_ticks(), [0], "a ball that a magnet holds is not stuck");
    }
}

#[test]
fn it_goes_on_when_the_magnet_is_switched_off() {
    for (command, name) in [
        (Command::Magnet(PartId(0), false), "switched off"),
        (Command::SetCoils(false), "dead"),
        (Command::BallSearch, "searched"),
    ] {
        let mut machine = table_with_magnet(0.113, true);
        roll(&mut machine, v(0.25, 0.44), v(0.0, 0.1));
        run(&mut machine, 3000, EventKind::Closed);
        assert!(machine.pose().magnets[0].1);
        machine.tick(Controls::default(), &[command]);
        assert!(!machine.pose().magnets[0].1, "{name}");
        assert_eq!(run(&mut machine, 1000, EventKind::Opened), 1, "{name}");
        assert!(machine.pose().balls[0].center.y > 0.8, "{name}: it rolls down the slope as ever");
    }
}

#[test]
fn a_fast_ball_is_bent_towards_it_and_goes_on() {
    let bend = |speed: f64, on: bool| {
        let mut machine = table_with_magnet(0.0, on);
        roll(&mut machine, v(0.15, 0.48), v(speed, 0.0));
        assert_eq!(run(&mut machine, (0.2 / speed * 1e3) as usize, EventKind::Closed), 0);
        let ball = machine.pose().balls[0];
        assert!(ball.center.x > 0.3, "{speed} m/s: {ball:?}");
        (ball.velocity.y / ball.velocity.x, ball.velocity.length() / speed)
    };
    let mut before = f64::INFINITY;
    for speed in [1.5, 2.5, 4.0, 7.0] {
        let (slope, left) = bend(speed, true);
        let degrees = libm::atan(slope).to_degrees();
        println!("{speed} m/s: bent by {degrees:.2} degrees, {left} of its speed left");
        assert!(slope > 0.0 && slope < before, "towards the middle, and the less the faster");
        assert!(left < 1.0 && left > 0.75, "{speed} m/s: {left}");
        assert!(bend(speed, false).0.abs() < 1e-9, "off, it does nothing");
        before = slope;
    }
}

#[test]
fn it_stops_a_ball_of_half_a_metre_a_second_and_not_one_of_one() {
    for (speed, caught) in [(0.3, 1), (0.5, 1), (1.0, 0)] {
        let mut machine = table_with_magnet(0.0, true);
        roll(&mut machine, MIDDLE + v(-0.046, 0.0), v(speed, 0.0));
        assert_eq!(run(&mut machine, 2000, EventKind::Closed), caught, "{speed} m/s");
    }
}

#[test]
fn it_gives_no_ball_any_speed() {
    let mut chance = Chance(9);
    for _ in 0..300 {
        let mut machine = table_with_magnet(0.0, true);
        let from = MIDDLE + v(-0.06, chance.between(-0.045, 0.045));
        let speed = chance.between(0.05, 6.0);
        roll(&mut machine, from, v(speed, chance.between(-0.5, 0.5) * speed));
        let first = machine.pose().balls[0].velocity.length();
        for _ in 0..3000 {
            machine.tick(Controls::default(), &[]);
            let ball = machine.pose().balls[0];
            let outside = ball.center.distance(MIDDLE) > 0.0451;
            assert!(!outside || ball.velocity.length() <= first * (1.0 + 1e-3), "{first}, then {ball:?}");
            if outside && ball.center.distance(MIDDLE) > 0.08 {
                break;
            }
        }
    }
}

#[test]
fn where_nothing_rubs_a_ball_leaves_as_fast_as_it_came() {
    let mut layout = with(Kind::Magnet(magnet(MIDDLE)));
    layout.playfield_friction = 0.0;
    for (aside, speed) in [(0.0, 3.0), (0.01, 2.0), (0.03, 5.0)] {
        let mut machine = live(layout.clone());
        machine.tick(Controls::default(), &[Command::Magnet(PartId(0), true)]);
        machine.put_ball(MIDDLE + v(-0.05, aside), v(speed, 0.0), [0.0; 3]);
        run(&mut machine, 60, EventKind::Closed);
        assert!(machine.pose().balls[0].center.x > MIDDLE.x + 0.045);
        let left = machine.pose().balls[0].velocity.length() / speed;
        println!("{aside} m aside at {speed} m/s: {left}");
        // Rolling resistance takes a little; nothing turns the ball, so the field does not.
        assert!((0.999..1.0).contains(&left), "{left}");
    }
}
