//! One mistake, one sentence.

use super::{told, told_of};
use crate::rules::program::Program;
use crate::rules::tests::bench::table;

/// A name in a constant was told at each of its uses, and never where it stands.
#[test]
fn a_name_in_a_constant_is_told_where_it_stands() {
    let rules = "const DROPS = [\"drop-1\", \"drop2\"];\nfn on_button(n) { start_game(1); flippers(true); add_ball(); score(1);\n\
                 for d in DROPS { raise(d); }\nfor d in DROPS { raise(d); } }";
    let told = told_of(rules, &["drop-1", "drop-2"]);
    assert_eq!(told, ["1: there is no part called \"drop2\" in the drawing; did you mean \"drop-2\"?"]);
}

/// A start that is nearly another was told with a lamp that nobody meant, and then with another start.
#[test]
fn a_start_has_one_hint_and_letters_that_changed_places_come_first() {
    let table = table("fn on_start() { lamp(\"lihgt-*\", \"on\"); }", &[], &["i-a", "light-1", "light-2"]);
    let failure = Program::new(&table).map(|_| ()).unwrap_err().to_string();
    let hint = "bench/rules.rhai:1: there is no lamp called \"lihgt-*\" in the drawing; did you mean \"light-*\"?";
    assert_eq!(failure, hint);
}

/// A comment that swallowed the rules was told, and with it that there are none.
#[test]
fn what_a_comment_has_swallowed_is_not_missing() {
    let told = told("/* fn on_start() { }");
    assert!(told.len() == 1 && told[0].contains("is never closed"), "{told:?}");
}

/// Rules without `flippers(true)` were told that they have it where a game begins.
#[test]
fn flippers_that_never_move_are_told_once() {
    let told = told("fn on_button(n) { start_game(1); add_ball(); score(1); } fn on_bob() { tilt(true); }");
    assert!(!told.iter().any(|one| one.contains("a tilt kills the flippers")), "{told:?}");
}

/// An entry that is never set was told in each line that reads it; a timer in each that starts it.
#[test]
fn the_same_mistake_in_two_lines_is_told_in_the_first() {
    let entry = told(
        "fn on_start() { this.bonuss = 0; }\nfn on_feed() { score(this.bonus); }\nfn on_launch() { score(this.bonus); }",
    );
    assert_eq!(
        entry,
        ["warning: 2: this.bonus is read here (and in line 3), and no rule ever sets it; did you mean this.bonuss?"]
    );
    let timer = told("fn on_start() { after(9, \"go\"); }\nfn on_feed() { after(8, \"go\"); }");
    assert_eq!(timer, ["warning: 1: the timer \"go\" is started for nothing: there is no `on_timer(name)`"]);
}
