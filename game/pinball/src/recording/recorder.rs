//! Records a simulation as it is played.

use super::{Header, Writer, best_score};
use crate::{Buttons, Simulation};
use std::io::{self, Seek, Write};

/// A recording of a simulation in play: call [`Recorder::record`] after every tick.
pub struct Recorder<W> {
    writer: Writer<W>,
    started: bool,
}

impl<W: Write + Seek> Recorder<W> {
    /// Begins to record into `out` a simulation that was just started with `seed`.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn new(out: W, simulation: &Simulation, seed: u64) -> io::Result<Recorder<W>> {
        let writer = Writer::new(out, &Header::new(simulation.table(), seed))?;
        Ok(Recorder { writer, started: false })
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
    /// If `out` cannot be written; give up recording then, not the game.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons) -> io::Result<()> {
        self.started |= buttons.contains(Buttons::START);
        self.writer.record(buttons, || simulation.hashes())
    }

    /// Writes the end of the recording and gives `out` back.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(self, simulation: &Simulation) -> io::Result<W> {
        self.writer.finish(best_score(simulation), simulation.hashes(), simulation.hash())
    }
}
