//! Which frame a buffer holds.

use std::sync::atomic::{AtomicU64, Ordering};

/// A frame: which renderer made it, and which of its frames it is. No two are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FrameId {
    renderer: u64,
    frame: u64,
}

/// How many renderers there have been.
static RENDERERS: AtomicU64 = AtomicU64::new(0);

impl FrameId {
    /// That of a renderer that has made no frame yet.
    pub fn of_new_renderer() -> FrameId {
        FrameId { renderer: RENDERERS.fetch_add(1, Ordering::Relaxed), frame: 0 }
    }

    /// Becomes the next frame of the same renderer, and returns it.
    pub fn advance(&mut self) -> FrameId {
        self.frame += 1;
        *self
    }
}
