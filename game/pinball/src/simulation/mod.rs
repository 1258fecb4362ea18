//! A game in play: the machine, the rules and the lamps, one tick at a time.
//!
//! A tick reads one [`Buttons`] and nothing else. Everything that can change what happens next is in [`Simulation::hash`]
//! and in [`Simulation::save`].

mod digest;
mod save;
mod snapshot;

#[cfg(test)]
mod tests;

pub use crate::lamps::LampLight;
pub use crate::rules::Display;
pub use digest::Digest;
pub use snapshot::Snapshot;

use crate::lamps::{ADAPTATION_TICKS, ExposureAdaptation, LampBrightness, LampController};
use crate::rules::{Program, Rules, TickInput};
use crate::table::FILES;
use crate::{Buttons, Failure, Table};
use geometry::DVec2;
use physics::{Controls, Event, Fingerprint, Machine, Pose, TickEvent, fingerprint};
use save::Saved;
use std::borrow::Cow;
use std::sync::Arc;

/// The version of everything that decides what a recording replays to. Raised whenever the same inputs would give
/// another game.
pub const SIMULATION_VERSION: u32 = 4;

/// A game in play. A clone goes on exactly as the original does.
#[derive(Clone)]
pub struct Simulation {
    table: Arc<Table>,
    machine: Machine,
    rules: Rules,
    lamps: LampController,
    /// What pictures are exposed for; no part of the game.
    adaptation: ExposureAdaptation,
    brightness: Arc<LampBrightness>,
    /// What happened in the last tick.
    tick_events: Vec<TickEvent>,
    tick: u64,
    /// The buttons of the last tick: the rules hear of changes only.
    buttons: Buttons,
}

/// The parts of the state, hashed one by one so that a difference can be named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hashes {
    /// The balls.
    pub balls: u64,
    /// Everything else that moves.
    pub mechanisms: u64,
    /// Score, players, the rules' own state and random numbers.
    pub rules: u64,
    /// The lamps.
    pub lamps: u64,
}

/// What the rules have decided about a moment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SimulationRules {
    /// A game is on.
    pub playing: bool,
    /// The machine is tilted.
    pub tilted: bool,
    /// Flippers obey their buttons.
    pub flippers_live: bool,
    /// Bumpers, slingshots and their like work.
    pub kickers_live: bool,
    /// Balls that were asked for and have not arrived yet.
    pub owed: u32,
    /// Whose turn it is: the player, from 0, and the ball, from 1.
    pub turn: (usize, u32),
    /// Balls that a player has in this game, or had in the last one.
    pub balls: u32,
    /// The last player plays the last ball.
    pub is_last_turn: bool,
    /// How often a game was begun while a ball of another was in play.
    pub restarts: u32,
}

impl Simulation {
    /// A machine that has just been switched on and waits for [`Buttons::START`].
    ///
    /// # Errors
    /// If the rules do not run, with file and line.
    pub fn new(table: Arc<Table>, seed: u64) -> Result<Simulation, Failure> {
        let program = Arc::new(Program::new(&table)?);
        let layout = Arc::new(table.layout.clone());
        let machine = Machine::new(layout).map_err(|error| refused(&table, &error))?;
        let mut lamps = LampController::new(&table);
        let rules = Rules::new(program, seed, &mut lamps)?;
        let (adaptation, brightness) = (ExposureAdaptation::default(), Arc::new(LampBrightness::new(&table)));
        Ok(Simulation {
            table,
            machine,
            rules,
            lamps,
            adaptation,
            brightness,
            tick_events: Vec::new(),
            tick: 0,
            buttons: Buttons::NONE,
        })
    }

    /// The table that is played.
    pub fn table(&self) -> &Arc<Table> {
        &self.table
    }

    /// One millisecond.
    pub fn tick(&mut self, buttons: Buttons) {
        let buttons = Buttons(buttons.0 & Buttons::ALL.0);
        self.tick += 1;
        let commands = self.rules.take_commands();
        self.machine.tick(controls(buttons), &commands);
        self.tick_events.clear();
        self.tick_events.extend(self.machine.tick_events());
        let input = TickInput {
            now: self.tick,
            buttons,
            before: self.buttons,
            events: &self.tick_events,
            balls: || self.machine.balls(),
        };
        self.rules.tick(&input, &mut self.lamps);
        self.lamps.tick(self.tick);
        if self.tick.is_multiple_of(ADAPTATION_TICKS) {
            self.brightness.show(&self.lamps, &self.table, self.tick, &mut self.adaptation);
        }
        self.buttons = buttons;
    }

    /// Ticks since the machine was switched on.
    pub fn ticks(&self) -> u64 {
        self.tick
    }

    /// The stream of the last tick: its events and contacts in order. Rules, bot and debug overlay listen to it.
    pub fn tick_events(&self) -> &[TickEvent] {
        &self.tick_events
    }

    /// The events of the stream alone.
    pub fn events(&self) -> impl Iterator<Item = &Event> {
        self.tick_events.iter().filter_map(TickEvent::event)
    }

    /// Where everything is now (cheaper than [`Simulation::snapshot`]).
    pub fn pose(&self) -> Pose {
        self.machine.pose()
    }

