//! Calls of `lamp` that the next ones take back.

use super::told;

/// `lamp("*", "off")` behind the lamps that it was to stand before left them dark.
#[test]
fn a_lamp_that_the_next_call_switches_again_is_told() {
    let undone = "warning: 1: `lamp(\"light-*\", \"on\")` is taken back at once by `lamp(\"*\", \"off\")` of line 2; write it behind that";
    assert_eq!(told("fn on_start() { lamp(\"light-*\", \"on\");\nlamp(\"*\", \"off\"); }"), [undone]);
    for rules in [
        "lamp(\"*\", \"off\"); lamp(\"light-*\", \"on\");",
        "lamp(\"red\", \"on\"); lamp(\"light-*\", \"off\");",
        "lamp(\"red\", \"on\"); if playing() { return; } lamp(\"*\", \"off\");",
        "lamp(\"red\", \"off\"); lamp(\"*\", \"off\");",
    ] {
        assert_eq!(told(&format!("fn on_start() {{ {rules} }}")), [""; 0], "{rules}");
    }
}
