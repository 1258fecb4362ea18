//! The player's own folder: the games that were played, recorded without being asked.

use super::file_failure::{file_failure, folder_failure};
use super::late_file::LateFile;
use super::recording_file::{unfinished, unwritable};
use super::retention::{self, KEPT_BYTES};
use crate::recording::{FLUSH_TICKS, Recorder};
use crate::{Buttons, Failure, Simulation, tell};
use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

pub use super::retention::recordings;

/// The folder of the games that were played: `recordings` in the data folder that the platform gives to a program.
pub fn folder() -> Option<PathBuf> {
    directories::ProjectDirs::from("", "", "Caustic").map(|dirs| dirs.data_dir().join("recordings"))
}

/// The recording of a game in the player's folder. There is no file until somebody plays, so that a window which nobody
/// plays leaves nothing and takes no game's place, however it ends.
pub struct LibraryRecording {
    recorder: Recorder<LateFile>,
    folder: PathBuf,
    /// When it began and on which table, as its name says it.
    label: String,
    /// The file, once there is one.
    path: Option<PathBuf>,
    /// Why there is none, though somebody has played.
    unmade: Option<Failure>,
}

impl LibraryRecording {
    /// Begins to record, in `folder`, a simulation that was just started with `seed`, at `unix_s` seconds since 1970.
    ///
    /// # Errors
    /// If the table is too large to be recorded: a sentence to warn with; the game itself can go on.
    pub fn new(folder: &Path, simulation: &Simulation, seed: u64, unix_s: u64) -> Result<LibraryRecording, Failure> {
        let label = format!("{} {}", moment(unix_s), simulation.table().name);
        let recorder = Recorder::new(LateFile::new(), simulation, seed)
            .map_err(|error| Failure::new(format!("the game is not recorded: {error}")))?;
        Ok(LibraryRecording { recorder, folder: folder.to_path_buf(), label, path: None, unmade: None })
    }

    /// Records the tick that `simulation` has just played with `buttons`. With the first tick that somebody `played`
    /// there is a file, and the oldest recordings that there is no room for any more are removed, which is told.
    pub fn record(&mut self, simulation: &Simulation, buttons: Buttons, played: bool) {
        let again = self.unmade.is_some() && self.recorder.ticks().is_multiple_of(FLUSH_TICKS);
        if self.path.is_none() && (again || played && self.unmade.is_none()) {
            self.unmade = self.make_file().err();
            for removed in self.path.iter().flat_map(|_| retention::prune(&self.folder, KEPT_BYTES)) {
                let why =
                    "removed, because the recordings in its folder took more than 50 MB; one that is renamed stays";
                tell(&Failure::new(why).in_file(removed.display()));
            }
        }
        // It is written to memory, which takes everything.
        self.recorder.record(simulation, buttons).unwrap_or_else(|error| self.unmade = Some(self.unwritable(&error)));
    }

    /// Why the file lacks something of what somebody played: it is tried again with every second of play.
    pub fn behind(&self) -> Option<Failure> {
        self.unmade.clone().or_else(|| self.recorder.get_ref().failure().map(|error| self.unwritable(error)))
    }

    /// Writes the end of the recording, if there is one.
    ///
    /// # Errors
    /// If somebody has played and the file cannot be written.
    pub fn finish(mut self, simulation: &Simulation) -> Result<(), Failure> {
        if self.unmade.is_some() {
            self.make_file()?;
        }
        let Some(path) = self.path else { return Ok(()) };
        self.recorder.finish(simulation).map(|_| ()).map_err(|error| unfinished(&path, &error))
    }

