//! The gate: the exact light against 16,384 stratified shadow rays to every lamp from every point.

use rayon::prelude::*;
use tracer::quality::{Quality, judge};
use tracer::{Scene, View, scenes};

fn passes(what: &str, quality: Quality) {
    assert!(quality.points > 0 && quality.passes(), "{what}: {quality:?}");
}

/// The same scene in fewer pixels.
fn smaller<'a>(scene: &Scene<'a>, floor: &'a tracer::Floor) -> Scene<'a> {
    let shrunk = scene.view.width as f64 / floor.width as f64;
    let view =
        View { width: floor.width, height: floor.height, mm_per_px: scene.view.mm_per_px * shrunk, ..scene.view };
    Scene { view, floor, ..scene.clone() }
}

#[test]
fn the_table_passes() {
    let [view, small] = [(180, 360), (14, 28)].map(|(width, height)| View::fit(width, height, scenes::SIZE_MM));
    let (props, small_props) = (scenes::props(&view), scenes::props(&small));
    let scene = scenes::table(view, &props);
    passes("table", judge(&scene, Some(&scenes::table(small, &small_props)), 60, 1));
}

/// Balls in the air: low and high on the table, and of all sizes among lamps and walls.
#[test]
fn floating_balls_pass() {
    let [view, small] = [(180, 360), (14, 28)].map(|(width, height)| View::fit(width, height, scenes::SIZE_MM));
    let (props, small_props) = (scenes::props(&view), scenes::props(&small));
    let [scene, small] = [(view, &props), (small, &small_props)].map(|(view, props)| {
        let mut scene = scenes::table(view, props);
        scene.lamps.iter_mut().step_by(2).for_each(|lamp| lamp.height_mm = 120.0);
        scenes::lift(&mut scene, &[60.0, 20.0, 0.5]);
        scene
    });
    passes("table", judge(&scene, Some(&small), 60, 3));
    let (floor, small) = (scenes::white(160, 160), scenes::white(10, 10));
    (0..16).into_par_iter().for_each(|seed| {
        let scene = scenes::floating_jumble(seed, &floor);
        let small = (seed % 4 == 0).then(|| smaller(&scene, &small));
        passes(&format!("jumble {seed}"), judge(&scene, small.as_ref(), 60, seed));
    });
}

#[test]
fn twenty_jumbles_pass() {
    let (floor, small) = (scenes::white(160, 160), scenes::white(10, 10));
    (0..20).into_par_iter().for_each(|seed| {
        let scene = scenes::mixed_jumble(seed, &floor);
        let small = (seed % 4 == 0).then(|| smaller(&scene, &small));
        passes(&format!("jumble {seed}"), judge(&scene, small.as_ref(), 40, seed));
    });
}
