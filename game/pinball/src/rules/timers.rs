//! Timers: what the rules want to be told later.

use serde::{Deserialize, Serialize};

/// Most timers that run at once.
pub const MAX_TIMERS: usize = 256;

/// The timers that run, the next one first; those of one tick in the order of their names.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Timers {
    running: Vec<Timer>,
}

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
struct Timer {
    due: u64,
    name: String,
}

impl Timers {
    /// Starts a timer, or sets it anew if it runs. False if too many run already.
    pub fn start(&mut self, name: &str, due: u64) -> bool {
        self.cancel(name);
        if self.running.len() >= MAX_TIMERS {
            return false;
        }
        let timer = Timer { due, name: name.to_string() };
        let place = self.running.partition_point(|other| *other < timer);
        self.running.insert(place, timer);
        true
    }

    /// How many run.
    pub fn count(&self) -> usize {
        self.running.len()
    }

    /// Forgets a timer, if it runs.
    pub fn cancel(&mut self, name: &str) {
        self.running.retain(|timer| timer.name != name);
    }

    /// When a timer is due; `None` if it does not run.
    pub fn due(&self, name: &str) -> Option<u64> {
        self.running.iter().find(|timer| timer.name == name).map(|timer| timer.due)
    }

    /// Takes the next timer that is due.
    pub fn take_due(&mut self, now: u64) -> Option<String> {
        let due = self.running.first().is_some_and(|timer| timer.due <= now);
        due.then(|| self.running.remove(0).name)
    }
}
