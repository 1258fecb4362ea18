//! `caustic frame`: one picture as a PNG file.

use super::parallel;
use crate::cli::FrameArgs;
use crate::hud::{Badge, Chrome};
use crate::picture::{Moment, Picture};
use crate::recording::Replay;
use crate::{Failure, Recording, Simulation, Snapshot, Table};
use physics::TICKS_PER_SECOND;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::Arc;
use tracer::Frame;

/// A table is shown this long after it was switched on, when its lamps are alight, s.
const LIT_S: f64 = 2.0;

/// Writes the frame that the arguments ask for.
///
/// # Errors
/// If the table or the recording cannot be read, or the file cannot be written.
pub fn run(args: &FrameArgs) -> Result<(), Failure> {
    let (table, moments) = match &args.replay {
        Some(file) => of_recording(file, args.at)?,
        None => of_table(&args.table, args.at.unwrap_or(LIT_S))?,
    };
    let mut picture = Picture::new(table, parallel::pool(args.threads)?)?;
    let chrome = Chrome { badge: args.replay.is_some().then_some(Badge::Replay), ..Chrome::default() };
    let frame = picture.draw(Moment::at(&moments), args.size.width, args.size.height, &chrome)?;
    write_png(frame, &args.out)
}

fn of_table(name: &str, at_s: f64) -> Result<(Arc<Table>, Snapshot), Failure> {
    let table = Arc::new(Table::load(name).map_err(Failure::of_many)?);
    let mut simulation = Simulation::new(table.clone(), 0)?;
    for _ in 0..(at_s * f64::from(TICKS_PER_SECOND)) as u64 {
        simulation.tick(crate::Buttons::NONE);
    }
    Ok((table, simulation.snapshot()))
}

fn of_recording(file: &Path, at_s: Option<f64>) -> Result<(Arc<Table>, Snapshot), Failure> {
    let recording = Recording::read(file)?;
    let end = recording.ticks();
    let tick = at_s.map_or(end, |at_s| (at_s * f64::from(TICKS_PER_SECOND)) as u64);
    if tick > end {
        let length_s = end as f64 / f64::from(TICKS_PER_SECOND);
        return Err(Failure::new(format!("{} is {length_s:.1} s long; give --at less", file.display())));
    }
    let mut replay = Replay::new(recording)?;
    replay.seek(tick);
    Ok((replay.simulation().table().clone(), replay.simulation().snapshot()))
}

/// Writes a picture as a PNG file.
///
/// # Errors
/// If the file cannot be written.
pub fn write_png(frame: &Frame, path: &Path) -> Result<(), Failure> {
    let wrong = |error: String| Failure::new(format!("cannot write {}: {error}", path.display()));
    let file = File::create(path).map_err(|error| wrong(error.to_string()))?;
    let mut file = BufWriter::new(file);
    let mut encoder = png::Encoder::new(&mut file, frame.width as u32, frame.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header().map_err(|error| wrong(error.to_string()))?;
    writer.write_image_data(&frame.to_rgb8()).map_err(|error| wrong(error.to_string()))?;
    writer.finish().map_err(|error| wrong(error.to_string()))?;
    file.flush().map_err(|error| wrong(error.to_string()))
}
