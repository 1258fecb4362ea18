//! Events and contacts: what comes out of a tick.

use crate::part::PartId;
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// Something that the rules may care about.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Where.
    pub part: Option<PartId>,
    /// What.
    pub kind: EventKind,
}

impl Event {
    /// The switch of this part has closed.
    pub(crate) fn closed(part: PartId) -> Event {
        Event { part: Some(part), kind: EventKind::Closed }
    }

    /// The switch of this part has opened.
    pub(crate) fn opened(part: PartId) -> Event {
        Event { part: Some(part), kind: EventKind::Opened }
    }
}

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum EventKind {
    /// A part's switch closed: a kicker fired, a target was hit, or a ball came to rest in or passed over the part. The
    /// part's own numbers (as [`crate::Rollover`]) say when.
    Closed,
    /// A part's switch opened: a ball left the part, or a drop target rose.
    Opened,
    /// A ball was shot by the plunger.
    Launched,
    /// A new ball arrived in the plunger lane.
    Fed,
    /// The cabinet moved so far that the tilt bob touched its ring.
    TiltBob,
    /// The cabinet was hit so hard, or shaken so long, that the slam switch closed.
    Slam,
}

/// One impact of a ball, for whoever listens: the debug overlay, benchmarks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// When in the tick, s: from 0 to [`crate::TICK_S`].
    pub time_s: f64,
    /// What was hit; `None` for another ball.
    pub part: Option<PartId>,
    /// The point of contact, m.
    pub point: DVec2,
    /// The unit normal, from the surface to the ball.
    pub normal: DVec2,
    /// Speed of approach along the normal, m/s.
    pub speed_m_s: f64,
    /// The impulse that the ball was given, N s.
    pub impulse_n_s: DVec2,
    /// How many of the tick's events came before it: its place in [`crate::Machine::tick_events`].
    pub events_before: usize,
}

/// One entry of a tick's stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TickEvent {
    /// A switch, a coil or the cabinet did something.
    Event(Event),
    /// A ball hit something.
    Contact(Contact),
}

impl TickEvent {
    /// The event, if it is one.
    pub fn event(&self) -> Option<&Event> {
        match self {
            TickEvent::Event(event) => Some(event),
            TickEvent::Contact(_) => None,
        }
    }

    /// The contact, if it is one.
    pub fn contact(&self) -> Option<&Contact> {
        match self {
            TickEvent::Event(_) => None,
            TickEvent::Contact(contact) => Some(contact),
        }
    }
}

/// Events and contacts of a tick as one stream, in the order in which they happened.
pub(crate) fn stream<'a>(events: &'a [Event], contacts: &'a [Contact]) -> impl Iterator<Item = TickEvent> + 'a {
    let mut contacts = contacts.iter().peekable();
    let mut passed = 0;
    std::iter::from_fn(move || {
        if let Some(&contact) = contacts.next_if(|contact| contact.events_before <= passed) {
            return Some(TickEvent::Contact(contact));
        }
        let event = events.get(passed)?;
        passed += 1;
        Some(TickEvent::Event(*event))
    })
}
