//! A game that is being played: the simulation, who plays it, and what is written down of it.

use super::contact_trail::ContactTrail;
use super::last_ball::{LastBall, Rerun};
use crate::bot::Bot;
use crate::hud::{Badge, TrailContact};
use crate::storage::library;
use crate::storage::recordings::RecordingFile;
use crate::{Buttons, Failure, Simulation, Snapshot, Table, tell};
use std::path::Path;
use std::sync::Arc;
use std::time::SystemTime;

/// The start button is pressed for a newcomer after this many ticks, and held for as many.
const OPENING_TICKS: u64 = 300;

/// A game in play.
pub struct LiveGame {
    simulation: Simulation,
    seed: u64,
    previous: Arc<Snapshot>,
    current: Arc<Snapshot>,
    bot: Option<Bot>,
    /// In the player's own folder.
    library: Option<RecordingFile>,
    /// In the file that was asked for.
    asked: Option<RecordingFile>,
    /// Why that one was given up: told when the window is closed.
    broken_off: Option<Failure>,
    last_ball: LastBall,
    rerun: Option<Rerun>,
    contact_trail: ContactTrail,
    complaints: Vec<String>,
}

impl LiveGame {
    /// Switches the machine on.
    ///
    /// # Errors
    /// If the rules do not run, or the recording that was asked for cannot be written.
    pub fn new(table: Arc<Table>, seed: u64, record: Option<&Path>, bot: bool) -> Result<LiveGame, Failure> {
        let simulation = Simulation::new(table, seed)?;
        let asked = record.map(|path| RecordingFile::create(path, &simulation, seed)).transpose()?;
        let mut complaints = Vec::new();
        let library = begin_in_library(&simulation, seed, &mut complaints);
        let current = Arc::new(simulation.snapshot());
        Ok(LiveGame {
            last_ball: LastBall::new(&simulation),
            simulation,
            seed,
            previous: current.clone(),
            current,
            bot: bot.then(|| Bot::new(seed)),
            library,
            asked,
            broken_off: None,
            rerun: None,
            contact_trail: ContactTrail::default(),
            complaints,
        })
    }

    /// Plays some ticks with these buttons down.
    pub fn play(&mut self, ticks: u64, buttons: Buttons) {
        if ticks == 0 {
            return;
        }
        if let Some(rerun) = &mut self.rerun {
            (self.previous, self.current) = rerun.play(ticks, &mut self.contact_trail);
            return;
        }
        for tick in 0..ticks {
            if tick + 1 == ticks {
                self.previous = Arc::new(self.simulation.snapshot());
            }
            self.tick(buttons);
        }
        self.current = Arc::new(self.simulation.snapshot());
        self.last_ball.look(&self.simulation, &self.current.display);
        for complaint in self.simulation.complaints() {
            tell(&Failure::new(&complaint));
            self.complaints.push(complaint);
        }
    }

    fn tick(&mut self, buttons: Buttons) {
        let buttons = match &mut self.bot {
            Some(bot) => bot.buttons(&self.simulation),
            None => self.opening(buttons),
        };
        self.simulation.tick(buttons);
        self.contact_trail.add(self.simulation.ticks(), self.simulation.contacts());
        self.last_ball.push(buttons);
        if let Some(failure) = keep_recording(&mut self.library, &self.simulation, buttons) {
            tell(&failure);
            self.complaints.push(failure.to_string());
        }
        if let Some(failure) = keep_recording(&mut self.asked, &self.simulation, buttons) {
            self.complaints.push(failure.to_string());
            self.broken_off = Some(failure);
        }
    }

    /// A newcomer has a ball at once: the start button is pressed as the machine warms up, like any other button.
    fn opening(&self, buttons: Buttons) -> Buttons {
        let pressed = (OPENING_TICKS..2 * OPENING_TICKS).contains(&self.simulation.ticks());
        if pressed { buttons.with(Buttons::START, true) } else { buttons }
    }

