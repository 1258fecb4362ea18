//! Records a simulation as it is played.

use super::{Header, Writer, best_score};
use crate::{Buttons, Failure, Simulation};
use std::fs::File;
use std::io::{Seek, Write};
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
    /// If the file cannot be created.
    pub fn create(path: &Path, simulation: &Simulation, seed: u64) -> Result<Recorder<File>, Failure> {
        let file = File::create(path)
            .map_err(|error| Failure::new(format!("cannot create the recording {}: {error}", path.display())))?;
        Recorder::new(file, path, simulation, seed)
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
    Failure::new(format!("cannot write the recording {}: {error}; the game is not recorded", path.display()))
}
