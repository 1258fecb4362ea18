//! Header: what a recorded simulation was started with.

use super::format::{Bytes, put_varint};
use crate::simulation::SIMULATION_VERSION;
use crate::{Failure, Table};

/// Everything that a simulation is started with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// The [`SIMULATION_VERSION`] of the program that played.
    pub simulation_version: u32,
    /// The table's name.
    pub table: String,
    /// The folder that the table lay in, when it is not one of the built-in ones; else empty.
    pub folder: String,
    /// [`Table::hash`].
    pub table_hash: u64,
    /// The seed of the game's random numbers.
    pub seed: u64,
}

impl Header {
    /// What `Simulation::new(table, seed)` starts with.
    pub fn new(table: &Table, seed: u64) -> Header {
        Header {
            simulation_version: SIMULATION_VERSION,
            table: table.name.clone(),
            folder: table.folder.clone(),
            table_hash: table.hash,
            seed,
        }
    }

    /// The payload of the chunk that a recording begins with.
    pub(super) fn payload(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        put_varint(&mut bytes, u64::from(self.simulation_version));
        bytes.extend(self.table_hash.to_le_bytes());
        bytes.extend(self.seed.to_le_bytes());
        for text in [&self.table, &self.folder] {
            put_varint(&mut bytes, text.len() as u64);
            bytes.extend(text.as_bytes());
        }
        bytes
    }

    /// What [`Header::payload`] wrote.
    pub(super) fn read(bytes: &mut Bytes) -> Option<Header> {
        let simulation_version = bytes.varint()?.try_into().ok()?;
        let (table_hash, seed) = (bytes.u64()?, bytes.u64()?);
        let [table, folder] = [text(bytes)?, text(bytes)?];
        Some(Header { simulation_version, table, folder, table_hash, seed })
    }

    /// What follows the seal in format 1.
    pub(super) fn read_format_1(bytes: &mut Bytes) -> Option<Header> {
        let simulation_version = u32::from_le_bytes(bytes.array()?);
        let (table_hash, seed) = (bytes.u64()?, bytes.u64()?);
        let name = bytes.byte()?;
        let table = String::from_utf8_lossy(bytes.take(usize::from(name))?).into_owned();
        let folder = bytes.u16()?;
        let folder = String::from_utf8_lossy(bytes.take(usize::from(folder))?).into_owned();
        Some(Header { simulation_version, table, folder, table_hash, seed })
    }

    /// Refuses the recording of another simulation version.
    ///
    /// # Errors
    /// If this program plays another game from the same inputs.
    pub fn check_version(&self) -> Result<(), Failure> {
        if self.simulation_version == SIMULATION_VERSION {
            return Ok(());
        }
        Err(Failure::new(format!(
            "it was recorded with simulation version {}, this is {SIMULATION_VERSION}: the same inputs would give \
             another game; play it with the program that recorded it",
            self.simulation_version
        )))
    }

    /// Refuses a table on which another game would be played.
    ///
    /// # Errors
    /// If `table` is not what it was when it was played on.
    pub fn check_table(&self, table: &Table) -> Result<(), Failure> {
        if self.table_hash == table.hash {
            return Ok(());
        }
        Err(Failure::new(format!(
            "it was played on another table: {} has changed since (its hash was \
             {:016x}, now it is {:016x}); it plays again with the table's files as they were",
            self.table, self.table_hash, table.hash
        )))
    }
}

fn text(bytes: &mut Bytes) -> Option<String> {
    let length = bytes.varint()?.try_into().ok()?;
    String::from_utf8(bytes.take(length)?.to_vec()).ok()
}
