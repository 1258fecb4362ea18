//! The rules' trial: a game begins, its first ball is shot and nobody flips. A ball must come, the flippers must be live,
//! and a lost ball must have a consequence; and a saucer's ball must come out again.

use super::finding::{Finding, FindingKind};
use crate::simulation::SimulationRules;
use crate::{Buttons, Failure, Simulation, Table};
use geometry::DVec2;
use physics::{Event, EventKind, FlipperControl, Kind, PartId};
use std::sync::Arc;

/// How long start is pressed, and when the game is on at the latest, ticks.
const PRESS_TICKS: u64 = 100;
const BEGIN_TICKS: u64 = 2000;
/// The table may be empty in a game for so long: soon after that the ball search gives a ball, whatever the rules say.
const EMPTY_TICKS: u64 = 14_300;
/// A first ball that is not lost by then is none of this trial's business, ticks.
const MOST_TICKS: u64 = 90_000;
/// How long the plunger is pulled, one pull after the other, ticks, and the time from one to the next.
const PULLS_TICKS: [u64; 4] = [1200, 900, 700, 500];
const PULL_PERIOD_TICKS: u64 = 5000;
/// With a ball on the table for so long flippers are live, ticks.
const IN_PLAY_TICKS: u64 = 3000;
/// A saucer may keep its ball for so long, ticks.
const HELD_TICKS: u64 = 20_000;
/// Between two presses of the flippers' buttons meanwhile, ticks: rules may ask the player something.
const ASKED_TICKS: u64 = 500;
/// Saucers that are tried.
const MAX_SAUCERS: usize = 16;
/// Contact solves that a trial may take.
const MOST_CONTACT_SOLVES: u64 = 400_000;

/// What the rules do wrong, or leave undone, and what they complain about meanwhile.
///
/// # Errors
/// If they do not run.
pub fn try_rules(table: &Arc<Table>) -> Result<(Vec<Finding>, Vec<String>), Failure> {
    let mut simulation = Simulation::new(table.clone(), 0)?;
    (0..PRESS_TICKS).for_each(|_| simulation.tick(Buttons::START));
    (PRESS_TICKS..BEGIN_TICKS).for_each(|_| simulation.tick(Buttons::NONE));
    if !simulation.display().playing {
        return Ok((Vec::new(), simulation.complaints())); // what the bot shows
    }
    let saucers = held(&simulation);
    let told = |kind| Finding { kind, part: None, place_mm: DVec2::ZERO, count: 1 };
    let (found, complaints) = first_ball(simulation);
    Ok((found.into_iter().map(told).chain(saucers).collect(), complaints))
}

/// What has been seen of a game.
#[derive(Default)]
struct Seen {
    /// The table is empty for so long.
    empty_ticks: u64,
    /// A ball has been on the table for so long.
    in_play_ticks: u64,
    /// The flippers have been live.
    flippers_live: bool,
    /// The machine was tilted.
    tilted: bool,
}

/// Plays until the first ball is lost and something has come of it.
fn first_ball(mut simulation: Simulation) -> (Vec<FindingKind>, Vec<String>) {
    let is_empty = simulation.machine().balls().is_empty();
    let mut seen = Seen { empty_ticks: if is_empty { BEGIN_TICKS } else { 0 }, ..Seen::default() };
    let mut contact_solves = 0;
    let mut found = Vec::new();
    for tick in 0..MOST_TICKS {
        let rules = simulation.rules_state();
        let is_empty = simulation.machine().balls().is_empty();
        let another_came = !is_empty && seen.empty_ticks > 0 && seen.in_play_ticks > 0;
        if !rules.playing || another_came || contact_solves > MOST_CONTACT_SOLVES {
            break;
        }
        seen.look(rules, is_empty);
        if seen.empty_ticks >= EMPTY_TICKS {
            let never = seen.in_play_ticks == 0;
            found.push(if never { FindingKind::NoBall } else { FindingKind::BallWithoutEnd });
            break;
        }
        simulation.tick(plunger(tick));
        contact_solves += simulation.machine().contact_solves();
    }
    let has_flippers = simulation.table().layout.parts.iter().any(|part| is_flipper(&part.kind));
    if has_flippers && seen.in_play_ticks >= IN_PLAY_TICKS && !seen.flippers_live && !seen.tilted {
        found.push(FindingKind::DeadFlippers);
    }
    (found, simulation.complaints())
}

impl Seen {
    fn look(&mut self, rules: SimulationRules, is_empty: bool) {
        self.flippers_live |= rules.flippers_live;
        self.tilted |= rules.tilted;
        if is_empty {
            self.empty_ticks += 1;
        } else {
            self.empty_ticks = 0;
            self.in_play_ticks += 1;
        }
    }
}

fn is_flipper(kind: &Kind) -> bool {
    matches!(kind, Kind::Flipper(flipper) if flipper.control != FlipperControl::Rules)
}

/// Pulls of different strength: a full one may come back round a bend.
fn plunger(tick: u64) -> Buttons {
    let pull = PULLS_TICKS[(tick / PULL_PERIOD_TICKS) as usize % PULLS_TICKS.len()];
    if tick % PULL_PERIOD_TICKS < pull { Buttons::PLUNGER } else { Buttons::NONE }
}

/// Saucers that keep a ball, in a game whose first ball waits at the plunger.
fn held(simulation: &Simulation) -> Vec<Finding> {
    let parts = simulation.table().layout.parts.iter().enumerate();
    let saucers = parts.filter_map(|(index, part)| match &part.kind {
        Kind::Saucer(saucer) => Some((PartId(index as u16), saucer.circle.center)),
        _ => None,
    });
    let kept = saucers.take(MAX_SAUCERS).filter(|(part, center)| keeps(simulation.clone(), *part, *center));
    kept.map(|(part, center)| Finding::of_part(FindingKind::NeverEjected, part, center)).collect()
}

fn keeps(mut simulation: Simulation, part: PartId, center: DVec2) -> bool {
    simulation.put_ball(center);
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
        if is_meant || is_out || contact_solves > MOST_CONTACT_SOLVES {
            return false;
        }
    }
    caught
}

/// The flippers' buttons, now the one and now the other.
fn answers(tick: u64) -> Buttons {
    match tick / ASKED_TICKS % 4 {
        1 => Buttons::LEFT,
        3 => Buttons::RIGHT,
        _ => Buttons::NONE,
    }
}
