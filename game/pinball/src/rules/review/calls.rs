//! Calls without which a game cannot be played: for flippers that move, for a ball, for a saucer that gives its ball back.

use super::facts::{Call, Facts};
use super::remark::Remark;
use crate::rules::names::Names;
use crate::rules::script::Kind as NodeKind;
use physics::{FlipperControl, Kind};

/// What is never called, in rules that begin a game.
pub fn remarks(facts: &Facts, names: &Names) -> Vec<Remark> {
    let Some(begin) = facts.calls_of("start_game").next() else { return Vec::new() };
    let line = begin.line as usize;
    let has_flippers = names
        .parts()
        .any(|(_, kind)| matches!(kind, Kind::Flipper(flipper) if flipper.control != FlipperControl::Rules));
    let mut found = Vec::new();
    if has_flippers && !facts.calls_of("flippers").any(switches_on) {
        found.push(Remark::error(
            line,
            "the flippers never move: no rule calls `flippers(true)`; call it behind `start_game`",
        ));
    }
    if facts.calls_of("add_ball").next().is_none() {
        found.push(Remark::error(
            line,
            "a game begins without a ball: no rule calls `add_ball()`; call it behind `start_game`",
        ));
    }
    let ejected = facts.given("eject", 0);
    let saucers = names.parts().filter(|(_, kind)| matches!(kind, Kind::Saucer(_)));
    for name in saucers.filter_map(|(part, _)| names.part_name(part)) {
        let is_ejected = ejected.others || !ejected.told.is_empty() || ejected.literals.contains(name);
        if !is_ejected {
            let what = format!(
                "the saucer \"{name}\" keeps its ball: no rule calls `eject(\"{name}\")`; start a timer in `on_switch` and \
                 call it in `on_timer`"
            );
            found.push(Remark::error(0, what));
        }
    }
    found
}

fn switches_on(call: &Call) -> bool {
    !matches!(call.arguments.first().map(|node| &node.kind), Some(NodeKind::Bool(false)))
}
