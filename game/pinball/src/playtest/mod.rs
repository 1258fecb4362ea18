//! The playtest: what only play shows of a table. The plunger is pulled and let go, every coil is tried with a ball
//! before it, a ball is let go wherever one can come to, and a bot plays.
//!
//! It is made of pieces that do not know of each other, so that its caller can run them side by side. Each gives the same
//! findings on every machine.

mod coils;
mod fallen_targets;
mod finding;
mod first_game;
mod let_go;
mod nearest;
mod places;
mod plunger;
mod reach;
mod rules_finding;
mod shaken;
mod switches;
#[cfg(test)]
mod tests;
mod wedges;
mod whole_game;

use fallen_targets::MAX_TARGETS;
pub use finding::{Finding, FindingKind};
use nearest::touchable;

use crate::bot::Bot;
use crate::bot::anomaly::AnomalyKind;
use crate::bot::message_log::ShownMessage;
use crate::bot::self_play::{self, Player, SelfPlayOptions};
use crate::{Failure, Table, simulation};
use geometry::{DVec2, Shape};
use physics::{BALL_RADIUS_M, Command, Controls, Kind, Machine, PartId, TICKS_PER_SECOND};
use reach::{OneWayGates, Reach};
use std::sync::Arc;
use switches::Shot;
use whole_game::LossPlaces;

/// How long the bot plays, s.
pub const BOT_S: u32 = 60;

/// Moving parts of a large table.
const USUAL_BURDEN: usize = 12;
/// Coils that are tried on a table with no more of them.
const MOST_TRIALS: usize = 400;
/// A ball that is thrown has come this far, m.
const THROWN_M: f64 = 0.05;
/// A ball that lies is no faster, m/s.
const LYING_M_S: f64 = 0.01;
/// Captive balls that have been slow for so long have come to rest, ticks; after so many times as long they are left alone.
const SETTLED_TICKS: usize = 250;
const MOST_SETTLING: usize = 20;

/// Where on the table a ball is put that is to stay in play, in parts of the table's size.
const REFUGE: DVec2 = DVec2::new(0.5, 0.4);

/// A table that is being tried.
pub struct Playtest {
    table: Arc<Table>,
    /// With its coils live, and no ball in play.
    machine: Machine,
    reach: Reach,
    /// What the plunger's trial has found.
    launch: Vec<Finding>,
}

/// What a bot has shown of a table.
#[derive(Default)]
pub struct BotRun {
    /// What went wrong.
    pub findings: Vec<Finding>,
    /// The best score.
    pub score: i64,
    /// The messages that were shown for a time.
    pub messages: Vec<ShownMessage>,
    /// What the rules complained about.
    pub complaints: Vec<String>,
}

impl Playtest {
    /// Tries the plunger, and finds where a ball can come to.
    ///
    /// # Errors
    /// If the table's parts make no machine.
    pub fn new(table: &Arc<Table>) -> Result<Playtest, Failure> {
        let machine = Machine::new(Arc::new(table.layout.clone()));
        let mut machine = machine.map_err(|error| simulation::refused(table, &error))?;
        machine.tick(Controls::NONE, &[Command::SetFlippers(true), Command::SetCoils(true)]);
        settle_captives(&mut machine);
        let launch = plunger::try_it(&machine);
        // Where no ball leaves the plunger, what it could come to is told from the middle of the table, back through gates too.
        let feed = machine.layout().parts.iter().find_map(|part| match &part.kind {
            Kind::Plunger(plunger) if launch.is_empty() => Some(plunger.feed),
            _ => None,
        });
        let start = feed.unwrap_or(machine.layout().size_m * 0.5);
        let gates = feed.map(|_| OneWayGates::new(machine.layout())).unwrap_or_default();
        let reach = Reach::new(&machine, start, gates);
        Ok(Playtest { table: table.clone(), machine, reach, launch })
    }

    /// What the plunger's trial has found.
    pub fn launch(&self) -> &[Finding] {
        &self.launch
    }

    /// At most `most` places that a ball can come to, m: pockets, what lies beside parts that move, and others that are
    /// spread over all of the table.
    pub fn places(&self, most: usize) -> Vec<DVec2> {
        places::places(&self.machine, &self.reach, most)
    }

    /// What becomes of a ball that is let go at rest at one of [`Playtest::places`].
    pub fn let_go(&self, place_m: DVec2) -> Option<Finding> {
        let_go::let_go(&self.machine, place_m)
    }

    /// What each coil does with a ball before it, and which switches a ball cannot close.
    pub fn coils(&self) -> Vec<Finding> {
        let tried = self.trials().filter_map(|(part, kind)| coils::try_it(&self.machine, &self.reach, part, kind));
        let crossing = coils::crossing_flippers(&self.machine);
        coils::loose_captives(&self.machine).into_iter().chain(crossing).chain(tried).collect()
    }

