//! `caustic view`: a drawing's light in a window.

use super::parallel;
use crate::Failure;
use crate::cli::ViewArgs;
use crate::rendering::Integrator;
use crate::scene_viewer::{self, ViewerOptions};

/// Shows a drawing until the window is closed.
///
/// # Errors
/// If it cannot be read, or there is no display.
pub fn run(args: &ViewArgs) -> Result<(), Failure> {
    if args.drawing.extension().is_some_and(|end| end.eq_ignore_ascii_case("json")) {
        let path = args.drawing.display();
        return Err(Failure::new(format!(
            "{path}: only drawings (.svg) are shown in a window; caustic render draws this"
        )));
    }
    let options = ViewerOptions {
        size: args.size,
        fullscreen: args.fullscreen,
        integrator: args.integrator.map(Integrator::from),
        white_kelvin: args.white,
    };
    scene_viewer::view(&args.drawing, options, parallel::pool(args.threads)?)
}
