//! The room's ways one by one, at three sizes: `cargo bench -p shadow-race --bench methods`. The counter is pixels, so its
//! gigaitems a second are pixels a nanosecond.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use shadow_race::{Room, Threads, Way};
use tracer::Frame;

/// Widths and heights.
const SIZES: [(usize, usize); 3] = [(512, 512), (1920, 1080), (3840, 2160)];

/// Seconds of the circles' way between two pictures.
const STEP_S: f64 = 0.1;

fn main() {
    divan::main();
}

#[divan::bench(args = SIZES, sample_count = 10)]
fn literal(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::Literal, Threads::One, size);
}

#[divan::bench(args = SIZES, sample_count = 10)]
fn literal_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::Literal, Threads::All, size);
}

#[divan::bench(args = SIZES)]
fn lane_wise(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::LaneWise, Threads::One, size);
}

#[divan::bench(args = SIZES)]
fn lane_wise_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::LaneWise, Threads::All, size);
}

#[divan::bench(args = SIZES)]
fn spans(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::Spans, Threads::One, size);
}

#[divan::bench(args = SIZES)]
fn spans_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::Spans, Threads::All, size);
}

#[divan::bench(args = SIZES)]
fn fill(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::Fill, Threads::One, size);
}

#[divan::bench(args = SIZES)]
fn fill_all_threads(bencher: Bencher, size: (usize, usize)) {
    race(bencher, Way::Fill, Threads::All, size);
}

fn race(bencher: Bencher, way: Way, threads: Threads, (width, height): (usize, usize)) {
    let (mut room, mut frame) = (Room::default(), Frame::new(width, height));
    let mut seconds = 0.0;
    bencher.counter(ItemsCount::new(width * height)).bench_local(|| {
        seconds += STEP_S;
        room.render(way, threads, seconds, &mut frame);
        black_box(&mut frame);
    });
}
