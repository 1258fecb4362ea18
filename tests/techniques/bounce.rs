//! Flippers at rest are rigid: balls bounce off them as off a wall.

use super::{NONE, Play};

#[test]
fn a_ball_dropped_on_a_resting_flipper_crosses_to_the_other() {
    let crossed = |left: bool| {
        let drops = (0..100).map(|drop| (f64::from(drop / 10), f64::from(drop % 10)));
        let mirror = |x: f64| if left { x } else { 470.0 - x };
        drops
            .filter(|&(place, speed)| {
                let start = (mirror(163.0 + 3.5 * place), 800.0);
                let mut play = Play::new().ball(start, (0.0, 1.0 + speed / 9.0));
                let over = |play: &Play| {
                    let ball = play.first();
                    ball.is_some_and(|ball| mirror(ball.center.x * 1e3) > 260.0 && ball.center.y < 0.93)
                };
                play.until(NONE, 1200, over).is_some()
            })
            .count()
    };
    let (from_left, from_right) = (crossed(true), crossed(false));
    println!("{from_left} of 100 cross to the right, {from_right} to the left");
    assert!(from_left >= 80, "{from_left} of 100");
    assert!(from_right >= 80, "{from_right} of 100 arrive above the other flipper");
}
