//! Script state: what a script's calls work on: the score, the display, the timers, and the orders to the machine.

use super::display::Display;
use super::score::Score;
use super::switches::Switches;
use super::timers::Timers;
use geometry::rng::SplitMix64;
use physics::{Command, Event, EventKind, PartId};
use serde::{Deserialize, Serialize};

/// Most orders that wait for the next tick.
pub const MAX_COMMANDS: usize = 256;
/// Time after a touch of the tilt bob in which further touches are the same swing, ms.
const BOB_MS: u64 = 300;

/// Everything that the host keeps for the script.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScriptState {
    /// Ticks since the machine was switched on.
    pub now: u64,
    /// Players, points and balls.
    pub score: Score,
    /// What the display says.
    pub message: Message,
    /// Progress that is shown: name, done, of how many; in the order in which it was first told.
    pub progress: Vec<(String, i64, i64)>,
    /// What the script wants to be told later.
    pub timers: Timers,
    /// The script's random numbers.
    pub random: SplitMix64,
    /// The switches that are closed.
    pub switches: Switches,
    /// Balls in play at the start of the call, without those that are owed.
    pub balls: u32,
    /// Balls that were asked for and have not arrived in the plunger lane yet.
    pub owed: u32,
    /// Flippers obey their buttons.
    pub flippers: bool,
    /// All coils but those of the flippers work.
    pub kickers: bool,
    /// Until when touches of the tilt bob do not count.
    bob_until: u64,
    /// Orders for the next tick.
    pub commands: Vec<Command>,
    /// How often a game was begun while a ball of another was in play, since this was made or read: trials look at it, and no
    /// game comes to depend on it.
    #[serde(skip)]
    pub restarts: u32,
}

/// A message on the display.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Message {
    /// Its lines; none when there is no message.
    pub lines: Vec<String>,
    /// When it came.
    pub since: u64,
    /// When it goes; `None` if it stays.
    pub until: Option<u64>,
}

impl Message {
    fn is_gone(&self, now: u64) -> bool {
        self.until.is_some_and(|until| until <= now)
    }
}

impl ScriptState {
    /// The script state of a machine that has just been switched on.
    pub fn new(seed: u64) -> ScriptState {
        ScriptState { random: SplitMix64::new(seed), ..ScriptState::default() }
    }

    /// Queues an order for the next tick. False if too many wait already.
    pub fn order(&mut self, command: Command) -> bool {
        let room = self.commands.len() < MAX_COMMANDS;
        if room {
            self.commands.push(command);
        }
        room
    }

    /// Asks for a ball in the plunger lane.
    pub fn add_ball(&mut self) -> bool {
        let ordered = self.order(Command::AddBall);
        self.owed += u32::from(ordered);
        ordered
    }

    /// Shows a message from now on, for `duration_ms` or (0) until another comes. A message with the headline of the one
    /// that is still shown is the same message with other words: it does not come anew.
    pub fn show_message(&mut self, lines: Vec<String>, duration_ms: u64) {
        let until = (duration_ms > 0).then(|| self.now.saturating_add(duration_ms));
        let same = !self.message.is_gone(self.now) && self.message.lines.first() == lines.first();
        let since = if same { self.message.since } else { self.now };
        self.message = Message { lines, since, until };
    }

    /// Takes note of an event; the name of the script's function that should hear of it, and the part that it is told.
    pub fn record(&mut self, event: &Event) -> Option<(&'static str, Option<PartId>)> {
        match event.kind {
            EventKind::Closed => {
                self.switches.set(event.part?, true);
                Some(("on_switch", event.part))
            }
            EventKind::Opened => {
                self.switches.set(event.part?, false);
                Some(("on_open", event.part))
            }
            EventKind::Launched => Some(("on_launch", None)),
            EventKind::Fed => {
                self.owed = self.owed.saturating_sub(1);
                Some(("on_feed", None))
            }
            EventKind::TiltBob => {
                let counted = self.now >= self.bob_until;
                self.bob_until = self.now + BOB_MS;
                counted.then_some(("on_bob", None))
            }
            EventKind::Slam => Some(("on_slam", None)),
        }
    }

    /// What the display shows now.
    pub fn display(&self) -> Display {
        let gone = self.message.is_gone(self.now);
        Display {
            scores: self.score.scores.clone(),
            player: self.score.player,
            ball: self.score.ball,
            balls: self.score.balls,
            message: if gone { Vec::new() } else { self.message.lines.clone() },
            message_tick: self.message.since,
            message_until: self.message.until.filter(|_| !gone),
            playing: self.score.playing,
            tilted: self.score.tilted,
            progress: self.progress.clone(),
        }
    }
}
