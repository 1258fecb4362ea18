//! Caustic: everything that knows both the light and the ball.
//!
//! The data's way, each arrow one function and each noun plain data:
//!
//! keys -> [`Buttons`] -> [`Simulation::tick`] -> [`Snapshot`] -> scene builder -> [`tracer::Scene`] -> radiance ->
//! frame -> HUD -> window or PNG
//!
//! A replay enters at [`Buttons`]; a headless dump leaves at the frame; nothing in between knows which it is.

pub mod art;
pub mod bot;
pub mod buttons;
pub mod cli;
pub mod commands;
pub mod desktop;
pub mod failure;
mod fonts;
pub mod frame_composer;
pub mod game_app;
pub mod hud;
pub mod input;
pub mod lamps;
pub mod recording;
pub mod rules;
pub mod scene_builder;
pub mod screen;
pub mod session;
pub mod simulation;
#[cfg(test)]
mod small_table;
mod standard_error;
pub mod storage;
pub mod table;

pub use buttons::Buttons;
pub use failure::Failure;
pub use recording::Recording;
pub use simulation::{Simulation, Snapshot};
pub use standard_error::tell;
pub use table::Table;
