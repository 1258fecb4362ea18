//! A lost ball of which nothing comes.

use super::told_of;

const BEGIN: &str = "fn on_button(name) { if name == \"start\" && !playing() { start_game(3); flippers(true); add_ball(); score(1); } }\n";

/// What is told of rules that begin a game so, on a table with a drain.
fn told(rules: &str) -> Vec<String> {
    told_of(&format!("{BEGIN}{rules}"), &["drain", "lane"])
}

/// The one sentence begins so.
fn tells(rules: &str, line: &str, what: &str) {
    let told = told(rules);
    assert_eq!(told.len(), 1, "{rules}: {told:?}");
    assert!(told[0].starts_with(&format!("{line}: {what}")), "{rules}: {told:?}");
}

/// A drain whose case was deleted, and one whose rule was empty, were called good.
#[test]
fn a_lost_ball_of_which_nothing_comes_is_told() {
    let lost = "a lost ball has no consequence: ";
    tells("", "1", &format!("{lost}there is no `on_switch(name)`; write one"));
    tells(
        "fn on_switch(name) { score(10); }",
        "2",
        &format!("{lost}`on_switch` does nothing of that kind for the drain"),
    );
    for empty in [
        "fn on_switch(name) { switch name { \"lane\" => score(1), \"drain\" => score(2) } }",
        "fn on_switch(name) { if name == \"drain\" && balls_in_play() == 0 { flippers(false); } }",
        "fn on_switch(name) { if name == \"drain\" { return; } if balls_in_play() == 0 { game_over_soon(); } } fn game_over_soon() { score(1); }",
        "fn on_switch(name) { if name == \"drain\" { after(500, \"end\"); } } fn on_timer(name) { if name == \"end\" { score(1); } }",
        "fn lost() { if next_player() { add_ball(); } else { game_over(); } } fn on_switch(name) { if name == \"drain\" { score(1); } }",
        "fn on_switch(name) { if name == \"drain\" { score(1); } } fn on_slam() { game_over(); }",
        "fn on_switch(name) { if name == \"drain\" { score(1); } if name == \"lane\" { add_ball(); } }",
    ] {
        tells(empty, "2", &format!("{lost}what `on_switch` does for \"drain\" never comes to"));
    }
}

/// Rules that hear a lost ball in many ways.
#[test]
fn a_lost_ball_that_may_have_a_consequence_is_left_alone() {
    let next = "if next_player() { add_ball(); } else { game_over(); }";
    for rules in [
        format!("fn on_switch(name) {{ switch name {{ \"lane\" => score(1), _ => {{ {next} }} }} }}"),
        format!("fn on_switch(name) {{ if name.starts_with(\"dr\") {{ {next} }} }}"),
        format!("const ENDS = [\"drain\"]; fn on_switch(name) {{ if name in ENDS {{ {next} }} }}"),
        format!("fn is_end(name) {{ name == \"drain\" }} fn on_switch(name) {{ if is_end(name) {{ {next} }} }}"),
        format!("fn on_switch(name) {{ let n = name; if n != \"drain\" {{ return; }} this.lost(); }} fn lost() {{ {next} }}"),
        format!("fn on_switch(name) {{ if balls_in_play() == 0 {{ {next} }} }}"),
        format!("fn on_switch(name) {{ if name == \"drain\" {{ after(9, \"x\"); }} }} fn on_timer(name) {{ if name == \"x\" {{ {next} }} }}"),
        format!("fn on_switch(name) {{ if name == \"drain\" {{ after(9, name); }} }} fn on_timer(name) {{ if name == \"drain\" {{ {next} }} }}"),
        format!("fn on_start() {{ after(9, \"x\"); }} fn on_timer(name) {{ after(9, \"x\"); if balls_in_play() == 0 {{ {next} }} }}"),
        format!("fn on_switch(name) {{ if name == \"lane\" {{ {next} }} }}"),
        format!("fn on_switch(name) {{ let f = |x| {{ {next} }}; f.call(name); }}"),
        // The player asks for the next ball.
        "fn on_switch(name) { if name == \"drain\" { this.waits = true; } else { this.waits = false; } } fn on_release(name) { if this.waits { if next_player() { add_ball(); } else { game_over(); } } }".to_string(),
        // A game of one ball.
        "fn on_switch(name) { if name == \"drain\" { game_over(); } } fn on_bob() { next_player(); }".to_string(),
        // The next game begins by itself.
        "fn on_switch(name) { if name == \"drain\" { if next_player() { add_ball(); } else { start_game(3); add_ball(); } } }".to_string(),
    ] {
        assert_eq!(told(&rules), Vec::<String>::new(), "{rules}");
    }
    assert_eq!(told_of(BEGIN, &["lane"]), Vec::<String>::new(), "no drain, no lost ball");
}

/// Timers that only a lost ball starts do not run without it, and `running` says so.
#[test]
fn a_timer_that_nothing_starts_is_no_consequence() {
    let hurry = "fn on_release(name) { if running(\"bonus\") { after(1, \"bonus\"); } }\nfn on_timer(name) { switch name { \"bonus\" => if next_player() { add_ball(); } else { game_over(); } } }\n";
    let lost = |body: &str| format!("{hurry}fn on_switch(name) {{ if name == \"drain\" {{ {body} }} }}");
    assert_eq!(told(&lost("after(700, \"bonus\");")), Vec::<String>::new());
    let no = "a lost ball has no consequence: ";
    tells(&lost("flippers(false);"), "4", no);
    let side = "let side = if playing() { \"left\" } else { \"right\" }; after(9, \"boost-\" + side); let runs = running(\"boost-\" + side);";
    tells(&lost(side), "4", no);
    assert_eq!(told(&lost("let timer = \"bon\" + \"us\"; after(9, timer);")), Vec::<String>::new());
}

/// `next_player()` without `add_ball()`, and the other way round, were called good; so was a game without an end.
#[test]
fn a_ball_that_never_comes_and_a_game_that_never_ends_are_told() {
    let drain = |body: &str| format!("fn on_switch(name) {{ if name == \"drain\" {{ {body} }} }}");
    let never = "the next ball never comes: `add_ball()` is called only where a game begins";
    tells(&drain("if !next_player() { game_over(); }"), "2", never);
    tells(&drain("if next_player() { score(1); } else { game_over(); }"), "2", never);
    let end = "the game never ends: no rule that a lost ball comes to calls `game_over()`";
    tells(&drain("if next_player() { add_ball(); }"), "2", end);
    tells(&format!("{} fn on_slam() {{ game_over(); }}", drain("if next_player() { add_ball(); }")), "2", end);
    tells(&drain("add_ball();"), "warning: 1", end);
    let first = "a game of 3 balls stays at its first: no rule calls `next_player()`";
    tells(&drain("game_over();"), "warning: 1", first);
    let one = format!("{}{}", BEGIN.replace("start_game(3)", "start_game(1)"), drain("game_over();"));
    assert_eq!(told_of(&one, &["drain"]), Vec::<String>::new());
}

/// Rules in which everything calls everything else are looked through in no time.
#[test]
fn rules_of_many_calls_take_no_time() {
    let calls = (0..60).map(|other| format!("f{other}(name); ")).collect::<String>();
    let functions =
        (0..60).map(|own| format!("fn f{own}(name) {{ {calls} if name == \"lane\" {{ score({own} + 1); }} }}\n"));
    let rules = format!("{}fn on_switch(name) {{ f0(\"a\"); f1(name); }}", functions.collect::<String>());
    tells(&rules, "62", "a lost ball has no consequence: ");
}
