//! Pictures: the same bytes on any number of threads, at every size, of every moment.

use game::hud::Chrome;
use game::picture::placement::Placement;
use game::picture::{Moment, Picture};
use game::{Buttons, Simulation, Snapshot, Table};
use std::sync::{Arc, OnceLock};

fn table() -> Arc<Table> {
    static TABLE: OnceLock<Arc<Table>> = OnceLock::new();
    TABLE.get_or_init(|| Arc::new(Table::load("spectrum").expect("the table of the project is whole"))).clone()
}

fn picture(threads: usize) -> Picture {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    Picture::new(table(), pool).expect("a picture")
}

/// A game in its first second: a ball in the lane, lamps alight.
fn moment() -> Snapshot {
    let mut simulation = Simulation::new(table(), 7).expect("the rules run");
    for tick in 0..1500 {
        let start = (100..200).contains(&tick);
        simulation.tick(if start { Buttons::START } else { Buttons::NONE });
    }
    simulation.snapshot()
}

fn pixels(picture: &mut Picture, snapshot: &Snapshot, width: usize, height: usize) -> Vec<u32> {
    let frame = picture.draw(Moment::at(snapshot), width, height, &Chrome::default()).expect("it can be drawn");
    assert_eq!((frame.width, frame.height), (width, height));
    frame.pixels.clone()
}

#[test]
fn one_thread_and_three_draw_the_same_bytes() {
    let moment = moment();
    assert!(pixels(&mut picture(1), &moment, 150, 300) == pixels(&mut picture(3), &moment, 150, 300));
}

#[test]
fn a_picture_does_not_depend_on_the_pictures_before_it() {
    let (dark, lit) = (Snapshot::default(), moment());
    let mut used = picture(2);
    for (width, height) in [(90, 180), (200, 120)] {
        pixels(&mut used, &dark, width, height);
        pixels(&mut used, &lit, width, height);
    }
    // The cabinet is pushed and comes back.
    let mut pushed = lit.clone();
    pushed.pose.cabinet_m.x = 0.03;
    pixels(&mut used, &pushed, 90, 180);
    assert!(pixels(&mut used, &lit, 90, 180) == pixels(&mut picture(2), &lit, 90, 180));
}

#[test]
fn no_size_is_too_small_or_too_odd() {
    let moment = moment();
    let mut picture = picture(2);
    for (width, height) in [(64, 64), (65, 301), (301, 65), (64, 200), (177, 99), (1, 1), (3, 200), (200, 3)] {
        pixels(&mut picture, &moment, width, height);
    }
}

#[test]
fn a_push_moves_the_playfield_and_not_the_display() {
    let still = moment();
    let mut pushed = still.clone();
    pushed.pose.cabinet_m.x = 0.012;
    let mut picture = picture(2);
    let (width, height) = (216, 432);
    let (a, b) = (pixels(&mut picture, &still, width, height), pixels(&mut picture, &pushed, width, height));
    let placement = Placement::new(width, height, table().size_mm);
    let rows = |rows: std::ops::Range<usize>| {
        a[rows.start * width..rows.end * width] == b[rows.start * width..rows.end * width]
    };
    assert!(rows(0..placement.well.y as usize), "the display stands still");
    assert!(!rows(placement.table.y as usize..height), "the playfield moves");
}

#[test]
fn between_two_ticks_lies_another_picture_and_at_their_ends_their_own() {
    let previous = moment();
    let mut current = previous.clone();
    current.tick += 1;
    current.pose.balls.iter_mut().for_each(|ball| ball.center.y -= 0.02);
    assert!(!current.pose.balls.is_empty(), "a ball lies in the lane");
    let mut picture = picture(2);
    let mut at = |alpha: f64| {
        let moment = Moment { previous: &previous, current: &current, alpha };
        picture.draw(moment, 120, 240, &Chrome::default()).expect("it can be drawn").pixels.clone()
    };
    let (start, middle, end) = (at(0.0), at(0.5), at(1.0));
    assert!(start != middle && middle != end);
    assert!(end == pixels(&mut self::picture(2), &current, 120, 240));
}
