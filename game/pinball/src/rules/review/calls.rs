//! Calls without which a game cannot be played, or a part of it does nothing: for flippers that move, for a ball, for a
//! saucer that gives its ball back.

use super::facts::{Call, Facts};
use super::remark::Remark;
use super::timers::Silent;
use crate::rules::names::Names;
use crate::rules::script::{Kind as NodeKind, Script};
use crate::spelling;
use physics::{FlipperControl, Kind};

/// What is said of rules that begin no game.
pub const NO_START: &str = "no game can begin: no rule speaks of `start_game` or of \"start\"; if the table is there to be \
                            played, call `start_game(3)` and `add_ball()` in `on_button(name)`";

/// Whether a part works only where rules say `kickers(true)`.
pub fn is_kicker(kind: &Kind) -> bool {
    matches!(kind, Kind::Bumper(_) | Kind::Slingshot(_) | Kind::Kickback(_) | Kind::Magnet(_))
}

/// What is said of rules without any rule: in other rules play shows it.
pub fn none(script: &Script) -> Option<Remark> {
    script.functions().next().is_none().then(|| Remark::warning(0, NO_START))
}

/// What is never called, in rules that begin a game.
pub fn remarks(facts: &Facts, names: &Names, joined: &[Silent]) -> Vec<Remark> {
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
    if !facts.calls_of("score").any(|call| !call.words.is_empty()) {
        let what = "no player can score: no rule calls `score(points)`; call it in `on_switch(name)`, as `score(100)`";
        found.push(Remark::warning(line, what));
    }
    if names.parts().any(|(_, kind)| is_kicker(kind)) && !facts.calls_of("kickers").any(switches_on) {
        let what = "bumpers, slingshots, kickbacks and magnets never work: no rule calls `kickers(true)`; call it behind \
                    `start_game`";
        found.push(Remark::warning(line, what));
    }
    found.extend(never_named(facts, names, "eject", |kind| matches!(kind, Kind::Saucer(_))).map(|name| {
        let what = format!(
            "the saucer \"{name}\" keeps its ball: no rule calls `eject(\"{name}\")`; {}",
            in_timer(joined, "start a timer in `on_switch` and call it in `on_timer`")
        );
        Remark::error(0, what)
    }));
    found.extend(never_named(facts, names, "raise", |kind| matches!(kind, Kind::DropTarget(_))).map(|name| {
        let what = format!("the drop target \"{name}\" falls once: no rule calls `raise(\"{name}\")`");
        Remark::warning(0, what)
    }));
    found.extend(never_named(facts, names, "kick", |kind| matches!(kind, Kind::Kickback(_))).map(|name| {
        Remark::warning(0, format!("the kickback \"{name}\" never kicks: no rule calls `kick(\"{name}\")`"))
    }));
    found.extend(never_named(facts, names, "divert", is_diverter).map(|name| {
        Remark::warning(0, format!("the diverter \"{name}\" never turns: no rule calls `divert(\"{name}\", true)`"))
    }));
    found.extend(never_switched(facts, names, joined));
    found
}

/// Where to call what is called nowhere: for the one timer that is started for nothing, or else for a new one.
fn in_timer(joined: &[Silent], usual: &str) -> String {
    match joined {
        [Silent { timer, line }] => {
            format!("call it in `on_timer` for \"{timer}\", which line {line} starts and for which that does nothing")
        }
        _ => usual.to_string(),
    }
}

/// Whether one of these remarks names the timer that was started for nothing.
pub fn names_timer(remarks: &[Remark]) -> bool {
    remarks.iter().any(|remark| remark.what.ends_with("for which that does nothing"))
}

fn is_diverter(kind: &Kind) -> bool {
    matches!(kind, Kind::Flipper(flipper) if flipper.control == FlipperControl::Rules)
}

/// Magnets that no rule switches on, or off again.
fn never_switched(facts: &Facts, names: &Names, joined: &[Silent]) -> Option<Remark> {
    let mut magnets = names.parts().filter(|(_, kind)| matches!(kind, Kind::Magnet(_)));
    let name = magnets.next().and_then(|(part, _)| names.part_name(part))?;
    let gives = |call: &Call, on: bool| !matches!(call.arguments.get(1).map(|node| &node.kind), Some(NodeKind::Bool(is)) if *is != on);
    let any = |on: bool| facts.calls_of("magnet").any(|call| gives(call, on));
    let what = match (any(true), any(false)) {
        (true, true) => return None,
        (false, _) => format!("the magnet \"{name}\" never pulls: no rule calls `magnet(\"{name}\", true)`"),
        (true, false) => format!(
            "the magnet \"{name}\" never lets go, once it is on: no rule calls `magnet(\"{name}\", false)`; {}",
            in_timer(joined, "start a timer and call it in `on_timer`")
        ),
    };
    Some(Remark::warning(0, what))
}

/// The parts of a kind that no call of `function` can name.
fn never_named<'a>(
    facts: &Facts,
    names: &'a Names,
    function: &str,
    is: fn(&Kind) -> bool,
) -> impl Iterator<Item = &'a str> {
    let given = facts.given(function, 0);
    // A name that is nearly this part's is told itself.
    let is_meant = |name: &str| {
        given.literals.iter().any(|word| !names.exists(word) && spelling::near_name(word, [name]).is_some())
    };
    let meant: Vec<&str> =
        names.parts().filter_map(|(part, _)| names.part_name(part)).filter(|name| is_meant(name)).collect();
    let parts = names.parts().filter(move |(_, kind)| is(kind));
    let named = parts.filter_map(|(part, _)| names.part_name(part));
    named.filter(move |name| {
        !given.others && given.told.is_empty() && !given.literals.contains(*name) && !meant.contains(name)
    })
}

/// Whether a call of `flippers` or `kickers` may switch them on.
pub fn switches_on(call: &Call) -> bool {
    !matches!(call.arguments.first().map(|node| &node.kind), Some(NodeKind::Bool(false)))
}
