//! The rules' trial: a game begins, its balls are lost and nobody flips. A ball must come, the flippers must be live, a
//! lost ball must have a consequence, and the game an end; and a saucer's ball must come out again.

use super::finding::{Finding, FindingKind};
use super::switches::Shot;
use super::whole_game::{self, BEGIN_TICKS, BEGINNINGS, LossPlaces, MOST_BALLS, PRESS_TICKS, answers};
use super::{fallen_targets, shaken};
use crate::{Buttons, Failure, Simulation, Table};
use geometry::DVec2;
use physics::{Event, EventKind, Kind, PartId};
use std::sync::Arc;

/// A saucer may keep its ball for so long, ticks.
const HELD_TICKS: u64 = 20_000;
/// Saucers that are tried.
const MAX_SAUCERS: usize = 16;
/// Drains that balls are lost in.
const MAX_DRAINS: usize = 6;
/// Contact solves that the trial of a saucer may take: 120 in a tick, where a captive ball that lies takes 30.
const MOST_HELD_SOLVES: u64 = 120 * HELD_TICKS;

/// What the rules do wrong, or leave undone, and what they complain about meanwhile.
///
/// # Errors
/// If they do not run.
pub fn try_rules(
    table: &Arc<Table>,
    places: &LossPlaces,
    targets: &[(PartId, Shot)],
) -> Result<(Vec<Finding>, Vec<String>), Failure> {
    let mut simulation = Simulation::new(table.clone(), 0)?;
    if !BEGINNINGS.into_iter().any(|button| begins(&mut simulation, button)) {
        let kind = if means_to_begin(&table.rules) { FindingKind::NoGame } else { FindingKind::NoStart };
        let told = Finding { kind, part: None, place_mm: DVec2::ZERO, count: 1 };
        return Ok((vec![told], simulation.complaints()));
    }
    let (mut found, mut complaints) = game(&simulation, places);
    // In a game that goes wrong what becomes of drop targets is a consequence.
    if found.is_empty() {
        found.extend(fallen_targets::stay_down(&simulation, places, targets));
    }
    let (kept, more) = held(&simulation);
    found.extend(kept);
    complaints.extend(more);
    complaints.extend(shaken::complaints(&simulation));
    Ok((found, once(complaints)))
}

/// Whether a game is on behind a press of this button.
fn begins(simulation: &mut Simulation, button: Buttons) -> bool {
    (0..PRESS_TICKS).for_each(|_| simulation.tick(button));
    (PRESS_TICKS..BEGIN_TICKS).for_each(|_| simulation.tick(Buttons::NONE));
    simulation.display().playing
}

/// Whether the rules speak of the beginning of a game: those of a table that only shows lamps do not.
fn means_to_begin(rules: &str) -> bool {
    let code = rules.lines().map(|line| line.split_once("//").map_or(line, |(code, _)| code));
    code.into_iter().any(|line| line.contains("start_game") || line.contains("\"start\""))
}

/// The game whose balls are lost in the first drain, and in each of the others the game's first ball.
fn game(simulation: &Simulation, places: &LossPlaces) -> (Vec<Finding>, Vec<String>) {
    let Some((first, others)) = places.drains.split_first() else {
        let played = whole_game::play(simulation, places, None, MOST_BALLS);
        return (played.findings, played.complaints);
    };
    let played = whole_game::play(simulation, places, Some(*first), MOST_BALLS);
    let (mut found, mut complaints) = (played.findings, played.complaints);
    // Of the others the same would be told.
    let others = if found.is_empty() { others } else { &[] };
    for drain in others.iter().take(MAX_DRAINS - 1) {
        let played = whole_game::play(simulation, places, Some(*drain), 1);
        found.extend(played.findings);
        complaints.extend(played.complaints);
    }
    (found, complaints)
}

/// The same complaint once.
fn once(complaints: Vec<String>) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    for complaint in complaints {
        if !told.contains(&complaint) {
            told.push(complaint);
        }
    }
    told
}

/// Saucers that keep a ball, in a game whose first ball waits at the plunger, and what the rules complain about meanwhile.
fn held(simulation: &Simulation) -> (Vec<Finding>, Vec<String>) {
    let parts = simulation.table().layout.parts.iter().enumerate();
    let saucers = parts.filter_map(|(index, part)| match &part.kind {
        Kind::Saucer(saucer) => Some((PartId(index as u16), saucer.circle.center)),
        _ => None,
    });
    let mut complaints = Vec::new();
    let kept = saucers.take(MAX_SAUCERS).filter(|(part, center)| {
        let mut simulation = simulation.clone();
        let is_kept = keeps(&mut simulation, *part, *center);
        complaints.extend(simulation.complaints());
        is_kept
    });
    let kept = kept.map(|(part, center)| Finding::of_part(FindingKind::NeverEjected, part, center)).collect();
    (kept, complaints)
}

fn keeps(simulation: &mut Simulation, part: PartId, center: DVec2) -> bool {
    simulation.put_ball(center, DVec2::ZERO);
    let (mut caught, mut contact_solves) = (false, 0);
    let is = |event: &Event, kind: EventKind| event.part == Some(part) && event.kind == kind;
    for tick in 0..HELD_TICKS {
        simulation.tick(answers(tick));
        contact_solves += simulation.machine().contact_solves();
        caught |= simulation.events().any(|event| is(event, EventKind::Closed));
        // Who locks a ball gives another; who ends the game may keep it.
        let rules = simulation.rules_state();
        let is_meant = rules.owed > 0 || !rules.playing;
        let is_out = simulation.events().any(|event| is(event, EventKind::Opened));
        if is_meant || is_out || contact_solves > MOST_HELD_SOLVES {
            return false;
        }
    }
    caught
}
