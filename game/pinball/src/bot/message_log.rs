//! The message log: what the display shows in a run, and for how long.

use crate::Simulation;
use std::collections::BTreeSet;

/// Messages that are kept: those of a script that counts something are each another.
const MOST_MESSAGES: usize = 1000;

/// A message as it was shown.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ShownMessage {
    /// The display's lines.
    pub lines: Vec<String>,
    /// How long it was to stand, ms.
    pub ms: u64,
}

/// The messages of a run, each once; those that stay until another comes are not kept.
#[derive(Default)]
pub(super) struct MessageLog {
    /// What the message that is shown still has, ms.
    left_ms: u64,
    shown: BTreeSet<ShownMessage>,
}

impl MessageLog {
    /// Looks at the display after a tick.
    pub fn look(&mut self, simulation: &Simulation) {
        let Some((lines, ms)) = simulation.message() else {
            self.left_ms = 0;
            return;
        };
        // Time only runs out: a message that has more of it has just come.
        let is_new = ms >= self.left_ms;
        self.left_ms = ms;
        if is_new && self.shown.len() < MOST_MESSAGES {
            self.shown.insert(ShownMessage { lines: lines.to_vec(), ms });
        }
    }

    /// All of them.
    pub fn shown(self) -> Vec<ShownMessage> {
        self.shown.into_iter().collect()
    }
}
