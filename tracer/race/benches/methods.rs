//! The race's methods one by one, at three sizes: `cargo bench -p shadow-race --bench methods`. The counter is pixels,
//! so its gigaitems a second are pixels a nanosecond.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use shadow_race::{Method, RaceRenderer, Threads};
use tracer::Frame;

/// Widths and heights.
const SIZES: [(usize, usize); 3] = [(512, 512), (1920, 1080), (3840, 2160)];

/// Seconds of the circles' motion between two pictures.
const STEP_S: f64 = 0.1;

fn main() {
    divan::main();
}

#[divan::bench(args = SIZES, sample_count = 10)]
fn literal(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Literal, Threads::One, size);
}

#[divan::bench(args = SIZES, sample_count = 10)]
fn literal_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Literal, Threads::All, size);
}

#[divan::bench(args = SIZES)]
fn simd(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Simd, Threads::One, size);
}

#[divan::bench(args = SIZES)]
fn simd_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Simd, Threads::All, size);
}

#[divan::bench(args = SIZES)]
fn spans(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Spans, Threads::One, size);
}

#[divan::bench(args = SIZES)]
fn spans_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Spans, Threads::All, size);
}

#[divan::bench(args = SIZES)]
fn memset(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Memset, Threads::One, size);
}

#[divan::bench(args = SIZES)]
fn memset_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Method::Memset, Threads::All, size);
}

fn race(bencher: Bencher, method: Method, threads: Threads, (width, height): (usize, usize)) {
    let (mut renderer, mut frame) = (RaceRenderer::default(), Frame::new(width, height));
    let mut seconds = 0.0;
    bencher.counter(ItemsCount::new(width * height)).bench_local(|| {
        seconds += STEP_S;
        renderer.render(method, threads, seconds, &mut frame);
        black_box(&mut frame);
    });
}
