//! What a table's maker is told of rules that can be played and do not do what they say.

mod arguments;
mod handlers;
mod lost_ball;
mod told_once;
mod types;
mod undone;
mod unlit;
mod unreached;
mod unused_value;

use super::Review;
use crate::rules::tests::bench::table;
use crate::table::tests::spectrum;

const PARTS: [&str; 6] = ["dock", "drain", "lane-1", "lane-2", "plunger", "target"];

/// What is told of rules, without the file's name.
fn told(rules: &str) -> Vec<String> {
    told_of(rules, &PARTS)
}

fn told_of(rules: &str, parts: &[&str]) -> Vec<String> {
    let table = table(rules, parts, &["red", "light-1", "light-2"]);
    super::Program::new(&table).map(|_| ()).unwrap_or_else(|failure| panic!("{failure}"));
    let findings = Review::of(&table).findings;
    let told = findings.iter().map(|finding| finding.to_string().replace("bench/rules.rhai:", ""));
    // Hardly any of these rules has to do with lamps; `unlit` looks at them.
    told.filter(|one| !one.contains(" dark: no rule calls `lamp(")).collect()
}

const DOCK: &str = "1: there is no part called \"dokc\" in the drawing; did you mean \"dock\"?";

/// An arm with a misspelt name never came, and nobody said so.
#[test]
fn a_name_that_no_event_has_is_told_wherever_it_is_compared() {
    for rules in [
        "fn on_switch(name) { switch name { \"dokc\" => score(1), \"drain\" => score(2) } }",
        "fn on_switch(name) { switch name { \"drain\" | \"dokc\" => score(2) } }",
        "fn on_open(n) { if n == \"dokc\" { score(1); } }",
        "fn on_open(n) { if \"dokc\" != n { score(1); } }",
        "const DOCK = \"dokc\"; fn on_open(n) { if n == DOCK { score(1); } }",
        "fn on_open(n) { let m = n; if m == \"dokc\" { score(1); } }",
        "fn hit(part) { if part == \"dokc\" { score(1); } } fn on_switch(name) { this.hit(name); }",
    ] {
        assert_eq!(told(rules), [DOCK], "{rules}");
    }
    let below = "fn on_switch(name) {\n  switch name {\n    \"drain\" |\n    \"dokc\" =>\n      score(1),\n  }\n}";
    assert_eq!(told(below), [DOCK.replace("1:", "4:")]);
}

#[test]
fn a_name_that_may_be_another_is_warned_of_or_left_alone() {
    let listed = "const ALL = [\"dock\", \"dokc\"];\nfn on_switch(name) { if name in ALL { score(1); } }";
    assert_eq!(told(listed), [format!("warning: {DOCK}")]);
    assert_eq!(told(&listed.replace("name in ALL", "ALL.contains(name)")), [format!("warning: {DOCK}")]);
    for rules in [
        "fn on_switch(name) { if exists(\"dokc\") && name == \"dokc\" { score(1); } }",
        "fn on_switch(name) { name = \"x-\" + name; if name == \"x-dock\" { score(1); } }",
        "fn on_switch(name) { if name == \"dokc\" { score(1); } } fn on_feed() { this.on_switch(\"dokc\"); }",
        "fn on_switch(name) { let n = name.len(); if `${n}` == \"dokc\" { score(1); } }",
        "fn on_switch(name) { [1].for_each(|x| this == \"dokc\"); score(1); }",
        "fn hit(word) { if word == \"dokc\" { score(1); } } fn on_feed() { this.hit(\"dokc\"); }",
        "fn on_switch(name) { if name == \"\" { score(1); } }",
    ] {
        assert_eq!(told(rules), Vec::<String>::new(), "{rules}");
    }
}

#[test]
fn buttons_lamps_and_parts_without_a_switch_are_told_apart() {
    let start = "fn on_button(name) { if name == \"strat\" { score(1); } }";
    let buttons = "left, right, plunger, nudge-left, nudge-right, nudge-up, nudge-down, start";
    let expected = format!("1: there is no button called \"strat\"; did you mean \"start\"? (there are {buttons})");
    assert_eq!(told(start), [expected]);
    let lamp = "fn on_switch(name) { if name == \"red\" { score(1); } }";
    assert_eq!(told(lamp), ["1: \"red\" is a lamp, and no event is ever about a lamp; name a part"]);
    let silent = "fn on_switch(name) { if name == \"plunger\" { score(1); } }";
    assert_eq!(told(silent), ["warning: 1: \"plunger\" has no switch, so no event is ever about it"]);
}

