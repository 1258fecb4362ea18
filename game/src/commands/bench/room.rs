//! The classic race: a room of 5 x 5, three circles of radius 1 that move, a point lamp in each corner, every frame
//! computed from nothing.
//!
//! Every way makes a frame in turn, so that a slow moment of the machine is everybody's. What a row is worth is told by
//! the memset beside it, which writes the same bytes on as many threads, and by how far its pictures are from those of
//! the literal loops.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::Failure;
use crate::cli::Size;
use crate::commands::parallel;
use rayon::ThreadPool;
use tracer::Frame;
use tracer::room::{Room, Threads, Way};

/// The size that is quoted.
const SIZE: Size = Size { width: 1920, height: 1080 };

/// Rounds that are timed, after one to warm up.
const ROUNDS: usize = 31;

/// Seconds of the circles' way between two rounds.
const STEP_S: f64 = 0.1;

/// Pictures that are compared with the literal ones, spread over the rounds.
const COMPARED: usize = 8;

/// Times every way, on one thread and on all.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let size = size.unwrap_or(SIZE);
    let pool = parallel::pool(threads)?;
    let racers: Vec<_> = Way::ALL.into_iter().flat_map(|way| [(way, Threads::One), (way, Threads::All)]).collect();
    let mut track = Track { pool: &pool, room: Room::default(), frame: Frame::new(size.width, size.height) };
    let distances = track.distances(&racers);
    let times_ms = track.times_ms(&racers);
    let memset_ms = |threads| {
        let place = racers.iter().position(|racer| *racer == (Way::Fill, threads)).expect("a memset is among the ways");
        times_ms[place]
    };
    let row = |((&(way, threads), &ms), distance): ((&(Way, Threads), &f64), &Distance)| Row {
        bench: "room",
        variant: way.name().to_string(),
        size: Some(format!("{}x{}", size.width, size.height)),
        threads: if threads == Threads::All { pool.current_num_threads() } else { 1 },
        ms,
        ns_per_pixel: Some(ms * 1e6 / (size.width * size.height) as f64),
        times_memset: Some(ms / memset_ms(threads)),
        most_levels_off: (way != Way::Fill).then_some(distance.most_levels),
        pixels_off: (way != Way::Fill).then_some(distance.pixels),
        ..Row::default()
    };
    Ok(racers.iter().zip(&times_ms).zip(&distances).map(row).collect())
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
    room: Room,
    frame: Frame,
}

impl Track<'_> {
    fn run(&mut self, (way, threads): (Way, Threads), round: usize) {
        let seconds = round as f64 * STEP_S;
        let (room, frame) = (&mut self.room, &mut self.frame);
        match threads {
            Threads::One => room.render(way, threads, seconds, frame),
            Threads::All => self.pool.install(|| room.render(way, threads, seconds, frame)),
        }
    }

    fn distances(&mut self, racers: &[(Way, Threads)]) -> Vec<Distance> {
        let mut distances = vec![Distance::default(); racers.len()];
        for round in (0..ROUNDS).step_by(ROUNDS.div_ceil(COMPARED)) {
            self.run((Way::Literal, Threads::One), round);
            let expected = self.frame.clone();
            for (&racer, distance) in racers.iter().zip(&mut distances) {
                self.run(racer, round);
                distance.add(&expected, &self.frame);
            }
        }
        distances
    }

    /// Every racer's median.
    fn times_ms(&mut self, racers: &[(Way, Threads)]) -> Vec<f64> {
        let mut times_ms = vec![Vec::new(); racers.len()];
        for round in 0..=ROUNDS {
            for (&racer, times_ms) in racers.iter().zip(&mut times_ms) {
                let ms = time_ms(|| self.run(racer, round));
                if round > 0 {
                    times_ms.push(ms);
                }
            }
        }
        times_ms.iter_mut().map(|times_ms| quantile(times_ms, 0.5)).collect()
    }
}
