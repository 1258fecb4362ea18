//! Reads a table again when its files are saved, on a thread of its own: the game never waits for a file.

use crate::desktop::Waker;
use crate::storage::{FileWatch, tables};
use crate::{Failure, Table};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

/// Watches one table's folder.
pub struct TableReload {
    dir: PathBuf,
    watch: FileWatch,
    loading: bool,
    loaded: Receiver<Loaded>,
    outbox: Sender<Loaded>,
}

/// A table that was read again, or every mistake in it.
pub type Loaded = Result<Arc<Table>, Failure>;

impl TableReload {
    /// Watches the table in `dir`.
    pub fn new(dir: &Path) -> TableReload {
        let (outbox, loaded) = channel();
        TableReload { dir: dir.to_path_buf(), watch: FileWatch::of_table(dir), loading: false, loaded, outbox }
    }

    /// Looks whether a file was saved, and begins to read the table if so; `now` is the time since any fixed moment.
    /// The main thread is woken when the table has been read.
    pub fn look(&mut self, now: Duration, waker: Waker) {
        if self.loading || self.watch.changed(now).is_empty() {
            return;
        }
        let (dir, outbox) = (self.dir.clone(), self.outbox.clone());
        let read = move || {
            // Nobody waits for it any more when the window is being closed.
            let _ = outbox.send(read(&dir));
            waker.wake();
        };
        self.loading = std::thread::Builder::new().name("reload".to_string()).spawn(read).is_ok();
    }

    /// What has been read, when it is.
    pub fn take(&mut self) -> Option<Loaded> {
        let loaded = self.loaded.try_recv().ok();
        self.loading &= loaded.is_none();
        loaded
    }
}

fn read(dir: &Path) -> Loaded {
    let table = tables::load_dir(dir).map_err(Failure::of_many)?;
    Ok(Arc::new(table))
}
