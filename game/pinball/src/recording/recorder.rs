//! Records a simulation as it is played.

use super::{Header, Writer, best_score};
use crate::table::EmbeddedTable;
use crate::{Buttons, Simulation};
use std::io::{self, Seek, Write};

/// A recording of a simulation in play: call [`Recorder::record`] after every tick.
pub struct Recorder<W> {
    writer: Writer<W>,
}

impl<W: Write + Seek> Recorder<W> {
    /// Begins to record into `out` a simulation that was just started with `seed`.
    ///
    /// # Errors
    /// If it cannot be written, or the table is too large to be carried.
    pub fn new(out: W, simulation: &Simulation, seed: u64) -> io::Result<Recorder<W>> {
        let table = simulation.table();
        let writer = Writer::new(out, &Header::new(table, seed), &EmbeddedTable::of(table))?;
        Ok(Recorder { writer })
    }

    /// Ticks recorded so far.
    pub fn ticks(&self) -> u64 {
        self.writer.ticks()
    }

    /// Where it is written to.
    pub fn get_ref(&self) -> &W {
        self.writer.get_ref()
    }

    /// Where it is written to.
    pub fn get_mut(&mut self) -> &mut W {
        self.writer.get_mut()
    }

    /// Records the tick that `simulation` has just played with `buttons`.
    ///
    /// # Errors
    /// If `out` cannot be written; give up recording then, not the game.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons) -> io::Result<()> {
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
