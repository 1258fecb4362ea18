//! Comparisons that the types of their sides decide.

use super::told;

fn asked(condition: &str) -> Vec<String> {
    told(&format!(
        "const ALL = [\"dock\", \"drain\"];\nfn on_switch(name) {{ let x = 3;\nif {condition} {{ score(1); }} }}"
    ))
}

/// `name == BUMPERS` and `balls_in_play() == "0"` were never true, and no bumper gave a point and no game came to an end.
#[test]
fn a_comparison_of_two_types_is_told() {
    let zero = "a whole number is compared with a text (\"0\"); write 0 without quotes";
    let array = "a text is compared with an array; whether it is in an array, `in` asks";
    for (condition, what) in [
        ("name == ALL", format!("never true: {array}")),
        ("name != ALL", format!("always true: {array}")),
        ("name == [\"dock\"]", format!("never true: {array}")),
        ("balls_in_play() == \"0\"", format!("never true: {zero}")),
        ("ball() > \"0\"", format!("never true: {zero}")),
        ("playing() == 1", "never true: true or false is compared with a whole number (1)".to_string()),
        ("name == 3", "never true: a text is compared with a whole number (3)".to_string()),
        (
            "closed(\"dock\") == \"true\"",
            "never true: true or false is compared with a text (\"true\"); write true without quotes".to_string(),
        ),
    ] {
        assert_eq!(asked(condition), [format!("3: this is {what}")], "{condition}");
    }
    let case = "fn on_feed() { switch ball() {\n\"1\" => score(1),\n2 => score(2) } }";
    let what = "a whole number is compared with a text (\"1\"); write 1 without quotes";
    assert_eq!(told(case), [format!("2: this case is never reached: {what}")]);
    for good in [
        "name in ALL",
        "name == \"dock\"",
        "x == \"3\"",
        "this.mode == 1 || this.mode == \"1\"",
        "(this.x ?? ()) == ()",
        "balls_in_play() == 0",
        "score() >= 1000",
        "name == `${1}`",
    ] {
        let all: Vec<String> = asked(good).into_iter().filter(|one| one.contains("compared with a")).collect();
        assert_eq!(all, Vec::<String>::new(), "{good}");
    }
}
