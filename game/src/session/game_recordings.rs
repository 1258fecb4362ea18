//! The recordings of a game in play: one in the player's own folder, and one in a file that was asked for.

use crate::storage::library::{self, LibraryRecording};
use crate::storage::recording_file::RecordingFile;
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
    /// Why one of them lacks something of what was played.
    behind: Option<Failure>,
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
        Ok(GameRecordings { library, asked, behind: None })
    }

    /// Whether the player asked for a recording.
    pub fn is_asked_for(&self) -> bool {
        self.asked.is_some()
    }

    /// Records a tick, which somebody `played` or nobody did. A recording that falls behind what is played, and one that has
    /// caught up with it, is told once.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons, played: bool, complaints: &mut Vec<String>) {
        if let Some(recording) = &mut self.library {
            recording.record(simulation, buttons, played);
        }
        if let Some(recording) = &mut self.asked {
            recording.record(simulation, buttons);
        }
        let asked = self.asked.as_ref().and_then(RecordingFile::behind);
        let behind = asked.or_else(|| self.library.as_ref().and_then(LibraryRecording::behind));
        let news = match (&self.behind, &behind) {
            (None, Some(failure)) => Some(failure.clone()),
            (Some(_), None) => Some(Failure::new("the recording goes on, and nothing of the game is missing in it")),
            _ => None,
        };
        if let Some(news) = news {
            tell(&news);
            complaints.push(news.to_string());
        }
        self.behind = behind;
    }

    /// Why a recording lacks something of what was played.
    pub fn behind(&self) -> Option<&Failure> {
        self.behind.as_ref()
    }

    /// Writes the end of the recordings; a game that nobody played leaves none in the player's own folder.
    ///
    /// # Errors
    /// If a recording is not whole.
    pub fn finish(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        let library = self.library.take().map_or(Ok(()), |recording| recording.finish(simulation));
        let asked = match self.asked.take() {
            Some(recording) if recording.ticks() == 0 => recording.discard(),
            Some(recording) => recording.finish(simulation),
            None => Ok(()),
        };
        let failures: Vec<Failure> = [asked, library].into_iter().filter_map(Result::err).collect();
        if failures.is_empty() { Ok(()) } else { Err(Failure::of_many(failures)) }
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
