//! The whole game's trial: nobody flips, each ball is lost soon after it was shot, and each lost ball must have a
//! consequence, until the game is over.
//!
//! A ball that is not lost by itself is put into a drain, so that what is found does not depend on where the walls lead
//! balls. What saves a ball for some time is waited for: each ball that is played again is kept in play for longer.

mod seen;

use super::finding::{Finding, FindingKind};
use crate::{Buttons, Simulation};
use geometry::DVec2;
use physics::{BALL_RADIUS_M, BallPose, EventKind, Kind, PartId, TICKS_PER_SECOND};
use seen::Seen;
use std::collections::BTreeSet;

/// The table may be empty in a game for so long: soon after that the ball search gives a ball, whatever the rules say.
const EMPTY_TICKS: u64 = 14_300;
/// No ball is lost sooner after it has come, ticks.
const LEAST_TICKS: u64 = 3000;
/// How long a ball that has left the plunger is kept in play, ticks: the first of a turn, and those that are played
/// again. A game whose turn does not end behind so many balls has no end.
const KEPT_TICKS: [u64; 5] = [2000, 2000, 8000, 16_000, 32_000];
/// Balls of a game that are lost: what comes later in a longer game is none of this trial's business.
pub const MOST_BALLS: usize = 12;
/// A ball that cannot be lost by then is none of it either, ticks.
const MOST_TICKS: u64 = 90_000;
/// Contact solves that a ball may take, and more for each tick that it is kept in play.
const MOST_CONTACT_SOLVES: u64 = 400_000;
const CONTACT_SOLVES_PER_TICK: u64 = 40;
/// Parts of a full pull of the plunger, one pull after the other, and the time from one to the next, ticks.
const PULLS: [f64; 4] = [1.0, 0.8, 0.6, 0.4];
const PULL_PERIOD_TICKS: u64 = 5000;
/// A ball this far from the place where balls arrive has left the plunger, m.
const LANE_M: f64 = 6.0 * BALL_RADIUS_M;
/// A ball that comes this near to a drain before its time is brought back, m.
const RESCUE_M: f64 = 0.04;
/// From one ball that is put into a drain to the next, ticks.
const LOSS_PERIOD_TICKS: u64 = 200;
/// What a lost ball ends while another is in play has ended by then, ticks.
const EARLY_TICKS: u64 = 4000;
/// A game is on so long after start was pressed, and has given its first ball at the latest, ticks.
pub const BEGIN_TICKS: u64 = 2000;
/// What begins a game: start, again as for a second coin, or another button.
pub const BEGINNINGS: [Buttons; 5] = [Buttons::START, Buttons::START, Buttons::PLUNGER, Buttons::LEFT, Buttons::RIGHT];
/// From one press that may begin the next game to another, ticks.
const PRESS_PERIOD_TICKS: u64 = 5000;
/// How long a button is pressed for that, ticks.
pub const PRESS_TICKS: u64 = 100;
/// What is pressed while a ball is in play, and must not begin the game anew, and how long each is watched, ticks.
const IN_PLAY: [Buttons; 3] = [Buttons::START, Buttons::LEFT, Buttons::RIGHT];
const PRESSED_TICKS: u64 = 400;
/// Between two presses of the flippers' buttons while the table is empty, ticks: rules may ask the player something.
const ASKED_TICKS: u64 = 500;

/// Where balls are lost, and where they are kept until then.
#[derive(Clone, Debug, Default)]
pub struct LossPlaces {
    /// A place in each drain that a ball can come to, m.
    pub drains: Vec<(PartId, DVec2)>,
    /// Where a ball is put that would be lost too soon, m.
    pub refuge: Option<DVec2>,
}

/// A game on its way.
struct WholeGame<'a> {
    simulation: Simulation,
    places: &'a LossPlaces,
    /// The drain in which balls are lost.
    drain: Option<(PartId, DVec2)>,
    /// The game just before the last ball on the table was put into the drain.
    before_loss: Option<Simulation>,
    seen: Seen,
    /// Drop targets that have risen.
    raised: BTreeSet<PartId>,
}

