//! Balls, players, tilt and the ball search, on rules of a few lines.

use super::bench::{Bench, table};
use crate::Buttons;
use physics::Command;

const RULES: &str = "
fn on_start() { message(\"PRESS START\", 0); }
fn on_button(name) {
    if name != \"start\" { return; }
    if !playing() { start_game(2); flippers(true); kickers(true); add_ball(); }
    else if ball() == 1 && players() < max_players() { add_player(); }
}
fn on_switch(name) {
    if name == \"lane\" { score(100); }
    if name == \"drain\" && balls_in_play() == 0 {
        if next_player() { flippers(true); add_ball(); } else { game_over(); flippers(false); }
    }
}
fn on_bob() { score(1); }
";

fn bench() -> Bench {
    Bench::new(table(RULES, &["lane", "drain", "saucer", "drop-1", "plunger"], &[])).expect("the rules are sound")
}

#[test]
fn players_take_turns_and_the_last_ball_ends_the_game() {
    let mut bench = bench();
    bench.hit("lane");
    assert_eq!(bench.score(), 0, "no points before a game");
    bench.press(Buttons::START);
    bench.press(Buttons::START);
    assert_eq!(bench.display().scores, [0, 0]);
    for (player, ball) in [(0, 1), (1, 1), (0, 2), (1, 2)] {
        let display = bench.display();
        assert_eq!((display.player, display.ball, display.playing), (player, ball, true));
        bench.launch();
        bench.hit("lane");
        bench.drain();
        bench.wait(1);
    }
    let display = bench.display();
    assert_eq!((display.scores, display.playing, display.ball), (vec![200, 200], false, 0));
    assert_eq!(bench.orders.last(), Some(&Command::SetFlippers(false)));
}

#[test]
fn one_swing_of_the_bob_counts_once() {
    let mut bench = bench();
    bench.press(Buttons::START);
    for _ in 0..4 {
        bench.bob();
        bench.wait(100);
    }
    assert_eq!(bench.score(), 1, "touches that follow within 300 ms belong to the same swing");
    bench.wait(300);
    bench.bob();
    assert_eq!(bench.score(), 2);
}

#[test]
fn a_silent_ball_is_searched_for_and_then_given_up() {
    let mut bench = bench();
    bench.press(Buttons::START);
    bench.wait(20_000);
    assert_eq!(bench.balls.len(), 1, "a ball at the plunger may wait");
    bench.launch();
    bench.wait(11_700);
    assert!(!bench.ordered(Command::BallSearch), "patience");
    bench.wait(4_000);
    let rounds = bench.orders.iter().filter(|order| **order == Command::BallSearch);
    assert_eq!(rounds.count(), 3, "three rounds");
    assert_eq!(bench.balls.len(), 2, "then another ball");
    bench.launch();
    bench.balls.swap(0, 1);
    bench.drain();
    bench.wait(1);
    assert_eq!(bench.display().ball, 2, "the ball that was given up does not count");
}

#[test]
fn another_ball_is_asked_for_within_fifteen_seconds_of_the_last_switch() {
    for late in 0..100 {
        let mut bench = bench();
        bench.press(Buttons::START);
        bench.launch();
        bench.wait(late);
        bench.hit("lane");
        bench.wait(14_998);
        let rounds = bench.orders.iter().filter(|order| **order == Command::BallSearch).count();
        assert_eq!((rounds, bench.balls.len()), (3, 2), "{late} ms after a look");
    }
}

#[test]
fn a_ball_that_was_given_up_and_comes_free_is_in_play_again() {
    let mut bench = bench();
    bench.press(Buttons::START);
    bench.launch();
    bench.wait(16_000);
    assert_eq!(bench.balls.len(), 2);
    bench.launch();
    bench.balls[0].center.y += 0.2;
    bench.wait(200);
    bench.drain();
    bench.wait(1);
    assert_eq!(bench.display().ball, 1, "one of two balls was lost");
}

#[test]
fn a_player_may_hold_a_ball_on_a_flipper() {
    let mut bench = bench();
    bench.press(Buttons::START);
    bench.launch();
    bench.hold(Buttons::LEFT);
    bench.wait(25_000);
    assert!(!bench.ordered(Command::BallSearch));
}

#[test]
fn a_script_that_forgets_the_ball_is_helped() {
    let rules = "fn on_button(name) { start_game(1); }";
    let mut bench = Bench::new(table(rules, &["lane", "plunger"], &[])).expect("the rules are sound");
    bench.press(Buttons::START);
    bench.wait(16_000);
    assert_eq!(bench.balls.len(), 1);
}

#[test]
fn kickback_magnet_and_diverter_do_what_the_script_says() {
    let rules = "fn on_switch(name) { kick(\"kickback\"); magnet(\"magnet\", true); divert(\"diverter\", true); }
        fn on_open(name) { magnet(\"magnet\", false); divert(\"diverter\", false); }
        fn on_button(name) { if name == \"nudge-down\" { score(1); start_game(1); } }
        fn on_slam() { game_over(); }";
    let parts = ["lane", "kickback", "magnet", "diverter"];
    let mut bench = Bench::new(table(rules, &parts, &[])).expect("the rules are sound");
    bench.close("lane");
    bench.wait(1);
    let [kickback, magnet, diverter] = ["kickback", "magnet", "diverter"].map(|name| bench.part(name));
    let on = [Command::Kick(kickback), Command::Magnet(magnet, true), Command::Divert(diverter, true)];
    assert_eq!(bench.orders, on);
    bench.orders.clear();
    bench.hit("lane");
    bench.wait(1);
    assert!(bench.ordered(Command::Magnet(magnet, false)) && bench.ordered(Command::Divert(diverter, false)));
    bench.press(Buttons::NUDGE_DOWN);
    assert!(bench.display().playing);
    bench.slam();
    assert!(!bench.display().playing);
    assert_eq!(bench.rules.take_complaints(), Vec::<String>::new());
}

#[test]
fn a_message_that_counts_does_not_come_anew() {
    let rules = "fn on_switch(name) { this.count = 1 + if this.count == () { 0 } else { this.count };
        message(name.to_upper(), `${this.count}`, 500); }";
    let mut bench = Bench::new(table(rules, &["lane", "other"], &[])).expect("the rules are sound");
    bench.close("lane");
    let since = bench.display().message_tick;
    bench.wait(100);
    bench.close("lane");
    assert_eq!((bench.display().message_tick, bench.display().message[1].as_str()), (since, "2"));
    bench.wait(499);
    assert_eq!(bench.display().message.len(), 2, "its time begins again");
    bench.wait(1);
    assert!(bench.display().message.is_empty());
    bench.close("lane");
    assert!(bench.display().message_tick > since, "it had gone");
    let since = bench.display().message_tick;
    bench.close("other");
    assert!(bench.display().message_tick > since, "another headline");
}
