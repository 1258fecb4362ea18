//! A player that plays by itself: it traps, aims and shoots.
//!
//! It sees what a player sees (balls, flippers, score) and has a player's hands: a decision takes a tenth of a second to
//! reach the fingers, and they are a few milliseconds early or late. What it has instead of experience is a copy of the
//! machine, with which it tries a few plans before a ball is down at the flippers: let it pass, hold a flipper up, strike
//! at this moment or at that one, push the cabinet. What a hit is worth, it learns from the score.
//!
//! The same seed and the same game give the same play. The bot knows no rule, no lamp and no table by name.

pub mod anomaly;
mod coverage_player;
mod flipper_zones;
mod game_result;
mod input_queue;
pub mod message_log;
mod plan_search;
mod random_player;
mod rng;
mod rollout;
mod run_statistics;
pub mod self_play;
mod shot_value;
mod stay;

pub use coverage_player::CoveragePlayer;
pub use game_result::GameResult;
pub use random_player::RandomPlayer;
pub use rng::BotRng;

use crate::{Buttons, Simulation};
use flipper_zones::FlipperZones;
use input_queue::{ButtonChange, InputQueue};
use physics::{BallPose, EventKind};
use rollout::Rollout;
use shot_value::ShotValues;

/// Ticks from a decision to the first move of the fingers.
const REACTION_TICKS: u64 = 115;
/// A ball that can be at the flippers within so many ticks calls for a decision.
const ALERT_TICKS: u64 = 280;
/// Ticks between two decisions about the same ball.
const REPLAN_TICKS: u64 = 170;
/// Ticks between two decisions about a ball that seems lost.
const REPLAN_LOST_TICKS: u64 = 300;
/// A plan that is worth less loses a ball.
const LOST_VALUE: f64 = -30.0;
/// Ticks between two looks at the display.
const DISPLAY_TICKS: u64 = 100;
/// Ticks before the first game.
const WARM_UP_TICKS: u64 = 1500;
/// Ticks between two games.
const GAME_PAUSE_TICKS: u64 = 6000;
/// Ticks between two pushes of the cabinet.
const NUDGE_PAUSE_TICKS: u64 = 2500;
/// Times that the tilt bob may touch in a ball before the bot pushes no more.
const BOB_TOUCHES: u32 = 1;

/// A bot in play.
#[derive(Clone, Debug)]
pub struct Bot {
    rng: BotRng,
    input_queue: InputQueue,
    /// What it knows of the table: seen when it plays the first tick.
    knowledge: Option<(FlipperZones, ShotValues)>,
    /// The next decision is due.
    think_at: u64,
    /// Since when a ball has been lying on a raised flipper.
    cradled_since: Option<u64>,
    last_score: i64,
    playing: bool,
    idle_since: u64,
    nudged_at: Option<u64>,
    bob_touches: u32,
}

impl Bot {
    /// The bot that this seed gives.
    pub fn new(seed: u64) -> Bot {
        Bot {
            rng: BotRng::new(seed ^ 0xb07),
            input_queue: InputQueue::default(),
            knowledge: None,
            think_at: 0,
            cradled_since: None,
            last_score: 0,
            playing: false,
            idle_since: 0,
            nudged_at: None,
            bob_touches: 0,
        }
    }

    /// What it presses in the next tick.
    pub fn buttons(&mut self, simulation: &Simulation) -> Buttons {
        let layout = &simulation.table().layout;
        let (zones, shot_values) = self.knowledge.take().unwrap_or_else(|| {
            let zones = FlipperZones::new(layout);
            let shot_values = ShotValues::new(layout, zones.line_m);
            (zones, shot_values)
        });
        let shot_values = self.watch(simulation, shot_values);
        let tick = simulation.ticks();
        if tick >= self.think_at && !self.input_queue.is_pending() {
            self.think(simulation, &zones, &shot_values);
        }
        self.knowledge = Some((zones, shot_values));
        self.input_queue.at(tick)
    }

    /// Looks at the score and the display.
    fn watch(&mut self, simulation: &Simulation, mut shot_values: ShotValues) -> ShotValues {
        let tick = simulation.ticks();
        let events = || simulation.events();
        let scored = events().any(|event| event.kind == EventKind::Closed && event.part.is_some());
        self.bob_touches += events().filter(|event| event.kind == EventKind::TiltBob).count() as u32;
        if events().any(|event| event.kind == EventKind::Fed) {
            self.bob_touches = 0;
        }
        if scored || tick.is_multiple_of(DISPLAY_TICKS) {
            let display = simulation.display();
            let score = display.scores.iter().sum();
            if scored && score >= self.last_score {
                shot_values.learn(simulation.tick_events(), score - self.last_score, tick);
            }
            if self.playing != display.playing {
                self.idle_since = tick;
            }
            (self.last_score, self.playing) = (score, display.playing);
        }
        shot_values
    }

