//! A simulation as bytes: what it is saved to, and what its hashes are taken of.

use super::SIMULATION_VERSION;
use crate::lamps::{ExposureAdaptation, LampController};
use crate::rules::State;
use crate::{Buttons, Failure, Table};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use xxhash_rust::xxh3::xxh3_64;

/// Bytes of the checksum at the end.
const CHECKSUM: usize = 8;

/// Everything of a simulation that can change what happens next, and what its pictures depend on.
#[derive(Serialize, Deserialize)]
pub struct Saved<'a> {
    /// [`SIMULATION_VERSION`].
    pub version: u32,
    /// The table's hash.
    pub table: u64,
    /// Ticks since the machine was switched on.
    pub tick: u64,
    /// The buttons of the last tick.
    pub buttons: Buttons,
    /// What the machine saved.
    pub machine: Vec<u8>,
    /// The rules.
    pub rules: Cow<'a, State>,
    /// The lamps.
    pub lamps: Cow<'a, LampController>,
    /// The light that somebody has got used to.
    pub adaptation: ExposureAdaptation,
}

/// The bytes of a simulation, a checksum at their end.
pub fn write(saved: &Saved) -> Vec<u8> {
    let mut bytes = encode(saved);
    bytes.extend(xxh3_64(&bytes).to_le_bytes());
    bytes
}

/// What [`write`] wrote for this table.
///
/// # Errors
/// If a byte is missing or damaged, or the bytes are another version's or another table's.
pub fn read(bytes: &[u8], table: &Table) -> Result<Saved<'static>, Failure> {
    let damaged = || Failure::new("the saved game is damaged");
    let (body, checksum) = bytes.split_last_chunk::<CHECKSUM>().ok_or_else(damaged)?;
    if xxh3_64(body).to_le_bytes() != *checksum {
        return Err(damaged());
    }
    let saved: Saved = postcard::from_bytes(body).map_err(|_| damaged())?;
    if saved.version != SIMULATION_VERSION {
        return Err(Failure::new(format!(
            "the saved game is of simulation version {}; this program has version {SIMULATION_VERSION}",
            saved.version
        )));
    }
    if saved.table != table.hash || saved.lamps.len() != table.lamps.len() {
        return Err(Failure::new(format!("the saved game was played on another table than {}", table.name)));
    }
    Ok(saved)
}

fn encode(value: &impl Serialize) -> Vec<u8> {
    // Into memory, of types that postcard knows: it has no way to fail.
    postcard::to_stdvec(value).unwrap_or_default()
}
