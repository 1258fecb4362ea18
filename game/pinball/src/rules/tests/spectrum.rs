//! Spectrum's own rules, feat by feat.

use super::bench::Bench;
use crate::rules::Value;
use crate::{Buttons, table};
use physics::Command;

fn spectrum() -> Bench {
    Bench::new(table::tests::spectrum()).unwrap_or_else(|mistake| panic!("{mistake}"))
}

/// A game whose first ball has just been shot.
fn game() -> Bench {
    let mut bench = spectrum();
    bench.press(Buttons::START);
    bench.wait(3000);
    bench.launch();
    sound(&mut bench);
    bench
}

fn sound(bench: &mut Bench) {
    assert_eq!(bench.rules.take_complaints(), Vec::<String>::new());
}

fn repeat(bench: &mut Bench, switch: &str, times: usize) {
    for _ in 0..times {
        bench.hit(switch);
        bench.wait(2000);
    }
}

/// Makes the shots that win a colour.
fn make(bench: &mut Bench, colour: &str) {
    match colour {
        "red" => {
            for target in ["drop-1", "drop-2", "drop-3"] {
                bench.close(target);
            }
        }
        "orange" => repeat(bench, "spinner", 40),
        "yellow" => repeat(bench, "standup-left", 2),
        "green" => repeat(bench, "bumper-low", 15),
        "blue" => repeat(bench, "saucer", 2),
        "indigo" => {
            bench.hit("left-sling");
            repeat(bench, "orbit-right", 2);
        }
        "violet" => repeat(bench, "standup-right", 2),
        other => panic!("{other} is not a colour"),
    }
    sound(bench);
}

const COLOURS: [&str; 7] = ["red", "orange", "yellow", "green", "blue", "indigo", "violet"];

fn won(bench: &Bench, colour: &str) -> bool {
    let display = bench.display();
    display.progress.iter().any(|(name, done, of)| name.eq_ignore_ascii_case(colour) && done == of)
}

fn number(bench: &Bench, name: &str) -> i64 {
    let Value::Map(memory) = bench.rules.state().memory() else { return 0 };
    let Some(Value::Map(me)) = memory.get("me") else { return 0 };
    match me.get(name) {
        Some(Value::Int(number)) => *number,
        _ => 0,
    }
}

/// The ball is lost after its save has run out, and the bonus is counted.
fn lose(bench: &mut Bench) {
    bench.wait(8000);
    bench.hit("left-sling");
    bench.wait(8000);
    bench.drain();
    bench.wait(5000);
    sound(bench);
}

#[test]
fn a_table_that_nobody_plays_shows_a_running_rainbow() {
    let mut bench = spectrum();
    let brightest = |bench: &Bench| COLOURS.map(|colour| bench.light(&format!("lamp-{colour}")).level);
    bench.wait(2000);
    let early = brightest(&bench);
    bench.wait(1000);
    assert_ne!(early, brightest(&bench));
    for _ in 0..4 {
        assert!(!bench.display().message.is_empty());
        bench.wait(20_000);
    }
    bench.wait(15_000);
    assert!(bench.display().message.is_empty(), "between the messages the display has its own show");
    assert!(!bench.display().playing);
    sound(&mut bench);
}

#[test]
fn every_colour_is_won_by_its_shot_and_by_no_other() {
    for colour in COLOURS {
        let mut bench = game();
        assert!(bench.light(&format!("lamp-{colour}")).level < 400, "a missing colour is dim");
        make(&mut bench, colour);
        bench.wait(4000);
        for other in COLOURS {
            assert_eq!(won(&bench, other), other == colour, "{other} after the shots for {colour}");
        }
        assert!(bench.light(&format!("lamp-{colour}")).level > 800, "{colour} shines");
        assert!(bench.score() > 50_000);
        bench.wait(4200);
        let lit = COLOURS.iter().filter(|other| bench.light(&format!("lamp-{other}")).level > 400);
        assert_eq!(lit.collect::<Vec<_>>(), [&colour], "and the others wait in the dark");
    }
}