/// What a game has shown.
pub struct Played {
    /// What the rules do wrong, or leave undone.
    pub findings: Vec<Finding>,
    /// What they complain about.
    pub complaints: Vec<String>,
    /// Drop targets that have risen.
    pub raised: BTreeSet<PartId>,
    /// The next game, if the game is over and another has begun.
    pub next: Option<Simulation>,
}

/// What has become of a ball that was waited for.
enum Arrival {
    Came,
    GameOver,
    Never,
}

/// What has become of a ball that was to be lost.
enum Loss {
    /// It is lost, or the game is over.
    Seen,
    /// It takes too long to see.
    Unseen,
}

/// What the rules do wrong, or leave undone, from here to the end of a game whose balls are lost in this drain, or until so
/// many are lost; and what they complain about.
pub fn play(begun: &Simulation, places: &LossPlaces, drain: Option<(PartId, DVec2)>, balls: usize) -> Played {
    let (seen, raised) = (Seen::default(), BTreeSet::new());
    let mut game = WholeGame { simulation: begun.clone(), places, drain, before_loss: None, seen, raised };
    let mut begins_again = false;
    let mut found = Vec::new();
    let (mut last_turn, mut same_turn, mut ends_early, mut restarts) = (None, 0, None, false);
    for lost in 0..=balls {
        let arrival = game.wait_for_ball(lost == 0);
        let turn = game.simulation.rules_state().turn;
        let is_over = matches!(arrival, Arrival::GameOver);
        let turns_in_play = game.turn_before_loss().is_some_and(|before| last_turn.is_some_and(|last| last != before));
        let has_ended = last_turn.is_some_and(|last| last != turn || is_over);
        if has_ended && ends_early.is_none() {
            ends_early = game.ends_early();
        }
        if is_over {
            let is_early = lost < game.simulation.rules_state().balls as usize;
            let kind = if turns_in_play { FindingKind::TurnsInPlay } else { FindingKind::OverEarly };
            found.extend(is_early.then_some((kind, lost)));
            begins_again = game.begins_again();
            found.extend((!begins_again).then_some((FindingKind::NoNextGame, lost)));
            break;
        }
        if matches!(arrival, Arrival::Never) {
            found.push(game.missing(last_turn, lost));
            break;
        }
        same_turn = if last_turn == Some(turn) { same_turn + 1 } else { 0 };
        let Some(kept_ticks) = KEPT_TICKS.get(same_turn) else {
            found.push((FindingKind::GameWithoutEnd, lost));
            break;
        };
        if lost == balls {
            break;
        }
        let loss = game.lose_ball(*kept_ticks);
        if found.is_empty() {
            found.extend(game.seen.fault(game.simulation.table()).map(|kind| (kind, lost + 1)));
        }
        restarts |= game.seen.begins_anew;
        if matches!(loss, Loss::Unseen) {
            break;
        }
        last_turn = Some(turn);
    }
    found.extend(ends_early.unwrap_or(false).then_some((FindingKind::EndsEarly, 1)));
    restarts |= game.simulation.rules_state().restarts > 0;
    found.extend(restarts.then_some((FindingKind::BeginsAnew, 1)));
    let part = drain.map(|(part, _)| part);
    let told = |(kind, count)| Finding { kind, part, place_mm: DVec2::ZERO, count };
    let (findings, complaints) = (found.into_iter().map(told).collect(), game.simulation.complaints());
    Played { findings, complaints, raised: game.raised, next: begins_again.then_some(game.simulation) }
}

