//! A live game: a machine in play, who plays it, and what is written down of it.

use super::contact_trail::ContactTrail;
use super::game_recordings::GameRecordings;
use super::last_ball::{LastBall, Rerun};
use crate::bot::Bot;
use crate::hud::{Badge, TrailContact};
use crate::{Buttons, Failure, Simulation, Snapshot, Table, tell};
use pinball::timeline::{TickSource, Timeline};
use std::path::Path;
use std::sync::Arc;

/// Auto start: the start button is pressed after this many ticks, and held for as many.
const AUTO_START_TICKS: u64 = 300;

/// A game in play.
pub struct LiveGame {
    seed: u64,
    play: RecordedPlay,
    /// The last ball, while it is watched instead of the game.
    rerun: Option<Rerun>,
    timeline: Timeline,
    contact_trail: ContactTrail,
}

/// A game that somebody plays, each tick of it recorded.
struct RecordedPlay {
    simulation: Simulation,
    /// Plays instead of the player.
    bot: Option<Bot>,
    /// What the player holds down.
    held: Buttons,
    last_ball: LastBall,
    recordings: GameRecordings,
    complaints: Vec<String>,
}

impl LiveGame {
    /// Switches the machine on, and records what is played: in the player's own folder, and in the file `record`.
    ///
    /// # Errors
    /// If the rules do not run, or the recording that was asked for cannot be written.
    pub fn new(table: Arc<Table>, seed: u64, record: Option<&Path>, bot: bool) -> Result<LiveGame, Failure> {
        let mut game = LiveGame::unrecorded(table, seed, bot)?;
        let RecordedPlay { simulation, complaints, .. } = &mut game.play;
        game.play.recordings = GameRecordings::begin(simulation, seed, record, complaints)?;
        Ok(game)
    }

    /// Switches the machine on, and records nothing.
    ///
    /// # Errors
    /// If the rules do not run.
    pub fn unrecorded(table: Arc<Table>, seed: u64, bot: bool) -> Result<LiveGame, Failure> {
        let simulation = Simulation::new(table, seed)?;
        Ok(LiveGame {
            seed,
            rerun: None,
            timeline: Timeline::new(&simulation),
            contact_trail: ContactTrail::default(),
            play: RecordedPlay {
                bot: bot.then(|| Bot::new(seed)),
                held: Buttons::NONE,
                last_ball: LastBall::new(&simulation),
                recordings: GameRecordings::default(),
                complaints: Vec::new(),
                simulation,
            },
        })
    }

    /// Plays some ticks with these buttons down.
    pub fn play(&mut self, ticks: u64, buttons: Buttons) {
        let LiveGame { play, rerun, timeline, contact_trail, .. } = self;
        let after_tick = |game: &Simulation| contact_trail.add(game.ticks(), game.tick_events());
        if let Some(rerun) = rerun {
            timeline.play(rerun, ticks, after_tick);
            return;
        }
        play.held = buttons;
        if timeline.play(play, ticks, after_tick) > 0 {
            play.look(timeline.current());
        }
    }

    /// The snapshots of the last two ticks.
    pub fn snapshots(&self) -> (&Arc<Snapshot>, &Arc<Snapshot>) {
        self.timeline.snapshots()
    }

    /// Whether a game is on, so that a ball can be shot.
    pub fn is_on(&self) -> bool {
        self.timeline.current().display.playing
    }

    /// Who is at the machine, if not the player.
    pub fn badge(&self) -> Option<Badge> {
        match (&self.rerun, &self.play.bot) {
            (Some(_), _) => Some(Badge::Replay),
            (None, Some(_)) => Some(Badge::Bot),
            (None, None) => None,
        }
    }

    /// The contact trail, as it is shown now.
    pub fn contact_trail(&self) -> Vec<TrailContact> {
        self.contact_trail.shown(self.timeline.current().tick)
    }

    /// What went wrong since the last call.
    pub fn complaints(&mut self) -> Vec<String> {
        std::mem::take(&mut self.play.complaints)
    }

    /// What stands in the window for as long as it is so: why a recording lacks something of the game.
    pub fn notice(&self) -> Option<String> {
        self.play.recordings.behind().map(ToString::to_string)
    }

    /// Shows the last ball again; `false` if there has been none.
    pub fn watch_last_ball(&mut self) -> bool {
        self.rerun = self.play.last_ball.rerun();
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
        self.timeline.reset_to(&self.play.simulation);
    }

    /// Whether the player asked for a recording: its table must stay as it is.
    pub fn is_bound_to_table(&self) -> bool {
        self.play.recordings.is_asked_for()
    }

    /// Goes on with another version of the table: with the same game if only the picture changed, else from the start.
    ///
    /// # Errors
    /// If its rules do not run; the game then goes on as it was.
    pub fn set_table(&mut self, table: Arc<Table>) -> Result<(), Failure> {
        let simulation = &mut self.play.simulation;
        if table.hash == simulation.table().hash {
            *simulation = Simulation::restore(table, &simulation.save())?;
            return Ok(());
        }
        let game = LiveGame::new(table, self.seed, None, self.play.bot.is_some())?;
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
        self.play.recordings.finish(&self.play.simulation)
    }
}

impl RecordedPlay {
    /// What the player holds down, and the start button as the machine warms up: the first game starts by itself.
    fn auto_start(&self) -> Buttons {
        let pressed = (AUTO_START_TICKS..2 * AUTO_START_TICKS).contains(&self.simulation.ticks());
        if pressed { self.held.with(Buttons::START, true) } else { self.held }
    }

    /// Looks at what has been played: whether another ball is in play, and what the rules complained about.
    fn look(&mut self, current: &Snapshot) {
        self.last_ball.look(&self.simulation, &current.display);
        for complaint in self.simulation.complaints() {
            tell(&Failure::new(&complaint));
            self.complaints.push(complaint);
        }
    }
}

impl TickSource for RecordedPlay {
    fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    fn step(&mut self) -> bool {
        let buttons = match &mut self.bot {
            Some(bot) => bot.buttons(&self.simulation),
            None => self.auto_start(),
        };
        self.simulation.tick(buttons);
        self.last_ball.push(buttons);
        // The opening presses start by itself: a window that is only looked at is not played.
        let played = self.bot.is_some() || self.held != Buttons::NONE;
        self.recordings.record(&self.simulation, buttons, played, &mut self.complaints);
        true
    }
}
