//! Balls held on a raised flipper.

use super::{BOTH, LEFT, Play, RIGHT, is_still};

#[test]
fn a_ball_that_rolls_onto_a_raised_flipper_is_trapped() {
    let mut play = Play::new().then(&[(100, LEFT)]).ball((150.0, 868.0), (0.0, 0.0));
    let rest = play.until(LEFT, 2500, |play| {
        let mut on = play.clone();
        is_still(&play.first().expect("a ball"))
            && on.until(LEFT, 20, |on| !is_still(&on.first().expect("it"))).is_none()
    });
    println!("at rest after {rest:?} ms");
    assert!(rest.is_some(), "it is at rest within 2.5 s");
    let before = play.first().expect("a ball").center;
    let after = play.then(&[(10_000, LEFT)]).first().expect("a ball").center;
    println!("drifts {:e} m", after.distance(before));
    assert!(after.distance(before) < 1e-4, "drifts {} m in 10 s", after.distance(before));
}

#[test]
fn two_cradled_balls_hardly_bend_the_flipper() {
    let angle = |play: &Play| play.machine.pose().flippers_rad[0].1.to_degrees();
    let empty = angle(&Play::new().then(&[(2000, LEFT)]));
    let two = Play::cradled().ball((85.0, 828.0), (0.0, 0.0)).then(&[(6000, LEFT)]);
    assert_eq!(two.within(135.0..205.0, 840.0..900.0).len(), 2, "both lie on it");
    assert!((angle(&two) - empty).abs() < 0.2, "it sags by {} degrees", angle(&two) - empty);
}

#[test]
fn two_held_balls_part_onto_two_flippers() {
    let two = Play::cradled().ball((85.0, 828.0), (0.0, 0.0)).then(&[(6000, LEFT)]);
    let parted = |gap: usize, press: usize| {
        let play = two.clone().then(&[(gap, RIGHT), (press, BOTH), (200, RIGHT), (4000, BOTH)]);
        play.is_held_left() && play.is_held_right()
    };
    let found: Vec<_> = (2..14).flat_map(|press| (0..150).step_by(3).map(move |gap| (gap, press))).collect();
    let parts: Vec<_> = found.iter().filter(|&&(gap, press)| parted(gap, press)).collect();
    println!("{parts:?}");
    assert!((1..60).contains(&parts.len()), "{} of {} inputs part them", parts.len(), found.len());
}
