//! Caustic: everything that knows both the light and the ball.
//!
//! The data's way, each arrow one function and each noun plain data:
//!
//! keys -> [`Buttons`] -> [`Simulation::tick`] -> [`Snapshot`] -> scene builder -> [`tracer::Scene`] -> radiance ->
//! frame -> HUD -> window or PNG
//!
//! A replay enters at [`Buttons`]; a headless dump leaves at the frame; nothing in between knows which it is.

pub mod art;
pub mod cli;
pub mod commands;
pub mod desktop;
pub mod drawn_scene;
mod fonts;
pub mod frame_composer;
pub mod game_app;
pub mod hud;
pub mod input;
mod interrupt;
pub mod optics;
pub mod rendering;
pub mod scene_builder;
pub mod scene_viewer;
pub mod screen;
pub mod session;
#[cfg(test)]
mod small_table;
mod standard_error;
pub mod storage;
mod terminal;

pub use pinball::{Buttons, Failure, Recording, Simulation, Snapshot, Table};
pub use pinball::{bot, lamps, recording, rules, simulation, table};
pub use standard_error::tell;