    /// Decides what to do next, if anything is to be done.
    fn think(&mut self, simulation: &Simulation, zones: &FlipperZones, shot_values: &ShotValues) {
        let tick = simulation.ticks();
        if !self.playing {
            return self.press_start(tick);
        }
        let balls = simulation.machine().balls();
        if balls.iter().any(|ball| zones.waits(ball)) {
            return self.plunge(tick, zones);
        }
        let playable = |ball: &&BallPose| !ball.held && !zones.in_lane(ball) && !zones.lost(ball.center);
        let mut free = balls.iter().filter(playable);
        let lying = free.clone().find(|ball| self.lies_on_raised(zones, ball));
        match lying {
            Some(_) => self.aim(simulation, zones, shot_values),
            None => {
                self.cradled_since = None;
                let near = |ball: &BallPose| zones.arrives_in(ball).is_some_and(|ticks| ticks < ALERT_TICKS);
                if free.any(near) {
                    self.decide(simulation, zones, shot_values, true);
                } else {
                    self.rest(tick);
                }
            }
        }
    }

    fn lies_on_raised(&self, zones: &FlipperZones, ball: &BallPose) -> bool {
        let side = |left| if left { Buttons::LEFT } else { Buttons::RIGHT };
        zones.cradle(ball).is_some_and(|flipper| self.input_queue.held().contains(side(flipper.left)))
    }

    /// Waits a moment with a ball that lies still, then shoots it.
    fn aim(&mut self, simulation: &Simulation, zones: &FlipperZones, shot_values: &ShotValues) {
        let tick = simulation.ticks();
        match self.cradled_since {
            None => {
                self.cradled_since = Some(tick);
                self.think_at = tick + self.rng.between(250, 700);
            }
            Some(_) => {
                self.cradled_since = None;
                self.decide(simulation, zones, shot_values, false);
            }
        }
    }

    /// Tries some plans in rollouts and begins the best.
    fn decide(&mut self, simulation: &Simulation, zones: &FlipperZones, shot_values: &ShotValues, may_hold: bool) {
        let tick = simulation.ticks();
        let reaction = self.rng.between(REACTION_TICKS - 20, REACTION_TICKS + 30);
        let mut start = Rollout::now(simulation.machine(), self.input_queue.held(), tick, zones, shot_values);
        start.play(reaction, |_| false);
        let mut plan = plan_search::best(&start, may_hold);
        if plan.value < LOST_VALUE
            && self.may_nudge(tick)
            && let Some(save) = plan_search::best_nudge(&start)
        {
            plan = save;
            self.nudged_at = Some(tick);
        }
        self.input_queue.replace(&plan.moves, tick, &mut self.rng);
        self.think_at = tick + if plan.value < LOST_VALUE { REPLAN_LOST_TICKS } else { REPLAN_TICKS };
    }

    fn may_nudge(&self, tick: u64) -> bool {
        self.bob_touches <= BOB_TOUCHES && self.nudged_at.is_none_or(|before| tick > before + NUDGE_PAUSE_TICKS)
    }

    /// Lets the flippers hang while the ball is elsewhere.
    fn rest(&mut self, tick: u64) {
        if self.input_queue.held() != Buttons::NONE {
            let all = ButtonChange { tick: tick + 60, buttons: Buttons::ALL, down: false };
            self.input_queue.replace(&[all], tick, &mut self.rng);
        }
        self.think_at = tick + 20;
    }

    /// Pulls the plunger: all the way, or less on purpose.
    fn plunge(&mut self, tick: u64, zones: &FlipperZones) {
        let pull = 0.55 + 0.5 * self.rng.unit();
        let begin = tick + self.rng.between(300, 900);
        let release = begin + (zones.pull_ticks as f64 * pull) as u64;
        let moves = [
            ButtonChange { tick: begin, buttons: Buttons::PLUNGER, down: true },
            ButtonChange { tick: release, buttons: Buttons::PLUNGER, down: false },
        ];
        self.input_queue.replace(&moves, tick, &mut self.rng);
        self.think_at = release + 400;
    }

    fn press_start(&mut self, tick: u64) {
        self.think_at = tick + 50;
        let pause = if self.idle_since == 0 { WARM_UP_TICKS } else { GAME_PAUSE_TICKS };
        if tick < self.idle_since + pause {
            return;
        }
        let moves = [
            ButtonChange { tick: tick + 10, buttons: Buttons::START, down: true },
            ButtonChange { tick: tick + 110, buttons: Buttons::START, down: false },
        ];
        self.input_queue.replace(&moves, tick, &mut self.rng);
        self.think_at = tick + 1500;
    }
}
