//! The dot-matrix display (DMD): what it shows at a tick, and its dots as pixels.

mod animation;
mod dots;
mod raster;

pub use animation::{animation_dots, grouped, reading_ms};
pub use dots::{Dots, has_dots};
pub use raster::{DmdRaster, housing};
