//! Where a shot goes.

use super::{LEFT, NONE, Play, left_flipper};
use geometry::{Circle, Taper, trig};

/// Direction (degrees, 90 is up, 0 to the right) and speed of the shot.
fn shot(play: Play) -> (f64, f64) {
    let ball = play.then(&[(40, LEFT)]).first().expect("a ball");
    (-trig::angle(ball.velocity).to_degrees(), ball.velocity.length())
}

/// A ball that rolls down the resting left flipper, near its base.
fn rolling_on_the_flipper(speed: f64) -> Play {
    let flipper = left_flipper();
    let tip = flipper.base.center + trig::direction(flipper.rest_rad) * flipper.length_m;
    let resting = Taper { a: flipper.base, b: Circle { center: tip, radius: flipper.tip_radius_m } };
    let normals = resting.side_normals().expect("a flipper has sides");
    let normal = if normals[0].y < 0.0 { normals[0] } else { normals[1] };
    let (side, along) = (resting.side(normal), resting.side(normal).along().normalize());
    let center = (side.a + along * 0.01 + normal * (physics::BALL_RADIUS_M + 1e-6)) * 1e3;
    Play::new().ball((center.x, center.y), (along.x * speed, along.y * speed))
}

#[test]
fn a_millisecond_later_goes_farther_across() {
    let rolling = rolling_on_the_flipper(0.8);
    let aimed = |wait: usize| shot(rolling.clone().then(&[(wait, NONE)])).0;
    let first = (0..60).find(|&wait| aimed(wait) - aimed(wait + 1) > 0.5).expect("near the tip it turns");
    let angles: Vec<f64> = (first..first + 60).map(aimed).collect();
    println!("{angles:.1?}");
    assert!(angles.windows(2).all(|pair| pair[1] < pair[0]), "{angles:?}");
    let sweep = angles[0] - angles[59];
    assert!(sweep >= 60.0, "{sweep} degrees");
    let mut bins = vec![0; sweep as usize + 2];
    angles.iter().for_each(|angle| bins[(angles[0] - angle) as usize] += 1);
    let mean = 60.0 / sweep;
    assert!(bins.iter().all(|&count| f64::from(count) <= (3.0 * mean).max(1.0)), "{bins:?}");
}

#[test]
fn a_shot_up_the_ramp_comes_home_on_the_wires_to_the_right_flipper() {
    let home = |speed: f64, x: f64| {
        let mut play = Play::new().ball((x, 600.0), (0.0, -speed));
        play.until(NONE, 4000, |play| play.has_met("wire"))?;
        let before: Vec<f64> = play.first().iter().map(|ball| ball.height_m).collect();
        play.until(NONE, 400, |play| play.first().is_some_and(|ball| ball.height_m < 0.003))?;
        let ball = play.first()?;
        Some((before[0], play.switches.clone(), ball.center))
    };
    for speed in [1.9, 2.5, 3.5] {
        let (height, switches, place) = home(speed, 270.0).expect("it goes up and comes down");
        assert!(switches.starts_with(&["ramp".into(), "wire".into()]), "{speed} m/s: {switches:?}");
        assert!(height > 0.02 && (0.34..0.43).contains(&place.x), "{speed} m/s: from {height} m to {place}");
    }
    assert!(home(0.8, 270.0).is_none(), "a slow ball rolls back");
    assert!(home(2.5, 320.0).is_none(), "and one that misses does not go up");
}

#[test]
fn the_slowest_ball_over_the_ramp_comes_home_and_the_fastest_that_is_not_over_comes_back() {
    let gets_over = |speed: f64| {
        let mut play = Play::new().ball((270.0, 600.0), (0.0, -speed));
        let is_back = |play: &Play| play.first().is_none_or(|ball| ball.center.y > 0.62 && !ball.above);
        let ends = play.until(NONE, 8000, |play| play.has_met("wire") || is_back(play));
        assert!(ends.is_some(), "at {speed} m/s it lies on the ramp: {:?}", play.first());
        play.has_met("wire")
    };
    let (mut under, mut over) = (0.8, 2.5);
    assert!(!gets_over(under) && gets_over(over));
    while over - under > 1e-6 {
        let middle = 0.5 * (under + over);
        *(if gets_over(middle) { &mut over } else { &mut under }) = middle;
    }
    println!("over from {over} m/s on");
}

#[test]
fn a_ball_near_the_base_goes_to_the_flippers_own_side() {
    let rolling = Play::new().ball((71.0, 740.0), (0.0, 0.6));
    let shots = |waits: std::ops::Range<usize>| waits.map(|wait| shot(rolling.clone().then(&[(wait, NONE)])));
    let tip = shots(480..520).map(|(_, speed)| speed).fold(0.0, f64::max);
    let backhand = shots(385..400).filter(|(angle, _)| *angle > 95.0).map(|(_, speed)| speed).fold(0.0, f64::max);
    println!("tip {tip} m/s, backhand {backhand} m/s");
    assert!(backhand >= 0.45 * tip, "{backhand} m/s against {tip} m/s");
}
