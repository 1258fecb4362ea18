//! Records a simulation as it is played.

use super::{Header, Writer, best_score};
use crate::{Buttons, Failure, Simulation};
use std::fs::File;
use std::io::{ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};

/// A recording of a simulation in play: call [`Recorder::record`] after every tick.
pub struct Recorder<W> {
    writer: Writer<W>,
    /// The file's name, for what goes wrong.
    path: PathBuf,
    started: bool,
}

impl Recorder<File> {
    /// Begins to record, in the new file `path`, a simulation that was just started with `seed`.
    ///
    /// # Errors
    /// If there is already such a file, which stays as it is, or it cannot be created.
    pub fn create(path: &Path, simulation: &Simulation, seed: u64) -> Result<Recorder<File>, Failure> {
        let doing = "make the recording";
        if path.is_dir() {
            return Err(Failure::of_file(doing, path, &ErrorKind::IsADirectory.into()));
        }
        let file = File::create_new(path).map_err(|error| Failure::of_file(doing, path, &error))?;
        Recorder::begin(file, path, simulation, seed)
    }

    /// As [`Recorder::new`] in a file that was just made, which is removed if nothing can be written.
    pub(super) fn begin(
        file: File,
        path: &Path,
        simulation: &Simulation,
        seed: u64,
    ) -> Result<Recorder<File>, Failure> {
        Recorder::new(file, path, simulation, seed).inspect_err(|_| {
            // An empty file is no recording; if it cannot be removed either, the first error is the one to tell.
            let _ = std::fs::remove_file(path);
        })
    }

    /// Removes the file: there was nothing to record.
    ///
    /// # Errors
    /// If it cannot be removed.
    pub fn discard(self) -> Result<(), Failure> {
        let Recorder { writer, path, .. } = self;
        drop(writer);
        std::fs::remove_file(&path).map_err(|error| Failure::of_file("remove", &path, &error))
    }
}

impl<W: Write + Seek> Recorder<W> {
    /// Begins to record into `out`, which is called `path`, a simulation that was just started with `seed`.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn new(out: W, path: &Path, simulation: &Simulation, seed: u64) -> Result<Recorder<W>, Failure> {
        let path = path.to_path_buf();
        match Writer::new(out, &Header::new(simulation.table(), seed)) {
            Ok(writer) => Ok(Recorder { writer, path, started: false }),
            Err(error) => Err(unwritable(&path, &error)),
        }
    }

    /// The file that is written.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Ticks recorded so far.
    pub fn ticks(&self) -> u64 {
        self.writer.ticks()
    }

    /// Whether anybody has pressed start since the recording began.
    pub fn started(&self) -> bool {
        self.started
    }

    /// Records the tick that `simulation` has just played with `buttons`.
    ///
    /// # Errors
    /// If the file cannot be written; give up recording then, not the game.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons) -> Result<(), Failure> {
        self.started |= buttons.contains(Buttons::START);
        self.writer.record(buttons, || simulation.hashes()).map_err(|error| unwritable(&self.path, &error))
    }

    /// Writes the end of the recording and gives the file back.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self, simulation: &Simulation) -> Result<W, Failure> {
        let score = best_score(simulation);
        self.writer
            .finish(score, simulation.hashes(), simulation.hash())
            .map_err(|error| unwritable(&self.path, &error))
    }
}

fn unwritable(path: &Path, error: &std::io::Error) -> Failure {
    Failure::of_file("go on with the recording", path, error)
}