impl WholeGame<'_> {
    /// Whose turn it was just before the last ball was lost.
    fn turn_before_loss(&self) -> Option<(usize, u32)> {
        self.before_loss.as_ref().map(|before| before.rules_state().turn)
    }

    /// Waits until a ball is on the table, or none will come.
    fn wait_for_ball(&mut self, is_first: bool) -> Arrival {
        // The first has been waited for already.
        let waited = if is_first { BEGIN_TICKS } else { 0 };
        for tick in waited..EMPTY_TICKS {
            if !self.simulation.rules_state().playing {
                return Arrival::GameOver;
            }
            if !self.balls().is_empty() {
                return Arrival::Came;
            }
            self.tick(if is_first { Buttons::NONE } else { answers(tick) });
        }
        Arrival::Never
    }

    /// Shoots the ball, keeps it in play for so long, and loses it with all others that have come meanwhile.
    fn lose_ball(&mut self, kept_ticks: u64) -> Loss {
        self.seen = Seen::default();
        self.before_loss = None;
        let most_contact_solves = MOST_CONTACT_SOLVES + CONTACT_SOLVES_PER_TICK * kept_ticks;
        let mut contact_solves = 0;
        let mut lost_at = None;
        for tick in 0..MOST_TICKS {
            let rules = self.simulation.rules_state();
            let balls = self.balls();
            if !rules.playing || balls.is_empty() {
                return Loss::Seen;
            }
            if contact_solves > most_contact_solves {
                return Loss::Unseen;
            }
            let is_shot = balls.iter().any(|ball| self.is_away(ball));
            self.seen.look(rules, is_shot);
            lost_at = lost_at.or(is_shot.then_some(tick + kept_ticks));
            if lost_at.is_some_and(|at| tick == at.max(LEAST_TICKS)) && rules.turn == (0, 1) {
                self.seen.begins_anew = IN_PLAY.into_iter().any(|button| self.begins_anew_by(button));
            }
            if lost_at.is_some_and(|at| tick >= at.max(LEAST_TICKS)) {
                self.lose_one(tick, &balls);
            } else {
                rescue(&mut self.simulation, self.places, &balls);
            }
            self.tick(self.plunger(tick));
            contact_solves += self.simulation.machine().contact_solves();
        }
        Loss::Unseen
    }

    /// Puts a ball into the drain. What a saucer holds is the rules', what waits at the plunger will be shot.
    fn lose_one(&mut self, tick: u64, balls: &[BallPose]) {
        let Some((_, place)) = self.drain.filter(|_| tick.is_multiple_of(LOSS_PERIOD_TICKS)) else { return };
        let Some(ball) = balls.iter().find(|ball| !ball.held && self.is_away(ball)) else { return };
        if balls.len() == 1 {
            self.before_loss = Some(self.simulation.clone());
        }
        self.simulation.move_ball(ball.id, place);
    }

    /// Whether the loss that has ended this turn, or the game, ends it while another ball is on the table too; unknown
    /// where nobody saw that loss.
    fn ends_early(&self) -> Option<bool> {
        let (mut simulation, refuge) = (self.before_loss.clone()?, self.places.refuge?);
        let ball = simulation.machine().balls().first()?.id;
        let turn = simulation.rules_state().turn;
        simulation.put_ball(refuge, DVec2::ZERO);
        simulation.tick(Buttons::NONE);
        simulation.move_ball(ball, self.drain?.1);
        for _ in 0..EARLY_TICKS {
            simulation.tick(Buttons::NONE);
            let rules = simulation.rules_state();
            if !rules.playing || rules.turn != turn {
                return Some(true);
            }
            let balls = simulation.machine().balls();
            if balls.is_empty() {
                return None;
            }
            rescue(&mut simulation, self.places, &balls);
        }
        Some(false)
    }

    /// Whether a press of this button begins the game anew while its first ball is in play: with a later one that may be
    /// meant.
    fn begins_anew_by(&self, button: Buttons) -> bool {
        let mut simulation = self.simulation.clone();
        for tick in 0..PRESSED_TICKS {
            simulation.tick(if tick < PRESS_TICKS { button } else { Buttons::NONE });
            let balls = simulation.machine().balls();
            rescue(&mut simulation, self.places, &balls);
        }
        simulation.rules_state().restarts > 0
    }

    /// Whether a press of a button begins the next game.
    fn begins_again(&mut self) -> bool {
        // What the rules complain about meanwhile is kept.
        let mut is_begun_by = |button: Buttons| {
            (0..PRESS_PERIOD_TICKS).any(|tick| {
                let is_down =
                    tick.checked_sub(PRESS_PERIOD_TICKS - BEGIN_TICKS).is_some_and(|since| since < PRESS_TICKS);
                self.tick(if is_down { button } else { Buttons::NONE });
                self.simulation.rules_state().playing
            })
        };
        BEGINNINGS.into_iter().any(&mut is_begun_by)
    }

    fn tick(&mut self, buttons: Buttons) {
        self.simulation.tick(buttons);
        self.raised.extend(risen(&self.simulation));
    }

    /// What is missing where no ball comes behind so many lost ones.
    fn missing(&self, last_turn: Option<(usize, u32)>, lost: usize) -> (FindingKind, usize) {
        let rules = self.simulation.rules_state();
        let kind = match last_turn {
            None => FindingKind::NoBall,
            Some(last) if last != rules.turn => FindingKind::NoNextBall,
            Some(_) if rules.is_last_turn => FindingKind::NoGameOver,
            Some(_) => FindingKind::BallWithoutEnd,
        };
        (kind, lost)
    }

    fn balls(&self) -> Vec<BallPose> {
        self.simulation.machine().balls()
    }

    fn is_away(&self, ball: &BallPose) -> bool {
        is_away(&self.simulation, ball)
    }

    /// Pulls of different strength: a full one may come back round a bend.
    fn plunger(&self, tick: u64) -> Buttons {
        let pull_s = self.simulation.table().layout.parts.iter().find_map(|part| match &part.kind {
            Kind::Plunger(plunger) => Some(plunger.pull_s),
            _ => None,
        });
        let pull = PULLS[(tick / PULL_PERIOD_TICKS) as usize % PULLS.len()] * pull_s.unwrap_or_default();
        let pull_ticks = (pull * f64::from(TICKS_PER_SECOND)).ceil() as u64;
        let is_down = tick % PULL_PERIOD_TICKS < pull_ticks.min(PULL_PERIOD_TICKS - 1);
        if is_down { Buttons::PLUNGER } else { Buttons::NONE }
    }
}

