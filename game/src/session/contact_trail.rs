//! The contact trail: the last contacts of balls, for as long as they are shown.

use crate::hud::TrailContact;
use physics::{Contact, TickEvent};
use std::collections::VecDeque;

/// How long a contact is shown, ticks.
const SHOWN_TICKS: u64 = 400;
/// The most contacts that are kept: a ball that rolls along a wall adds a contact in every tick.
const MOST_CONTACTS: usize = 256;

/// The last contacts, the oldest first.
#[derive(Default)]
pub struct ContactTrail(VecDeque<(u64, Contact)>);

impl ContactTrail {
    /// Adds the contacts in a tick's stream.
    pub fn add(&mut self, tick: u64, events: &[TickEvent]) {
        self.0.extend(events.iter().filter_map(TickEvent::contact).map(|&contact| (tick, contact)));
        let surplus = self.0.len().saturating_sub(MOST_CONTACTS);
        self.0.drain(..surplus);
    }

    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Those that are still shown at a tick.
    pub fn shown(&self, now: u64) -> Vec<TrailContact> {
        let age = |tick: u64| now.saturating_sub(tick) as f64 / SHOWN_TICKS as f64;
        let recent = self.0.iter().filter(|(tick, _)| age(*tick) < 1.0);
        recent.map(|&(tick, contact)| TrailContact { contact, age: age(tick) }).collect()
    }
}
