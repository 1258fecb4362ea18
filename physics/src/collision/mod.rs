//! What balls can collide with, and the time of impact.

pub(crate) mod grid;
pub(crate) mod time_of_impact;
pub(crate) mod world;
