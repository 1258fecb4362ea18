//! Rendering of scenes of light: an integrator, pass by pass, to a picture that can be shown or saved.

mod develop;
mod direct;
mod exposure;
mod passes;
mod picture;
#[cfg(test)]
mod tests;

pub use develop::{add_art, develop, expose};
pub use passes::{Integrator, Passes, Settings, Stopped, finds_all_by_beams, weights};
pub use picture::Picture;