#[test]
fn seven_colours_make_white_light_in_which_everything_counts_tenfold() {
    let mut bench = game();
    let before = bench.score();
    bench.hit("left-sling");
    let sling = bench.score() - before;
    for colour in COLOURS {
        make(&mut bench, colour);
    }
    assert_eq!(bench.display().message, ["WHITE LIGHT", "ALL SCORES X10"]);
    bench.wait(5000);
    assert!(bench.display().message[1].ends_with("SECONDS"));
    let before = bench.score();
    bench.hit("left-sling");
    assert_eq!(bench.score() - before, 10 * sling);
    let lamp = bench.light("lamp-red").color;
    assert!(lamp.iter().all(|channel| *channel > 200), "white, not {lamp:?}");
    let before = bench.score();
    bench.hit("saucer");
    assert!(bench.score() - before >= 1_000_000, "the jackpot");
    bench.wait(25_000);
    assert!(COLOURS.iter().all(|colour| !won(&bench, colour)), "the colours begin anew");
    assert_eq!(number(&bench, "level"), 2);
    let before = bench.score();
    make(&mut bench, "yellow");
    assert!(bench.score() - before >= 100_000, "and are worth more");
}

#[test]
fn a_ball_that_is_lost_soon_comes_back_once() {
    let mut bench = game();
    bench.wait(4000);
    bench.drain();
    bench.wait(10);
    assert_eq!(bench.display().message, ["BALL SAVED", "SHOOT AGAIN"]);
    assert_eq!((bench.balls.len(), bench.display().ball), (1, 1));
    bench.launch();
    bench.wait(1000);
    bench.drain();
    bench.wait(7000);
    assert_eq!(bench.display().ball, 2);
    sound(&mut bench);
}

#[test]
fn the_save_waits_for_a_ball_that_goes_down_the_outlane() {
    let mut bench = game();
    bench.wait(9500);
    bench.hit("outlane-left");
    bench.wait(2500);
    bench.drain();
    bench.wait(10);
    assert_eq!(bench.display().message, ["BALL SAVED", "SHOOT AGAIN"]);
}

#[test]
fn the_third_ball_ends_the_game() {
    let mut bench = game();
    for ball in 1..=3 {
        assert_eq!((bench.display().ball, bench.display().playing), (ball, true));
        lose(&mut bench);
        if ball < 3 {
            bench.launch();
        }
    }
    assert!(!bench.display().playing);
    assert_eq!(bench.balls.len(), 0);
    assert_eq!(bench.orders.last(), Some(&Command::SetCoils(false)));
    bench.press(Buttons::START);
    bench.wait(10);
    assert_eq!((bench.display().ball, bench.score(), bench.balls.len()), (1, 0, 1), "and another one begins");
    sound(&mut bench);
}

#[test]
fn players_keep_their_own_colours() {
    let mut bench = game();
    bench.press(Buttons::START);
    make(&mut bench, "yellow");
    lose(&mut bench);
    assert_eq!((bench.display().player, bench.display().scores.len()), (1, 2));
    assert!(!won(&bench, "yellow"));
    bench.launch();
    bench.press(Buttons::START);
    assert_eq!(bench.display().scores.len(), 3, "still on the first ball");
    make(&mut bench, "violet");
    lose(&mut bench);
    bench.launch();
    lose(&mut bench);
    assert_eq!((bench.display().player, bench.display().ball), (0, 2));
    assert!(won(&bench, "yellow") && !won(&bench, "violet"));
    bench.press(Buttons::START);
    assert_eq!(bench.display().scores.len(), 3, "nobody joins later");
}

#[test]
fn the_third_swing_of_the_bob_tilts() {
    let mut bench = game();
    bench.hit("bumper-low");
    for warning in 1..=2 {
        bench.bob();
        bench.wait(1000);
        assert!(!bench.display().tilted, "warning {warning}");
        assert_eq!(bench.display().message[0], "DANGER");
    }
    bench.orders.clear();
    bench.bob();
    bench.wait(1);
    assert!(bench.display().tilted);
    assert!(bench.ordered(Command::SetFlippers(false)) && bench.ordered(Command::SetCoils(false)));
    let before = bench.score();
    bench.hit("bumper-low");
    bench.drain();
    bench.wait(1);
    assert_eq!((bench.balls.len(), bench.score()), (0, before), "no points, and no save");
    bench.wait(3000);
    let display = bench.display();
    assert_eq!((display.ball, display.tilted, bench.score()), (2, false, before), "no bonus");
    assert!(bench.ordered(Command::SetFlippers(true)) && bench.ordered(Command::SetCoils(true)));
    sound(&mut bench);
}

