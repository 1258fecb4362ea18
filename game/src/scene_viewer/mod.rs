//! A drawing's light in a window: what is dragged with the mouse moves, and its light follows.
//!
//! Beams show at once where light goes; while nothing moves the picture is refined. A drag changes the drawing's text, which is
//! read again as the file would be: what is seen is what will be saved.

mod app;
mod camera;
mod document;
mod overlay;
mod pick;
mod refiner;
mod resampling;
#[cfg(test)]
mod tests;

use crate::desktop::{Display, WindowOptions};
use crate::rendering::Integrator;
use crate::screen::Size;
use crate::{Failure, tell};
use app::SceneViewer;
use document::Document;
use std::path::Path;

/// How a drawing is shown.
#[derive(Clone, Copy, Debug)]
pub struct ViewerOptions {
    /// The window's size in pixels; by default as the page, on most of the monitor.
    pub size: Option<Size>,
    /// Whether it fills the screen.
    pub fullscreen: bool,
    /// What refines the picture; by default beams, or photons where something is matt or rough.
    pub integrator: Option<Integrator>,
    /// The temperature of the light that is white, K.
    pub white_kelvin: Option<f64>,
}

/// The longer side of a window whose size is not said, pixels.
const USUAL_SIDE: f64 = 1080.0;

/// Shows the drawing in `path` in a window until that is closed.
///
/// # Errors
/// If the drawing cannot be read, or there is no display.
pub fn view(path: &Path, options: ViewerOptions, pool: rayon::ThreadPool) -> Result<(), Failure> {
    let document = Document::open(path).map_err(Failure::of_many)?;
    document.scene().warnings.iter().for_each(tell);
    let display = Display::open()?;
    let page = document.scene().drawing.size_mm;
    let usual = (page * (USUAL_SIDE / page.max_element())).round();
    let size = options.size.unwrap_or(Size { width: usual.x.max(1.0) as usize, height: usual.y.max(1.0) as usize });
    let title = format!("{} - Caustic", path.display());
    let window = WindowOptions { title, size: Some(size), fullscreen: options.fullscreen };
    let mut app = SceneViewer::new(document, options, pool)?;
    let painter = overlay::painter()?;
    display.run(&mut app, window, painter)
}
