//! What is wrong with a script is said with its line, and never stops the game.

use super::bench::{Bench, table};

fn mistake(rules: &str) -> String {
    match Bench::new(table(rules, &["lane", "saucer", "drop-1"], &["red", "green"])) {
        Ok(_) => String::new(),
        Err(failure) => failure.to_string(),
    }
}

#[test]
fn a_literal_name_that_the_drawing_lacks_is_found_before_play() {
    let rules =
        "fn on_switch(name) {\n  if name == \"never\" {\n    lamp(\"rde\", \"on\"); // lamp(\"blue\", 1)\n  }\n}";
    assert_eq!(
        mistake(rules),
        "bench/rules.rhai:3: there is no lamp called \"rde\" in the drawing; did you mean \"red\"?"
    );
}

#[test]
fn every_wrong_name_is_named_at_once() {
    let rules = "fn on_switch(name) {\n  raise(\"saucer\");\n  eject(\"hole\");\n  flash(\"x*\", 10);\n}";
    assert_eq!(mistake(rules).lines().count(), 3, "{}", mistake(rules));
}

#[test]
fn a_name_that_the_script_asks_about_may_be_absent() {
    assert_eq!(mistake("fn on_launch() { if exists(\"gate\") { closed(\"gate\"); } }"), "");
}

#[test]
fn a_name_made_at_run_time_is_found_when_it_is_used() {
    let rules = "fn on_start() {\n  let name = \"lamp-\" + 3;\n  lamp(name, \"on\");\n}";
    assert_eq!(mistake(rules), "bench/rules.rhai:3: there is no lamp called \"lamp-3\" in the drawing");
}

#[test]
fn syntax_variables_and_functions_are_checked_with_their_lines() {
    assert!(mistake("fn on_start() {\n  lamp(\"red\" \"on\");\n}").starts_with("bench/rules.rhai:2: "));
    assert!(mistake("fn on_start() {\n\n  nothing_like_it(1);\n}").starts_with("bench/rules.rhai:3: "));
    assert!(mistake("fn on_swich(name) {}").contains("nothing calls on_swich"));
    assert!(mistake("fn on_start() {\n  if nobody > 1 {}\n}").starts_with("bench/rules.rhai:2: "));
    assert!(
        mistake("fn on_swich(name) {}").contains("nothing calls on_swich; did you mean `on_switch`? (there are on_s")
    );
    assert_eq!(
        mistake("\nfn on_timer() { if name == \"x\" { score(1); } }"),
        "bench/rules.rhai:2: on_timer is told one value: write `fn on_timer(name)`"
    );
    assert_eq!(
        mistake("fn on_bob(name) { lamp(name, 1); }"),
        "bench/rules.rhai:1: on_bob is told nothing: write `fn on_bob()`"
    );
}

/// `this.score(1000)` was told to have one value too few or too many, and of `score += 10` that there is no score.
#[test]
fn a_function_that_is_used_as_something_else_is_told_with_what_to_write() {
    let said = |call: &str| mistake(&format!("fn on_feed() {{ {call} }}")).replacen("bench/rules.rhai:1: ", "", 1);
    let alone = "nothing stands before score, no `this.` either: write `score(points)`";
    assert_eq!(said("this.score(1000);"), alone);
    let score =
        "score is a function, not a variable: `score()` is what the player has, and `score(10)` gives 10 points";
    assert_eq!(said("score += 10;"), score);
    assert_eq!(said("if ball == 1 { score(1); }"), "ball is a function, not a variable: write `ball()`");
    assert_eq!(said("\"red\".lamp(\"on\");"), "");
}

/// The drain that rules named had no id, and the sentence did not say so.
#[test]
fn a_part_without_an_id_is_named_by_its_line() {
    let rules = "fn on_switch(name) { if name == \"drain\" { score(1); } }";
    let review = crate::rules::Review::of(&crate::table::tests::with_rules("", rules));
    let told: Vec<String> = review.findings.iter().map(ToString::to_string).collect();
    let drain = "rules.rhai:1: there is no part called \"drain\" in the drawing; the drain of line 3 has no id; give it id=\"drain\"";
    assert_eq!(told, [drain]);
}

