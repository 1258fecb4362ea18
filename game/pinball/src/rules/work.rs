//! How much the rules may work: in steps, so that every machine stops a script at the same place.
//!
//! What events and timers work beyond [`TICK_STEPS`] in a tick is a debt, of which every tick pays back so much. A tick
//! alone may need many more steps than that; rules that work without end leave the game what a tick has.

use physics::Fingerprint;
use serde::{Deserialize, Serialize};

/// Steps that every tick has.
pub const TICK_STEPS: u64 = 400;
/// Steps that may be owed.
pub const MAX_DEBT: u64 = 600_000;
/// Steps that are owed before the debt is in the hash.
pub const SILENT_DEBT: u64 = 60_000;

/// What the rules owe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Work {
    debt: u64,
}

impl Work {
    /// The most steps that the rules can take in so many ticks, one after the other.
    pub fn most(ticks: u64) -> u64 {
        MAX_DEBT + ticks * TICK_STEPS
    }

    /// Steps that are owed.
    pub fn debt(self) -> u64 {
        self.debt
    }

    /// The steps that the next event may take.
    pub fn allowed(self) -> u64 {
        MAX_DEBT.saturating_sub(self.debt)
    }

    /// An event has taken these.
    pub fn add(&mut self, steps: u64) {
        self.debt = self.debt.saturating_add(steps);
    }

    /// A tick is over.
    pub fn end_tick(&mut self) {
        self.debt = self.debt.saturating_sub(TICK_STEPS);
    }

    /// Adds the debt, if it is large: a game whose rules work little has the hashes that it had before anybody counted. No
    /// difference is lost by that: an event is cut short only where nothing more may be owed, and that is in the hash of its
    /// tick.
    pub fn add_to(self, fingerprint: &mut Fingerprint) {
        if self.debt > SILENT_DEBT {
            fingerprint.add(&self.debt);
        }
    }
}
