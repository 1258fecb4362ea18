//! What a push of the cabinet saves, and what it costs.

use super::{BOTH, NONE, Play};
use physics::Controls;

const PUSH_MS: usize = 30;
const PUSHES: [Controls; 4] = [
    Controls { nudge_left: true, ..NONE },
    Controls { nudge_right: true, ..NONE },
    Controls { nudge_up: true, ..NONE },
    Controls { nudge_down: true, ..NONE },
];

fn with(hands: Controls, push: Controls) -> Controls {
    Controls { left: hands.left, right: hands.right, ..push }
}

/// Plays on until a ball drains, is safe, or 4 s are over: whether it is safe.
fn is_saved(mut play: Play, hands: Controls, safe: impl Fn(&Play) -> bool) -> bool {
    play.until(hands, 4000, |play| safe(play) || play.has_met("drain")).is_some() && safe(&play)
}

#[test]
fn a_push_keeps_a_ball_out_of_the_outlane() {
    let lane = |start: f64, push: Option<(usize, Controls)>| {
        let mut play = Play::new().ball((start, 660.0), (0.02, 0.5));
        if let Some((wait, push)) = push {
            play = play.then(&[(wait, NONE), (PUSH_MS, push)]);
        }
        let lanes = |play: &Play| play.has_met("outlane-left") || play.has_met("inlane-left");
        play.until(NONE, 3000, lanes)?;
        assert_eq!(play.bob, 0, "one push does not touch the bob");
        Some(play.has_met("inlane-left"))
    };
    let lost: Vec<f64> = (0..60).map(|i| 20.0 + 0.5 * f64::from(i)).filter(|&x| lane(x, None) == Some(false)).collect();
    let saves = |start: f64| {
        PUSHES.iter().any(|&push| (0..400).step_by(10).any(|ms| lane(start, Some((ms, push))) == Some(true)))
    };
    let saved = lost.iter().filter(|&&start| saves(start)).count();
    println!("{saved} of {} lost balls are saved", lost.len());
    assert!(!lost.is_empty() && 2 * saved >= lost.len(), "{saved} of {}", lost.len());
}

#[test]
fn a_slap_with_a_push_reaches_a_ball_between_the_flippers() {
    let falls = || Play::new().ball((235.0, 800.0), (0.0, 0.8));
    let safe = |play: &Play| play.first().is_some_and(|ball| ball.center.y < 0.75);
    let slap = |wait: usize, push: Controls| {
        let play = falls().then(&[(wait, NONE), (PUSH_MS, with(BOTH, push))]);
        assert_eq!(play.bob, 0);
        is_saved(play, BOTH, safe)
    };
    assert!((0..200).step_by(2).all(|wait| !slap(wait, NONE)), "without a push it falls between them");
    let saved: Vec<usize> =
        (0..200).step_by(2).filter(|&wait| slap(wait, PUSHES[0]) || slap(wait, PUSHES[1])).collect();
    println!("{saved:?}");
    assert!((1..30).contains(&saved.len()), "{saved:?}");
}

#[test]
fn a_push_turns_a_dead_bounce_that_falls_short() {
    let over = |play: &Play| play.first().is_some_and(|ball| ball.center.x > 0.26 && ball.center.y < 0.93);
    let starts = (0..8).map(|place| Play::new().ball((146.0 + 3.0 * f64::from(place), 800.0), (0.0, 0.2)));
    let short: Vec<Play> = starts.filter(|start| !is_saved(start.clone(), NONE, over)).collect();
    let save = |start: &Play, wait: usize, push: Controls| {
        is_saved(start.clone().then(&[(wait, NONE), (PUSH_MS, push)]), NONE, over)
    };
    let helps = |start: &&Play| (0..600).step_by(40).any(|wait| PUSHES.iter().any(|&push| save(start, wait, push)));
    let saved = short.iter().filter(helps).count();
    println!("{saved} of {} that fall short cross with a push", short.len());
    assert!(short.len() >= 3 && saved == short.len(), "{saved} of {} are saved", short.len());
}

#[test]
fn a_bang_back_saves_a_ball_from_the_outlane_inside_two_warnings() {
    let drains = || Play::new().ball((29.0, 820.0), (0.0, 0.4));
    let safe = |play: &Play| play.within(30.0..440.0, 0.0..870.0).iter().any(|ball| ball.center.x > 0.05);
    let bang = |wait: usize, pushes: usize| {
        let mut play = drains().then(&[(wait, BOTH)]);
        for _ in 0..pushes {
            play = play.then(&[(PUSH_MS, with(BOTH, PUSHES[2])), (160 - PUSH_MS, BOTH)]);
        }
        let done = play.until(BOTH, 4000, |play| safe(play) || play.has_met("drain"));
        (done.is_some() && safe(&play), play.bob)
    };
    assert!(!bang(0, 0).0, "without a push it drains");
    let saves: Vec<usize> = (200..400).step_by(5).filter(|&wait| matches!(bang(wait, 3), (true, 0..=2))).collect();
    println!("saved when pushed after {saves:?} ms");
    assert!((1..20).contains(&saves.len()), "{saves:?}");
}