    /// The parts whose coils are tried: of very many some, for each trial takes the longer the more moves.
    fn trials(&self) -> impl Iterator<Item = (PartId, &Kind)> {
        let parts = self.machine.layout().parts.iter().enumerate();
        let ids = parts.map(|(index, part)| (PartId(index as u16), &part.kind));
        let with_coils: Vec<(PartId, &Kind)> = ids.filter(|(_, kind)| coils::has_trial(kind)).collect();
        let most = MOST_TRIALS * USUAL_BURDEN / burden(&self.machine).max(USUAL_BURDEN);
        let stride = with_coils.len().div_ceil(most.max(1)).max(1);
        with_coils.into_iter().step_by(stride)
    }

    /// Parts beside which a ball can leave the playfield.
    pub fn open_edges(&self) -> Vec<Finding> {
        let layout = self.machine.layout();
        let gaps = self.reach.gaps(layout).into_iter();
        let findings = gaps.map(|gap| Finding {
            place_mm: gap.middle * 1000.0,
            ..Finding::near(FindingKind::OpenEdge, layout, gap.side, false)
        });
        self.merged(findings.collect())
    }

    /// Parts with a switch that no ball can come to from the plunger. Nothing is said of a table whose plunger fails.
    pub fn unreachable(&self) -> Vec<Finding> {
        if !self.launch.is_empty() {
            return Vec::new();
        }
        let parts = self.machine.layout().parts.iter().enumerate();
        let parts = parts.map(|(index, part)| (PartId(index as u16), &part.kind));
        let out_of_reach = parts.filter(|(part, kind)| self.is_out_of_reach(*part, kind));
        out_of_reach.map(|(part, _)| Finding::of_part(FindingKind::Unreachable, part, DVec2::ZERO)).collect()
    }

    fn is_out_of_reach(&self, part: PartId, kind: &Kind) -> bool {
        match kind {
            Kind::Wall(_) | Kind::Flipper(_) | Kind::Plunger(_) | Kind::CaptiveBall(_) => false,
            Kind::Ramp(_) => {
                // Of ramps that are joined one is told.
                let joints = self.machine.ramp_joints();
                let is_told =
                    |(one, other): &(PartId, PartId)| *one == part && *other < part && !self.reach.comes_onto(*other);
                !self.reach.comes_onto(part) && !joints.iter().any(is_told)
            }
            _ => {
                // Over a switch, a hole or a field the ball's centre must come.
                let reach_m = if kind.sensor().is_some() { 0.0 } else { BALL_RADIUS_M };
                let touched = |shape: &Shape| self.reach.comes_to(shape, reach_m);
                let shapes = touchable(kind);
                !shapes.iter().any(touched) && !shapes.iter().any(|shape| self.is_on_a_ramp(shape))
            }
        }
    }

    /// Whether this lies on a ramp that a ball can come onto.
    fn is_on_a_ramp(&self, shape: &Shape) -> bool {
        let near = |leg: &physics::Leg| shape.distance(leg.at(0.5 * leg.length())).0 < leg.length();
        let mut parts = self.machine.layout().parts.iter().enumerate();
        parts.any(|(index, part)| {
            let ramp = reach::ramp(&part.kind).filter(|_| self.reach.comes_onto(PartId(index as u16)));
            ramp.is_some_and(|ramp| ramp.path.iter().any(near))
        })
    }

    /// What the rules do wrong, or leave undone, in a game whose balls are all lost soon, and what they complain
    /// about.
    ///
    /// # Errors
    /// If they do not run.
    pub fn first_game(&self) -> Result<(Vec<Finding>, Vec<String>), Failure> {
        first_game::try_rules(&self.table, &self.loss_places(), &self.target_shots())
    }

    /// A shot at each drop target; none of a table that has very many, or one that no shot fells.
    fn target_shots(&self) -> Vec<(PartId, Shot)> {
        let parts = self.machine.layout().parts.iter().enumerate();
        let targets = parts.filter(|(_, part)| matches!(part.kind, Kind::DropTarget(_)));
        let targets: Vec<(PartId, &Kind)> =
            targets.map(|(index, part)| (PartId(index as u16), &part.kind)).take(MAX_TARGETS + 1).collect();
        let shot = |(part, kind): &(PartId, &Kind)| {
            Some((*part, switches::closing_shot(&self.machine, &self.reach, *part, kind).ok()??))
        };
        let shots: Option<Vec<_>> = targets.iter().take(MAX_TARGETS).map(shot).collect();
        shots.filter(|_| targets.len() <= MAX_TARGETS).unwrap_or_default()
    }

