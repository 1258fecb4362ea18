//! Collision: what stands still in a ball's way, where a ball's centre closes a switch, and the time of impact.
//!
//! Refuses to know what an impact does, and how anything moves.

pub(crate) mod grid;
pub(crate) mod obstacle;
pub(crate) mod time_of_impact;
pub(crate) mod trigger;
pub(crate) mod world;
