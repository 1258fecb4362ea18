//! Answers that nothing uses.

use super::told;

/// `score();` on a bumper gave no points, and nobody said so.
#[test]
fn an_answer_that_nothing_uses_is_told() {
    for (rules, line) in [
        ("fn on_switch(name) {\n score();\n message(\"A\", 900); }", 2),
        ("fn on_switch(name) {\n if name == \"dock\" {\n score(); } }", 3),
        ("fn on_switch(name) { switch name {\n \"dock\" => score(),\n \"target\" => score(9) } }", 2),
        ("fn on_switch(name) { for i in 0..3 {\n score(); } }", 2),
        ("fn on_switch(name) { try {\n score(); } catch (e) { } }", 2),
        ("fn on_switch(name) { bonus(); } fn bonus() {\n score();\n score(9) }", 2),
    ] {
        let expected = format!("warning: {line}: the answer of `score` is used by nothing; `score(100)` gives points");
        assert!(told(rules).contains(&expected), "{rules}: {:?}", told(rules));
    }
    let playing = told("fn on_switch(name) {\n playing();\n score(9); }");
    assert!(playing.iter().any(|one| one.contains("2: the answer of `playing` is used by nothing")), "{playing:?}");
    // What a function of the script gives may be what is asked for.
    for good in [
        "fn on_switch(name) { if mine() > 9 { score(9); } } fn mine() { score() }",
        "fn on_switch(name) { let a = score(); if a > 9 { score(9); } }",
        "fn on_switch(name) { score(if playing() { 9 } else { 1 }); }",
    ] {
        assert!(!told(good).iter().any(|one| one.contains("used by nothing")), "{good}: {:?}", told(good));
    }
}
