//! What the game's functions are given that they do not take, and switches that are asked in vain.

use super::{Review, told, told_of};
use crate::rules::host;
use crate::rules::signatures;

fn tells(call: &str, what: &str) {
    let rules = format!("fn on_feed() {{\n{call}; after(1, \"x\"); }}\nfn on_timer(name) {{ score(1); }}");
    assert_eq!(told(&rules), [what], "{call}");
}

/// `score("1000")` was found when the ball met the target, if it did.
#[test]
fn values_of_the_wrong_type_are_told_before_play() {
    for (call, what) in [
        (
            "score(\"1000\")",
            "2: `score(points)` takes a whole number as `points`, not a text (\"1000\"); write 1000 without quotes",
        ),
        (
            "after(\"throw\", 1000)",
            "2: `after(ms, timer)` is given its values in the wrong order: write `after(1000, \"throw\")`",
        ),
        (
            "lamp(3, \"on\")",
            "2: `lamp(name, mode)` or `lamp(name, level)` takes a text as `name`, not a whole number (3); a text stands in \
             quotes",
        ),
        (
            "lamp(\"red\", true)",
            "2: `lamp(name, mode)` or `lamp(name, level)` takes a text as `mode`, not true or false (true)",
        ),
        ("flippers(1)", "2: `flippers(on)` takes `true` or `false` as `on`, not a whole number (1); write true"),
        (
            "kickers(\"true\")",
            "2: `kickers(on)` takes `true` or `false` as `on`, not a text (\"true\"); write true without quotes",
        ),
        ("score([1])", "2: `score(points)` takes a whole number as `points`, not an array"),
        ("score(`${now()}`)", "2: `score(points)` takes a whole number as `points`, not a text"),
        ("score(playing() == true)", "2: `score(points)` takes a whole number as `points`, not true or false"),
        (
            "message(1500)",
            "2: message cannot be called with one value: it is `message()` or `message(line, ms)` or `message(line, line, ms)`",
        ),
        ("message(\"A\", \"B\")", "2: `message(line, ms)` takes a whole number as `ms`, not a text (\"B\")"),
        (
            "progress(\"A\", \"B\", 3)",
            "2: `progress(name, done, of)` takes a whole number as `done`, not a text (\"B\")",
        ),
    ] {
        tells(call, what);
    }
    let constant = "const POINTS = \"5\";\nfn on_feed() { score(POINTS); }";
    let told = told(constant);
    assert!(told[0].starts_with("2: `score(points)` takes a whole number as `points`, not a text (\"5\")"), "{told:?}");
}

/// A level of 5000 and a time below 0 were errors in play only.
#[test]
fn numbers_that_a_function_refuses_are_told_before_play() {
    for (call, what) in [
        ("lamp(\"red\", 5000)", "2: a lamp's level is from 0 to 1000, not 5000"),
        ("lamp(\"red\", \"blink\", -5)", "2: a time must be from 0 to 86400000 ms, not -5"),
        ("after(-1000, \"x\")", "2: a time must be from 0 to 86400000 ms, not -1000"),
        ("after(90_000_000, \"x\")", "2: a time must be from 0 to 86400000 ms, not 90000000"),
        ("flash(\"red\", -1)", "2: a time must be from 0 to 86400000 ms, not -1"),
        ("show(\"red\", \"on\", 100, 0, -100)", "2: a time must be from 0 to 86400000 ms, not -100"),
        ("message(\"A\", -1)", "2: a time must be from 0 to 86400000 ms, not -1"),
        ("random(0)", "2: random needs a number above 0, not 0"),
        ("score(0)", "warning: 2: `score(0)` gives no points"),
        ("score(-2000)", "warning: 2: `score(-2000)` takes points from the player; write 2000 if it is to give them"),
        (
            "lamp(\"red\", \"blink\", 0)",
            "warning: 2: a lamp cannot \"blink\" in 0 ms: name the time from one to the next, as 400",
        ),
    ] {
        tells(call, what);
    }
    let balls = told(
        "fn on_button(name) { start_game(0); flippers(true); add_ball(); } fn on_switch(name) { score(5); game_over(); }",
    );
    assert_eq!(balls, ["1: a game has 1 to 99 balls, not 0"]);
}

