//! All that decides a game of pinball, and nothing else.
//!
//! [`Buttons`] -> [`Simulation::tick`] -> [`Snapshot`]
//!
//! A [`Table`] is parsed from texts, a [`Recording`] from bytes; a [`bot`] plays as a player does, by its buttons. The
//! crate refuses to know files and paths, clocks, threads, windows, pictures and light: the same inputs give the same
//! game on every machine.

pub mod bot;
mod buttons;
mod failure;
pub mod lamps;
pub mod playtest;
pub mod recording;
pub mod rules;
pub mod simulation;
mod spelling;
pub mod table;
pub mod timeline;

pub use buttons::Buttons;
pub use failure::Failure;
pub use recording::Recording;
pub use simulation::{Simulation, Snapshot};
pub use table::Table;