    /// Where balls are lost, and where they are kept in play until then.
    fn loss_places(&self) -> LossPlaces {
        let layout = self.machine.layout();
        let parts = layout.parts.iter().enumerate();
        let drains = parts.filter_map(|(index, part)| match &part.kind {
            Kind::Drain(drain) => Some((PartId(index as u16), self.reach.place_in(&self.machine, &drain.shape)?)),
            _ => None,
        });
        let refuge = Shape::disc(layout.size_m * REFUGE, 0.0);
        let refuge = self.reach.nearest(&refuge, layout.size_m.max_element()).map(|(place, _)| place);
        LossPlaces { drains: drains.collect(), refuge }
    }

    /// A bot's first minute.
    ///
    /// # Errors
    /// If the table's rules do not run.
    pub fn bot_run(&self) -> Result<BotRun, Failure> {
        let longest = u64::from(BOT_S) * u64::from(TICKS_PER_SECOND);
        let options = SelfPlayOptions { again: true, ..SelfPlayOptions::one_game(longest) };
        let run = self_play::play(&self.table, 0, Player::Bot(Bot::new(0)), options)?;
        let layout = self.machine.layout();
        let findings = run.anomalies.iter().map(|anomaly| {
            let kind = match anomaly.kind {
                AnomalyKind::Stuck => FindingKind::Stuck,
                AnomalyKind::Escaped => FindingKind::Escaped,
                AnomalyKind::Overlap => FindingKind::Overlap,
                AnomalyKind::NotANumber => FindingKind::NotANumber,
            };
            Finding::near(kind, layout, anomaly.center_mm * 0.001, anomaly.above)
        });
        let anew = Finding { kind: FindingKind::BeginsAnew, part: None, place_mm: DVec2::ZERO, count: 1 };
        let findings = findings.chain((run.restarts > 0).then_some(anew));
        Ok(BotRun {
            findings: findings.collect(),
            score: run.score(),
            messages: run.messages,
            complaints: run.complaints,
        })
    }

    /// All that was found, the worst first: the same about the same part once. Where the playfield is open, balls that
    /// have left it are a consequence.
    pub fn merged(&self, mut findings: Vec<Finding>) -> Vec<Finding> {
        if findings.iter().any(|finding| finding.kind == FindingKind::OpenEdge) {
            findings.retain(|finding| finding.kind != FindingKind::Escaped);
        }
        let dead: Vec<_> =
            findings.iter().filter(|one| one.kind == FindingKind::KeepsItsBall).map(|one| one.part).collect();
        findings.retain(|finding| finding.kind != FindingKind::NeverEjected || !dead.contains(&finding.part));
        let hidden: Vec<_> =
            findings.iter().filter(|one| one.kind == FindingKind::Unreachable).map(|one| one.part).collect();
        findings.retain(|finding| finding.kind != FindingKind::SwitchNeverCloses || !hidden.contains(&finding.part));
        finding::merged(findings)
    }
}

/// Lets captive balls that are drawn off their resting places roll there, as they have in any game.
fn settle_captives(machine: &mut Machine) {
    let is_rolling =
        |machine: &Machine| machine.pose().captives.iter().any(|(_, ball)| ball.velocity.length() > LYING_M_S);
    for _ in 0..MOST_SETTLING {
        if machine.pose().captives.is_empty() {
            return;
        }
        let mut rolled = false;
        for _ in 0..SETTLED_TICKS {
            machine.tick(Controls::NONE, &[]);
            rolled |= is_rolling(machine);
        }
        if !rolled {
            return;
        }
    }
}

/// Puts a ball there; whether there is room for it. A captive ball that lies wedged may be in its walls.
fn put_ball(machine: &mut Machine, place: DVec2, velocity: DVec2) -> bool {
    let id = machine.put_ball(place, velocity, [0.0; 3]);
    machine.penetration_of_m(id).is_some_and(|depth| depth <= 0.0)
}

/// Whether a ball there is on the playfield.
fn is_on(machine: &Machine, center: DVec2) -> bool {
    center.cmpge(DVec2::ZERO).all() && center.cmple(machine.layout().size_m).all()
}

fn wait(machine: &mut Machine, controls: Controls, ticks: u32) {
    (0..ticks).for_each(|_| machine.tick(controls, &[]));
}

/// How far the ball comes from `start` in so many ticks, m.
fn farthest(machine: &mut Machine, controls: Controls, start: DVec2, ticks: u32) -> f64 {
    let mut farthest = 0.0_f64;
    for _ in 0..ticks {
        machine.tick(controls, &[]);
        let distances = machine.balls().into_iter().map(|ball| ball.center.distance(start));
        farthest = distances.fold(farthest, f64::max);
    }
    farthest
}

/// How much slower a tick is for all that moves on the table.
fn burden(machine: &Machine) -> usize {
    let weight = |kind: &Kind| match kind {
        Kind::Flipper(_) | Kind::CaptiveBall(_) | Kind::Spinner(_) | Kind::Gate(_) | Kind::Kickback(_) => 4,
        Kind::DropTarget(_) => 1,
        _ => 0,
    };
    machine.layout().parts.iter().map(|part| weight(&part.kind)).sum::<usize>() / 4
}
