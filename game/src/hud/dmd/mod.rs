//! The dot-matrix display (DMD): what it shows at a tick, and its dots as pixels.

mod animation;
mod dots;
mod raster;

pub use animation::{grouped, page};
pub use dots::Dots;
pub use raster::{Matrix, housing};
