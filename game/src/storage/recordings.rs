//! Recordings as files: read, matched with their table, and written while a game is played.

use super::file_failure::file_failure;
use super::limited_read::{self, RECORDING_LIMIT_BYTES};
use super::{new_file, tables};
use crate::recording::{Header, Recorder, Recording, Replay};
use crate::{Buttons, Failure, Simulation, Table};
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Reads the recording in the file `path`.
///
/// # Errors
/// If the file cannot be read or is not an undamaged recording: one sentence that names the file and the damage.
pub fn read(path: &Path) -> Result<Recording, Failure> {
    let bytes = limited_read::read(path, RECORDING_LIMIT_BYTES)
        .map_err(|error| file_failure("read the recording", path, &error))?;
    Recording::parse(&bytes).map_err(|damage| Failure::new(damage.to_string()).in_file(path.display()))
}

/// The simulation as it was when the recording began.
///
/// # Errors
/// If the recording is of another simulation version or another table, or the table is not found.
pub fn start(recording: &Recording) -> Result<Simulation, Failure> {
    recording.start(find_table(&recording.header)?)
}

/// A replay that stands at the recording's beginning.
///
/// # Errors
/// As [`start`].
pub fn replay(recording: Recording) -> Result<Replay, Failure> {
    let table = find_table(&recording.header)?;
    Replay::new(recording, table)
}

/// A replay of the recording in the file `path`, at its beginning.
///
/// # Errors
/// As [`read`] and [`replay`]: one sentence that names the file.
pub fn open(path: &Path) -> Result<Replay, Failure> {
    replay(read(path)?).map_err(|failure| failure.in_file(path.display()))
}

/// The table that was played on, if it is still what it was.
fn find_table(header: &Header) -> Result<Arc<Table>, Failure> {
    header.check_version()?;
    let mut refusal = Failure::new("it does not say which table it was played on");
    for place in [&header.table, &header.folder].into_iter().filter(|place| !place.is_empty()) {
        match tables::load(place) {
            Ok(table) => match header.check_table(&table) {
                Ok(()) => return Ok(Arc::new(table)),
                Err(failure) => refusal = failure,
            },
            Err(failures) => {
                let first = failures.first().map(ToString::to_string).unwrap_or_default();
                refusal = Failure::new(format!("the table {place} that it was played on cannot be read: {first}"));
            }
        }
    }
    Err(refusal)
}

/// A recording file that is written while a game is played: call [`RecordingFile::record`] after every tick.
pub struct RecordingFile {
    recorder: Recorder<File>,
    path: PathBuf,
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
        RecordingFile::begin(file, path, simulation, seed)
    }

    /// Begins in a file that was just made, which is removed if nothing can be written.
    pub(super) fn begin(file: File, path: &Path, simulation: &Simulation, seed: u64) -> Result<RecordingFile, Failure> {
        match Recorder::new(file, simulation, seed) {
            Ok(recorder) => Ok(RecordingFile { recorder, path: path.to_path_buf() }),
            Err(error) => {
                // An empty file is no recording; if it cannot be removed either, the first error is the one to tell.
                let _ = fs::remove_file(path);
                Err(unwritable(path, &error))
            }
        }
    }

    /// The file that is written.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Ticks recorded so far.
    pub fn ticks(&self) -> u64 {
        self.recorder.ticks()
    }

    /// Whether anybody has pressed start since the recording began.
    pub fn started(&self) -> bool {
        self.recorder.started()
    }

    /// Records the tick that `simulation` has just played with `buttons`.
    ///
    /// # Errors
    /// If the file cannot be written; give up recording then, not the game.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons) -> Result<(), Failure> {
        self.recorder.record(simulation, buttons).map_err(|error| unwritable(&self.path, &error))
    }

    /// Writes the end of the recording.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self, simulation: &Simulation) -> Result<(), Failure> {
        let RecordingFile { recorder, path } = self;
        recorder.finish(simulation).map(|_| ()).map_err(|error| unwritable(&path, &error))
    }

    /// Removes the file: there was nothing to record.
    ///
    /// # Errors
    /// If it cannot be removed.
    pub fn discard(self) -> Result<(), Failure> {
        let RecordingFile { recorder, path } = self;
        drop(recorder);
        fs::remove_file(&path).map_err(|error| file_failure("remove", &path, &error))
    }
}

fn unwritable(path: &Path, error: &io::Error) -> Failure {
    file_failure("go on with the recording", path, error)
}
