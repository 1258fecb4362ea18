//! The recordings of a game in play: one in the player's own folder, and one in a file that was asked for.

use crate::storage::library::{self, LibraryRecording};
use crate::storage::recordings::RecordingFile;
use crate::{Buttons, Failure, Simulation, tell};
use std::path::Path;
use std::time::SystemTime;

/// What is written down of a game.
#[derive(Default)]
pub struct GameRecordings {
    /// In the player's own folder.
    library: Option<LibraryRecording>,
    /// In the file that was asked for.
    asked: Option<RecordingFile>,
    /// Why that one was given up: told when the game is ended.
    broken_off: Option<Failure>,
}

impl GameRecordings {
    /// Begins to record a game that was just started with `seed`, in the player's own folder and in the file `asked`.
    /// If the first is not possible, the game goes on and `complaints` says why.
    ///
    /// # Errors
    /// If the file that was asked for cannot be written.
    pub fn begin(
        simulation: &Simulation,
        seed: u64,
        asked: Option<&Path>,
        complaints: &mut Vec<String>,
    ) -> Result<GameRecordings, Failure> {
        let asked = asked.map(|path| RecordingFile::create(path, simulation, seed)).transpose()?;
        let library = begin_in_library(simulation, seed, complaints);
        Ok(GameRecordings { library, asked, broken_off: None })
    }

    /// Whether the player asked for a recording.
    pub fn is_asked_for(&self) -> bool {
        self.asked.is_some()
    }

    /// Records a tick, which somebody `played` or nobody did; gives a recording up when that fails, and says why.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons, played: bool, complaints: &mut Vec<String>) {
        if let Some(recording) = &mut self.library
            && let Err(failure) = recording.record(simulation, buttons, played)
        {
            self.library = None;
            tell(&failure);
            complaints.push(failure.to_string());
        }
        if let Some(recording) = &mut self.asked
            && let Err(failure) = recording.record(simulation, buttons)
        {
            self.asked = None;
            complaints.push(failure.to_string());
            self.broken_off = Some(failure);
        }
    }

    /// Writes the end of the recordings; a game that nobody played leaves none in the player's own folder.
    ///
    /// # Errors
    /// If the recording that was asked for is not whole.
    pub fn finish(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        if let Some(recording) = self.library.take()
            && let Err(failure) = recording.finish(simulation)
        {
            tell(&failure);
        }
        match self.asked.take() {
            Some(recording) if recording.ticks() == 0 => recording.discard(),
            Some(recording) => recording.finish(simulation),
            None => self.broken_off.take().map_or(Ok(()), Err),
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "a recording is named after the moment that it was begun")]
fn begin_in_library(simulation: &Simulation, seed: u64, complaints: &mut Vec<String>) -> Option<LibraryRecording> {
    let unix_s = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let folder =
        library::folder().ok_or_else(|| Failure::new("the game is not recorded: this system names no data folder"));
    let recording = folder.and_then(|folder| LibraryRecording::new(&folder, simulation, seed, unix_s));
    recording
        .inspect_err(|failure| {
            tell(failure);
            complaints.push(failure.to_string());
        })
        .ok()
}
