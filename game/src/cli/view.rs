//! `caustic view`: its words.

use super::LightIntegrator;
use super::render::kelvin;
use super::values::threads;
use crate::screen::Size;
use clap::Args;
use std::path::PathBuf;

/// `caustic view`
#[derive(Args, Debug, Clone)]
pub struct ViewArgs {
    /// The drawing; it is read again when another program saves it
    #[arg(value_name = "DRAWING.svg")]
    pub drawing: PathBuf,
    /// Size of the window in pixels; by default as the page, 1080 pixels on its longer side
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse)]
    pub size: Option<Size>,
    /// Fill the screen
    #[arg(long)]
    pub fullscreen: bool,
    /// How the picture is refined while nothing moves; by default by beams, and by photons where something is matt or rough
    #[arg(long, value_enum)]
    pub integrator: Option<LightIntegrator>,
    /// The temperature of the light that is white, in kelvin; without it light of equal power at every wavelength is white
    #[arg(long, value_name = "K", allow_hyphen_values = true, value_parser = kelvin)]
    pub white: Option<f64>,
    /// Threads that trace light; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
}