#[test]
fn coils_are_told_apart_by_what_they_are() {
    for (call, what) in [
        ("kick(\"lane\")", "\"lane\" is not a kickback"),
        ("magnet(\"lane\", true)", "\"lane\" is not a magnet"),
        ("divert(\"lane\", true)", "\"lane\" is not a diverter"),
        ("magnet(\"magent\", true)", "there is no part called \"magent\""),
    ] {
        let said = mistake(&format!("fn on_start() {{\n  {call};\n}}"));
        assert!(said.starts_with("bench/rules.rhai:2: ") && said.contains(what), "{said}");
    }
}

#[test]
fn a_script_without_end_is_cut_short_and_the_game_goes_on() {
    let rules = "fn on_start() { start_game(3); }\nfn on_switch(name) {\n  score(1); loop {}\n}";
    let mut bench = Bench::new(table(rules, &["lane"], &[])).expect("the rules are sound");
    bench.hit("lane");
    bench.hit("lane");
    let complaints = bench.rules.take_complaints();
    assert_eq!(complaints.len(), 1, "said once: {complaints:?}");
    assert!(complaints[0].starts_with("bench/rules.rhai:3: this does not come to an end"), "{complaints:?}");
    assert_eq!(bench.score(), 2, "what was done before the error stays done");
}

#[test]
fn a_script_that_grows_or_nests_without_end_is_cut_short() {
    for body in ["let a = [1]; loop { a += a; }", "let s = \"x\"; loop { s += s; }", "this.again();"] {
        let rules = format!("fn again() {{ this.again(); }}\nfn on_launch() {{ {body} }}");
        let mut bench = Bench::new(table(&rules, &["lane"], &[])).expect("the rules are sound");
        bench.launch();
        assert_eq!(bench.rules.take_complaints().len(), 1, "{body}");
    }
}

#[test]
fn the_deepest_script_that_is_taken_ends_with_a_sentence_on_a_small_stack() {
    for (open, close) in [("1 + (", ")"), ("if true { ", " }"), ("[", "][0]"), ("-(", ")")] {
        let nested = |depth: usize| {
            let body = format!("{}this.again(){}", open.repeat(depth), close.repeat(depth));
            let rules = format!("fn again() {{ {body} }}\nfn on_launch() {{ this.again(); }}");
            Bench::new(table(&rules, &["plunger"], &[])).ok()
        };
        let mut bench = (1..100).rev().find_map(nested).expect("some depth is taken");
        bench.launch();
        let complaints = bench.rules.take_complaints();
        assert!(complaints.len() == 1 && complaints[0].contains("overflow"), "{open}: {complaints:?}");
    }
}

/// Eight switches in each other took half a minute to read: what nine cases did alike was read nine times, in each of nine.
#[test]
fn cases_that_do_the_same_are_read_once() {
    let cases = |count: usize| (0..count).map(|case| case.to_string()).collect::<Vec<_>>().join(" | ");
    let nested = |count: usize, depth: usize| {
        let open = format!("switch x {{ {} => {{", cases(count)).repeat(depth);
        format!("fn on_start() {{ let x = 1; {open} now(); {} }}", "}}".repeat(depth))
    };
    assert_eq!(mistake(&nested(9, 3)), "");
    let told = mistake(&nested(50, 8));
    let expected = "bench/rules.rhai:1: too many cases of a `switch` stand in cases of another: put them into functions of their own";
    assert_eq!(told, expected);
}

#[test]
fn what_is_missing_is_told_where_it_is_missing() {
    let told = mistake("fn on_start() {\n  score(1) // no more\n\n  score(2);\n}");
    assert_eq!(told, "bench/rules.rhai:2: a `;` is missing behind `)`");
    let told = mistake("fn on_start() {\n  score(1.5);\n}");
    assert_eq!(told, "bench/rules.rhai:2: a whole number is expected, not 1.5: rules know no fractions");
}

#[test]
fn a_function_that_does_not_exist_is_told_with_one_like_it() {
    for (call, meant) in [("lmap(\"red\", \"on\")", "lamp"), ("scor(1)", "score"), ("twce(1)", "twice")] {
        let told = mistake(&format!("fn twice(x) {{ x * 2 }}\nfn on_start() {{ {call}; }}"));
        assert!(told.ends_with(&format!("; did you mean {meant}?")), "{told}");
    }
    assert!(mistake("fn on_start() { xyzzy(1); }").ends_with("there is no function called xyzzy"));
}

