//! Headless play on one core: the demos' inputs, played again.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::Failure;
use crate::storage::{assets, recordings};

/// Ticks that are timed together: one alone is too short for the clock.
const BATCH: u64 = 10;

/// Plays every demo once and reports the time of a tick.
pub fn rows() -> Result<Vec<Row>, Failure> {
    let mut batches_ms = Vec::new();
    let mut ticks = 0;
    for path in assets::demos()? {
        let recording = recordings::read(&path)?;
        let mut simulation = recordings::start(&recording).map_err(|failure| failure.in_file(path.display()))?;
        for first in (0..recording.ticks()).step_by(BATCH as usize) {
            let last = (first + BATCH).min(recording.ticks());
            batches_ms.push(time_ms(|| (first..last).for_each(|tick| simulation.tick(recording.buttons(tick)))));
            ticks += last - first;
        }
    }
    if ticks == 0 {
        return Err(Failure::new("there is no demo in assets/demos to play: record one with `caustic play --record`"));
    }
    let total_ms: f64 = batches_ms.iter().sum();
    let tick_ms = 1000.0 / f64::from(physics::TICKS_PER_SECOND);
    Ok(vec![Row {
        bench: "tick",
        variant: format!("{} s of the demos, mean", ticks / 1000),
        size: None,
        threads: 1,
        ms: total_ms / ticks as f64,
        ns_per_pixel: None,
        ms_99th: Some(quantile(&mut batches_ms, 0.99) / BATCH as f64),
        times_real_time: Some(ticks as f64 * tick_ms / total_ms),
        ..Row::default()
    }])
}
