//! Lamps that stay dark.

use super::Review;
use crate::rules::tests::bench::table;

const LAMPS: [&str; 4] = ["gi-left", "gi-right", "red", "stern"];

/// What is told of lamps in rules that do this when a button is pressed.
fn told(rules: &str) -> Vec<String> {
    let begin = format!("fn on_button(name) {{ start_game(3); flippers(true); add_ball(); score(1); {rules} }}");
    let findings = Review::of(&table(&begin, &[], &LAMPS)).findings;
    findings.iter().map(ToString::to_string).filter(|one| one.contains("dark")).collect()
}

/// A lamp that was drawn and of which no rule speaks was called good, and nobody saw why it was dark.
#[test]
fn lamps_that_no_rule_switches_on_are_told() {
    let dark = "warning: bench/rules.rhai: the lamp \"red\" stays dark: no rule calls `lamp(\"red\", \"on\")`";
    for rules in [
        r#"lamp("gi-*", "on"); lamp("stern", 300);"#,
        r##"flash("gi-*", 100); show("stern", "chase", 100, 0, 400); lamp_color("*", "#ffffff");"##,
        r#"lamp("*", "off"); lamp("*", 0); for side in ["left", "right"] { lamp("gi-" + side, "on"); } lamp("stern", "on");"#,
    ] {
        assert_eq!(told(rules), [dark], "{rules}");
    }
    assert_eq!(
        told(""),
        [dark
            .replace("lamp \"red\" stays", "lamps \"gi-left\", \"gi-right\", \"red\" and 1 more stay")
            .replace("(\"red\"", "(\"gi-left\"")]
    );
}

/// What is switched on by a name that only play makes is left alone.
#[test]
fn lamps_that_may_be_switched_on_are_left_alone() {
    for rules in [
        r#"lamp("*", "on");"#,
        r#"lamp("*", this.level);"#,
        r#"let all = #{ red: 1, stern: 2 }; for name in all.keys() { lamp(name, "on"); } lamp("gi-" + name, "on");"#,
        r#"for at in ["gi-", "re", "st"] { lamp(at + name, "on"); }"#,
    ] {
        assert_eq!(told(rules), Vec::<String>::new(), "{rules}");
    }
}