    /// The last two ticks.
    pub fn snapshots(&self) -> (&Arc<Snapshot>, &Arc<Snapshot>) {
        (&self.previous, &self.current)
    }

    /// Whether a game is on, so that a ball can be shot.
    pub fn is_on(&self) -> bool {
        self.current.display.playing
    }

    /// Who is at the machine, if not the player.
    pub fn badge(&self) -> Option<Badge> {
        match (&self.rerun, &self.bot) {
            (Some(_), _) => Some(Badge::Replay),
            (None, Some(_)) => Some(Badge::Bot),
            (None, None) => None,
        }
    }

    /// The last impacts.
    pub fn contact_trail(&self) -> Vec<TrailContact> {
        self.contact_trail.shown(self.current.tick)
    }

    /// What went wrong since the last call.
    pub fn complaints(&mut self) -> Vec<String> {
        std::mem::take(&mut self.complaints)
    }

    /// Shows the last ball again; `false` if there has been none.
    pub fn watch_last_ball(&mut self) -> bool {
        self.rerun = self.last_ball.rerun();
        self.rerun.is_some()
    }

    /// Whether the last ball is being shown.
    pub fn is_watching(&self) -> bool {
        self.rerun.is_some()
    }

    /// Whether the last ball is being shown and has come to its end.
    pub fn has_watched(&self) -> bool {
        self.rerun.as_ref().is_some_and(Rerun::is_over)
    }

    /// Back from the last ball to the game.
    pub fn return_to_game(&mut self) {
        self.rerun = None;
        self.current = Arc::new(self.simulation.snapshot());
        self.previous = self.current.clone();
    }

    /// Whether the player asked for a recording: its table must stay as it is.
    pub fn is_bound_to_table(&self) -> bool {
        self.asked.is_some()
    }

    /// Goes on with another version of the table: with the same game if only the picture changed, else from the start.
    ///
    /// # Errors
    /// If its rules do not run; the game then goes on as it was.
    pub fn set_table(&mut self, table: Arc<Table>) -> Result<(), Failure> {
        if table.hash == self.simulation.table().hash {
            self.simulation = Simulation::restore(table, &self.simulation.save())?;
            return Ok(());
        }
        let game = LiveGame::new(table, self.seed, None, self.bot.is_some())?;
        // A game that must be recorded keeps its table; what is lost here is told and no more.
        self.finish().unwrap_or_else(|failure| tell(&failure));
        *self = game;
        Ok(())
    }

    /// Writes the end of the recordings; a game that never ran leaves none.
    ///
    /// # Errors
    /// If the recording that was asked for is not whole.
    pub fn finish(&mut self) -> Result<(), Failure> {
        if let Some(recorder) = self.library.take()
            && let Err(failure) = library::finish(recorder, &self.simulation)
        {
            tell(&failure);
        }
        match self.asked.take() {
            Some(recorder) if recorder.ticks() == 0 => recorder.discard(),
            Some(recorder) => recorder.finish(&self.simulation),
            None => self.broken_off.take().map_or(Ok(()), Err),
        }
    }
}

/// Records a tick; gives the recording up when that fails, and says why.
fn keep_recording(recorder: &mut Option<RecordingFile>, game: &Simulation, buttons: Buttons) -> Option<Failure> {
    let failure = recorder.as_mut()?.record(game, buttons).err()?;
    *recorder = None;
    Some(failure)
}

#[expect(clippy::disallowed_methods, reason = "a recording is named after the moment that it was made")]
fn begin_in_library(simulation: &Simulation, seed: u64, complaints: &mut Vec<String>) -> Option<RecordingFile> {
    let unix_s = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let recorder = library::record(simulation, seed, unix_s);
    recorder
        .inspect_err(|failure| {
            tell(failure);
            complaints.push(failure.to_string());
        })
        .ok()
}
