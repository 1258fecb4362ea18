//! Recorded games: what was pressed, tick by tick, and what it must lead to.
//!
//! A `.caustic` file holds how the simulation was started, all of the table that decides the game, every change of the
//! [`Buttons`], a short hash of each part of the state every [`CHECKPOINT_TICKS`] ticks and, when the game ended well, the
//! final score and hashes. It is written as it is played, a chunk a second, so that a killed process leaves all but the
//! last second. `docs/recording_format.md` says what each byte means, in this format and in the one before it.
//!
//! The format refuses to know what a button does or what a score means.

mod damage;
mod format;
mod header;
mod packed_text;
mod reader;
mod recorder;
mod replay;
mod salvage;
mod writer;

pub use damage::Damage;
pub use format::{CHECKPOINT_TICKS, FLUSH_TICKS, FORMAT_VERSION};
pub use header::Header;
pub use recorder::Recorder;
pub use replay::{Difference, Replay};
pub use writer::Writer;

use crate::simulation::Hashes;
use crate::table::EmbeddedTable;
use crate::{Buttons, Failure, Simulation, Table};
use std::sync::Arc;

/// A recorded game, read and found undamaged.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// What the simulation was started with.
    pub header: Header,
    /// The table that it carries; `None` in format 1, which names its table only.
    pub table: Option<EmbeddedTable>,
    /// What the recorded states must be, one for each [`CHECKPOINT_TICKS`] ticks, in order.
    pub checkpoints: Vec<Checkpoint>,
    /// What the game ended with; `None` when the recording was never finished (the process was killed).
    pub end: Option<End>,
    changes: Vec<Change>,
    ticks: u64,
}

/// The hashes of [`Hashes`], 16 bits of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checkpoint {
    /// The number of ticks that had been played.
    pub tick: u64,
    /// Balls, mechanisms, rules, lamps.
    pub hashes: [u16; 4],
}

/// What a finished recording ended with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct End {
    /// The number of ticks that had been played.
    pub tick: u64,
    /// The best score of the players.
    pub score: i64,
    /// The parts of the state.
    pub hashes: Hashes,
    /// All of the state: [`Simulation::hash`].
    pub hash: u64,
}

/// From `tick` on, `buttons` were down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Change {
    tick: u64,
    buttons: Buttons,
}

impl Recording {
    /// The recording that `bytes` hold.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn parse(bytes: &[u8]) -> Result<Recording, Damage> {
        reader::parse(bytes)
    }

    /// The table that it carries, without its art; `None` in format 1.
    ///
    /// # Errors
    /// If the table cannot be read.
    pub fn embedded_table(&self) -> Result<Option<Table>, Failure> {
        self.table.as_ref().map(|table| table.table(&self.header.table)).transpose()
    }

    /// How many ticks were played.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// What was down in the tick that `tick` ticks came before; nothing after the end.
    pub fn buttons(&self, tick: u64) -> Buttons {
        if tick >= self.ticks {
            return Buttons::NONE;
        }
        // Where the changes after `tick` begin.
        let later = self.changes.partition_point(|change| change.tick <= tick);
        later.checked_sub(1).map_or(Buttons::NONE, |index| self.changes[index].buttons)
    }

    /// What was down in each tick, from the first to the last.
    pub fn inputs(&self) -> impl Iterator<Item = Buttons> + '_ {
        let mut changes = self.changes.iter().peekable();
        let mut down = Buttons::NONE;
        (0..self.ticks).map(move |tick| {
            while let Some(change) = changes.next_if(|change| change.tick <= tick) {
                down = change.buttons;
            }
            down
        })
    }

    /// The simulation as it was when the recording began, on the table that it was played on.
    ///
    /// # Errors
    /// If this program plays another game from the same inputs, if the table is another or has changed since, or if its
    /// rules do not run.
    pub fn start(&self, table: Arc<Table>) -> Result<Simulation, Failure> {
        self.header.check_version()?;
        self.header.check_table(&table)?;
        Simulation::new(table, self.header.seed)
    }
}

impl Checkpoint {
    /// The checkpoint of a state.
    pub fn of(tick: u64, hashes: Hashes) -> Checkpoint {
        let Hashes { balls, mechanisms, rules, lamps } = hashes;
        Checkpoint { tick, hashes: [balls, mechanisms, rules, lamps].map(|hash| hash as u16) }
    }
}

/// The best score of the players.
pub fn best_score(simulation: &Simulation) -> i64 {
    simulation.display().scores.into_iter().max().unwrap_or(0)
}

/// How many bytes every recording of a game on `table` takes before its first tick: they are for the table.
pub fn table_bytes(table: &Table) -> usize {
    let start = Writer::new(std::io::Cursor::new(Vec::new()), &Header::new(table, 0), &EmbeddedTable::of(table));
    start.map_or(0, |writer| writer.bytes() as usize)
}
