//! The player's own folder: the last games that were played, recorded without being asked.

use super::file_failure::file_failure;
use super::recordings::RecordingFile;
use crate::{Failure, Simulation};
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// How many recordings are kept.
pub const KEPT: usize = 10;

/// The folder of the games that were played: `recordings` in the data folder that the platform gives to a program.
pub fn folder() -> Option<PathBuf> {
    directories::ProjectDirs::from("", "", "Caustic").map(|dirs| dirs.data_dir().join("recordings"))
}

/// Begins to record a simulation that was just started with `seed`, at `unix_s` seconds since 1970, in the player's
/// folder, and removes all but the last [`KEPT`] recordings there.
///
/// # Errors
/// If the folder or the file cannot be made: a sentence to warn with; the game itself can go on.
pub fn record(simulation: &Simulation, seed: u64, unix_s: u64) -> Result<RecordingFile, Failure> {
    let folder = folder().ok_or_else(|| Failure::new("the game is not recorded: this system names no data folder"))?;
    record_in(&folder, simulation, seed, unix_s)
}

/// As [`record`], in another folder.
///
/// # Errors
/// As [`record`].
pub fn record_in(folder: &Path, simulation: &Simulation, seed: u64, unix_s: u64) -> Result<RecordingFile, Failure> {
    let unrecorded = |failure: Failure| Failure::new(format!("the game is not recorded: {failure}"));
    fs::create_dir_all(folder).map_err(|error| unrecorded(file_failure("make the folder", folder, &error)))?;
    let moment = moment(unix_s);
    let table = &simulation.table().name;
    for number in 1..=u32::MAX {
        let name = if number == 1 { format!("{moment} {table}") } else { format!("{moment} {table} {number}") };
        let path = folder.join(name + ".caustic");
        match File::create_new(&path) {
            Ok(file) => {
                let recorder = RecordingFile::begin(file, &path, simulation, seed).map_err(unrecorded)?;
                // Only now is there a new one in the old one's place.
                remove_oldest(folder);
                return Ok(recorder);
            }
            Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(unrecorded(file_failure("make", &path, &error))),
        }
    }
    Err(Failure::new(format!("the game is not recorded: {} is full", folder.display())))
}

/// Ends a recording in the player's folder; removes it if nobody ever pressed start, so that it takes no game's place.
///
/// # Errors
/// If the file cannot be written or removed.
pub fn finish(recorder: RecordingFile, simulation: &Simulation) -> Result<(), Failure> {
    if recorder.started() { recorder.finish(simulation) } else { recorder.discard() }
}

/// The recordings in `folder`, the oldest first: their names begin with their moment.
pub fn recordings(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut found: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|end| end == "caustic")).collect();
    found.sort();
    found
}

fn remove_oldest(folder: &Path) {
    let found = recordings(folder);
    for path in &found[..found.len().saturating_sub(KEPT)] {
        // A file that cannot be removed now is removed the next time.
        let _ = fs::remove_file(path);
    }
}

/// Date and time (UTC) in the proleptic Gregorian calendar: `2026-11-22 00.45.10`.
pub fn moment(unix_s: u64) -> String {
    let (days, second) = (unix_s / 86_400, unix_s % 86_400);
    // Years begin in March here, so that the leap day is the last of its year; 719468 days lie between
    // 0000-03-01 and 1970-01-01, and 400 years always have 146097.
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let march_month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * march_month + 2) / 5 + 1;
    let month = if march_month < 10 { march_month + 3 } else { march_month - 9 };
    let year = era * 400 + year_of_era + u64::from(month <= 2);
    let (hour, minute) = (second / 3600, second / 60 % 60);
    format!("{year:04}-{month:02}-{day:02} {hour:02}.{minute:02}.{:02}", second % 60)
}

#[cfg(test)]
mod tests {
    use super::moment;

    #[test]
    fn moments_are_the_calendars() {
        assert_eq!(moment(0), "1970-01-01 00.00.00");
        assert_eq!(moment(951_827_696), "2000-02-29 12.34.56");
        assert_eq!(moment(1_795_308_310), "2026-11-22 00.45.10");
        assert_eq!(moment(4_107_542_399), "2100-02-28 23.59.59");
        assert_eq!(moment(4_107_542_400), "2100-03-01 00.00.00");
    }
}
