//! Pictures: the same bytes on any number of threads, at every size, of every moment.

use game::frame_composer::{FrameComposer, Interpolation, LightResolution};
use game::hud::UiState;
use game::screen::{Placement, Size};
use game::{Buttons, Simulation, Snapshot, Table};
use std::sync::{Arc, OnceLock};

fn table() -> Arc<Table> {
    static TABLE: OnceLock<Arc<Table>> = OnceLock::new();
    TABLE
        .get_or_init(|| Arc::new(game::storage::tables::load("spectrum").expect("the table of the project is whole")))
        .clone()
}

fn composer_on(threads: usize) -> FrameComposer {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    FrameComposer::new(table(), pool).expect("a picture")
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

fn pixels(composer: &mut FrameComposer, snapshot: &Snapshot, width: usize, height: usize) -> Vec<u32> {
    let frame = composer
        .draw(Interpolation::at(snapshot), Size { width, height }, &UiState::default())
        .expect("it can be drawn");
    assert_eq!((frame.width, frame.height), (width, height));
    frame.pixels.clone()
}

#[test]
fn one_thread_and_three_draw_the_same_bytes() {
    let moment = moment();
    assert!(pixels(&mut composer_on(1), &moment, 150, 300) == pixels(&mut composer_on(3), &moment, 150, 300));
}

#[test]
fn a_picture_does_not_depend_on_the_pictures_before_it() {
    let (dark, lit) = (Snapshot::default(), moment());
    let mut used = composer_on(2);
    for (width, height) in [(90, 180), (200, 120)] {
        pixels(&mut used, &dark, width, height);
        pixels(&mut used, &lit, width, height);
    }
    // The cabinet is pushed and comes back.
    let mut pushed = lit.clone();
    pushed.pose.cabinet_m.x = 0.03;
    pixels(&mut used, &pushed, 90, 180);
    assert!(pixels(&mut used, &lit, 90, 180) == pixels(&mut composer_on(2), &lit, 90, 180));
}

#[test]
fn no_size_is_too_small_or_too_odd() {
    let moment = moment();
    let mut composer = composer_on(2);
    for (width, height) in [(64, 64), (65, 301), (301, 65), (64, 200), (177, 99), (1, 1), (3, 200), (200, 3)] {
        pixels(&mut composer, &moment, width, height);
    }
}

#[test]
fn a_push_moves_the_playfield_and_not_the_display() {
    let still = moment();
    let mut pushed = still.clone();
    pushed.pose.cabinet_m.x = 0.012;
    let mut composer = composer_on(2);
    let (width, height) = (216, 432);
    let (a, b) = (pixels(&mut composer, &still, width, height), pixels(&mut composer, &pushed, width, height));
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
    let mut composer = composer_on(2);
    let mut at = |alpha: f64| {
        let interpolation = Interpolation { previous: &previous, current: &current, alpha };
        composer
            .draw(interpolation, Size { width: 120, height: 240 }, &UiState::default())
            .expect("it can be drawn")
            .pixels
            .clone()
    };
    let (start, middle, end) = (at(0.0), at(0.5), at(1.0));
    assert!(start != middle && middle != end);
    assert!(end == pixels(&mut composer_on(2), &current, 120, 240));
}

#[test]
fn at_half_the_light_and_close_by_the_bytes_are_the_same_on_any_threads_and_after_any_picture() {
    let (dark, lit) = (Snapshot::default(), moment());
    let close = |threads: usize| {
        let mut composer = composer_on(threads);
        composer.set_light_resolution(LightResolution::Half);
        composer.set_zoom(1.5);
        composer
    };
    let expected = pixels(&mut close(1), &lit, 150, 300);
    let mut used = close(3);
    used.set_light_resolution(LightResolution::Full);
    pixels(&mut used, &lit, 150, 300);
    used.set_light_resolution(LightResolution::Half);
    pixels(&mut used, &dark, 90, 180);
    pixels(&mut used, &dark, 150, 300);
    assert!(pixels(&mut used, &lit, 150, 300) == expected, "the camera goes there at once, and nothing is left over");
    assert!(expected != pixels(&mut composer_on(2), &lit, 150, 300));
}

/// A window that follows a ball shows what a window does that looks there first: tiles that come into sight are whole.
#[test]
fn what_comes_into_sight_is_as_if_it_had_always_been_there() {
    let mut moved = moment();
    let mut composer = composer_on(2);
    composer.set_zoom(2.0);
    for step in 0..6 {
        moved.tick += 40;
        moved.pose.balls.iter_mut().for_each(|ball| ball.center.y -= 0.12);
        pixels(&mut composer, &moved, 120, 240);
        let again = pixels(&mut composer, &moved, 120, 240);
        // Another size in between: everything is drawn anew, from where the camera is.
        pixels(&mut composer, &moved, 90, 180);
        assert!(again == pixels(&mut composer, &moved, 120, 240), "step {step}");
    }
}

#[test]
fn no_size_is_too_small_or_too_odd_for_a_zoom_or_for_half_the_light() {
    let moment = moment();
    let mut composer = composer_on(2);
    composer.set_light_resolution(LightResolution::Half);
    for (zoom, width, height) in
        [(4.0, 64, 64), (1.3, 65, 301), (3.9, 301, 65), (1.0, 1, 1), (4.0, 1, 1), (2.0, 3, 200)]
    {
        composer.set_zoom(zoom);
        pixels(&mut composer, &moment, width, height);
    }
}

/// Eyes get used to the light, and the exposure with them: the same lamps look darker after a bright while than after a dark
/// one.
#[test]
fn the_film_follows_the_light_that_eyes_have_got_used_to() {
    let mut simulation = Simulation::new(table(), 7).expect("the rules run");
    let usual = simulation.snapshot().adaptation;
    (0..4000).for_each(|_| simulation.tick(Buttons::NONE));
    let adapted = simulation.snapshot();
    assert!(adapted.adaptation.light() < 0.9 * usual.light(), "attract mode is dark: {}", adapted.adaptation.light());
    let plain = Snapshot { adaptation: usual, ..adapted.clone() };
    let sum = |pixels: Vec<u32>| pixels.iter().map(|pixel| u64::from(pixel >> 8 & 255)).sum::<u64>();
    let mut composer = composer_on(2);
    assert!(sum(pixels(&mut composer, &adapted, 90, 180)) > sum(pixels(&mut composer, &plain, 90, 180)));
}

/// At another resolution of light the picture stood still for 0.4 s, in which the art was printed anew.
#[test]
fn no_picture_waits_for_what_is_prepared_beside_it() {
    let (moment, other) = (moment(), Snapshot::default());
    let size = |width, height| Size { width, height };
    let looks = [
        (size(150, 300), 1.0, LightResolution::Half),
        (size(150, 300), 1.0, LightResolution::Full),
        (size(200, 330), 1.0, LightResolution::Full),
        (size(200, 330), 1.5, LightResolution::Half),
    ];
    let mut before = (size(150, 300), 1.0, LightResolution::Full);
    let mut composer = composer_on(1);
    composer.prepare_beside();
    assert!(drawn(&mut composer, &moment, before) == drawn(&mut composer_on(2), &moment, before));
    for look in looks {
        let (old, new) = (drawn(&mut composer_on(2), &moment, before), drawn(&mut composer_on(2), &moment, look));
        assert!(drawn(&mut composer, &moment, look) == old, "the first picture does not wait");
        while composer.is_preparing() {
            drawn(&mut composer, &other, look);
            std::thread::yield_now();
        }
        assert_eq!(composer.drawn_light(), Some(look.2));
        assert!(drawn(&mut composer, &moment, look) == new, "the new ones are as if they had always been there");
        before = look;
    }
}

/// The frame of a moment, whatever size it has, where a size, a zoom and a resolution of light are asked for.
fn drawn(composer: &mut FrameComposer, snapshot: &Snapshot, look: (Size, f64, LightResolution)) -> tracer::Frame {
    let (size, zoom, light) = look;
    composer.set_zoom(zoom);
    composer.set_light_resolution(light);
    composer.draw(Interpolation::at(snapshot), size, &UiState::default()).expect("it can be drawn").clone()
}
