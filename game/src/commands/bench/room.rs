//! The classic race: a room of 5 x 5, three circles of radius 1 that move, a point lamp in each corner, every frame
//! computed from nothing.
//!
//! Every method makes a frame in turn, so that a slow moment of the machine is everybody's.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::Failure;
use crate::cli::Size;
use crate::commands::parallel;
use tracer::Frame;
use tracer::room::{Method, Room};

/// The size that is quoted.
const SIZE: Size = Size { width: 1920, height: 1080 };

/// Rounds that are timed, after one to warm up.
const ROUNDS: usize = 15;

/// Seconds of the circles' way between two rounds.
const STEP_S: f64 = 0.1;

/// Times every method.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let size = size.unwrap_or(SIZE);
    let pool = parallel::pool(threads)?;
    let (mut room, mut frame) = (Room::default(), Frame::default());
    let mut times_ms = vec![Vec::new(); Method::ALL.len()];
    for round in 0..=ROUNDS {
        for (method, times_ms) in Method::ALL.into_iter().zip(&mut times_ms) {
            let seconds = round as f64 * STEP_S;
            let ms = time_ms(|| pool.install(|| room.render(method, seconds, size.width, size.height, &mut frame)));
            if round > 0 {
                times_ms.push(ms);
            }
        }
    }
    let row = |method: Method, times_ms: &mut Vec<f64>| {
        let ms = quantile(times_ms, 0.5);
        let parallel = matches!(method, Method::LiteralThreads | Method::SpansThreads);
        Row {
            bench: "room",
            variant: method.name().to_string(),
            size: Some(format!("{}x{}", size.width, size.height)),
            threads: if parallel { pool.current_num_threads() } else { 1 },
            ms,
            ns_per_pixel: Some(ms * 1e6 / (size.width * size.height) as f64),
            ms_99th: None,
            times_real_time: None,
        }
    };
    Ok(Method::ALL.into_iter().zip(&mut times_ms).map(|(method, times_ms)| row(method, times_ms)).collect())
}