#[test]
fn values_that_are_right_or_not_known_are_left_alone() {
    for call in [
        "score(-now())",
        "let x = 5; score(x)",
        "let ms = \"x\"; ms = 5; score(ms)",
        "score(if playing() { 1 } else { 2 })",
        "lamp(\"red\", 0)",
        "lamp(\"red\", 1000)",
        "lamp(\"red\", if playing() { \"on\" } else { \"off\" })",
        "\"red\".lamp(\"on\")",
        "show(\"red\", \"on\", 0, 0, 0)",
        "flash(\"red\", 0)",
        "flash(\"red\", 100, \"#ffffff\")",
        "message(\"A\", \"B\", 0)",
        "message()",
        "after(0, \"x\")",
        "this.x = 1; after(this.x, \"x\")",
        "progress(\"A\", 0, 0)",
        "flippers(!playing() && tilted())",
        "random(1)",
        "tilt(true)",
    ] {
        let rules = format!("fn on_feed() {{\n{call}; after(1, \"x\"); }}\nfn on_timer(name) {{ score(1); }}");
        assert_eq!(told(&rules), Vec::<String>::new(), "{call}");
    }
    let passed = "fn give(points) { score(points); } fn on_feed() { give(5); }";
    assert_eq!(told(passed), Vec::<String>::new());
}

/// The table of signatures is what the functions take, and no more.
#[test]
fn every_function_has_its_signatures() {
    for function in host::all() {
        let counts: Vec<usize> = signatures::of(function.name).map(|one| one.parameters().count()).collect();
        let missing = (function.least..=function.most).filter(|count| !counts.contains(count));
        // A time alone would be no message.
        let missing: Vec<usize> = missing.filter(|count| (function.name, *count) != ("message", 1)).collect();
        assert!(
            missing.is_empty() && counts.iter().all(|count| function.takes(*count)),
            "{}: {counts:?}",
            function.name
        );
    }
}

/// `closed` of a wall was false for ever, and nobody said so.
#[test]
fn switches_that_cannot_answer_are_told() {
    let drawn = r#"<circle class="bumper" id="pop" cx="100" cy="300" r="20"/>
<line class="rollover" id="roll" x1="200" y1="300" x2="220" y2="300" stroke-width="10"/>"#;
    let told = |body: &str| -> Vec<String> {
        let table = crate::table::tests::with_rules(drawn, &format!("fn on_feed() {{\n{body}\n}}"));
        Review::of(&table).findings.iter().map(ToString::to_string).collect()
    };
    let never = "rules.rhai:2: `closed(\"left\")` is always false: \"left\" has no switch";
    assert_eq!(told("if closed(\"left\") { score(1); }"), [never]);
    let listed = told("for name in [\"left\", \"roll\"] { if closed(name) { score(1); } }");
    assert_eq!(listed, [format!("warning: {never}")]);
    let for_good = told("if closed(\"pop\") { score(1); }");
    assert!(for_good[0].starts_with("warning: rules.rhai:2: `closed(\"pop\")` is true for good once"), "{for_good:?}");
    assert_eq!(told("if closed(\"roll\") { score(1); }"), Vec::<String>::new());
}

#[test]
fn switches_that_never_open_are_told_where_on_open_waits_for_them() {
    let rules = |event: &str| format!("fn {event}(name) {{ if name == \"drain\" {{ score(1); }} }}");
    let never =
        "warning: 1: the switch of \"drain\" closes for a moment and is never told to open: hear it in `on_switch`";
    assert_eq!(told_of(&rules("on_open"), &["drain"]), [never]);
    assert_eq!(told_of(&rules("on_switch"), &["drain"]), Vec::<String>::new());
    let both = "fn hit(name) { if name == \"drain\" { score(1); } } fn on_open(name) { hit(name); } fn on_switch(name) { hit(name); }";
    assert_eq!(told_of(both, &["drain"]), Vec::<String>::new());
}
