//! Rendering of scenes of light: an integrator, pass by pass, to a picture that can be shown or saved.

mod baking;
mod develop;
mod direct;
mod exposure;
mod passes;
mod picture;
mod table_scene;
#[cfg(test)]
mod tests;

pub use develop::{add_art, develop, expose};
pub use passes::{Integrator, Passes, Settings, Stopped, finds_all_by_beams, weights};
pub use picture::Picture;
pub use table_scene::table_scene;
