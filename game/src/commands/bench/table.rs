//! A whole frame of the table in play, stage by stage, as the window draws it.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::bot::Bot;
use crate::cli::Size;
use crate::commands::parallel;
use crate::hud::Chrome;
use crate::picture::{Moment, Picture};
use crate::{Failure, Simulation, Snapshot, Table};
use std::sync::Arc;
use tracer::monte_carlo::Sampling;

/// The size that figures are quoted at, beside the one of a full HD monitor on its side.
const SIZES: [Size; 2] = [Size { width: 540, height: 1080 }, Size { width: 1080, height: 1920 }];

/// Frames that are timed, after as many again to warm up; a 60th of a second of play lies between two.
const FRAMES: usize = 120;

/// How long the bot has played before the first frame, ticks.
const PLAYED: u64 = 12_000;

/// Times the frames of a game at each size.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let table = Arc::new(Table::load("spectrum").map_err(Failure::of_many)?);
    let moments = moments(&table, FRAMES)?;
    let sizes = size.map_or(SIZES.to_vec(), |size| vec![size]);
    let mut rows = Vec::new();
    for size in sizes {
        rows.extend(frames(&table, &moments, size, threads)?);
    }
    Ok(rows)
}

/// What the bot's game looks like at `count` moments, a 60th of a second apart.
pub(super) fn moments(table: &Arc<Table>, count: usize) -> Result<Vec<Snapshot>, Failure> {
    let mut simulation = Simulation::new(table.clone(), 1)?;
    let mut bot = Bot::new(1);
    let mut moments = Vec::new();
    while moments.len() < count {
        let buttons = bot.buttons(&simulation);
        simulation.tick(buttons);
        if simulation.ticks() >= PLAYED && simulation.ticks() % 17 == 0 {
            moments.push(simulation.snapshot());
        }
    }
    Ok(moments)
}

fn frames(table: &Arc<Table>, moments: &[Snapshot], size: Size, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let pool = parallel::pool(threads)?;
    let threads = pool.current_num_threads();
    let mut picture = Picture::new(table.clone(), pool)?;
    let draw = |picture: &mut Picture, moment: &Snapshot| -> Result<f64, Failure> {
        let mut drawn = Ok(());
        let ms = time_ms(|| {
            drawn = picture.draw(Moment::at(moment), size.width, size.height, &Chrome::default()).map(|_| ());
        });
        drawn.map(|()| ms)
    };
    for moment in moments {
        draw(&mut picture, moment)?;
    }
    let mut columns: [Vec<f64>; 5] = Default::default();
    for moment in moments {
        let whole_ms = draw(&mut picture, moment)?;
        let times = picture.times();
        let parts = [whole_ms, times.stage_ms, times.light_ms, times.tone_ms, times.hud_ms];
        columns.iter_mut().zip(parts).for_each(|(column, part)| column.push(part));
    }
    let row = |variant: &str, mut times_ms: Vec<f64>| {
        let ms = quantile(&mut times_ms, 0.5);
        Row {
            bench: "table",
            variant: variant.to_string(),
            size: Some(format!("{}x{}", size.width, size.height)),
            threads,
            ms,
            ns_per_pixel: Some(ms * 1e6 / (size.width * size.height) as f64),
            ms_99th: Some(quantile(&mut times_ms, 0.99)),
            times_real_time: None,
        }
    };
    let names = ["whole frame", "- scene", "- light, floor, tops, balls, glare", "- tone map", "- display"];
    let mut rows: Vec<Row> = names.into_iter().zip(columns).map(|(name, column)| row(name, column)).collect();
    picture.use_reference(Sampling { samples: REFERENCE_SAMPLES, seed: 0, stratified: true });
    let slow_ms = draw(&mut picture, &moments[0])?;
    rows.push(row(&format!("(reference, {REFERENCE_SAMPLES} rays a lamp)"), vec![slow_ms]));
    Ok(rows)
}

/// Rays to each lamp that the slow reference is timed with: few, for it is slow.
const REFERENCE_SAMPLES: u32 = 4;