    /// The machine alone, to look ahead with: a bot plays its clone.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// What a picture needs to know of this moment.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            tick: self.tick,
            pose: self.pose(),
            lamps: self.lamps.lights(&self.table, self.tick),
            adaptation: self.adaptation,
            display: self.display(),
        }
    }

    /// What the display shows (cheaper than [`Simulation::snapshot`]).
    pub fn display(&self) -> Display {
        self.rules.script_state().display()
    }

    /// The message that is shown, unless it stays until another comes, and how long it is shown yet, ms.
    pub(crate) fn message(&self) -> Option<(&[String], u64)> {
        let state = self.rules.script_state();
        let left = state.message.until?.checked_sub(state.now)?;
        (left > 0).then_some((&state.message.lines, left))
    }

    /// What the rules have decided about this moment.
    pub(crate) fn rules_state(&self) -> SimulationRules {
        let state = self.rules.script_state();
        let score = &state.score;
        SimulationRules {
            playing: score.playing,
            tilted: score.tilted,
            flippers_live: state.flippers,
            kickers_live: state.kickers,
            owed: state.owed,
            turn: (score.player, score.ball),
            balls: score.balls,
            is_last_turn: score.is_last_turn(),
            restarts: state.restarts,
        }
    }

    /// Puts a ball on the playfield, and says its id: no game does that, trials do.
    pub(crate) fn put_ball(&mut self, center: DVec2, velocity_m_s: DVec2) -> u32 {
        self.machine.put_ball(center, velocity_m_s, [0.0; 3])
    }

    /// Puts a ball in play to another place, at rest: no game does that, trials do.
    pub(crate) fn move_ball(&mut self, id: u32, center: DVec2) {
        self.machine.move_ball(id, center);
    }

    /// The steps that the rules have taken in the last tick.
    pub fn rule_steps(&self) -> u64 {
        self.rules.steps()
    }

    /// The steps that the rules owe.
    pub fn rule_debt(&self) -> u64 {
        self.rules.state().work().debt()
    }

    /// What the rules have complained about since the last call, one sentence each with file and line.
    pub fn complaints(&mut self) -> Vec<String> {
        self.rules.take_complaints()
    }

    /// Of everything that can change what happens next.
    pub fn hashes(&self) -> Hashes {
        let machine = self.machine.hashes();
        let mut rules = Fingerprint::default();
        rules.add(&(self.tick, self.buttons));
        self.rules.state().add_to(&mut rules);
        Hashes {
            balls: machine.balls,
            mechanisms: machine.mechanisms,
            rules: rules.finish(),
            lamps: fingerprint(&self.lamps),
        }
    }

    /// All of [`Simulation::hashes`] in one.
    pub fn hash(&self) -> u64 {
        let hashes = self.hashes();
        fingerprint(&[hashes.balls, hashes.mechanisms, hashes.rules, hashes.lamps])
    }

    /// Everything that can change what happens next, and what its pictures depend on.
    pub fn save(&self) -> Vec<u8> {
        save::write(&Saved {
            version: SIMULATION_VERSION,
            table: self.table.hash,
            tick: self.tick,
            buttons: self.buttons,
            machine: self.machine.save(),
            rules: Cow::Borrowed(self.rules.state()),
            lamps: Cow::Borrowed(&self.lamps),
            adaptation: self.adaptation,
        })
    }

    /// The simulation that [`Simulation::save`] wrote, on the same table.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this table.
    pub fn restore(table: Arc<Table>, bytes: &[u8]) -> Result<Simulation, Failure> {
        // The seed does not matter: it is in the bytes, in what the rules remember.
        Simulation::new(table, 0)?.restored(bytes)
    }

    /// As [`Simulation::restore`], on this one's table: much faster, because what follows from the table alone is shared:
    /// the compiled rules, the machine's model, how much light each lamp gives. All else comes from the bytes.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this table.
    pub fn restored(&self, bytes: &[u8]) -> Result<Simulation, Failure> {
        let saved = save::read(bytes, &self.table)?;
        Ok(Simulation {
            table: self.table.clone(),
            machine: self.machine.restored(&saved.machine).map_err(|error| refused(&self.table, &error))?,
            rules: Rules::restored(self.rules.program().clone(), saved.rules.into_owned()),
            lamps: saved.lamps.into_owned(),
            adaptation: saved.adaptation,
            brightness: self.brightness.clone(),
            tick_events: Vec::new(),
            tick: saved.tick,
            buttons: saved.buttons,
        })
    }
}

/// The buttons as the machine knows them; START is for the rules alone.
pub(crate) fn controls(buttons: Buttons) -> Controls {
    Controls {
        left: buttons.contains(Buttons::LEFT),
        right: buttons.contains(Buttons::RIGHT),
        plunger: buttons.contains(Buttons::PLUNGER),
        nudge_left: buttons.contains(Buttons::NUDGE_LEFT),
        nudge_right: buttons.contains(Buttons::NUDGE_RIGHT),
        nudge_up: buttons.contains(Buttons::NUDGE_UP),
        nudge_down: buttons.contains(Buttons::NUDGE_DOWN),
    }
}

/// The machine's complaint as a sentence about the table's files.
pub(crate) fn refused(table: &Table, error: &physics::Error) -> Failure {
    match error {
        physics::Error::Layout(part, what) => {
            let part = usize::from(part.0);
            let name = table.layout.parts.get(part).map_or("", |part| part.name.as_str());
            let line = table.part_lines.get(part).map_or_else(String::new, |line| format!(":{line}"));
            let file = table.file(FILES[0]);
            Failure::new(format!("{file}{line}: the part \"{name}\" cannot be played: {what}"))
        }
        physics::Error::Save(what) => Failure::new(format!("the saved game cannot be read: {what}")),
    }
}
