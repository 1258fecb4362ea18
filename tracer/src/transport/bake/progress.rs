//! How far a bake is, and whether it is still wanted.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Counts what is done, and tells it.
pub(super) struct Progress<'a> {
    /// Is told what is done, and all; says whether to go on.
    tell: &'a (dyn Fn(u64, u64) -> bool + Sync),
    all: u64,
    done: AtomicU64,
    is_cancelled: AtomicBool,
}

impl<'a> Progress<'a> {
    pub(super) fn new(all: u64, tell: &'a (dyn Fn(u64, u64) -> bool + Sync)) -> Progress<'a> {
        Progress { tell, all, done: AtomicU64::new(0), is_cancelled: AtomicBool::new(false) }
    }

    /// So much more is done. Whether to go on.
    pub(super) fn add(&self, more: u64) -> bool {
        if self.is_cancelled() {
            return false;
        }
        let done = self.done.fetch_add(more, Ordering::Relaxed) + more;
        let goes_on = (self.tell)(done.min(self.all), self.all);
        if !goes_on {
            self.is_cancelled.store(true, Ordering::Relaxed);
        }
        goes_on
    }

    pub(super) fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }
}
