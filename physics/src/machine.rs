//! The machine in play.

use crate::{Command, Contact, Controls, Event, Layout, PartId, Pose};
use std::sync::Arc;

/// Everything on the playfield, tick after tick. A clone goes on exactly as the original does, and is cheap: the layout
/// is shared.
#[derive(Clone, Debug)]
pub struct Machine {
    layout: Arc<Layout>,
    events: Vec<Event>,
    contacts: Vec<Contact>,
}

/// Why a layout or saved bytes cannot be played.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// A part of the layout has a number that cannot be: which part, and what is wrong, as one sentence.
    Layout(PartId, String),
    /// Saved bytes that this machine did not write.
    Save(String),
}

/// The parts of a machine's state, hashed one by one so that a difference can be named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hashes {
    /// Places, velocities and spins of the balls.
    pub balls: u64,
    /// Flippers, plunger, kickers, cabinet and all rapier bodies.
    pub mechanisms: u64,
}

impl Machine {
    /// A machine with no ball on it, flippers and kickers dead.
    ///
    /// # Errors
    /// If a part's numbers cannot be.
    pub fn new(layout: Arc<Layout>) -> Result<Machine, Error> {
        Ok(Machine { layout, events: Vec::new(), contacts: Vec::new() })
    }

    /// What stands on the playfield.
    pub fn layout(&self) -> &Arc<Layout> {
        &self.layout
    }

    /// One millisecond. Commands are obeyed first, in their order.
    pub fn tick(&mut self, _controls: Controls, _commands: &[Command]) {
        self.events.clear();
        self.contacts.clear();
    }

    /// What happened in the last tick, in order.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The impacts of the last tick, in order.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Where everything is now.
    pub fn pose(&self) -> Pose {
        Pose::default()
    }

    /// Of everything that can change what happens next.
    pub fn hashes(&self) -> Hashes {
        Hashes { balls: 0, mechanisms: 0 }
    }

    /// Everything that can change what happens next.
    pub fn save(&self) -> Vec<u8> {
        Vec::new()
    }

    /// The machine that [`Machine::save`] wrote, on the same layout.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this layout.
    pub fn restore(layout: Arc<Layout>, _bytes: &[u8]) -> Result<Machine, Error> {
        Machine::new(layout)
    }
}
