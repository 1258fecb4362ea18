//! What comes out of a tick.

use crate::layout::PartId;
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

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum EventKind {
    /// A part's switch closed: a bumper or slingshot fired, a target or a captive ball was hit, a drop target fell, a
    /// ball rolled onto a rollover, passed a gate, turned a spinner by half a turn, came to rest in a saucer or over a
    /// magnet, touched a kickback's face, or was drained.
    Closed,
    /// A part's switch opened: a ball left a rollover, a saucer, a magnet's middle or a kickback's face, or a drop
    /// target rose.
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

/// One impact of a ball, for the debug overlay and for sounds; the rules never see it.
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
}
