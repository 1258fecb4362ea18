//! Rules that are wrong only in play, as their maker meets them on the command line.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A box with a bend, a plunger, a drain and two flippers.
const DRAWING: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 514 1067">
<path class="wall" d="M8 1060 V8 H506 V1060" stroke-width="8" fill="none"/>
<path class="wall" d="M462 1060 V200" stroke-width="8" fill="none"/>
<path class="wall" d="M462 1020 H506" stroke-width="8"/>
<path class="wall" d="M506 90 L420 8" stroke-width="8"/>
<path class="wall" d="M8 820 L145 900 M462 820 L324 900" stroke-width="8"/>
<line class="flipper" id="lf" x1="145.5" y1="900" x2="205" y2="933" stroke-width="18" data-side="left" data-up-deg="51"/>
<line class="flipper" id="rf" x1="324.5" y1="900" x2="265" y2="933" stroke-width="18" data-side="right" data-up-deg="51"/>
<line class="plunger" id="plunger" x1="484" y1="960" x2="484" y2="1006" stroke-width="30"/>
<rect class="drain" id="drain" x="12" y="1016" width="440" height="45"/>
</svg>"##;

/// The beginning of every script here: a game starts, a lost ball ends it.
const GAME: &str = r#"fn on_button(n) { if n == "start" && !playing() { start_game(3); flippers(true); kickers(true); add_ball(); score(1); } }
fn on_switch(n) { if n == "drain" && balls_in_play() == 0 { if !next_player() { game_over(); } else { add_ball(); } } }
"#;

/// A table's folder, gone when the test ends.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, rules: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("caustic-rules-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        for (file, text) in [("table.svg", DRAWING), ("table.toml", "name = \"x\""), ("rules.rhai", rules)] {
            fs::write(path.join(file), text).expect(file);
        }
        Folder(path)
    }

    /// What the program says: its exit code and standard output, and its complaint.
    fn run(&self, words: &[&str]) -> (Option<i32>, String, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_caustic"));
        let Output { status, stdout, stderr } = command.args(words).arg(&self.0).output().expect("the program runs");
        let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
        (status.code(), text(stdout), text(stderr))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// One that presses the flippers' buttons at random, as the bot does only where the ball comes to them.
const SIMULATE: [&str; 8] = ["simulate", "--games", "1", "--minutes", "0.2", "--player", "random", "--table"];

/// Both said nothing and ended with 0, because the script only went wrong when a ball was fed and shot.
#[test]
fn rules_that_do_not_end_in_play_end_check_and_simulate_with_1() {
    let rules = format!("{GAME}fn on_feed() {{ loop {{}} }}\nfn on_launch() {{ while true {{ let x = 1; }} }}\n");
    let folder = Folder::new("loop", &rules);
    let (code, said, complained) = folder.run(&["check"]);
    assert_eq!((code, said.as_str()), (Some(1), ""));
    for line in [3, 4] {
        assert!(
            complained
                .contains(&format!("rules.rhai:{line}: this does not come to an end, or does too much at once (")),
            "{complained}"
        );
    }
    let (code, said, complained) = folder.run(&SIMULATE);
    assert_eq!(code, Some(1), "{complained}");
    assert!(said.contains("rules.rhai:3: this does not come to an end, or does too much at once ("), "{said}");
    assert!(complained.contains("went wrong; --save-failures DIR keeps"), "{complained}");
}

/// What an endless script is told.
const ENDLESS: &str = "this does not come to an end, or does too much at once (the rules may take ";

/// A script ends with a sentence for its line in `check` and in `simulate`, and with nothing else.
fn ends_at_once(name: &str, rules: &str, line: usize, what: &str) {
    let folder = Folder::new(name, rules);
    let place = format!("rules.rhai:{line}: {what}");
    let (code, said, complained) = folder.run(&["check"]);
    assert_eq!((code, said.as_str(), complained.lines().count()), (Some(1), "", 1), "{complained}");
    assert!(complained.contains(&place), "{complained}");
    let (code, said, complained) = folder.run(&SIMULATE);
    assert_eq!((code, complained.lines().count()), (Some(1), 1), "{complained}");
    assert!(format!("{said}{complained}").contains(&place), "{said}{complained}");
}

/// A press of the left flipper took ten seconds: what `map` does to 4096 items was one operation.
#[test]
fn a_map_without_end_behind_a_button_ends_at_once() {
    let rules = r#"fn on_button(n) {
  if n == "start" && !playing() { start_game(3); flippers(true); add_ball(); score(1); }
  if n == "left" { let a = []; a.pad(4096, 1); loop { a.map(|x| x); } }
}
fn on_switch(n) { if n == "drain" && balls_in_play() == 0 { if next_player() { add_ball(); } else { game_over(); } } }
"#;
    ends_at_once("map", rules, 3, ENDLESS);
}

/// Switching on took a minute and a half: so did what `dedup` and `index_of` compare.
#[test]
fn a_search_without_end_at_the_start_ends_at_once() {
    let start = "fn on_start() { let a = []; for i in 0..4096 { a.push(i); } loop { a.dedup(); a.index_of(-1); } }";
    ends_at_once("dedup", &format!("{start}\n{GAME}"), 1, ENDLESS);
}