/// Whether the ball has left the plunger.
pub fn is_away(simulation: &Simulation, ball: &BallPose) -> bool {
    let mut plungers = simulation.table().layout.parts.iter().filter_map(|part| match &part.kind {
        Kind::Plunger(plunger) => Some(plunger.feed),
        _ => None,
    });
    plungers.all(|feed| ball.center.distance(feed) > LANE_M)
}

/// Brings balls back that are about to be lost.
fn rescue(simulation: &mut Simulation, places: &LossPlaces, balls: &[BallPose]) {
    let Some(refuge) = places.refuge.filter(|_| !places.drains.is_empty()) else { return };
    let is_free = |ball: &BallPose| ball.center.distance(refuge) > 2.0 * BALL_RADIUS_M;
    let is_lost = |ball: &&BallPose| {
        simulation.table().layout.parts.iter().any(|part| match &part.kind {
            Kind::Drain(drain) => drain.shape.distance(ball.center).0 < RESCUE_M,
            _ => false,
        })
    };
    let lost = balls.iter().find(is_lost).filter(|_| balls.iter().all(is_free)).map(|ball| ball.id);
    if let Some(ball) = lost {
        simulation.move_ball(ball, refuge);
    }
}

/// Drop targets that have risen in the last tick.
pub fn risen(simulation: &Simulation) -> impl Iterator<Item = PartId> {
    let parts = &simulation.table().layout.parts;
    let is_target = |part: &PartId| matches!(parts[usize::from(part.0)].kind, Kind::DropTarget(_));
    let opened = simulation.events().filter(|event| event.kind == EventKind::Opened);
    opened.filter_map(|event| event.part).filter(is_target)
}

/// The flippers' buttons, now the one and now the other.
pub fn answers(tick: u64) -> Buttons {
    match tick / ASKED_TICKS % 4 {
        1 => Buttons::LEFT,
        3 => Buttons::RIGHT,
        _ => Buttons::NONE,
    }
}
