//! The ball search: what a machine does when a ball has come to rest where no switch is.
//!
//! After a while without any switch it fires its coils, three rounds; then it gives the ball up and feeds another. A
//! ball that was given up and moves again is in play again. It also feeds a ball when a script has lost count.

use super::TickInput;
use super::names::Names;
use super::script_state::ScriptState;
use crate::Buttons;
use physics::{BALL_RADIUS_M, BallPose, Command, Event, EventKind, Kind, Plunger, TickEvent};
use serde::{Deserialize, Serialize};

/// Silence before the first round, ms: with the rounds and a late look another ball comes within 15 s.
const QUIET_MS: u64 = 11_800;
/// Silence before the first round while a flipper button is held, ms: a player may think about a trapped ball.
const HELD_MS: u64 = 30_000;
/// Between two rounds, ms.
const ROUND_MS: u64 = 1_000;
/// Rounds before the ball is given up.
const ROUNDS: u32 = 3;
/// How often the search looks, ms.
const LOOK_MS: u64 = 100;
/// How far a ball that was given up must move to be in play again, m.
const FREED_M: f64 = 0.03;

/// Where the search stands.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct BallSearch {
    /// When a switch was last heard, or nothing had to be heard.
    quiet_since: u64,
    /// Rounds of this silence.
    rounds: u32,
    /// The balls that were given up.
    lost: Vec<Lost>,
}

/// A ball that was given up, and where it lay.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Lost {
    ball: u32,
    x_um: i64,
    y_um: i64,
}

impl BallSearch {
    /// How many of these balls are in play: all but those that were given up.
    pub fn balls_in_play(&self, balls: &[BallPose]) -> u32 {
        balls.iter().filter(|ball| !self.is_lost(ball)).count() as u32
    }

    /// One millisecond.
    pub fn tick(&mut self, input: &TickInput<impl Fn() -> Vec<BallPose>>, script: &mut ScriptState, names: &Names) {
        if input.events.iter().filter_map(TickEvent::event).any(|event| is_sign_of_life(event, names)) {
            self.rest(input.now);
        }
        if !input.now.is_multiple_of(LOOK_MS) {
            return;
        }
        let balls = (input.balls)();
        self.lost.retain(|lost| balls.iter().any(|ball| lost.lies_at(ball)));
        let waits = balls.iter().any(|ball| names.parts().any(|(_, kind)| waits_at(ball, kind)));
        if !script.score.playing || waits {
            self.rest(input.now);
            return;
        }
        let held = input.buttons.0 & (Buttons::LEFT.0 | Buttons::RIGHT.0) != 0;
        let patience_ms = if held { HELD_MS } else { QUIET_MS };
        if input.now < self.quiet_since + patience_ms + u64::from(self.rounds) * ROUND_MS {
            return;
        }
        if self.rounds < ROUNDS {
            self.rounds += 1;
            script.order(Command::BallSearch);
        } else {
            self.rest(input.now);
            self.give_up(&balls);
            script.add_ball();
        }
    }

    fn rest(&mut self, now: u64) {
        self.quiet_since = now;
        self.rounds = 0;
    }

    fn give_up(&mut self, balls: &[BallPose]) {
        self.lost = balls.iter().map(Lost::new).collect();
    }

    fn is_lost(&self, ball: &BallPose) -> bool {
        self.lost.iter().any(|lost| lost.ball == ball.id)
    }
}

impl Lost {
    fn new(ball: &BallPose) -> Lost {
        Lost { ball: ball.id, x_um: micrometres(ball.center.x), y_um: micrometres(ball.center.y) }
    }

    fn lies_at(&self, ball: &BallPose) -> bool {
        let near = |um: i64, m: f64| (micrometres(m) - um).abs() < micrometres(FREED_M);
        self.ball == ball.id && near(self.x_um, ball.center.x) && near(self.y_um, ball.center.y)
    }
}

fn micrometres(length_m: f64) -> i64 {
    (length_m * 1e6) as i64
}

/// Whether this shows that a ball moves. A drop target that rises does not: the search itself may have raised it.
fn is_sign_of_life(event: &Event, names: &Names) -> bool {
    let target = event.part.and_then(|part| names.kind(part)).is_some_and(|kind| matches!(kind, Kind::DropTarget(_)));
    match event.kind {
        EventKind::TiltBob | EventKind::Slam => false,
        EventKind::Opened => !target,
        _ => true,
    }
}

/// Whether a ball lies where the player may let it lie: at the plunger.
fn waits_at(ball: &BallPose, kind: &Kind) -> bool {
    let Kind::Plunger(Plunger { feed, tip, half_width_m, .. }) = kind else {
        return false;
    };
    let lane = *feed - *tip;
    let along = if lane.length_squared() > 0.0 {
        ((ball.center - *tip).dot(lane) / lane.length_squared()).clamp(0.0, 1.0)
    } else {
        0.0
    };
    ball.center.distance(*tip + lane * along) < half_width_m + 2.0 * BALL_RADIUS_M
}
