//! Notices that a table's files were saved while it is played.
//!
//! It only looks at times and sizes, three small questions to the file system, and waits until a file has been left
//! alone for a moment, because editors write in several steps. It reads no clock and loads nothing: the window says
//! what time it is, and keeps the last good table if the new one is bad.

use crate::table::FILES;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(200);
/// How long the files must have been left alone.
const QUIET: Duration = Duration::from_millis(150);

/// When a file was last written and how long it is; `None` when there is none.
type Stamp = Option<(SystemTime, u64)>;

/// The three files of a table, and what they were like.
#[derive(Clone, Debug)]
pub struct TableWatch {
    dir: PathBuf,
    loaded: [Stamp; 3],
    seen: [Stamp; 3],
    seen_at: Duration,
    looked_at: Option<Duration>,
}

impl TableWatch {
    /// Watches the table in `dir`. Make it before the table is loaded, so that nothing is missed.
    pub fn new(dir: &Path) -> TableWatch {
        let stamps = stamps(dir);
        TableWatch { dir: dir.to_path_buf(), loaded: stamps, seen: stamps, seen_at: Duration::ZERO, looked_at: None }
    }

    /// The names of the files that were saved since they were last told of; empty when there are none or they are still
    /// being written. `now` is the time since any fixed moment; call it as often as you like.
    pub fn changed(&mut self, now: Duration) -> Vec<&'static str> {
        if self.looked_at.is_some_and(|looked_at| now < looked_at + LOOK) {
            return Vec::new();
        }
        self.looked_at = Some(now);
        let stamps = stamps(&self.dir);
        if stamps != self.seen {
            self.seen = stamps;
            self.seen_at = now;
        }
        if now < self.seen_at + QUIET {
            return Vec::new();
        }
        let loaded = std::mem::replace(&mut self.loaded, stamps);
        (0..3).filter(|&file| loaded[file] != stamps[file]).map(|file| FILES[file]).collect()
    }
}

fn stamps(dir: &Path) -> [Stamp; 3] {
    FILES.map(|file| {
        let metadata = std::fs::metadata(dir.join(file)).ok()?;
        Some((metadata.modified().ok()?, metadata.len()))
    })
}