/// A name in a constant was found only when it was used in play.
#[test]
fn names_modes_and_colours_are_followed_to_the_call() {
    let lamp = "1: there is no lamp called \"rde\" in the drawing; did you mean \"red\"?";
    for rules in [
        "const LAMP = \"rde\"; fn on_feed() { lamp(LAMP, \"on\"); }",
        "fn on_feed() { for name in [\"red\", \"rde\"] { lamp(name, \"on\"); } }",
        "fn on_feed() { let name = \"r\" + \"de\"; flash(name, 100); }",
        "fn on_feed() { lamp(if playing() { \"red\" } else { \"rde\" }, 500); }",
        "const LIGHT = #{ dock: \"rde\" }; fn on_feed() { lamp(LIGHT.dock, \"on\"); lamp(LIGHT[\"dock\"], \"on\"); }",
        "fn lit(name) { lamp(name, \"on\"); } fn on_feed() { this.lit(\"rde\"); this.lit(\"red\"); }",
    ] {
        assert_eq!(told(rules), [lamp], "{rules}");
    }
    let wrong =
        "fn on_feed() { lamp_color(\"red\", \"blue\"); flash(\"red\", 1, \"#12345\"); lamp(\"red\", \"puls\"); }";
    let told = told(wrong);
    assert_eq!(told.len(), 3, "{told:?}");
    assert!(told.contains(&"1: a colour is written \"#rrggbb\", not \"blue\"".to_string()), "{told:?}");
}

#[test]
fn timers_that_nobody_starts_or_hears_are_told_once() {
    let rules = |timer: &str, case: &str| {
        format!(
            "fn on_feed() {{ after(100, \"{timer}\"); }} fn on_timer(name) {{ switch name {{ \"{case}\" => score(1) }} }}"
        )
    };
    assert_eq!(told(&rules("eject", "eject")), Vec::<String>::new());
    let started = "warning: 1: no timer is called \"ejekt\": nothing starts it with `after`; did you mean \"eject\"?";
    assert_eq!(told(&rules("eject", "ejekt")), [started]);
    let two = told(&rules("eject", "reset"));
    let silent = "warning: 1: the timer \"eject\" is started for nothing: `on_timer` does nothing for it";
    assert_eq!(two, ["warning: 1: no timer is called \"reset\": nothing starts it with `after`", silent]);
    let unheard = "fn on_feed() { after(100, \"eject\"); }";
    assert_eq!(told(unheard), ["warning: 1: the timer \"eject\" is started for nothing: there is no `on_timer(name)`"]);
}

/// `cancel("egect")` stopped nothing, and the saucer's timer ran on.
#[test]
fn a_timer_that_is_stopped_or_asked_about_and_never_started_is_told() {
    let rules = |call: &str| {
        format!("fn on_feed() {{ after(100, \"eject\"); }} fn on_timer(name) {{ score(1); }}\nfn on_bob() {{ {call} }}")
    };
    let told = |call: &str| told(&rules(call));
    let meant = "nothing starts that timer with `after`; did you mean \"eject\"?";
    assert_eq!(told("cancel(\"egect\");"), [format!("warning: 2: `cancel(\"egect\")` stops nothing: {meant}")]);
    assert_eq!(
        told("if running(\"egect\") { score(1); }"),
        [format!("warning: 2: `running(\"egect\")` is always false: {meant}")]
    );
    let left = "warning: 2: `time_left(\"bonus\")` is always 0: nothing starts that timer with `after`";
    assert_eq!(told("score(time_left(\"bonus\"));"), [left]);
    assert_eq!(told("for timer in [\"eject\", \"late\"] { cancel(timer); }").len(), 1);
    for good in ["cancel(\"eject\");", "let timer = \"x\"; after(5, `${now()}`); cancel(timer);", "cancel(`${now()}`);"]
    {
        assert_eq!(told(good), Vec::<String>::new(), "{good}");
    }
}

