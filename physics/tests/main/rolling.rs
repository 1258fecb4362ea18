//! A ball alone on the playfield.

use crate::fixture::*;
use physics::*;

fn tick(machine: &mut Machine, ticks: usize) {
    (0..ticks).for_each(|_| machine.tick(Controls::default(), &[]));
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