/// The sort of Rust's library panics when comparisons contradict each other, and the panic was printed.
#[test]
fn a_sort_by_chance_prints_no_panic() {
    let sort = "let a = []; for i in 0..200 { a.push(random(100)); } a.sort(|x, y| random(3) - 1); score(1);";
    let rules = format!("{GAME}fn on_launch() {{ {sort} }}\n");
    ends_at_once("sort", &rules, 3, "sort's function contradicts itself: ");
}

/// What `check` says of rules, one sentence a line.
fn check(name: &str, words: &[&str], rules: &str) -> (Option<i32>, String) {
    let (code, _, complained) = Folder::new(name, rules).run(words);
    (code, complained)
}

/// A case with a misspelt name was silently dead, and the table was good.
#[test]
fn a_case_that_never_comes_is_told_with_its_line_and_with_what_was_meant() {
    let rules = format!("{GAME}fn on_open(n) {{\n  switch n {{\n    \"drian\" => score(1),\n  }}\n}}\n");
    let (code, complained) = check("case", &["check", "--quick"], &rules);
    assert_eq!((code, complained.lines().count()), (Some(1), 1), "{complained}");
    let expected = "rules.rhai:5: there is no part called \"drian\" in the drawing; did you mean \"drain\"?\n";
    assert!(complained.ends_with(expected), "{complained}");
}

/// The game ended with its first ball, in a silence that only the ball search broke, and the table was good.
#[test]
fn a_lost_ball_that_nobody_hears_of_is_told() {
    let rules = GAME.replace("n == \"drain\"", "n.len() == 99");
    let (code, complained) = check("lost", &["check"], &rules);
    assert_eq!((code, complained.lines().count()), (Some(1), 1), "{complained}");
    let expected =
        "and nothing follows for 14 s, until the ball search gives another; when `on_switch` hears the drain";
    assert!(complained.contains("rules.rhai:2: ball 1 is lost in drain (table.svg line "), "{complained}");
    assert!(complained.contains(expected), "{complained}");
    assert_eq!(check("whole", &["check"], GAME).0, Some(0));
}

/// Letters without dots were gaps, and nobody said so.
#[test]
fn letters_that_the_display_has_no_dots_for_are_told() {
    let rules =
        format!("{GAME}fn on_bob() {{ message(`\u{65e5}\u{672c} ${{now()}}`, \"\u{c4}\u{d6}\u{dc}\", 900); }}\n");
    let (code, complained) = check("letters", &["check", "--quick"], &rules);
    assert_eq!((code, complained.lines().count()), (Some(0), 1), "{complained}");
    let expected = "rules.rhai:3: the display has no dots for `\u{65e5}`, `\u{672c}` of the message `\u{65e5}\u{672c} `: it leaves";
    assert!(complained.contains(expected), "{complained}");
}

/// Errors of the first game that `check` plays were dropped: a rule for the lost ball could fail in every game.
#[test]
fn what_the_rules_do_wrong_in_the_first_game_is_told_once() {
    let timer = "fn on_timer(name) { if name == \"x\" { score(1); } }\n";
    let lost = "fn on_switch(n) { if n == \"drain\" && balls_in_play() == 0 { ";
    for (name, from, to, line) in [
        ("launch", "fn on_timer", "fn on_launch() { let ms = 5; after(ms - 1005, \"x\"); }\nfn on_timer", 3),
        ("drain", lost, &format!("{lost}after(n.len() - 1000, \"x\"); "), 2),
    ] {
        let (code, told) = check(name, &["check"], &format!("{GAME}{timer}").replace(from, to));
        let place = format!("rules.rhai:{line}: a time must be from 0 to 86400000 ms, not -");
        assert_eq!((code, told.matches(&place).count()), (Some(1), 1), "{name}: {told}");
    }
}

/// A value of the wrong type was told twice, by the game that failed for it and by the review; and of several mistakes that keep
/// the rules from starting nobody said how many they are.
#[test]
fn a_mistake_is_told_once_and_all_are_counted() {
    let (status, told) = check("twice", &["check", "--quick"], &format!("{GAME}fn on_start() {{ score(\"5\"); }}\n"));
    assert_eq!((status, told.lines().count()), (Some(1), 1), "{told}");
    assert!(told.contains("rules.rhai:3: `score(points)` takes a whole number as `points`, not a text"), "{told}");
    let unknown = format!("{GAME}fn on_start() {{ evel(1); prunt(2); }}\n");
    let (status, told) = check("counted", &["check", "--quick"], &unknown);
    assert_eq!((status, told.lines().last()), (Some(1), Some("2 errors")), "{told}");
}

/// An entry of `this` that nothing sets was told by the review and by play, and a game of one ball as well.
#[test]
fn what_review_and_play_find_is_told_once() {
    let unset = format!("{GAME}fn on_launch() {{ score(2 * this.bonus); }}\n");
    let one_ball = GAME.replace("if !next_player() { game_over(); } else { add_ball(); }", "game_over();");
    for (name, rules, told) in [("unset", unset, "this.bonus was never set"), ("one", one_ball, "stays at its first")] {
        let (_, _, complained) = Folder::new(name, &rules).run(&["check"]);
        let lines: Vec<&str> = complained.lines().collect();
        assert!(lines.len() == 1 && lines[0].contains(told), "{name}: {complained}");
    }
}
