//! A ball alone: the playfield under it and walls in its way.

use crate::fixture::*;
use geometry::Shape;
use physics::*;

fn tick(machine: &mut Machine, ticks: usize) {
    (0..ticks).for_each(|_| machine.tick(Controls::default(), &[]));
}

fn energy(machine: &Machine) -> f64 {
    let gravity = 9.81 * libm::sin(6.5_f64.to_radians());
    let inertia = 0.4 * BALL_RADIUS_M * BALL_RADIUS_M;
    let of = |ball: &BallPose| {
        let spin: f64 = ball.spin.iter().map(|s| s * s).sum();
        0.5 * ball.velocity.length_squared() + 0.5 * inertia * spin - gravity * (ball.center.y - 2.0)
    };
    machine.pose().balls.iter().map(of).sum()
}

#[test]
fn a_ball_rolls_down_with_five_sevenths_of_the_slope() {
    let mut machine = machine(bare());
    machine.put_ball(v(0.25, 0.1), v(0.0, 0.0), [0.0; 3]);
    tick(&mut machine, 1000);
    let speed = machine.pose().balls[0].velocity.y;
    assert!((speed / 0.793 - 1.0).abs() < 0.005, "{speed} m/s after a second");
}

#[test]
fn a_sliding_ball_ends_up_rolling_at_five_sevenths_of_its_speed() {
    let mut layout = bare();
    layout.slope_rad = 0.0;
    let mut machine = machine(layout);
    machine.put_ball(v(0.02, 0.5), v(0.5, 0.0), [0.0; 3]);
    tick(&mut machine, 400);
    let ball = machine.pose().balls[0];
    assert!((ball.velocity.x / (0.5 * 5.0 / 7.0) - 1.0).abs() < 0.01, "{} m/s", ball.velocity.x);
    assert!((ball.spin[1] * BALL_RADIUS_M - ball.velocity.x).abs() < 1e-6, "it rolls without slip");
}

#[test]
fn restitution_falls_with_speed_as_the_material_says() {
    for speed in [0.05, 0.2, 1.0, 3.0, 5.0] {
        let mut layout = bare();
        layout.slope_rad = 0.0;
        layout.playfield_friction = 0.0;
        layout.parts.push(part("wall", walls(vec![Shape::capsule(v(0.4, 0.0), v(0.4, 1.0), 0.003)], RUBBER)));
        let mut machine = machine(layout);
        machine.put_ball(v(0.4 - 0.003 - BALL_RADIUS_M - 0.4e-3, 0.5), v(speed, 0.0), [0.0; 3]);
        tick(&mut machine, 20);
        let rebound = -machine.pose().balls[0].velocity.x / speed;
        let wanted = 0.85 / (1.0 + 0.13 * speed);
        assert!((rebound / wanted - 1.0).abs() < 0.01, "at {speed} m/s: {rebound}, not {wanted}");
    }
}

#[test]
fn nothing_powered_makes_energy() {
    let mut chance = Chance(5);
    for _ in 0..20 {
        let mut layout = table();
        layout.parts.retain(|part| !matches!(part.kind, Kind::Plunger(_) | Kind::Saucer(_)));
        let mut machine = machine(layout);
        let velocity = v(chance.between(-3.0, 3.0), chance.between(-3.0, 3.0));
        machine.put_ball(v(chance.between(0.22, 0.29), chance.between(0.4, 0.7)), velocity, [0.0; 3]);
        let mut before = energy(&machine);
        for tick in 0..2000 {
            machine.tick(Controls::default(), &[]);
            if machine.pose().balls.is_empty() || machine.events().iter().any(|e| e.kind == EventKind::Closed) {
                break;
            }
            let after = energy(&machine);
            assert!(after <= before * (1.0 + 1e-6), "tick {tick}: {before} to {after} J/kg, {:?}", machine.contacts());
            before = after;
        }
    }
}
