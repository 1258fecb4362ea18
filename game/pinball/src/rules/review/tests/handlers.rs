//! Functions that nothing calls, and what rules leave undone behind a tilt.

use super::told;

/// Rules with `onSwitch` gave no points, and their saucer kept its ball: the one was told for the other.
#[test]
fn a_function_that_is_nearly_called_like_a_handler_is_told_alone() {
    for (written, meant) in [
        ("onSwitch", "on_switch"),
        ("On_Switch", "on_switch"),
        ("ON_SWITCH", "on_switch"),
        ("onswitch", "on_switch"),
        ("OnTimer", "on_timer"),
        ("onlaunch", "on_launch"),
        ("onSlam", "on_slam"),
        ("onSwich", "on_switch"),
    ] {
        let rules = format!("fn on_feed() {{ after(5, \"x\"); }}\nfn {written}() {{ score(1); }}");
        assert_eq!(told(&rules), [format!("2: nothing calls {written}; did you mean `{meant}`?")]);
    }
    for rules in [
        "fn on_slam() { onSlam(); } fn onSlam() { score(1); }",
        "fn on_slam() { this.onslam(); } fn onslam() { score(1); }",
        "fn on_feed() { score(1); } fn once() { score(2); } fn only_one() { score(3); } fn timer() { score(1); }",
    ] {
        assert_eq!(told(rules), Vec::<String>::new(), "{rules}");
    }
}

/// Behind a tilt all balls of the game rolled past dead flippers, and check said ok.
#[test]
fn a_tilt_that_nothing_mends_is_told() {
    let game = |begin: &str, lost: &str, bob: &str| {
        format!(
            "fn on_button(name) {{ if name == \"start\" {{ start_game(3); {begin} }} }}\nfn on_bob() {{ {bob} }}\n\
             fn on_switch(name) {{ score(1); if name == \"drain\" {{ if next_player() {{ {lost} }} else {{ game_over(); }} }} }}\n\
             fn serve() {{ flippers(true); add_ball(); }}"
        )
    };
    let dead = "warning: 2: a tilt kills the flippers, and they stay dead for the balls that follow in this game: no rule calls \
                `flippers(true)` but where a game begins; call it, and `tilt(false)`, where a ball begins too";
    assert_eq!(told(&game("flippers(true); add_ball();", "add_ball();", "tilt(true);")), [dead]);
    assert_eq!(told(&game("serve();", "add_ball(); flippers(false);", "tilt(true);")), [dead]);
    for (begin, lost, bob) in [
        ("serve();", "serve();", "tilt(true);"),
        ("serve();", "after(5, \"x\"); if running(\"x\") { this.serve(); }", "tilt(true);"),
        ("serve();", "add_ball();", "score(5);"),
        ("serve();", "add_ball(); tilt(false);", "tilt(false);"),
    ] {
        let told: Vec<String> =
            told(&game(begin, lost, bob)).into_iter().filter(|one| one.contains("a tilt")).collect();
        assert_eq!(told, Vec::<String>::new(), "{lost} {bob}");
    }
}

/// With `fn score(x) {}` in the rules every `score(100)` did nothing, and it was told that no rule calls `score`.
#[test]
fn a_function_that_hides_one_of_the_game_is_told() {
    let game = "fn on_button(name) { if name == \"start\" { start_game(3); flippers(true); add_ball(); } }\n";
    let game = format!("{game}fn on_switch(name) {{ score(100); flash(\"red\", 9); }}\n");
    let told = |more: &str| told(&format!("{game}{more}"));
    let plain = told("");
    let hidden =
        |what: &str| format!("warning: 3: the rules' own `{what}, which is never called then; name it otherwise");
    assert!(
        told("fn score(x) {}").contains(&hidden("score` hides the game's `score(points)`")),
        "{:?}",
        told("fn score(x) {}")
    );
    assert!(told("fn score(x) {}").iter().all(|told| !told.contains("no player can score")));
    let flash = told("fn flash(a, b) {}");
    assert!(
        flash.iter().any(|told| told.starts_with("warning: 3: the rules' own `flash` hides the game's `flash(")),
        "{flash:?}"
    );
    assert_eq!(told("fn score(a, b, c) {}").len(), plain.len(), "another function");
}
