//! `caustic frame`: one picture as a PNG file.

use super::parallel;
use crate::cli::{FrameArgs, Integrator};
use crate::frame_composer::{FrameComposer, Interpolation};
use crate::hud::UiState;
use crate::storage::recordings::{self, ShownRecording};
use crate::storage::{check_place, save_png, tables};
use crate::{Failure, Simulation, Snapshot, Table};
use physics::TICKS_PER_SECOND;
use std::path::Path;
use std::sync::Arc;
use tracer::monte_carlo::Sampling;

/// A table is shown this long after it was switched on, when its lamps are alight, s.
const LIT_S: f64 = 2.0;

/// Random samples a lamp and pixel, if nothing is said.
const SAMPLES: u32 = 64;

/// Writes the frame that the arguments ask for.
///
/// # Errors
/// If the table or the recording cannot be read, or the file cannot be written.
pub fn run(args: &FrameArgs) -> Result<(), Failure> {
    check_place(&args.out)?;
    let Moment { table, snapshot, notice } = match &args.replay {
        Some(file) => of_recording(file, args.at)?,
        None => of_table(&args.table, args.at.unwrap_or(LIT_S))?,
    };
    let ui_state = UiState { notice, ..UiState::default() };
    let mut composer = FrameComposer::new(table, parallel::pool(args.threads)?)?;
    composer.set_light_resolution(args.light.resolution().unwrap_or_default());
    composer.set_zoom(args.zoom);
    if args.integrator == Integrator::MonteCarlo {
        composer.use_reference(Sampling { samples: args.samples.unwrap_or(SAMPLES), seed: 0, stratified: true });
    }
    let frame = composer.draw(Interpolation::at(&snapshot), args.size, &ui_state)?;
    save_png(frame, &args.out)
}

/// What is shown.
struct Moment {
    table: Arc<Table>,
    snapshot: Snapshot,
    /// What the picture has to say.
    notice: Option<String>,
}

fn of_table(name: &str, at_s: f64) -> Result<Moment, Failure> {
    let table = Arc::new(tables::load(name).map_err(Failure::of_many)?);
    let mut simulation = Simulation::new(table.clone(), 0)?;
    let ticks = (at_s * f64::from(TICKS_PER_SECOND)) as u64;
    let bar = parallel::progress_bar(ticks, "ticks");
    for tick in 0..ticks {
        simulation.tick(crate::Buttons::NONE);
        bar.set_position(tick);
    }
    bar.finish_and_clear();
    Ok(Moment { table, snapshot: simulation.snapshot(), notice: None })
}

fn of_recording(file: &Path, at_s: Option<f64>) -> Result<Moment, Failure> {
    let ShownRecording { mut replay, missing_art: notice, .. } = recordings::open_to_show(file)?;
    let end = replay.recording().ticks();
    let tick = at_s.map_or(end, |at_s| (at_s * f64::from(TICKS_PER_SECOND)) as u64);
    if tick > end {
        let length_s = end as f64 / f64::from(TICKS_PER_SECOND);
        return Err(Failure::new(format!("{} is {length_s:.3} s long; give --at less", file.display())));
    }
    replay.seek(tick);
    let simulation = replay.simulation();
    Ok(Moment { table: simulation.table().clone(), snapshot: simulation.snapshot(), notice })
}
