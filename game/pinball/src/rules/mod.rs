//! The rules of a table: a script that turns events into points, lamps, messages and balls.
//!
//! The script is called when something happens and at no other time. What it remembers is plain data ([`Value`]), what
//! it may do is `host`, and a script that fails or does not end is cut short with a sentence while the game goes on.
//! Refuses to know how balls move and how light falls.

mod ball_search;
mod display;
mod handlers;
mod host;
mod host_function;
mod host_lamps;
mod literal_names;
mod memory;
mod names;
mod part_commands;
mod program;
mod review;
mod score;
mod script;
mod script_state;
mod signatures;
mod switches;
mod timers;
mod value;
mod work;

#[cfg(test)]
pub(crate) mod tests;

pub use display::Display;
pub use program::Program;
pub use review::{KnownMessage, NO_START, Review, is_kicker};
pub use score::Score;
pub use script_state::ScriptState;
pub use value::Value;
pub use work::Work;

use crate::lamps::LampController;
use crate::{Buttons, Failure};
use ball_search::BallSearch;
use memory::Memory;
use physics::{BallPose, Command, Fingerprint, TickEvent};
use program::Happening;
use script::Meter;
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
    /// The steps that the last tick has taken: nothing depends on them.
    steps: u64,
}

/// Everything of the rules that can change what happens next.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct State {
    /// What the script remembers: its `this`.
    memory: Memory,
    /// What the script's calls have done.
    script: ScriptState,
    /// The search for balls that have come to rest where no switch is.
    search: BallSearch,
    /// What the script's calls have worked too much.
    work: Work,
}

impl State {
    /// What the script remembers.
    #[cfg(test)]
    pub(crate) fn memory(&self) -> &Value {
        self.memory.value()
    }

    /// What the script's calls have worked too much.
    pub fn work(&self) -> Work {
        self.work
    }

    /// Adds what serializing the state would add, in less time.
    pub fn add_to(&self, fingerprint: &mut Fingerprint) {
        let State { memory, script, search, work } = self;
        fingerprint.add_bytes(memory.bytes());
        fingerprint.add(&(script, search));
        work.add_to(fingerprint);
    }
}

/// What the rules are told in a tick.
pub struct TickInput<'a, B: Fn() -> Vec<BallPose>> {
    /// Ticks since the machine was switched on.
    pub now: u64,
    /// The buttons that are down.
    pub buttons: Buttons,
    /// The buttons that were down in the tick before.
    pub before: Buttons,
    /// The machine's stream of this tick.
    pub events: &'a [TickEvent],
    /// The balls on the playfield; asked for only when it matters.
    pub balls: B,
}

impl Rules {
    /// The rules of a machine that has just been switched on: runs `on_start`.
    ///
    /// # Errors
    /// If `on_start` fails, with file and line.
    pub fn new(program: Arc<Program>, seed: u64, lamps: &mut LampController) -> Result<Rules, Failure> {
        let state = State {
            memory: Memory::new(Value::empty_map()),
            script: ScriptState::new(seed),
            search: BallSearch::default(),
            work: Work::default(),
        };
        let mut rules = Rules { program, state, complaints: Vec::new(), steps: 0 };
        rules.call(Happening { call: "on_start", name: None }, lamps, 0);
        rules.state.work.end_tick();
        match rules.complaints.is_empty() {
            true => Ok(rules),
            false => Err(Failure::of_many(rules.complaints.into_iter().map(Failure::new).collect())),
        }
    }

    /// The rules that go on from this state.
    pub fn restored(program: Arc<Program>, state: State) -> Rules {
        Rules { program, state, complaints: Vec::new(), steps: 0 }
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
    pub fn script_state(&self) -> &ScriptState {
        &self.state.script
    }

    /// The steps that the last tick has taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// What the rules want the machine to do in the next tick.
    pub fn take_commands(&mut self) -> Vec<Command> {
        std::mem::take(&mut self.state.script.commands)
    }

    /// What went wrong since the last call.
    pub fn take_complaints(&mut self) -> Vec<String> {
        std::mem::take(&mut self.complaints)
    }

    /// One millisecond: buttons first, then what happened on the playfield, then timers, then the ball search.
    pub fn tick(&mut self, input: &TickInput<impl Fn() -> Vec<BallPose>>, lamps: &mut LampController) {
        self.state.script.now = input.now;
        self.steps = 0;
        for (call, name) in switches::button_edges(input.before, input.buttons) {
            self.notify(call, Some(name), lamps, input);
        }
        for event in input.events.iter().filter_map(TickEvent::event) {
            if let Some((call, part)) = self.state.script.record(event) {
                let program = self.program.clone();
                match part.map(|part| program.names().part_name(part)) {
                    None => self.notify(call, None, lamps, input),
                    Some(Some(name)) => self.notify(call, Some(name), lamps, input),
                    // What has no name is none of the script's business.
                    Some(None) => {}
                }
            }
        }
        while let Some(name) = self.state.script.timers.take_due(input.now) {
            self.notify("on_timer", Some(&name), lamps, input);
        }
        self.state.search.tick(input, &mut self.state.script, self.program.names());
        self.state.work.end_tick();
    }

    fn notify(
        &mut self,
        call: &str,
        name: Option<&str>,
        lamps: &mut LampController,
        input: &TickInput<impl Fn() -> Vec<BallPose>>,
    ) {
        if self.program.has(call) {
            let balls = self.state.search.balls_in_play(&(input.balls)());
            self.call(Happening { call, name }, lamps, balls);
        }
    }

    fn call(&mut self, happening: Happening, lamps: &mut LampController, balls: u32) {
        self.state.script.balls = balls;
        let State { memory, script, work, .. } = &mut self.state;
        let mut meter = Meter::new(work.allowed());
        let answer = self.program.call(happening, memory, script, lamps, &mut meter);
        work.add(meter.spent());
        self.steps += meter.spent();
        if let Err(complaint) = answer {
            self.complain(complaint);
        }
    }

    fn complain(&mut self, complaint: String) {
        if self.complaints.len() < MAX_COMPLAINTS && !self.complaints.contains(&complaint) {
            self.complaints.push(complaint);
        }
    }
}
