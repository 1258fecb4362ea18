//! The rules of a table: a script that turns events into points, lamps, messages and balls.
//!
//! The script is called when something happens and at no other time. What it remembers is plain data ([`Value`]), what
//! it may do is `host`, and a script that fails or does not end is cut short with a sentence while the game goes on.
//! Refuses to know how balls move and how light falls.

mod desk;
mod display;
mod host;
mod literals;
mod memory;
mod names;
mod program;
mod score;
mod search;
mod switches;
mod timers;
mod value;

#[cfg(test)]
pub(crate) mod tests;

pub use desk::Desk;
pub use display::Display;
pub use program::Program;
pub use score::Score;
pub use value::Value;

use crate::lamps::Lamps;
use crate::{Buttons, Failure};
use memory::Memory;
use physics::{BallPose, Command, Event, Fingerprint};
use search::Search;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Most complaints that wait to be read.
const MAX_COMPLAINTS: usize = 64;

/// The rules in play.
#[derive(Clone)]
pub struct Rules {
    program: Arc<Program>,
    state: State,
    complaints: Vec<String>,
}

/// Everything of the rules that can change what happens next.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct State {
    /// What the script remembers: its `this`.
    memory: Memory,
    /// What the script's calls have done.
    desk: Desk,
    /// The search for balls that have come to rest where no switch is.
    search: Search,
}

impl State {
    /// What the script remembers.
    #[cfg(test)]
    pub(crate) fn memory(&self) -> &Value {
        self.memory.value()
    }

    /// Adds what serializing the state would add, in less time.
    pub fn add_to(&self, fingerprint: &mut Fingerprint) {
        let State { memory, desk, search } = self;
        fingerprint.add_bytes(memory.bytes());
        fingerprint.add(&(desk, search));
    }
}

/// What the rules are told in a tick.
pub struct Moment<'a, B: Fn() -> Vec<BallPose>> {
    /// Ticks since the machine was switched on.
    pub now: u64,
    /// The buttons that are down.
    pub buttons: Buttons,
    /// The buttons that were down in the tick before.
    pub before: Buttons,
    /// What happened on the playfield.
    pub events: &'a [Event],
    /// The balls on the playfield; asked for only when it matters.
    pub balls: B,
}

impl Rules {
    /// The rules of a machine that has just been switched on: runs `on_start`.
    ///
    /// # Errors
    /// If `on_start` fails, with file and line.
    pub fn new(program: Arc<Program>, seed: u64, lamps: &mut Lamps) -> Result<Rules, Failure> {
        let state = State { memory: Memory::new(Value::empty_map()), desk: Desk::new(seed), search: Search::default() };
        let mut rules = Rules { program, state, complaints: Vec::new() };
        rules.call("on_start", None, lamps, 0);
        match rules.complaints.is_empty() {
            true => Ok(rules),
            false => Err(Failure::new(rules.complaints.join("\n"))),
        }
    }

    /// The rules that go on from this state.
    pub fn restored(program: Arc<Program>, state: State) -> Rules {
        Rules { program, state, complaints: Vec::new() }
    }

    /// The compiled script, for another simulation of the same table.
    pub fn program(&self) -> &Arc<Program> {
        &self.program
    }

    /// Everything that can change what happens next.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// What the display and the score say.
    pub fn desk(&self) -> &Desk {
        &self.state.desk
    }

    /// What the rules want the machine to do in the next tick.
    pub fn take_commands(&mut self) -> Vec<Command> {
        std::mem::take(&mut self.state.desk.commands)
    }

    /// What went wrong since the last call.
    pub fn take_complaints(&mut self) -> Vec<String> {
        std::mem::take(&mut self.complaints)
    }

    /// One millisecond: buttons first, then what happened on the playfield, then timers, then the ball search.
    pub fn tick(&mut self, moment: &Moment<impl Fn() -> Vec<BallPose>>, lamps: &mut Lamps) {
        self.state.desk.now = moment.now;
        for (call, name) in switches::button_edges(moment.before, moment.buttons) {
            self.tell(call, Some(name), lamps, moment);
        }
        for event in moment.events {
            if let Some((call, part)) = self.state.desk.note(event) {
                let program = self.program.clone();
                match part.map(|part| program.names().part_name(part)) {
                    None => self.tell(call, None, lamps, moment),
                    Some(Some(name)) => self.tell(call, Some(name), lamps, moment),
                    // What has no name is none of the script's business.
                    Some(None) => {}
                }
            }
        }
        while let Some(name) = self.state.desk.timers.take_due(moment.now) {
            self.tell("on_timer", Some(&name), lamps, moment);
        }
        self.state.search.tick(moment, &mut self.state.desk, self.program.names());
    }

    fn tell(&mut self, call: &str, name: Option<&str>, lamps: &mut Lamps, moment: &Moment<impl Fn() -> Vec<BallPose>>) {
        if self.program.has(call) {
            let balls = self.state.search.balls_in_play(&(moment.balls)());
            self.call(call, name, lamps, balls);
        }
    }

    fn call(&mut self, call: &str, name: Option<&str>, lamps: &mut Lamps, balls: u32) {
        self.state.desk.balls = balls;
        let State { memory, desk, .. } = &mut self.state;
        let program = &self.program;
        if let Err(complaint) = memory.change(|memory| program.call(call, name, memory, desk, lamps)) {
            self.complain(complaint);
        }
    }

    fn complain(&mut self, complaint: String) {
        if self.complaints.len() < MAX_COMPLAINTS && !self.complaints.contains(&complaint) {
            self.complaints.push(complaint);
        }
    }
}