    fn make_file(&mut self) -> Result<(), Failure> {
        let unrecorded = |failure: Failure| Failure::new(format!("the game is not recorded: {failure}"));
        let folder = &self.folder;
        fs::create_dir_all(folder).map_err(|error| unrecorded(folder_failure(folder, &error)))?;
        let first = retention::next_number(folder);
        for number in first.. {
            let path = folder.join(format!("{number:06} {}.caustic", self.label));
            match File::create_new(&path) {
                Ok(file) => {
                    retention::hold_written(&file);
                    let kept = self.recorder.get_mut().keep_in(file).map_err(|error| unwritable(&path, &error));
                    match kept {
                        Ok(()) => self.path = Some(path),
                        // Half a beginning is no recording; if it cannot be removed either, the first error is told.
                        Err(_) => drop(fs::remove_file(&path)),
                    }
                    return kept;
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(unrecorded(file_failure("make", &path, &error))),
            }
        }
        Err(Failure::new(format!("the game is not recorded: {} is full", folder.display())))
    }

    fn unwritable(&self, error: &std::io::Error) -> Failure {
        unwritable(self.path.as_deref().unwrap_or(&self.folder), error)
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
    use super::*;
    use crate::Table;
    use crate::small_table;
    use crate::storage::tests::Scratch;
    use std::sync::Arc;

    fn simulation() -> Simulation {
        let table: Table = small_table::table("");
        Simulation::new(Arc::new(table), 7).unwrap()
    }

    fn play(recording: &mut LibraryRecording, simulation: &mut Simulation, ticks: u64, played: bool) {
        for _ in 0..ticks {
            simulation.tick(Buttons::NONE);
            recording.record(simulation, Buttons::NONE, played);
            assert!(recording.behind().is_none());
        }
    }

    /// Ten windows that nobody played and that ended by a signal had removed ten real games.
    #[test]
    fn a_window_that_nobody_plays_leaves_no_file_and_removes_none_however_it_ends() {
        let folder = Scratch::new("unplayed");
        let old = folder.path().join("2026-11-20 10.00.00 spectrum.caustic");
        File::create(&old).unwrap().set_len(2 * KEPT_BYTES).unwrap();
        let new = || LibraryRecording::new(folder.path(), &simulation(), 7, 0).unwrap();
        let (mut left, mut killed) = (new(), new());
        let mut simulation = simulation();
        play(&mut left, &mut simulation, 2500, false);
        left.finish(&simulation).unwrap();
        play(&mut killed, &mut simulation, 2500, false);
        drop(killed);
        assert_eq!(recordings(folder.path()), std::slice::from_ref(&old));
        let mut played = new();
        play(&mut played, &mut simulation, 1, true);
        let kept = recordings(folder.path());
        assert_eq!(
            kept,
            [folder.path().join("000001 1970-01-01 00.00.00 small.caustic")],
            "and the old one was too large"
        );
    }

    #[test]
    fn what_was_waited_before_the_first_key_is_in_the_recording_and_a_killed_one_is_whole() {
        let folder = Scratch::new("waited");
        let mut recording = LibraryRecording::new(folder.path(), &simulation(), 7, 0).unwrap();
        let mut simulation = simulation();
        play(&mut recording, &mut simulation, 1234, false);
        play(&mut recording, &mut simulation, 1, true);
        play(&mut recording, &mut simulation, 1000, false);
        let path = recordings(folder.path()).remove(0);
        let killed = crate::storage::recordings::read(&path).unwrap();
        assert_eq!((killed.ticks(), killed.end), (2000, None));
        recording.finish(&simulation).unwrap();
        let finished = crate::storage::recordings::read(&path).unwrap();
        assert_eq!((finished.ticks(), finished.end.unwrap().hash), (2235, simulation.hash()));
    }

    /// A game whose file could not be made at the first key was lost, though there was a place for it a moment later.
    #[test]
    fn a_file_that_cannot_be_made_is_made_when_it_can_and_the_game_is_whole() {
        let folder = Scratch::new("late");
        let place = folder.path().join("recordings");
        fs::write(&place, "a file where the folder is to be").unwrap();
        let mut recording = LibraryRecording::new(&place, &simulation(), 7, 0).unwrap();
        let mut simulation = simulation();
        let mut record = |recording: &mut LibraryRecording, ticks: u64| {
            for _ in 0..ticks {
                simulation.tick(Buttons::NONE);
                recording.record(&simulation, Buttons::NONE, true);
            }
            simulation.clone()
        };
        record(&mut recording, 1500);
        assert!(recording.behind().is_some_and(|why| why.to_string().starts_with("the game is not recorded: ")));
        fs::remove_file(&place).unwrap();
        let last = record(&mut recording, 1500);
        assert!(recording.behind().is_none());
        recording.finish(&last).unwrap();
        let kept = crate::storage::recordings::read(&recordings(&place)[0]).unwrap();
        assert_eq!((kept.ticks(), kept.end.unwrap().hash), (3000, last.hash()));
    }

    /// A link that led nowhere was "already one of that name".
    #[cfg(unix)]
    #[test]
    fn a_folder_that_is_a_link_to_nothing_is_told_as_such() {
        let folder = Scratch::new("links");
        for (name, target) in [("dangling", "nowhere"), ("loop", "loop")] {
            let place = folder.path().join(name);
            std::os::unix::fs::symlink(folder.path().join(target), &place).unwrap();
            let mut recording = LibraryRecording::new(&place, &simulation(), 7, 0).unwrap();
            let mut simulation = simulation();
            simulation.tick(Buttons::NONE);
            recording.record(&simulation, Buttons::NONE, true);
            let (told, place) = (recording.behind().unwrap().to_string(), place.display().to_string());
            let cause = format!("{place} is a link that leads nowhere; make the folder that it names, or remove it");
            assert_eq!(told, format!("the game is not recorded: cannot make the folder {place}: {cause}"));
        }
    }

    /// The program ended with 0 though the game was not kept.
    #[test]
    fn a_played_game_without_a_file_is_a_failure_at_the_end() {
        let folder = Scratch::new("never");
        let place = folder.path().join("recordings");
        fs::write(&place, "a file where the folder is to be").unwrap();
        let mut recording = LibraryRecording::new(&place, &simulation(), 7, 0).unwrap();
        let mut simulation = simulation();
        simulation.tick(Buttons::NONE);
        recording.record(&simulation, Buttons::NONE, true);
        assert!(recording.finish(&simulation).is_err());
    }

    #[test]
    fn moments_are_the_calendars() {
        assert_eq!(moment(0), "1970-01-01 00.00.00");
        assert_eq!(moment(951_827_696), "2000-02-29 12.34.56");
        assert_eq!(moment(1_795_308_310), "2026-11-22 00.45.10");
        assert_eq!(moment(4_107_542_399), "2100-02-28 23.59.59");
        assert_eq!(moment(4_107_542_400), "2100-03-01 00.00.00");
    }
}
