//! A recording file that somebody asked for: written while a game is played.

use super::file_failure::file_failure;
use super::late_file::LateFile;
use super::new_file;
use super::retention::hold_written;
use crate::recording::Recorder;
use crate::{Buttons, Failure, Simulation};
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// A recording file that is written while a game is played: call [`RecordingFile::record`] after every tick.
pub struct RecordingFile {
    recorder: Recorder<LateFile>,
    path: PathBuf,
    /// Why it cannot go on, whatever comes.
    broken: Option<Failure>,
}

impl RecordingFile {
    /// Begins to record, in the new file `path`, a simulation that was just started with `seed`.
    ///
    /// # Errors
    /// If there is already such a file, which stays as it is, or it cannot be created.
    pub fn create(path: &Path, simulation: &Simulation, seed: u64) -> Result<RecordingFile, Failure> {
        let doing = "make the recording";
        if path.is_dir() {
            return Err(file_failure(doing, path, &ErrorKind::IsADirectory.into()));
        }
        let file = new_file::make_parents(path).and_then(|()| File::create_new(path));
        let file = file.map_err(|error| file_failure(doing, path, &error))?;
        hold_written(&file);
        let begun = Recorder::new(LateFile::new(), simulation, seed).and_then(|mut recorder| {
            recorder.get_mut().keep_in(file)?;
            Ok(recorder)
        });
        match begun {
            Ok(recorder) => Ok(RecordingFile { recorder, path: path.to_path_buf(), broken: None }),
            Err(error) => {
                // An empty file is no recording; if it cannot be removed either, the first error is the one to tell.
                let _ = fs::remove_file(path);
                Err(unwritable(path, &error))
            }
        }
    }

    /// Ticks recorded so far.
    pub fn ticks(&self) -> u64 {
        self.recorder.ticks()
    }

    /// Records the tick that `simulation` has just played with `buttons`.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons) {
        let recorded = self.recorder.record(simulation, buttons);
        // It is written to memory, which takes everything.
        recorded.unwrap_or_else(|error| self.broken = Some(unwritable(&self.path, &error)));
    }

    /// Why the file lacks something of the game: it is tried again with every second of play.
    pub fn behind(&self) -> Option<Failure> {
        let failure = || self.recorder.get_ref().failure().map(|error| unwritable(&self.path, error));
        self.broken.clone().or_else(failure)
    }

    /// Writes the end of the recording.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self, simulation: &Simulation) -> Result<(), Failure> {
        let RecordingFile { recorder, path, broken } = self;
        let finished = recorder.finish(simulation).map(|_| ()).map_err(|error| unfinished(&path, &error));
        broken.map_or(finished, Err)
    }

    /// Removes the file: there was nothing to record.
    ///
    /// # Errors
    /// If it cannot be removed.
    pub fn discard(self) -> Result<(), Failure> {
        let RecordingFile { recorder, path, .. } = self;
        drop(recorder);
        fs::remove_file(&path).map_err(|error| file_failure("remove", &path, &error))
    }
}

/// What to say when a recording that was begun cannot be written on.
pub(super) fn unwritable(path: &Path, error: &io::Error) -> Failure {
    file_failure("go on with the recording", path, error)
}

/// What to say when a recording is not whole at the end.
pub(super) fn unfinished(path: &Path, error: &io::Error) -> Failure {
    file_failure("finish the recording", path, error)
}
