//! Notices that a table's or a drawing's files were saved while they are shown.
//!
//! It only looks at times and sizes, three small questions to the file system, and waits until a file has been left
//! alone for a moment, because editors write in several steps. It reads no clock and loads nothing: the window says
//! what time it is, and keeps what was last good if the new one is bad.

use crate::table::FILES;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(200);
/// How long the files must have been left alone.
const QUIET: Duration = Duration::from_millis(150);

/// When a file was last written and how long it is; `None` when there is none.
type Stamp = Option<(SystemTime, u64)>;

/// Some files, and what they were like.
#[derive(Clone, Debug)]
pub struct FileWatch {
    files: Vec<PathBuf>,
    loaded: Vec<Stamp>,
    seen: Vec<Stamp>,
    seen_at: Duration,
    looked_at: Option<Duration>,
}

impl FileWatch {
    /// Watches these files. Make it before they are loaded, so that nothing is missed.
    pub fn new(files: Vec<PathBuf>) -> FileWatch {
        let stamps = stamps(&files);
        FileWatch { files, loaded: stamps.clone(), seen: stamps, seen_at: Duration::ZERO, looked_at: None }
    }

    /// Watches the three files of the table in `dir`.
    pub fn of_table(dir: &Path) -> FileWatch {
        FileWatch::new(FILES.map(|file| dir.join(file)).to_vec())
    }

    /// The files that were saved since they were last told of; empty when there are none or they are still
    /// being written. `now` is the time since any fixed moment; call it as often as you like.
    pub fn changed(&mut self, now: Duration) -> Vec<&Path> {
        if self.looked_at.is_some_and(|looked_at| now < looked_at + LOOK) {
            return Vec::new();
        }
        self.looked_at = Some(now);
        let stamps = stamps(&self.files);
        if stamps != self.seen {
            self.seen.clone_from(&stamps);
            self.seen_at = now;
        }
        if now < self.seen_at + QUIET {
            return Vec::new();
        }
        let loaded = std::mem::replace(&mut self.loaded, stamps);
        let changed = self.files.iter().zip(loaded.iter().zip(&self.loaded));
        changed.filter(|(_, (before, now))| before != now).map(|(file, _)| file.as_path()).collect()
    }

    /// What the files are like now is known: who has written them says so.
    pub fn forget_changes(&mut self) {
        self.loaded = stamps(&self.files);
        self.seen.clone_from(&self.loaded);
    }
}

fn stamps(files: &[PathBuf]) -> Vec<Stamp> {
    let stamp = |file: &PathBuf| {
        let metadata = std::fs::metadata(file).ok()?;
        Some((metadata.modified().ok()?, metadata.len()))
    };
    files.iter().map(stamp).collect()
}
