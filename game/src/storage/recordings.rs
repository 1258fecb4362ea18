//! Recordings as files: read, matched with their table, and salvaged.

use super::file_failure::file_failure;
use super::limited_read::{self, RECORDING_LIMIT_BYTES};
use super::retention::hold_shown;
use super::{new_file, table_search};
use crate::recording::{Damage, Recording, Replay};
use crate::{Failure, Simulation, Table, tell};
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::Path;
use std::sync::Arc;

/// Reads the recording in the file `path`.
///
/// # Errors
/// If the file cannot be read or is not an undamaged recording: one sentence that names the file and the damage.
pub fn read(path: &Path) -> Result<Recording, Failure> {
    let bytes = read_bytes(path)?;
    Recording::parse(&bytes).map_err(|damage| {
        let is_sound_in_part = || Recording::salvage(&bytes).is_some() || Recording::salvage_game(&bytes).is_some();
        let is_sound_in_part = !is_whole(&damage) && is_sound_in_part();
        let cure = if is_sound_in_part { "; `caustic verify --salvage OUT` keeps what is sound" } else { "" };
        Failure::new(format!("{damage}{cure}")).in_file(path.display())
    })
}

/// Whether the bytes are what a later program wrote.
fn is_whole(damage: &Damage) -> bool {
    matches!(damage, Damage::FormatVersion(_) | Damage::UnknownChunk(_))
}

fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    limited_read::read(path, RECORDING_LIMIT_BYTES).map_err(|error| file_failure("read the recording", path, &error))
}

/// A damaged recording in the file `path`, cut to its sound part and put into the new file `out`: what was wrong, and what
/// has been kept, as a sentence to warn with.
///
/// # Errors
/// If it is not damaged, if nothing of it is sound, or if a file cannot be read or written.
pub fn salvage(path: &Path, out: &Path) -> Result<Failure, Failure> {
    let bytes = read_bytes(path)?;
    let in_file = |what: String| Failure::new(what).in_file(path.display());
    let Err(damage) = Recording::parse(&bytes) else {
        return Err(in_file("it is not damaged, so there is nothing to salvage".to_string()));
    };
    if is_whole(&damage) {
        return Err(in_file(damage.to_string()));
    }
    let nothing = || in_file(format!("{damage}; no part of the game is sound"));
    let (sound, kept) = match Recording::salvage(&bytes) {
        Some(sound) => (sound, "the sound part is".to_string()),
        None => {
            let game = Recording::salvage_game(&bytes).ok_or_else(nothing)?;
            let all = game.ticks();
            let table = game_table(&game, Some(path)).map_err(|failure| failure.in_file(path.display()))?;
            let game = game.confirmed_by_play(table).map_err(|failure| failure.in_file(path.display()))?;
            let game = game.ok_or_else(nothing)?;
            let kept = format!(
                "how its table looks is lost, {} of the {all} ticks of its game came out again in play and are",
                game.ticks()
            );
            (game.to_bytes().map_err(|error| in_file(error.to_string()))?, kept)
        }
    };
    Recording::parse(&sound).map_err(|damage| in_file(damage.to_string()))?;
    let doing = "write the salvaged recording";
    if out.exists() {
        return Err(file_failure(doing, out, &ErrorKind::AlreadyExists.into()));
    }
    new_file::write(out, |file| file.write_all(&sound)).map_err(|error| file_failure(doing, out, &error))?;
    Ok(in_file(format!("{damage}; {kept} in {}", out.display())))
}

/// The simulation as it was when the recording began, on a table without art.
///
/// # Errors
/// If the recording is of another simulation version, or carries no table and the table is not found.
pub fn start(recording: &Recording) -> Result<Simulation, Failure> {
    recording.start(game_table(recording, None)?)
}

/// A replay that stands at the recording's beginning, on a table without art.
///
/// # Errors
/// As [`start`].
pub fn replay(recording: Recording) -> Result<Replay, Failure> {
    let table = game_table(&recording, None)?;
    Replay::new(recording, table)
}

/// A replay of the recording in the file `path`, at its beginning, on a table without art.
///
/// # Errors
/// As [`read`] and [`replay`]: one sentence that names the file.
pub fn open(path: &Path) -> Result<Replay, Failure> {
    let recording = read(path)?;
    let table = game_table(&recording, Some(path)).map_err(|failure| failure.in_file(path.display()))?;
    Replay::new(recording, table).map_err(|failure| failure.in_file(path.display()))
}

/// A recording that is shown.
pub struct ShownRecording {
    /// The replay, at its beginning.
    pub replay: Replay,
    /// What the picture says when the table's art is not found.
    pub missing_art: Option<String>,
    /// Keeps the recording from being removed while it is shown.
    _held: Option<File>,
}

/// The recording in the file `path` with its table's art; where that is not found, without it, which is told.
///
/// # Errors
/// As [`open`].
pub fn open_to_show(path: &Path) -> Result<ShownRecording, Failure> {
    let recording = read(path)?;
    let held = hold_shown(path);
    let in_file = |failure: Failure| failure.in_file(path.display());
    recording.header.check_version().map_err(in_file)?;
    let (table, missing) = match table_search::find(&recording.header, Some(path)) {
        Ok(table) => (table, None),
        Err(why) => match recording.embedded_table().map_err(in_file)? {
            Some(table) => (table, Some(why)),
            None => return Err(in_file(why)),
        },
    };
    let missing_art = missing.map(|why| {
        // A look that was damaged was left out when the game was salvaged.
        let (lost, was) = match recording.table.as_ref().is_some_and(|carried| carried.look.is_none()) {
            true => ("art and without its look, which is lost", "was not found, and its look is lost"),
            false => ("art", "was not found"),
        };
        tell(&in_file(Failure::new(format!("{why}: its game is shown without its {lost}"))));
        format!("The art of {} {was}: this is its game without it.", table.title)
    });
    let replay = Replay::new(recording, Arc::new(table)).map_err(in_file)?;
    Ok(ShownRecording { replay, missing_art, _held: held })
}

/// The table that a recording carries; in format 1 the one that it names.
fn game_table(recording: &Recording, path: Option<&Path>) -> Result<Arc<Table>, Failure> {
    recording.header.check_version()?;
    let table = recording.embedded_table()?.map_or_else(|| table_search::find(&recording.header, path), Ok)?;
    Ok(Arc::new(table))
}