#[test]
fn a_slam_ends_the_game_for_everybody_at_once() {
    let mut bench = game();
    bench.press(Buttons::START);
    bench.hit("bumper-low");
    assert_eq!(bench.display().scores.len(), 2);
    let scores = bench.display().scores;
    bench.orders.clear();
    bench.slam();
    bench.wait(1);
    let display = bench.display();
    assert!(!display.playing && display.progress.is_empty());
    assert_eq!((display.message[0].as_str(), display.scores), ("SLAM TILT", scores));
    assert!(bench.ordered(Command::SetFlippers(false)) && bench.ordered(Command::SetCoils(false)));
    bench.wait(1000);
    bench.drain();
    bench.wait(10_000);
    assert!(
        !bench.display().playing && !bench.ordered(Command::AddBall),
        "the ball that is lost afterwards ends nothing"
    );
    bench.slam();
    bench.press(Buttons::START);
    bench.wait(1);
    let display = bench.display();
    assert_eq!((display.playing, display.scores, display.ball), (true, vec![0], 1), "and another game begins");
    assert!(bench.ordered(Command::AddBall));
    sound(&mut bench);
}

#[test]
fn a_ball_that_a_slam_leaves_at_the_plunger_is_played() {
    let mut bench = spectrum();
    bench.press(Buttons::START);
    bench.close("shooter");
    bench.slam();
    bench.wait(4000);
    bench.orders.clear();
    bench.press(Buttons::START);
    bench.wait(10);
    assert!(bench.display().playing && !bench.ordered(Command::AddBall));
    sound(&mut bench);
}

#[test]
fn top_lanes_move_with_the_flippers_and_raise_the_bonus() {
    let mut bench = game();
    for times in [2, 3, 5, 5] {
        bench.hit("lane-left");
        bench.press(Buttons::RIGHT);
        bench.hit("lane-left");
        bench.press(Buttons::RIGHT);
        bench.hit("lane-left");
        assert_eq!(number(&bench, "bonus_x"), times);
    }
    sound(&mut bench);
}

#[test]
fn the_skill_shot_is_the_first_lane_if_it_is_the_lit_one() {
    let skill = |bench: &Bench| {
        let Value::Map(memory) = bench.rules.state().memory() else { return 0 };
        let Some(Value::Int(lane)) = memory.get("skill") else { return 0 };
        *lane as usize
    };
    let lanes = ["lane-left", "lane-middle", "lane-right"];
    let mut bench = game();
    bench.hit(lanes[skill(&bench)]);
    assert_eq!(bench.display().message[0], "SKILL SHOT");
    let mut bench = game();
    bench.hit("bumper-low");
    bench.hit(lanes[skill(&bench)]);
    assert_eq!(bench.score(), 500 + 1000, "too late");
    let mut bench = game();
    bench.hit(lanes[(skill(&bench) + 1) % 3]);
    assert_eq!(bench.score(), 1000, "the wrong lane");
}

#[test]
fn an_orbit_and_then_the_saucer_is_a_combo() {
    let mut bench = game();
    bench.wait(3000);
    bench.hit("orbit-left");
    bench.wait(2000);
    bench.hit("saucer");
    assert_eq!(bench.display().message[0], "COMBO");
    bench.wait(6000);
    bench.hit("saucer");
    assert_ne!(bench.display().message[0], "COMBO");
}

#[test]
fn a_ball_that_comes_round_the_top_has_not_shot_the_right_orbit() {
    let mut bench = game();
    bench.hit("orbit-left");
    bench.wait(2000);
    let before = bench.score();
    bench.hit("orbit-right");
    assert_eq!(bench.score(), before);
}

#[test]
fn a_plunge_that_falls_back_through_the_right_orbit_has_not_shot_it() {
    let mut bench = game();
    bench.hit("orbit-right");
    assert_eq!(bench.score(), 0);
}

#[test]
fn the_saucer_is_emptied_until_it_is_empty() {
    let mut bench = game();
    bench.close("saucer");
    let eject = Command::Eject(bench.part("saucer"));
    bench.wait(5000);
    assert!(bench.orders.iter().filter(|order| **order == eject).count() >= 2);
}

#[test]
fn an_extra_ball_is_lit_by_four_colours_and_given_once() {
    let mut bench = game();
    for colour in ["yellow", "violet", "blue", "indigo"] {
        make(&mut bench, colour);
    }
    bench.hit("inlane-left");
    assert_eq!(bench.display().message, ["EXTRA BALL"]);
    lose(&mut bench);
    assert_eq!((bench.display().ball, bench.display().message[0].as_str()), (1, "SHOOT AGAIN"));
    bench.launch();
    bench.hit("inlane-left");
    lose(&mut bench);
    assert_eq!(bench.display().ball, 2);
}
