//! Tilt: a tilt kills the flippers, and something must give them back to the balls that follow.

use super::calls::switches_on;
use super::consequences::{Consequences, FLIPPERS_ON};
use super::facts::{Call, Facts};
use super::remark::Remark;
use super::words::Words;
use crate::rules::handlers;
use crate::rules::script::{Kind, Script};

/// The call that leaves the flippers dead for the rest of the game, if there is one.
pub fn remark(facts: &Facts, script: &Script) -> Option<Remark> {
    let begins = facts.calls_of("start_game").next().is_some();
    let tilts = |call: &&Call| !matches!(call.arguments.first().map(|node| &node.kind), Some(Kind::Bool(false)));
    let tilt = facts.calls_of("tilt").find(tilts).filter(|_| begins)?;
    // Of flippers that no rule switches on at all that is told.
    facts.calls_of("flippers").find(|call| switches_on(call))?;
    let running = Words::unknown();
    let mut play = Consequences::new(script, facts, &running);
    // What is done when the machine is switched on is done once.
    handlers::names().filter(|name| *name != "on_start").for_each(|event| play.hear_in_play(event));
    // Where no ball follows none is without them.
    if play.can_call(&[FLIPPERS_ON]) || !play.can_call(&["next_player", "add_ball"]) {
        return None;
    }
    let what = "a tilt kills the flippers, and they stay dead for the balls that follow in this game: no rule calls \
                `flippers(true)` but where a game begins; call it, and `tilt(false)`, where a ball begins too";
    Some(Remark::warning(tilt.line as usize, what))
}