/// What a script complains of when a ball is launched.
fn complaint(body: &str) -> String {
    let rules =
        format!("fn on_start() {{ this.jackpot = 5; this.me = #{{ won: 1 }}; }}\nfn on_launch() {{\n{body}\n}}");
    let mut bench = Bench::new(table(&rules, &["lane"], &["red"])).expect("the rules are sound");
    bench.launch();
    bench.rules.take_complaints().concat()
}

/// Sentences said `()` and i64, and not what was misspelt.
#[test]
fn what_was_never_set_is_told_by_its_name() {
    for (body, what) in [
        (
            "score(this.jakpot);",
            "score cannot be called with nothing: this.jakpot was never set; did you mean this.jackpot?",
        ),
        ("score(\"5\");", "score cannot be called with a text"),
        ("this.down.clear();", "clear cannot be called with nothing: this.down was never set"),
        (
            "let x = this.me.wno + 1;",
            "`+` does not go between nothing and a whole number: this.me.wno was never set; did you mean this.me.won?",
        ),
        ("if this.lit { score(1); }", "a condition must be true or false, not nothing: this.lit was never set"),
        ("let x = this.you.won;", "nothing has no property \"won\": this.you was never set"),
        ("this.count += 1;", "`+` does not go between nothing and a whole number: this.count was never set"),
        (
            "for x in this.all { score(x); }",
            "`for` goes through a list, a text or a range, not nothing: this.all was never set",
        ),
        ("throw \"a () of mine\";", "a () of mine"),
    ] {
        assert_eq!(complaint(body), format!("bench/rules.rhai:3: {what}"), "{body}");
    }
}

/// What a script catches is in what it remembers, and so in recordings.
#[test]
fn what_a_script_catches_is_told_as_ever() {
    let told = complaint("try { score(this.jakpot); } catch (e) { throw e; }");
    assert_eq!(told, "bench/rules.rhai:3: score cannot be called with (())");
}

/// Words of other languages were told as a `;` that is missing, or as names that are taken.
#[test]
fn words_of_other_languages_are_told_with_ours() {
    for (rules, what) in [
        ("import \"math\" as m;", "1: rules have no `import`: they are one file; write its functions into this one"),
        ("def on_start() { }", "1: rules have no `def`: write `fn`"),
        ("fn on_start() { let x = True; }", "1: rules have no `True`: write `true`"),
        ("# Spectrum\nfn on_start() { }", "1: rules have no sign `#`: a comment begins with `//`"),
        ("fn on_start() { let n = [1].size(); }", "1: there is no function called size; write len"),
        ("fn on_start() { print(1); }", "1: there is no function called print; write message"),
        (
            "let lives = 3;\nfn on_start() { score(lives); }",
            "2: lives is made with `let` outside of functions, and no function sees it: write `const`, or keep it in `this.lives` \
             if it changes",
        ),
    ] {
        assert_eq!(mistake(rules), format!("bench/rules.rhai:{what}"), "{rules}");
    }
}

/// `"a,b".split("")` was told that a text cannot be split at a text.
#[test]
fn what_a_function_does_not_take_is_told_with_why() {
    let split =
        "split cannot be called with a text, a text: its mark has no letter; `chars` gives each letter by itself";
    for (body, what) in [
        ("let x = \"a,b\".split(\"\");", split),
        // The empty text alone was wrong, the sentence named what is right as well.
        (
            "let s = \"a\"; s.pad(5000, \"\");",
            "pad cannot be called with a text, a whole number, a text: the text to fill up with has no letter",
        ),
        ("throw [1];", "the script has thrown an array"),
        ("throw #{};", "the script has thrown a map"),
        ("throw 1..=2;", "the script has thrown a range"),
        ("let x = [1]; let y = x[0..=0];", "an array cannot be indexed with a range"),
        ("let x = [1]; x.append(2);", "append takes an array; `push` adds one value"),
        ("let x = [1].length;", "an array has no property \"length\"; `len()` counts what is in it"),
    ] {
        assert_eq!(complaint(body), format!("bench/rules.rhai:3: {what}"), "{body}");
    }
}
