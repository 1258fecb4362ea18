//! Seen: what the rules do with the machine while a ball is in play: from the plunger's shot on, for that may be what kills
//! the flippers or tilts the machine.

use crate::Table;
use crate::playtest::finding::FindingKind;
use crate::rules::is_kicker;
use crate::simulation::SimulationRules;
use physics::{FlipperControl, Kind};

/// With a ball in play for so long the flippers have been live, and the machine not tilted, ticks.
const IN_PLAY_TICKS: u64 = 2000;

/// What has been seen of a ball.
#[derive(Default)]
pub struct Seen {
    /// The flippers were live when it waited at the plunger.
    waits_live: bool,
    /// It has been in play for so long, ticks.
    in_play_ticks: u64,
    /// Since then the flippers have been live.
    flippers_live: bool,
    /// Since then bumpers and their like have worked.
    kickers_live: bool,
    /// Since then the machine was tilted.
    tilted: bool,
    /// Since then it was not.
    untilted: bool,
    /// A press of a button has begun the game anew.
    pub begins_anew: bool,
}

impl Seen {
    /// A tick with the ball on the table: at the plunger, or shot.
    pub fn look(&mut self, rules: SimulationRules, is_shot: bool) {
        if !is_shot {
            self.waits_live |= rules.flippers_live;
            self.in_play_ticks = 0;
            return;
        }
        self.in_play_ticks += 1;
        self.flippers_live |= rules.flippers_live;
        self.kickers_live |= rules.kickers_live;
        self.tilted |= rules.tilted;
        self.untilted |= !rules.tilted;
    }

    /// What is wrong with flippers, kickers or tilt.
    pub fn fault(&self, table: &Table) -> Option<FindingKind> {
        if self.in_play_ticks < IN_PLAY_TICKS {
            return None;
        }
        let has_flippers = table.layout.parts.iter().any(|part| is_flipper(&part.kind));
        match (self.tilted, self.untilted) {
            (true, false) => Some(FindingKind::AlwaysTilted),
            _ if self.tilted => None,
            _ if self.flippers_live || !has_flippers => self.dead_kickers(table),
            _ if self.waits_live => Some(FindingKind::FlippersDieAtLaunch),
            _ => Some(FindingKind::DeadFlippers),
        }
    }

    fn dead_kickers(&self, table: &Table) -> Option<FindingKind> {
        let has_kickers = table.layout.parts.iter().any(|part| is_kicker(&part.kind));
        let is_dead = has_kickers && !self.kickers_live && switch_kickers_on(&table.rules);
        is_dead.then_some(FindingKind::DeadKickers)
    }
}

/// Whether rules switch kickers on somewhere; that they never do is told of them without play.
fn switch_kickers_on(rules: &str) -> bool {
    let code = rules.lines().filter_map(|line| line.split("//").next());
    code.flat_map(|code| code.split("kickers(").skip(1)).any(|argument| !argument.trim_start().starts_with("false"))
}

fn is_flipper(kind: &Kind) -> bool {
    matches!(kind, Kind::Flipper(flipper) if flipper.control != FlipperControl::Rules)
}
