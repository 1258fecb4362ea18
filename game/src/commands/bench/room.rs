//! The classic race: a room of 5 x 5, three circles of radius 1 that move, a point lamp in each corner, every frame
//! computed from nothing.
//!
//! Every method makes a frame in turn, so that a slow moment of the machine is everybody's. What a row is worth is told
//! by the memset beside it, which writes the same bytes on as many threads, and by how far its pictures are from those
//! of the literal loops.
//!
//! One frame that is written again and again stays in the processor's cache. The frames of a window or of an encoder do
//! not, so everything is timed a second time with a ring of frames that together are larger than a cache.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::Failure;
use crate::commands::parallel;
use crate::screen::Size;
use rayon::ThreadPool;
use shadow_race::{Method, RaceRenderer, Threads};
use tracer::Frame;

/// The size that is quoted.
const SIZE: Size = Size { width: 1920, height: 1080 };

/// Rounds that are timed, after one to warm up.
const ROUNDS: usize = 31;

/// Seconds of the circles' motion between two rounds.
const STEP_S: f64 = 0.1;

/// Pictures that are compared with the literal ones, spread over the rounds.
const COMPARED: usize = 8;

/// What a ring of frames takes up at least, bytes: a last-level cache of a few ten million holds no frame until its
/// turn comes again. At 1920x1080 it is 12 frames.
const RING_BYTES: usize = 96_000_000;

/// Times every method, on one thread and on all, with one frame and with a ring of them.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let size = size.unwrap_or(SIZE);
    let pool = parallel::pool(threads)?;
    let racers: Vec<_> =
        Method::ALL.into_iter().flat_map(|method| [(method, Threads::One), (method, Threads::All)]).collect();
    let mut track =
        Track { pool: &pool, renderer: RaceRenderer::default(), frames: vec![Frame::new(size.width, size.height)] };
    let distances = track.distances(&racers);
    let cached = rows_of(&racers, &track.times_ms(&racers), size, &pool);
    let cached = cached.into_iter().zip(racers.iter().zip(&distances)).map(|(row, ((method, _), distance))| Row {
        most_levels_off: (*method != Method::Memset).then_some(distance.most_levels),
        pixels_off: (*method != Method::Memset).then_some(distance.pixels),
        ..row
    });
    track.frames = vec![track.frames[0].clone(); ring_length(size)];
    let in_memory = rows_of(&racers, &track.times_ms(&racers), size, &pool);
    let in_memory =
        in_memory.into_iter().map(|row| Row { variant: format!("{}, frames in memory", row.variant), ..row });
    Ok(cached.chain(in_memory).collect())
}

/// How many frames a ring has.
fn ring_length(size: Size) -> usize {
    RING_BYTES.div_ceil(size.width * size.height * size_of::<u32>())
}

/// A row for each racer's time, with the memset among them as the floor.
fn rows_of(racers: &[(Method, Threads)], times_ms: &[f64], size: Size, pool: &ThreadPool) -> Vec<Row> {
    let memset_ms = |threads| {
        let place =
            racers.iter().position(|racer| *racer == (Method::Memset, threads)).expect("a memset is among the ways");
        times_ms[place]
    };
    let row = |(&(method, threads), &ms): (&(Method, Threads), &f64)| Row {
        bench: "room",
        variant: method.name().to_string(),
        size: Some(format!("{}x{}", size.width, size.height)),
        threads: if threads == Threads::All { pool.current_num_threads() } else { 1 },
        ms,
        ns_per_pixel: Some(ms * 1e6 / (size.width * size.height) as f64),
        times_memset: Some(ms / memset_ms(threads)),
        ..Row::default()
    };
    racers.iter().zip(times_ms).map(row).collect()
}

/// How far pictures are from the literal ones.
#[derive(Clone, Copy, Debug, Default)]
struct Distance {
    /// The largest difference in a byte.
    most_levels: u8,
    /// Pixels with a difference of more than one level.
    pixels: usize,
}

impl Distance {
    fn add(&mut self, expected: &Frame, got: &Frame) {
        for (expected, got) in expected.pixels.iter().zip(&got.pixels) {
            let levels = expected.to_le_bytes().into_iter().zip(got.to_le_bytes()).map(|(a, b)| a.abs_diff(b));
            let levels = levels.max().unwrap_or(0);
            self.most_levels = self.most_levels.max(levels);
            self.pixels += usize::from(levels > 1);
        }
    }
}

/// Where the race is run.
struct Track<'a> {
    pool: &'a ThreadPool,
    renderer: RaceRenderer,
    /// They are written in turn: the first is the one written last, the second is the next.
    frames: Vec<Frame>,
}

impl Track<'_> {
    /// Makes a picture in the next frame, and says in how many ms.
    fn run(&mut self, (method, threads): (Method, Threads), round: usize) -> f64 {
        let seconds = round as f64 * STEP_S;
        self.frames.rotate_left(1);
        let (renderer, frame) = (&mut self.renderer, &mut self.frames[0]);
        time_ms(|| match threads {
            Threads::One => renderer.render(method, threads, seconds, frame),
            Threads::All => self.pool.install(|| renderer.render(method, threads, seconds, frame)),
        })
    }

    fn distances(&mut self, racers: &[(Method, Threads)]) -> Vec<Distance> {
        let mut distances = vec![Distance::default(); racers.len()];
        for round in (0..ROUNDS).step_by(ROUNDS.div_ceil(COMPARED)) {
            self.run((Method::Literal, Threads::One), round);
            let expected = self.frames[0].clone();
            for (&racer, distance) in racers.iter().zip(&mut distances) {
                self.run(racer, round);
                distance.add(&expected, &self.frames[0]);
            }
        }
        distances
    }

    /// Every racer's median.
    fn times_ms(&mut self, racers: &[(Method, Threads)]) -> Vec<f64> {
        let mut times_ms = vec![Vec::new(); racers.len()];
        for round in 0..=ROUNDS {
            for (&racer, times_ms) in racers.iter().zip(&mut times_ms) {
                let ms = self.run(racer, round);
                if round > 0 {
                    times_ms.push(ms);
                }
            }
        }
        times_ms.iter_mut().map(|times_ms| quantile(times_ms, 0.5)).collect()
    }
}
