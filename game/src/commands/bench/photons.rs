//! Photons: path segments traced in a second, with and without the light that they leave on a film, by the fast tracer and by
//! its literal twin.
//!
//! All variants take turns, so that a slow moment of the machine is everybody's. The scene is generated: 200 segments, circles
//! and pieces of glass in a matt room.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::Failure;
use crate::commands::parallel;
use crate::screen::Size;
use rayon::prelude::*;
use tracer::View;
use tracer::literal_photons::LiteralTracer;
use tracer::scenes::{OPTICAL_JUMBLE_MM, optical_jumble};
use tracer::transport::spectrum::Weights;
use tracer::transport::{PhotonPicture, PhotonTracer, Scene};

/// The size that figures are quoted at: a millimetre of the scene a pixel.
const SIZE: Size = Size { width: 540, height: 1080 };

/// What lies in the room.
const THINGS: usize = 200;

/// Rounds that are timed, after one to warm up.
const ROUNDS: usize = 9;

/// Packets of a round: of the fast tracer, and of the literal one.
const PACKETS: u64 = 16_384;
const LITERAL_PACKETS: u64 = 1_024;

/// Packets of a task.
const TASK: u64 = 256;

/// Threads, where nothing is said.
const THREADS: usize = 2;

/// One way of tracing.
struct Variant<'a> {
    name: &'static str,
    threads: usize,
    size: Option<Size>,
    /// Of these the ratio is told: the place of its literal twin.
    twin: Option<usize>,
    /// Traces a round; how many segments it had.
    round: Box<dyn FnMut() -> u64 + 'a>,
}

/// Times every way.
///
/// # Errors
/// If the system gives no threads.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let size = size.unwrap_or(SIZE);
    let scene = optical_jumble(THINGS, 1);
    let (one, all) = (parallel::pool(Some(1))?, parallel::pool(Some(threads.unwrap_or(THREADS)))?);
    let mut variants = variants(&scene, size, &one, &all);
    let mut rates: Vec<Vec<f64>> = vec![Vec::new(); variants.len()];
    let mut times_ms = rates.clone();
    for round in 0..=ROUNDS {
        for (at, variant) in variants.iter_mut().enumerate() {
            let mut segments = 0;
            let ms = time_ms(|| segments = (variant.round)());
            if round > 0 {
                rates[at].push(segments as f64 * 1e-3 / ms);
                times_ms[at].push(ms);
            }
        }
    }
    let rates: Vec<f64> = rates.iter_mut().map(|rates| quantile(rates, 0.5)).collect();
    let row = |(at, variant): (usize, &Variant)| Row {
        bench: "photons",
        variant: variant.name.to_string(),
        size: variant.size.map(|size| format!("{}x{}", size.width, size.height)),
        threads: variant.threads,
        ms: quantile(&mut times_ms[at], 0.5),
        million_segments_a_second: Some(rates[at]),
        times_literal: variant.twin.map(|twin| rates[at] / rates[twin]),
        ..Row::default()
    };
    Ok(variants.iter().enumerate().map(row).collect())
}

/// The literal ways first, then the fast ones.
fn variants<'a>(
    scene: &'a Scene,
    size: Size,
    one: &'a rayon::ThreadPool,
    all: &'a rayon::ThreadPool,
) -> Vec<Variant<'a>> {
    let view = View::fit(size.width, size.height, OPTICAL_JUMBLE_MM);
    let literal = || LiteralTracer::new(scene, Weights::equal_energy(), 1).expect("nothing in the scene is rough");
    let (tracer, splatting) = (literal(), literal());
    let mut sums = vec![[0.0; 3]; view.width * view.height];
    let mut variants = vec![
        Variant {
            name: "literal, traced",
            threads: 1,
            size: None,
            twin: None,
            round: Box::new(move || tracer.trace(LITERAL_PACKETS, |_, _, _, _| {}).segments),
        },
        Variant {
            name: "literal, with splats",
            threads: 1,
            size: Some(size),
            twin: None,
            round: Box::new(move || splatting.expose(&view, LITERAL_PACKETS, &mut sums).segments),
        },
    ];
    for pool in [one, all] {
        let threads = pool.current_num_threads();
        let tracer = PhotonTracer::new(scene, Weights::equal_energy(), 1);
        let trace = move |task: u64| tracer.trace(task * TASK..(task + 1) * TASK, |_, _| {}).segments;
        variants.push(Variant {
            name: "traced",
            threads,
            size: None,
            twin: Some(0),
            round: Box::new(move || pool.install(|| (0..PACKETS / TASK).into_par_iter().map(&trace).sum())),
        });
        let tracer = PhotonTracer::new(scene, Weights::equal_energy(), 1);
        let mut picture = pool.install(|| PhotonPicture::new(tracer, view));
        variants.push(Variant {
            name: "with splats",
            threads,
            size: Some(size),
            twin: Some(1),
            round: Box::new(move || {
                let before = picture.counts().segments;
                pool.install(|| picture.expose(PACKETS));
                picture.counts().segments - before
            }),
        });
    }
    variants
}