#[test]
fn a_timer_that_somebody_may_hear_or_ask_about_is_left_alone() {
    for rules in [
        "fn on_feed() { after(100, \"x\"); } fn on_timer(name) { score(1); }",
        "fn on_feed() { after(100, \"x\"); } fn on_timer(name) { if name != \"y\" { score(1); } } fn on_bob() { after(1, \"y\"); let y = running(\"y\"); }",
        "fn on_feed() { after(100, \"x\"); } fn on_switch(name) { if running(\"x\") { score(1); } }",
        "fn on_feed() { after(100, \"x\"); } fn on_timer(name) { if name != \"x\" { return; } score(1); }",
        "fn on_switch(name) { after(100, name); } fn on_timer(name) { switch name { \"dock\" => score(1) } }",
        "fn on_feed() { after(1, \"x\"); } fn on_timer(name) { after(100, name); if name == \"x\" { score(1); } }",
        "fn on_switch(name) { after(100, `${name}-late`); } fn on_timer(name) { switch name { \"dock-late\" => score(1) } }",
    ] {
        assert_eq!(told(rules), Vec::<String>::new(), "{rules}");
    }
}

/// A jackpot that was read by a misspelt name ended the event in play, with `()` in the sentence.
#[test]
fn what_is_remembered_by_no_rule_is_told_where_it_is_read() {
    let rules = |read: &str| format!("fn on_start() {{ this.jackpot = 100; }}\nfn on_switch(name) {{ {read} }}");
    let unset = "warning: 2: this.jakpot is read here, and no rule ever sets it; did you mean this.jackpot?";
    for read in ["score(this.jakpot);", "this.jakpot += 1;", "if this.jakpot > 1 { score(1); }", "this.jakpot.x = 1;"] {
        assert_eq!(told(&rules(read)), [unset], "{read}");
    }
    for read in [
        "score(this.jackpot);",
        "if this.jakpot == () { score(1); }",
        "score(this.jakpot ?? 1);",
        "this[name] = 1; score(this.jakpot);",
        "this.set(name, 1); score(this.jakpot);",
        "let other = #{ jakpot: 1 }; other.gives();",
    ] {
        let rules = rules(read) + "\nfn gives() { score(this.jackpot); }";
        assert_eq!(told(&rules), Vec::<String>::new(), "{read}");
    }
    let foreign = "fn gives() { score(this.jakpot); }\nfn on_feed() { let other = #{ jakpot: 1 }; other.gives(); }";
    assert_eq!(told(foreign), Vec::<String>::new());
}

/// A game in which no rule gave a point was called good.
#[test]
fn rules_that_give_no_points_are_told() {
    let rules = "fn on_button(name) { start_game(1); add_ball(); message(`${score()}`, 0); } fn on_switch(name) { game_over(); }";
    let none =
        "warning: 1: no player can score: no rule calls `score(points)`; call it in `on_switch(name)`, as `score(100)`";
    assert_eq!(told(rules), [none]);
    assert_eq!(told(&rules.replace("game_over();", "5.score(); game_over();")), Vec::<String>::new());
}

/// A game whose flippers were never switched on was called good.
#[test]
fn calls_without_which_no_game_can_be_played_are_told() {
    let rules =
        "fn on_button(name) { if name == \"start\" { start_game(1); } } fn on_switch(name) { score(5); game_over(); }";
    let ball = "1: a game begins without a ball: no rule calls `add_ball()`; call it behind `start_game`";
    let saucer = " the saucer \"saucer\" keeps its ball: no rule calls `eject(\"saucer\")`; start a timer in \
                  `on_switch` and call it in `on_timer`";
    assert_eq!(told_of(rules, &["drain", "saucer"]), [saucer, ball]);
    let both = rules.replace("start_game(1);", "start_game(1); add_ball(); for hole in [\"saucer\"] { eject(hole); }");
    assert_eq!(told_of(&both, &["drain", "saucer"]), Vec::<String>::new());
    assert_eq!(told_of("fn on_feed() { score(1); }", &["drain", "saucer"]), Vec::<String>::new(), "nothing begins");
}

