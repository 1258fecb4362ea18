//! Balls that lie still: for a minute, to the twentieth of a millimetre.

use crate::fixture::*;
use geometry::{Arc, Circle, Core, DVec2, Shape};
use physics::*;

/// Lets everything come to rest, then watches for a minute: the farthest drift, the root mean square of the speed and the
/// fastest spin.
fn watch(machine: &mut Machine, hands: Controls) -> (f64, f64, f64) {
    (0..8000).for_each(|_| machine.tick(hands, &[]));
    let starts: Vec<DVec2> = machine.pose().balls.iter().map(|ball| ball.center).collect();
    let (mut drift, mut squares, mut spin, mut count) = (0.0_f64, 0.0, 0.0_f64, 0.0);
    for _ in 0..60_000 {
        machine.tick(hands, &[]);
        for (ball, start) in machine.pose().balls.iter().zip(&starts) {
            drift = drift.max(ball.center.distance(*start));
            squares += ball.velocity.length_squared();
            spin = ball.spin.iter().fold(spin, |most, part| most.max(part.abs()));
            count += 1.0;
        }
    }
    (drift, (squares / count).sqrt(), spin)
}

fn assert_rests(name: &str, mut machine: Machine, hands: Controls) {
    let (drift, speed, spin) = watch(&mut machine, hands);
    println!("{name}: drifts {drift:e} m, {speed:e} m/s, spins at {spin:e} rad/s");
    assert!(drift <= 5e-5, "{name} drifts {drift} m in a minute");
    assert!(speed <= 1e-3, "{name} moves at {speed} m/s");
    assert!(spin <= 0.1, "{name} twists at {spin} rad/s");
}

fn with(shapes: Vec<Shape>, material: Material, balls: &[(f64, f64)]) -> Machine {
    let mut layout = bare();
    layout.parts.push(part("things", walls(shapes, material)));
    let mut machine = machine(layout);
    for &(x, y) in balls {
        machine.put_ball(v(x, y), DVec2::ZERO, [0.0; 3]);
    }
    machine
}

#[test]
fn a_ball_in_a_trough_rests() {
    let sides =
        vec![Shape::capsule(v(0.15, 0.4), v(0.25, 0.5), 0.003), Shape::capsule(v(0.35, 0.4), v(0.25, 0.5), 0.003)];
    assert_rests("trough", with(sides, RUBBER, &[(0.22, 0.44)]), Controls::default());
}

#[test]
fn a_ball_on_two_posts_rests() {
    let posts = vec![Shape::disc(v(0.238, 0.5), 0.004), Shape::disc(v(0.262, 0.5), 0.004)];
    assert_rests("posts", with(posts, RUBBER, &[(0.25, 0.47)]), Controls::default());
}

#[test]
fn a_ball_in_a_bowl_rests() {
    let arc = Arc::new(Circle { center: v(0.25, 0.4), radius: 0.1 }, 0.5, 2.2);
    let bowl = Shape { core: Core::Arc(arc), radius: 0.002 };
    assert_rests("bowl", with(vec![bowl], RUBBER, &[(0.2505, 0.4845)]), Controls::default());
}

/// Rolling resistance alone would hold the first for ever: the slope pulls at it with a third of that.
#[test]
fn no_ball_balances_on_a_post() {
    for off_m in [1e-5, 1e-8] {
        let mut machine = with(vec![Shape::disc(v(0.25, 0.5), 0.0045)], RUBBER, &[(0.25 + off_m, 0.482)]);
        let fell = |machine: &Machine| machine.pose().balls[0].center.y > 0.52;
        let done = (0..10_000).find(|_| {
            machine.tick(Controls::default(), &[]);
            fell(&machine)
        });
        println!("{off_m:e} m off the top of a post: fell after {done:?} ms");
        assert!(done.is_some_and(|ticks| ticks < 6_000), "{off_m} m off: {:?}", machine.pose().balls);
    }
}

#[test]
fn a_pile_of_five_balls_in_a_corner_rests() {
    let sides =
        vec![Shape::capsule(v(0.1, 0.3), v(0.25, 0.6), 0.003), Shape::capsule(v(0.4, 0.3), v(0.25, 0.6), 0.003)];
    let balls = [(0.25, 0.5), (0.235, 0.45), (0.265, 0.45), (0.22, 0.40), (0.25, 0.40)];
    assert_rests("pile", with(sides, WOOD, &balls), Controls::default());
}

#[test]
fn balls_on_a_raised_flipper_rest() {
    for balls in [&[(0.13, 0.87)][..], &[(0.13, 0.87), (0.11, 0.85)]] {
        let up = Controls { left: true, ..Controls::default() };
        let mut machine = machine(table());
        machine.tick(up, &[Command::SetFlippers(true)]);
        (0..100).for_each(|_| machine.tick(up, &[]));
        for &(x, y) in balls {
            machine.put_ball(v(x, y), DVec2::ZERO, [0.0; 3]);
        }
        assert_rests("flipper", machine, up);
    }
}

#[test]
fn balls_that_jam_in_a_chute_free_themselves() {
    let mut chance = Chance(12);
    for count in 2..=6 {
        for start in 0..12 {
            // A funnel into a lane that is a ball and a third wide.
            let (left, right) = (0.25 - 0.018, 0.25 + 0.018);
            let walls = vec![
                Shape::capsule(v(0.10, 0.35), v(left, 0.55), 0.002),
                Shape::capsule(v(0.40, 0.35), v(right, 0.55), 0.002),
                Shape::capsule(v(left, 0.55), v(left, 0.75), 0.002),
                Shape::capsule(v(right, 0.55), v(right, 0.75), 0.002),
            ];
            let mut machine = with(walls, WOOD, &[]);
            for ball in 0..count {
                let place = v(0.16 + 0.03 * f64::from(ball) + chance.between(0.0, 0.002), chance.between(0.28, 0.34));
                machine.put_ball(place, v(chance.between(-0.5, 0.5), chance.between(0.0, 2.0)), [0.0; 3]);
            }
            let through = |machine: &Machine| machine.pose().balls.iter().all(|ball| ball.center.y > 0.77);
            let done = (0..6_000).find(|_| {
                machine.tick(Controls::default(), &[]);
                through(&machine)
            });
            println!("{count} balls, start {start}: free after {done:?} ms");
            assert!(done.is_some(), "{count} balls, start {start}: {:?}", machine.pose().balls);
        }
    }
}
