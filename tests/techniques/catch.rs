//! Taking the speed out of a ball: the flipper yields, or is still soft when the ball comes.

use super::{LEFT, NONE, Play, left_flipper};
use geometry::{Circle, DVec2, Taper, trig};
use physics::Controls;

/// How far from the pivot's end of the flipper's upper side balls are caught, m.
const PLACES_M: [f64; 3] = [0.045, 0.05, 0.055];
/// How fast they come.
const SPEEDS_M_S: [f64; 3] = [1.5, 2.0, 2.5];

/// The place on the raised left flipper's upper side that is `along` from the side's start, and the side's normal.
fn place(along_m: f64) -> (DVec2, DVec2) {
    let flipper = left_flipper();
    let tip = flipper.base.center + trig::direction(flipper.up_rad) * flipper.length_m;
    let raised = Taper { a: flipper.base, b: Circle { center: tip, radius: flipper.tip_radius_m } };
    let normals = raised.side_normals().expect("a flipper has sides");
    let normal = if normals[0].y < 0.0 { normals[0] } else { normals[1] };
    let side = raised.side(normal);
    (side.a + side.along().normalize() * along_m, normal)
}

/// A ball on its way to a place on the raised flipper, straight down on it, `ms` before it is there.
fn falling(play: Play, along_m: f64, speed: f64, ms: f64) -> Play {
    let (place, normal) = place(along_m);
    let center = place + normal * (physics::BALL_RADIUS_M + speed * ms * 1e-3);
    play.ball((center.x * 1e3, center.y * 1e3), (-normal.x * speed, -normal.y * speed))
}

/// The ball's speed away from the raised flipper 40 ms after it first touched it, over its speed of arrival, and after
/// how many milliseconds it touched it.
fn rebound(mut play: Play, along_m: f64, speed: f64, hands: impl Fn(usize) -> Controls) -> (f64, usize) {
    let (_, normal) = place(along_m);
    let touch = (1..400).find(|&ms| {
        play.tick(hands(ms));
        !play.machine.contacts().is_empty()
    });
    let touch = touch.expect("the ball comes down on the flipper");
    (touch + 1..touch + 40).for_each(|ms| play.tick(hands(ms)));
    (play.first().expect("a ball").velocity.dot(normal) / speed, touch)
}

/// After how many milliseconds of its press the flipper has reached its stop: it rises no more.
fn arrival_ms() -> usize {
    let mut play = Play::new();
    let angle = |play: &Play| play.machine.pose().flippers_rad[0].1;
    let mut before = angle(&play);
    let up = left_flipper().up_rad;
    (1..100)
        .find(|_| {
            play.tick(LEFT);
            let now = angle(&play);
            let stopped = now >= before && now <= up;
            before = now;
            stopped
        })
        .expect("the flipper comes up")
}

#[test]
fn a_live_catch_kills_the_ball_and_a_late_one_does_not() {
    let arrival = arrival_ms();
    for along in PLACES_M {
        for speed in SPEEDS_M_S {
            let caught = |after: usize| {
                let ball = falling(Play::new(), along, speed, (arrival + after) as f64);
                rebound(ball, along, speed, |_| LEFT).0
            };
            let held = {
                let ball = falling(Play::new().then(&[(200, LEFT)]), along, speed, 100.0);
                rebound(ball, along, speed, |_| LEFT).0
            };
            let curve: Vec<f64> = (0..=24).map(caught).collect();
            println!("{along} m, {speed} m/s, held {held:.2}: {curve:.2?}");
            assert!(held > 0.5, "a held flipper throws it back with {held}");
            for (after, &left) in curve.iter().enumerate().take(9) {
                assert!(left <= 0.05, "{after} ms after the stop, {speed} m/s at {along} m: leaves at {left}");
            }
            for pair in curve[8..].windows(2) {
                assert!(pair[1] > pair[0] - 0.03, "it grows: {curve:?}");
            }
            assert!(curve[20..].iter().all(|left| (left / held - 1.0).abs() < 0.1), "normal by 20 ms: {curve:?}");
        }
    }
}

#[test]
fn a_flipper_that_has_not_arrived_shoots_the_ball() {
    let early = arrival_ms() - 3;
    let ball = falling(Play::new(), 0.05, 2.0, early as f64);
    let (left, _) = rebound(ball, 0.05, 2.0, |_| LEFT);
    assert!(left > 1.0, "it is shot away at {left}");
}

#[test]
fn a_drop_catch_lets_the_ball_fall_with_the_flipper() {
    let raised = Play::new().then(&[(300, LEFT)]);
    let along = 0.055;
    for speed in SPEEDS_M_S {
        let ball = falling(raised.clone(), along, speed, 100.0);
        let (held, touch) = rebound(ball.clone(), along, speed, |_| LEFT);
        let dropped = |before: usize| {
            let hands = |ms: usize| if ms + before < touch { LEFT } else { NONE };
            rebound(ball.clone(), along, speed, hands).0
        };
        let curve: Vec<f64> = (10..=40).step_by(5).map(dropped).collect();
        println!("{speed} m/s, held {held:.2}: {curve:.2?}");
        assert!(held > 0.5, "{held}");
        assert!(curve.iter().all(|&left| left <= 0.15), "{speed} m/s: {curve:?}");
        assert!(dropped(0) > 0.5, "let go too late, the ball is thrown back");
    }
}