/// A magnet that holds a ball for ever, and a diverter that nobody turns, were called good.
#[test]
fn magnets_and_diverters_that_no_rule_works_are_told() {
    let drawn = [
        r#"<circle class="magnet" id="mag" cx="100" cy="300" r="40"/>"#,
        r#"<line class="diverter" id="dv" x1="300" y1="500" x2="330" y2="500" stroke-width="6" data-turn-deg="40"/>"#,
    ];
    let told = |more: &str| -> Vec<String> {
        let lost = "fn on_switch(name) { if name == \"drain#1\" { game_over(); } }";
        let begin = "start_game(1); flippers(true); kickers(true); add_ball();";
        let rules = format!("fn on_button(name) {{\n{begin} {more}\n}}\n{lost}");
        let review = Review::of(&crate::table::tests::with_rules(&drawn.concat(), &rules));
        let of_both = |one: &String| one.contains("magnet") || one.contains("diverter");
        review.findings.iter().map(ToString::to_string).filter(of_both).collect()
    };
    let both = told("");
    assert!(
        both[0].contains("the diverter \"dv\" never turns") && both[1].contains("the magnet \"mag\" never pulls"),
        "{both:?}"
    );
    let on = told("divert(\"dv\", playing()); magnet(\"mag\", true);");
    assert!(on.len() == 1 && on[0].contains("the magnet \"mag\" never lets go"), "{on:?}");
    for off in ["magnet(\"mag\", false);", "let is = playing(); magnet(\"mag\", is);"] {
        assert_eq!(told(&format!("divert(\"dv\", true); magnet(\"mag\", true); {off}")), Vec::<String>::new());
    }
}

/// A start with which no lamp's name begins was told without what was meant.
#[test]
fn a_misspelt_start_of_names_is_told_with_what_was_meant() {
    let told = told("fn on_feed() { for all in [\"ligth-*\"] { lamp(all, \"on\"); } }");
    let lack = "1: there is no lamp called \"ligth-*\" in the drawing; did you mean \"light-*\"?";
    assert_eq!(told, [lack]);
}

/// Bumpers and slingshots that nobody switched on were dead, and nothing was said.
#[test]
fn coils_that_no_rule_works_are_told() {
    let drawn = [
        r#"<circle class="bumper" id="pop" cx="100" cy="300" r="20"/>"#,
        r#"<line class="drop-target" id="drop" x1="200" y1="300" x2="220" y2="300"/>"#,
        r#"<line class="kickback" id="kb" x1="300" y1="500" x2="300" y2="480" stroke-width="20"/>"#,
    ];
    let told = |more: &str| -> Vec<String> {
        let lost = "fn on_switch(name) { if name == \"drain#1\" { game_over(); } }";
        let rules =
            format!("fn on_button(name) {{\nstart_game(1); flippers(true); add_ball(); score(5); {more}\n}}\n{lost}");
        let review = Review::of(&crate::table::tests::with_rules(&drawn.concat(), &rules));
        review.findings.iter().map(ToString::to_string).filter(|one| !one.contains("saucer")).collect()
    };
    let dead = told("");
    assert_eq!(dead.len(), 3, "{dead:?}");
    for (sentence, what) in dead.iter().zip([
        "the drop target \"drop\" falls once: no rule calls `raise(\"drop\")`",
        "the kickback \"kb\" never kicks: no rule calls `kick(\"kb\")`",
        "never work: no rule calls `kickers(true)`; call it behind `start_game`",
    ]) {
        assert!(sentence.contains(what), "{dead:?}");
    }
    assert_eq!(told("kickers(true); raise(\"drop\"); for kb in [\"kb\"] { kick(kb); }"), Vec::<String>::new());
}

/// Without play nothing was said of an empty file.
#[test]
fn rules_without_a_rule_are_told() {
    for empty in ["", "// later\n", "const BALLS = 3;"] {
        let told = told(empty);
        assert!(
            told.len() == 1 && told[0].starts_with("warning:") && told[0].contains("no game can begin: no rule"),
            "{told:?}"
        );
    }
    assert_eq!(told("fn on_feed() { score(1); }"), Vec::<String>::new());
}

#[test]
fn spectrum_is_left_alone() {
    let review = Review::of(&spectrum());
    assert_eq!(review.findings, []);
    assert!(review.messages.len() > 10);
}

#[test]
fn messages_are_known_as_far_as_they_stand_there() {
    let rules = "const LONG = 1500;\nfn say(line) { message(line, 0); }\nfn on_feed() {\n  message(\"JACKPOT\", LONG);\n  \
                 message(\"A\", \"B // C\", 0); // message(\"no\", 1)\n  message(`${now()} OF`, now());\n  this.say(\"X\"); \
                 message();\n}";
    let messages = Review::of(&table(rules, &PARTS, &[])).messages;
    let known: Vec<_> =
        messages.iter().map(|one| (one.line, one.texts().map(String::as_str).collect::<Vec<_>>(), one.ms)).collect();
    let expected = [
        (4, vec!["JACKPOT"], Some(1500)),
        (5, vec!["A", "B // C"], Some(0)),
        (6, vec![" OF"], None),
        (2, vec!["X"], Some(0)),
    ];
    assert_eq!(known, expected);
}
