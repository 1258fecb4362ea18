//! What comes of a lost ball, in rules that begin a game: another ball, the next player, or the end of the game.

use super::consequences::{Consequences, text};
use super::facts::Facts;
use super::known::Known;
use super::remark::{Remark, line_of};
use super::words::Words;
use crate::rules::handlers::line_of_function;
use crate::rules::names::Names;
use crate::rules::script::{Kind as NodeKind, Script};
use physics::Kind;
use std::collections::BTreeSet;
use std::sync::Arc;

/// What a lost ball can lead to.
const ENDS: [&str; 4] = ["next_player", "add_ball", "game_over", "start_game"];
/// Drains that are looked at.
const MAX_DRAINS: usize = 16;
/// Rounds after which no more timers can run in any script that a person writes.
const MAX_ROUNDS: usize = 32;
/// Events that only a ball in the plunger lane brings.
const WITH_BALLS: [&str; 2] = ["on_launch", "on_feed"];

/// What nothing comes of.
pub fn remarks(facts: &Facts, names: &Names, script: &Script, rules: &str) -> Vec<Remark> {
    let Some(begin) = facts.calls_of("start_game").next() else { return Vec::new() };
    let drains = names.parts().filter(|(_, kind)| is_drain(kind)).take(MAX_DRAINS);
    let drains: Vec<&str> = drains.filter_map(|(part, _)| names.part_name(part)).collect();
    let Some(running) = timers(script, facts).filter(|_| !drains.is_empty()) else { return Vec::new() };
    let review = Review { facts, script, rules, running: &running, drains: &drains, begin: begin.line as usize };
    let lost: Vec<Remark> = drains.iter().filter_map(|drain| review.unheard(drain)).collect();
    if lost.is_empty() { review.unended() } else { lost }
}

fn is_drain(kind: &Kind) -> bool {
    matches!(kind, Kind::Drain(_))
}

/// The timers that can run at all, if that comes to an end.
fn timers(script: &Script, facts: &Facts) -> Option<Words> {
    let mut running = Words::default();
    for _ in 0..MAX_ROUNDS {
        let mut all = Consequences::new(script, facts, &running);
        hear_all(&mut all);
        let mut more = running.clone();
        more.add(&all.timers);
        if more == running {
            return Some(running);
        }
        running = more;
    }
    None
}

/// Every event but those of a machine that is shaken.
fn hear_all(all: &mut Consequences) {
    for event in ["on_start", "on_switch", "on_open", "on_button", "on_release"].into_iter().chain(WITH_BALLS) {
        all.hear(event, &Known::Nothing);
    }
    all.hear_timers();
}

struct Review<'a> {
    facts: &'a Facts<'a>,
    script: &'a Script,
    rules: &'a str,
    /// The timers that can run at all.
    running: &'a Words,
    drains: &'a [&'a str],
    /// The line where a game begins.
    begin: usize,
}

impl Review<'_> {
    /// What a ball that is lost in this drain can come to, with nothing else on the table.
    fn after(&self, drain: &str) -> Consequences<'_> {
        let mut found = Consequences::new(self.script, self.facts, self.running);
        found.hear("on_switch", &text(drain));
        found.hear_timers();
        ["on_button", "on_release"].into_iter().for_each(|event| found.hear_in_play(event));
        found
    }

    /// Whether balls that go elsewhere can end a player's turn: a switch before the drain may count for it.
    fn ends_elsewhere(&self) -> bool {
        let mut found = Consequences::new(self.script, self.facts, self.running);
        let drains: BTreeSet<Arc<str>> = self.drains.iter().map(|drain| Arc::from(*drain)).collect();
        ["on_switch", "on_open"].into_iter().for_each(|event| found.hear(event, &Known::Other(drains.clone())));
        WITH_BALLS.into_iter().for_each(|event| found.hear(event, &Known::Nothing));
        found.can_call(&["next_player", "game_over", "start_game"])
    }

    /// A drain of which nothing comes.
    fn unheard(&self, drain: &str) -> Option<Remark> {
        if self.after(drain).can_call(&ENDS) || self.ends_elsewhere() {
            return None;
        }
        let add = "call `next_player()` and `add_ball()`, or `game_over()`";
        let lost = "a lost ball has no consequence";
        let id = if drain.contains('#') { "give the drain an `id`, and " } else { "" };
        let quoted = format!("\"{drain}\"");
        if self.rules.contains(&quoted) {
            let own = self.facts.comparisons.iter().find(|one| &*one.text == drain);
            let line = line_of(drain, self.rules, own.map_or(0, |one| one.line));
            let what = format!(
                "{lost}: what `on_switch` does for {quoted} never comes to `next_player()`, `add_ball()` or \
                                `game_over()`; where `balls_in_play()` is 0, {add}"
            );
            return Some(Remark::error(line, what));
        }
        if self.script.functions().any(|function| function.name == "on_switch") {
            let what = format!(
                "{lost}: `on_switch` does nothing of that kind for the drain {quoted}; {id}where \
                                `on_switch` hears it and `balls_in_play()` is 0, {add}"
            );
            return Some(Remark::error(line_of_function("on_switch", self.rules), what));
        }
        let what = format!(
            "{lost}: there is no `on_switch(name)`; {id}write one that, where `name` is the drain \
                            {quoted} and `balls_in_play()` is 0, does what comes then: {add}"
        );
        Some(Remark::error(self.begin, what))
    }

    /// Balls that never come, games that never end.
    fn unended(&self) -> Vec<Remark> {
        let mut found = Vec::new();
        let after: Vec<Consequences> = self.drains.iter().map(|drain| self.after(drain)).collect();
        let any = |functions: &[&str]| after.iter().any(|after| after.can_call(functions));
        let mut all = Consequences::new(self.script, self.facts, self.running);
        hear_all(&mut all);
        let next = self.facts.calls_of("next_player").next();
        if let Some(next) = next
            && any(&["next_player"])
            && !any(&["add_ball", "start_game"])
            && self.facts.calls_of("add_ball").next().is_some()
        {
            let what = "the next ball never comes: `add_ball()` is called only where a game begins; call it where \
                        `next_player()` is true";
            found.push(Remark::error(next.line as usize, what));
        }
        if !all.can_call(&["game_over"]) && !any(&["start_game"]) {
            let what = "the game never ends: no rule that a lost ball comes to calls `game_over()`";
            found.push(match next {
                Some(next) => {
                    Remark::error(next.line as usize, format!("{what}; call it where `next_player()` is false"))
                }
                None => Remark::warning(self.begin, format!("{what}; call it behind the last ball")),
            });
        }
        if let (true, None, Some(balls)) = (found.is_empty(), next, self.balls()) {
            let what = format!(
                "a game of {balls} balls stays at its first: no rule calls `next_player()`; call it where \
                                a ball is lost, or begin with `start_game(1)`"
            );
            found.push(Remark::warning(self.begin, what));
        }
        found
    }

    /// How many balls every game has, if it has several.
    fn balls(&self) -> Option<i64> {
        let balls = self.facts.calls_of("start_game").map(|call| match call.arguments.first().map(|node| &node.kind) {
            Some(NodeKind::Int(balls)) => Some(*balls),
            Some(NodeKind::Constant(number)) => self.script.constant_value(*number)?.number(),
            _ => None,
        });
        balls.min()?.filter(|balls| *balls > 1)
    }
}
