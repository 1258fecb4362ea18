//! Retention: which recordings of the player's folder are kept, and in which order they were played.
//!
//! The order is a number that each name begins with, counted up from game to game. A clock may go back, a number does not.
//! Recordings of before there were numbers begin with their moment; they come first, by it. A file with any other name is
//! not the folder's own: somebody named it, so it is neither counted nor ever removed.

use super::limited_read;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// How much the folder's own recordings may take, bytes.
pub const KEPT_BYTES: u64 = 50_000_000;

/// The last number that is counted to; a name with a larger one is not the folder's own.
const LAST_NUMBER: u64 = 999_999_999;

/// When a recording was played: its number, 0 if it has none, and then its name.
pub(super) type PlayOrder = (u64, String);

/// When the recording in the file `path` was played; `None` if its name is not the folder's own.
pub(super) fn play_order(path: &Path) -> Option<PlayOrder> {
    let name = path.file_stem()?.to_str()?;
    if begins_with_moment(name) {
        return Some((0, name.to_string()));
    }
    let (number, rest) = name.split_once(' ')?;
    let is_number = number.bytes().all(|byte| byte.is_ascii_digit());
    let is_own = |number: &u64| is_number && *number <= LAST_NUMBER && begins_with_moment(rest);
    let number = number.parse().ok().filter(is_own)?;
    Some((number, rest.to_string()))
}

/// The number of the next game in `folder`; after the last number there is that one again, and the moments tell the order.
pub(super) fn next_number(folder: &Path) -> u64 {
    let last = recordings(folder).iter().filter_map(|path| play_order(path)).map(|(number, _)| number).max();
    (last.unwrap_or(0) + 1).min(LAST_NUMBER)
}

/// The recordings in `folder` in the order in which they were played, after those that have names of their own.
pub fn recordings(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut found: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|end| end == "caustic")).collect();
    found.sort_by_cached_key(|path| (play_order(path), path.clone()));
    found
}

/// Removes the recordings that were played first, until all together take at most `limit` bytes, and returns what is no
/// more. The last one stays however large it is, and so does one that a program writes or shows.
pub(super) fn prune(folder: &Path, limit: u64) -> Vec<PathBuf> {
    let own: Vec<PathBuf> = recordings(folder).into_iter().filter(|path| play_order(path).is_some()).collect();
    let size = |path: &PathBuf| fs::metadata(path).map_or(0, |metadata| metadata.len());
    let mut total: u64 = own.iter().map(size).sum();
    let mut removed = Vec::new();
    let Some((_, older)) = own.split_last() else { return removed };
    for path in older {
        if total <= limit {
            break;
        }
        let bytes = size(path);
        // A file that cannot be removed now is removed the next time.
        if !is_in_use(path) && fs::remove_file(path).is_ok() {
            total -= bytes;
            removed.push(path.clone());
        }
    }
    removed
}

/// Whether `text` begins with a date and a time of day, as `2026-11-22 00.45.10`.
fn begins_with_moment(text: &str) -> bool {
    let form = "0000-00-00 00.00.00";
    let fits = |(byte, form): (u8, u8)| if form == b'0' { byte.is_ascii_digit() } else { byte == form };
    text.len() >= form.len() && text.bytes().zip(form.bytes()).all(fits)
}

/// Holds a recording that is written, so that no other program removes it, for as long as the file is open.
pub(super) fn hold_written(file: &File) {
    if HOLDS {
        // Whoever holds it already protects it as well; a file system without locks protects nothing.
        let _ = file.try_lock();
    }
}

/// Holds the recording in the file `path` while it is shown: as long as what is returned is open.
pub(super) fn hold_shown(path: &Path) -> Option<File> {
    let file = limited_read::open(path).ok().filter(|_| HOLDS)?;
    // One that is being written is held by its writer.
    let _ = file.try_lock_shared();
    Some(file)
}

