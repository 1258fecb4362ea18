//! Recordings of Spectrum played again where there is no operating system: `.ci/wasm` builds this library for
//! WebAssembly, hands it the demos, and compares the digest with this machine's.
//!
//! The caller asks for room with [`recording`], writes the bytes there, and calls [`play`]; [`digest`] is of all
//! recordings played so far.

use pinball::recording::Replay;
use pinball::simulation::Digest;
use pinball::table::TableSources;
use pinball::{Failure, Recording, Table};
use std::sync::{Arc, Mutex, PoisonError};

static BYTES: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static GAMES: Mutex<Vec<(u64, Digest)>> = Mutex::new(Vec::new());

/// Room for a recording of `length` bytes.
#[unsafe(no_mangle)]
pub extern "C" fn recording(length: usize) -> *mut u8 {
    let mut bytes = BYTES.lock().unwrap_or_else(PoisonError::into_inner);
    *bytes = vec![0; length];
    bytes.as_mut_ptr()
}

/// Plays the recording to its end: the number of ticks, or -1 if it cannot be played or differs from what was recorded.
#[unsafe(no_mangle)]
pub extern "C" fn play() -> i64 {
    let bytes = BYTES.lock().unwrap_or_else(PoisonError::into_inner);
    let Ok(mut replay) = replay(&bytes) else { return -1 };
    let mut digest = Digest::default();
    while replay.step() {
        digest.add(replay.simulation().hash());
    }
    if replay.difference().is_some() {
        return -1;
    }
    GAMES.lock().unwrap_or_else(PoisonError::into_inner).push((replay.recording().header.seed, digest));
    digest.ticks().cast_signed()
}

/// What `caustic verify --digest` prints for the same recordings.
#[unsafe(no_mangle)]
pub extern "C" fn digest() -> u64 {
    Digest::of_seeds(&GAMES.lock().unwrap_or_else(PoisonError::into_inner)).value()
}

fn replay(bytes: &[u8]) -> Result<Replay, Failure> {
    let recording = Recording::parse(bytes).map_err(|damage| Failure::new(damage.to_string()))?;
    Replay::new(recording, Arc::new(Table::parse(spectrum()).map_err(Failure::of_many)?))
}

fn spectrum() -> TableSources {
    let files = [
        include_str!("../../../assets/tables/spectrum/table.svg"),
        include_str!("../../../assets/tables/spectrum/table.toml"),
        include_str!("../../../assets/tables/spectrum/rules.rhai"),
    ];
    TableSources {
        name: "spectrum".to_string(),
        origin: "spectrum".to_string(),
        folder: String::new(),
        files: files.map(|text| Ok(text.as_bytes().to_vec())),
    }
}
