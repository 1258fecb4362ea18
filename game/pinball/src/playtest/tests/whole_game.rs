//! What a whole game shows of rules with one fault each, wherever the walls lead a ball.

use super::{WALLS, playtest, playtest_of, sentences};
use crate::playtest::FindingKind;
use crate::table::tests::{spectrum, with_rules};

/// Rules that begin a game, and what they do when the ball is lost.
const GAME: &str =
    "fn on_button(name) { if name == \"start\" && !playing() { start_game(3); flippers(true); add_ball(); } }
fn on_timer(name) { eject(\"hole\"); }
fn on_switch(name) {
  if name == \"hole\" { after(1000, \"out\"); }
  if name == \"drain\" && balls_in_play() == 0 { if next_player() { add_ball(); } else { game_over(); } }
}";
const HOLE: &str =
    r#"<circle class="saucer" id="hole" cx="200" cy="300" r="15" data-eject-deg="90" data-eject-m-s="1"/>"#;
const DRAIN: &str = r#"<line class="drain" id="drain" x1="90" y1="960" x2="410" y2="960" stroke-width="10"/>"#;
/// A floor from wall to wall, so that no ball comes to the drain by itself but through its middle, and that slowly.
const BASIN: &str = r#"<path class="wall" d="M10 700H210M250 700H460" fill="none" stroke-width="6"/>
<path class="wall" d="M200 690V660M260 690V660" fill="none" stroke-width="6"/>"#;

fn told(drawn: &str, rules: &str) -> Vec<String> {
    let playtest = playtest_of(with_rules(&format!("{WALLS}{HOLE}{drawn}"), rules));
    sentences(&playtest, playtest.first_game().unwrap().0)
}

/// What is told of a game with these rules.
fn first_game(rules: &str) -> Vec<FindingKind> {
    kinds(DRAIN, rules)
}

fn kinds(drawn: &str, rules: &str) -> Vec<FindingKind> {
    let playtest = playtest_of(with_rules(&format!("{WALLS}{HOLE}{drawn}"), rules));
    playtest.first_game().unwrap().0.iter().map(|finding| finding.kind).collect()
}

fn changed(from: &str, to: &str) -> String {
    assert!(GAME.contains(from), "{from}");
    GAME.replace(from, to)
}

/// It was a warning that named no line.
#[test]
fn a_game_that_never_begins_is_told() {
    let found = |rules: &str| {
        let playtest = playtest_of(with_rules(WALLS, rules));
        let found = playtest.first_game().unwrap().0;
        (found[0].kind, found[0].is_warning(), sentences(&playtest, found)[0].clone())
    };
    let (kind, is_warning, told) =
        found("const A = 1;\nfn on_button(name) { if name == \"strat\" { start_game(3); } }");
    assert!(kind == FindingKind::NoGame && !is_warning, "{told}");
    assert!(told.starts_with("rules.rhai:2: no game begins when start is pressed; "), "{told}");
    // A table that only shows lamps is none that cannot be played.
    let (kind, is_warning, told) = found("fn on_start() { now(); } // no start_game");
    assert!(kind == FindingKind::NoStart && is_warning && told.starts_with("warning: rules.rhai: no game"), "{told}");
    // A second coin, or another button.
    let coins = changed(
        "name == \"start\" && ",
        "name == \"start\" { this.coins = if \"coins\" in this { 2 } else { 1 }; }
        if name == \"start\" && this.coins == 2 && ",
    );
    assert_eq!(first_game(&coins), []);
    assert_eq!(first_game(&changed("\"start\"", "\"plunger\"")), []);
}

/// A game of three balls that was over with the first one was called good.
#[test]
fn a_game_that_is_over_too_early_is_told() {
    let early = changed(
        "if next_player() { add_ball(); } else { game_over(); }",
        "if !next_player() { add_ball(); } else { game_over(); }",
    );
    assert_eq!(first_game(&early), [FindingKind::OverEarly]);
    let told = told(DRAIN, &early);
    assert!(told[0].contains("the game is over when 1 ball is lost in drain"), "{told:?}");
}

/// A bumper called `next_player()`: the advice was to call `game_over()` where that is false, as the rules did.
#[test]
fn turns_that_end_in_play_are_told_with_the_lines_that_end_them() {
    let rules = format!("{GAME}\nfn on_launch() {{ next_player(); next_player(); }}");
    let told = told(DRAIN, &rules);
    let expected = "for turns have ended while a ball was in play; call `next_player()` only where a ball is lost (it is called in \
                    lines 5 and 7)";
    assert!(told.len() == 1 && told[0].ends_with(expected), "{told:?}");
}

/// A press of start in play gave the first ball anew, and all points were gone: check said ok.
#[test]
fn a_game_that_begins_anew_in_play_is_told() {
    let anew = changed(" && !playing()", "");
    let told = told(DRAIN, &anew);
    let expected = "warning: rules.rhai:1: a game begins while a ball of another is in play, and the players' points are gone; \
                    ask `!playing()` before `start_game`";
    assert_eq!(told, [expected]);
    assert!(first_game(&changed("name == \"start\" && !playing()", "true")).contains(&FindingKind::BeginsAnew));
    assert_eq!(
        first_game(&changed("!playing()", "(!playing() || ball() > 1)")),
        [],
        "as machines did, later in a game"
    );
    assert_eq!(
        first_game(&changed(
            "if name == \"start\"",
            "if name == \"start\" && playing() { add_player(); } else if name == \"start\""
        )),
        []
    );
    // A switch that begins one, in the plunger's lane.
    let switch = GAME.replace("\"hole\" { after", "\"pop\" { start_game(3); }\n if name == \"hole\" { after");
    let pop = r#"<line class="rollover" id="pop" x1="480" y1="500" x2="480" y2="540" stroke-width="20"/>"#;
    let playtest = playtest_of(with_rules(&format!("{WALLS}{HOLE}{DRAIN}{pop}"), &switch));
    let run = playtest.bot_run().unwrap();
    assert!(run.findings.iter().any(|finding| finding.kind == FindingKind::BeginsAnew), "{:?}", run.findings);
}

/// Games without flippers, without a ball, without an end were called good: all that is needed was in the rules, and none
/// of it came.
#[test]
fn rules_that_leave_a_game_unplayable_are_told() {
    assert_eq!(first_game(GAME), []);
    let changed = |from, to| first_game(&changed(from, to));
    assert_eq!(changed(" add_ball(); } }", " } }"), [FindingKind::NoBall]);
    assert_eq!(changed("flippers(true)", "flippers(playing() && ball() > 1)"), [FindingKind::DeadFlippers]);
    assert_eq!(changed("\"drain\" &&", "\"drian\" &&"), [FindingKind::BallWithoutEnd]);
    assert_eq!(changed("\"hole\" {", "\"hloe\" {"), [FindingKind::NeverEjected]);
}

/// `kickers(true)` stood only where the second ball begins, and the bumpers were dead all through the first.
#[test]
fn bumpers_that_are_dead_while_a_ball_is_in_play_are_told() {
    let bumper = format!("{DRAIN}<circle class='bumper' id='pop' cx='300' cy='200' r='30'/>");
    let kinds = |begin: &str, next: &str| {
        let rules = changed("flippers(true); add_ball();", &format!("flippers(true); {begin} add_ball();"));
        kinds(&bumper, &rules.replace("if next_player() {", &format!("if next_player() {{ {next}")))
    };
    assert_eq!(kinds("kickers(true);", ""), []);
    assert_eq!(kinds("", "kickers(true);"), [FindingKind::DeadKickers]);
    assert_eq!(kinds("kickers(true);", "kickers(false);"), [FindingKind::DeadKickers]);
    // That no rule ever switches them on is told without play.
    assert_eq!(kinds("", ""), []);
}

/// On a table whose first ball was not lost within the trial nothing was said of what a lost ball leads to, and behind the
/// first ball nothing on any.
#[test]
fn a_lost_ball_without_a_consequence_is_told_on_every_table_and_of_every_ball() {
    for table in [DRAIN.to_string(), format!("{DRAIN}{BASIN}")] {
        let kinds = |from, to| kinds(&table, &changed(from, to));
        assert_eq!(kinds("3", "3"), []);
        assert_eq!(kinds("\"drain\" &&", "\"drian\" &&"), [FindingKind::BallWithoutEnd]);
        assert_eq!(
            kinds("{ if next_player() { add_ball(); } else { game_over(); } }", "{ }"),
            [FindingKind::BallWithoutEnd]
        );
        assert_eq!(kinds("{ add_ball(); } else", "{ } else"), [FindingKind::NoNextBall]);
        assert_eq!(kinds("{ game_over(); }", "{ }"), [FindingKind::NoGameOver]);
        assert_eq!(
            kinds("{ if next_player() { add_ball(); } else { game_over(); } }", "{ next_player(); add_ball(); }"),
            [FindingKind::GameWithoutEnd]
        );
        assert_eq!(kinds("&& balls_in_play() == 0 ", ""), [FindingKind::EndsEarly]);
        // Behind the second ball.
        assert_eq!(kinds("{ add_ball(); } else", "{ if ball() < 3 { add_ball(); } } else"), [FindingKind::NoNextBall]);
        assert_eq!(kinds("{ add_ball(); }", "{ add_ball(); flippers(ball() < 3); }"), [FindingKind::DeadFlippers]);
        assert_eq!(kinds("!playing()", "!playing() && scores().len() == 0"), [FindingKind::NoNextGame]);
    }
    let told = told(DRAIN, &changed("{ add_ball(); } else", "{ } else"));
    let expected =
        "rules.rhai:3: ball 1 is lost in drain (table.svg line 8), `next_player()` begins the next turn, and no ball";
    assert!(told[0].starts_with(expected), "{told:?}");
}

/// What gives a lost ball back for a while, or once, is no fault; nor is a second ball.
#[test]
fn rules_that_mean_it_are_left_alone() {
    let lost = "if name == \"drain\" && balls_in_play() == 0 { ";
    let saves = |by: &str| first_game(&changed(lost, &format!("{lost} {by} {{ add_ball(); return; }} ")));
    let with_launch = |more: &str, by: &str| {
        let rules = changed(lost, &format!("{lost} if {by} {{ add_ball(); return; }} "));
        first_game(&format!("{rules}\nfn on_launch() {{ {more} }}"))
    };
    // Ball save: whenever a ball is shot, and so for ever if it is lost at once.
    assert_eq!(with_launch("after(15_000, \"save\");", "running(\"save\")"), []);
    // Two extra balls.
    let extra = "if !(\"extra\" in this) { this.extra = 0; } this.extra += 1; if this.extra <= 2";
    assert_eq!(saves(extra), []);
    // Each launch brings a second ball.
    let multiball = "if !(\"more\" in this) || this.more != ball() { this.more = ball(); add_ball(); }";
    assert_eq!(with_launch(multiball, "false"), []);
    // The next ball comes after a bonus.
    let late = changed("{ add_ball(); }", "{ after(9000, \"next\"); }")
        .replace("eject(\"hole\");", "if name == \"next\" { add_ball(); } else { eject(\"hole\"); }");
    assert_eq!(first_game(&late), []);
}

/// Of two drains one was forgotten.
#[test]
fn every_drain_is_tried() {
    let hole = r#"<circle class="drain" id="well" cx="300" cy="500" r="12"/>"#;
    let drawn = format!("{hole}{DRAIN}");
    assert_eq!(kinds(&drawn, &changed("name == \"drain\"", "name in [\"drain\", \"well\"]")), []);
    let told = told(&drawn, GAME);
    assert!(told.len() == 1 && told[0].contains(": ball 1 is lost in well (table.svg line 8) and nothing"), "{told:?}");
}

#[test]
fn spectrum_plays_a_whole_game() {
    let playtest = playtest_of(spectrum());
    assert_eq!(sentences(&playtest, playtest.first_game().unwrap().0), Vec::<String>::new());
    assert_eq!(playtest.loss_places().drains.len(), 1);
}

#[test]
fn a_saucer_that_waits_for_the_player_or_locks_its_ball_is_left_alone() {
    let timer = "if name == \"hole\" { after(1000, \"out\"); }";
    let asks = GAME
        .replace(timer, "")
        .replace("fn on_button(name) {", "fn on_button(name) { if name == \"left\" { eject(\"hole\"); }");
    assert_eq!(first_game(&asks), []);
    assert_eq!(first_game(&GAME.replace(timer, "if name == \"hole\" { add_ball(); }")), []);
}

#[test]
fn the_small_table_can_lose_its_balls() {
    assert_eq!(playtest(DRAIN).loss_places().drains.len(), 1, "the other is out of reach below it");
    assert!(playtest("").loss_places().refuge.is_some());
}

/// Rules that tilt every ball as it comes were not told of it, or of flippers that are dead.
#[test]
fn a_machine_that_is_always_tilted_is_told_so() {
    assert_eq!(first_game(&changed("flippers(true);", "flippers(true); tilt(true);")), [FindingKind::AlwaysTilted]);
    let once = "flippers(true); tilt(true); after(100, \"right\");";
    let rules =
        changed("flippers(true);", once).replace("eject(\"hole\");", "eject(\"hole\"); tilt(false); flippers(true);");
    assert_eq!(first_game(&rules), []);
    // Flippers that were given back hid a tilt under which nobody ever scored; so did the time before the plunger shot.
    assert_eq!(first_game(&changed("flippers(true);", "tilt(true); flippers(true);")), [FindingKind::AlwaysTilted]);
    let launched = format!("{GAME}\nfn on_launch() {{ tilt(true); }}");
    assert_eq!(first_game(&launched), [FindingKind::AlwaysTilted]);
    let told = told(DRAIN, &launched);
    assert!(
        told[0].starts_with("rules.rhai:7: the machine is tilted as long as ball 1 of a game is in play"),
        "{told:?}"
    );
}

/// Flippers that lived until the plunger shot were live for the trial, and dead in every ball.
#[test]
fn flippers_that_die_with_the_shot_are_told() {
    let with_launch = |rules: &str, done: &str| format!("{rules}\nfn on_launch() {{ {done} }}");
    let dead = with_launch(GAME, "flippers(false);");
    assert_eq!(first_game(&dead), [FindingKind::FlippersDieAtLaunch]);
    let expected = "rules.rhai:7: the flippers are live while ball 1 of a game waits at the plunger, and dead when it has been \
                    shot; call `flippers(false)` only where a game is over";
    assert_eq!(told(DRAIN, &dead), [expected]);
    assert_eq!(first_game(&with_launch(&changed("flippers(true);", ""), "flippers(true);")), []);
    let soon = GAME.replace("eject(\"hole\");", "eject(\"hole\"); flippers(true);");
    assert_eq!(first_game(&with_launch(&soon, "flippers(false); after(500, \"live\");")), []);
}

/// With a captive ball on the table the trial of a saucer ended before its 20 s: what held a ball was called good.
#[test]
fn a_saucer_that_keeps_its_ball_is_told_beside_a_captive_ball() {
    let captive = r#"<path class="guide" d="M88 467L82 460V435A18 18 0 0 1 118 435V460L112 467" stroke-width="4"/>
<circle class="captive-ball" id="cap" cx="100" cy="457" r="13.5"/>"#;
    let drawn = format!("{DRAIN}{captive}");
    assert_eq!(kinds(&drawn, GAME), []);
    assert_eq!(kinds(&drawn, &changed("after(1000", "after(60_000")), [FindingKind::NeverEjected]);
    let asks = changed("eject(\"hole\");", "if ball() > 100 { eject(\"hole\"); }");
    assert_eq!(kinds(&drawn, &asks), [FindingKind::NeverEjected]);
}

/// Drop targets that rules raised behind `1 > 2` fell once and lay for ever: some `raise` named them.
#[test]
fn a_drop_target_that_no_rule_raises_in_play_is_told() {
    let target = |id: &str, x: u32| {
        format!(r#"<line class="drop-target" id="{id}" x1="{x}" y1="500" x2="{}" y2="500" stroke-width="4"/>"#, x + 30)
    };
    let drawn = format!("{DRAIN}{}{}", target("d1", 150), target("d2", 250));
    let never = changed("eject(\"hole\");", "eject(\"hole\"); if 1 > 2 { raise(\"d1\"); raise(\"d2\"); }");
    assert_eq!(kinds(&drawn, &never), [FindingKind::NeverRaised; 2]);
    let told = told(&drawn, &never);
    assert!(
        told[0].starts_with("warning: table.svg:8: d1: in a trial every drop target was hit, and no rule"),
        "{told:?}"
    );
    // Of two the one.
    assert_eq!(kinds(&drawn, &never.replace("1 > 2 { raise(\"d1\");", "ball() > 0 {")), [FindingKind::NeverRaised]);
    // When both are down, when a ball begins, when a game does.
    let both = GAME.replace(
        "fn on_switch(name) {",
        "fn on_switch(name) {\n  if closed(\"d1\") && closed(\"d2\") { after(900, \"up\"); }",
    );
    assert_eq!(kinds(&drawn, &both.replace("eject(\"hole\");", "eject(\"hole\"); raise(\"d1\"); raise(\"d2\");")), []);
    let feeds = format!("{GAME}\nfn on_feed() {{ raise(\"d1\"); raise(\"d2\"); }}");
    assert_eq!(kinds(&drawn, &feeds), []);
    assert_eq!(kinds(&drawn, &changed("start_game(3);", "start_game(3); raise(\"d1\"); raise(\"d2\");")), []);
}

/// Rules that divided by 0 when the bob swung, or when the machine was slammed, were called good: nobody pushed it.
#[test]
fn what_the_rules_do_when_the_machine_is_pushed_is_tried() {
    let complaints = |more: &str| {
        let playtest = playtest_of(with_rules(&format!("{WALLS}{HOLE}{DRAIN}"), &format!("{GAME}\n{more}")));
        playtest.first_game().unwrap().1
    };
    let zero = "fn on_bob() { score(10 / (ball() - ball())); }";
    assert_eq!(complaints(zero), ["rules.rhai:7: 10 cannot be divided by 0"]);
    assert_eq!(complaints("fn on_slam() { score(scores()[9]); }").len(), 1);
    assert_eq!(complaints("fn on_bob() { this.n = (this.n ?? 0) + 1; if this.n > 3 { score([]); } }").len(), 1);
    for name in ["left", "right", "nudge-left", "nudge-right", "nudge-up", "nudge-down"] {
        let told = complaints(&format!("fn on_release(name) {{ if name == \"{name}\" {{ score([]); }} }}"));
        assert_eq!(told.len(), 1, "{name}");
    }
    assert_eq!(complaints("fn on_bob() { tilt(true); } fn on_slam() { game_over(); }"), [""; 0]);
    // A saucer's ball, wherever the walls lead balls.
    let out = GAME.replace("eject(\"hole\");", "eject(\"hole\"); score([]);");
    let playtest = playtest_of(with_rules(&format!("{WALLS}{HOLE}{DRAIN}"), &out));
    assert_eq!(playtest.first_game().unwrap().1.len(), 1);
}