/// Locks keep others from reading elsewhere, so nothing is held there.
const HOLDS: bool = cfg!(unix);

fn is_in_use(path: &Path) -> bool {
    HOLDS && limited_read::open(path).is_ok_and(|file| matches!(file.try_lock(), Err(fs::TryLockError::WouldBlock)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::storage::tests::Scratch;

    fn write(folder: &Scratch, name: &str, bytes: usize) -> PathBuf {
        let path = folder.path().join(name);
        fs::write(&path, vec![0; bytes]).unwrap();
        path
    }

    fn names(paths: &[PathBuf]) -> Vec<&str> {
        paths.iter().map(|path| path.file_stem().unwrap().to_str().unwrap()).collect()
    }

    /// The clock of a machine went back by a year, and the game that was played today counted as the oldest.
    #[test]
    fn age_is_the_order_of_play_whatever_the_clock_said() {
        let folder = Scratch::new("order");
        for name in ["10 2025-01-01 00.00.00 a", "2026-11-20 10.00.00 a", "9 2031-01-01 00.00.00 a", "mine"] {
            write(&folder, &format!("{name}.caustic"), 10);
        }
        let order = ["mine", "2026-11-20 10.00.00 a", "9 2031-01-01 00.00.00 a", "10 2025-01-01 00.00.00 a"];
        assert_eq!(names(&recordings(folder.path())), order);
        assert_eq!(next_number(folder.path()), 11);
        assert_eq!(names(&prune(folder.path(), 20)), ["2026-11-20 10.00.00 a"]);
        assert_eq!(names(&prune(folder.path(), 0)), ["9 2031-01-01 00.00.00 a"], "the last one stays");
        assert_eq!(names(&recordings(folder.path())), ["mine", "10 2025-01-01 00.00.00 a"]);
    }

    #[test]
    fn a_name_that_somebody_gave_is_not_the_folders_own() {
        for name in [
            "best game",
            "12",
            "12 best",
            "12a 2026-11-20 10.00.00 a",
            "2026-11-20",
            "+1 2026-11-20 10.00.00 a",
            "1000000000 2026-11-20 10.00.00 a",
            "99999999999999999999 2026-11-20 10.00.00 a",
        ] {
            assert_eq!(play_order(Path::new(&format!("{name}.caustic"))), None, "{name}");
        }
    }

    /// After the largest number of all came 0, and the new game counted as the oldest.
    #[test]
    fn no_number_in_a_name_makes_the_next_game_the_oldest() {
        let folder = Scratch::new("numbers");
        write(&folder, "18446744073709551615 2026-11-29 10.00.00 a.caustic", 10);
        assert_eq!(next_number(folder.path()), 1);
        write(&folder, "999999999 2026-11-29 10.00.00 a.caustic", 10);
        assert_eq!(next_number(folder.path()), 999_999_999);
        write(&folder, "999999999 2026-11-30 10.00.00 a.caustic", 10);
        let names = ["999999999 2026-11-29 10.00.00 a", "999999999 2026-11-30 10.00.00 a"];
        assert_eq!(names_of_own(&folder), names);
    }

    fn names_of_own(folder: &Scratch) -> Vec<String> {
        let own = recordings(folder.path()).into_iter().filter(|path| play_order(path).is_some());
        own.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect()
    }

    #[cfg(unix)]
    #[test]
    fn what_is_written_or_shown_is_never_pruned() {
        let folder = Scratch::new("held");
        let paths = [1, 2, 3, 4].map(|n| write(&folder, &format!("{n} 2026-11-20 10.00.00 a.caustic"), 10));
        let written = File::options().write(true).open(&paths[0]).unwrap();
        hold_written(&written);
        let shown = hold_shown(&paths[1]);
        assert_eq!(prune(folder.path(), 0), [paths[2].clone()]);
        drop((written, shown));
        assert_eq!(prune(folder.path(), 0), [paths[0].clone(), paths[1].clone()]);
    }
}
