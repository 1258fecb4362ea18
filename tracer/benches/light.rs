//! How the exact light grows with what is in a scene: pixels, lamps, occluders, balls; from nothing (cold) and with
//! what the last picture has left (warm, every ball a little farther), on every instruction set of this machine.
//!
//! `cargo bench -p tracer --bench light`

use divan::Bencher;
use geometry::DVec2;
use tracer::scenes::{self, Props};
use tracer::{Radiance, Renderer, Scene, SimdLevel, View};

fn main() {
    divan::main();
}

/// The paths of this machine, by name.
fn paths() -> Vec<&'static str> {
    SimdLevel::available().into_iter().map(SimdLevel::name).collect()
}

fn path(name: &str) -> SimdLevel {
    SimdLevel::available().into_iter().find(|path| path.name() == name).unwrap_or(SimdLevel::best())
}

/// The made-up table at the size that figures are quoted at.
fn table(props: &mut Props, width: usize) -> Scene<'_> {
    let view = View::fit(width, 2 * width, scenes::SIZE_MM);
    *props = scenes::props(&view);
    scenes::table(view, props)
}

/// Renders from nothing again and again.
fn cold(bencher: Bencher, path: SimdLevel, scene: &Scene) {
    let (mut renderer, mut radiance) = (Renderer::on(path), Radiance::default());
    bencher.bench_local(|| {
        renderer.invalidate();
        renderer.render(scene, &mut radiance);
    });
}

/// Renders again and again, the balls rolling to and fro.
fn warm(bencher: Bencher, path: SimdLevel, scene: &mut Scene) {
    let (mut renderer, mut radiance) = (Renderer::on(path), Radiance::default());
    renderer.render(scene, &mut radiance);
    let mut step = DVec2::new(1.5, -2.0);
    bencher.bench_local(|| {
        scenes::roll(scene, step);
        step = -step;
        renderer.render(scene, &mut radiance);
    });
}

#[divan::bench(args = paths())]
fn cold_by_path(bencher: Bencher, name: &str) {
    let mut props = Props::default();
    cold(bencher, path(name), &table(&mut props, 540));
}

#[divan::bench(args = paths())]
fn warm_by_path(bencher: Bencher, name: &str) {
    let mut props = Props::default();
    warm(bencher, path(name), &mut table(&mut props, 540));
}

#[divan::bench(args = [270, 540, 1080])]
fn cold_by_pixels_across(bencher: Bencher, width: usize) {
    let mut props = Props::default();
    cold(bencher, SimdLevel::best(), &table(&mut props, width));
}

#[divan::bench(args = [270, 540, 1080])]
fn warm_by_pixels_across(bencher: Bencher, width: usize) {
    let mut props = Props::default();
    warm(bencher, SimdLevel::best(), &mut table(&mut props, width));
}

#[divan::bench(args = [4, 16, 64])]
fn cold_by_lamps(bencher: Bencher, count: usize) {
    let mut props = Props::default();
    let mut scene = table(&mut props, 540);
    scenes::with_lamps(&mut scene, count);
    cold(bencher, SimdLevel::best(), &scene);
}

#[divan::bench(args = [4, 16, 64])]
fn warm_by_lamps(bencher: Bencher, count: usize) {
    let mut props = Props::default();
    let mut scene = table(&mut props, 540);
    scenes::with_lamps(&mut scene, count);
    warm(bencher, SimdLevel::best(), &mut scene);
}

#[divan::bench(args = [0, 100, 400])]
fn cold_by_more_occluders(bencher: Bencher, count: u16) {
    let mut props = Props::default();
    let mut scene = table(&mut props, 540);
    scenes::with_posts(&mut scene, count);
    cold(bencher, SimdLevel::best(), &scene);
}

#[divan::bench(args = [0, 100, 400])]
fn warm_by_more_occluders(bencher: Bencher, count: u16) {
    let mut props = Props::default();
    let mut scene = table(&mut props, 540);
    scenes::with_posts(&mut scene, count);
    warm(bencher, SimdLevel::best(), &mut scene);
}

#[divan::bench(args = [0, 3, 12])]
fn cold_by_balls(bencher: Bencher, count: u16) {
    let mut props = Props::default();
    let mut scene = table(&mut props, 540);
    scenes::with_balls(&mut scene, count);
    cold(bencher, SimdLevel::best(), &scene);
}

#[divan::bench(args = [0.0, 5.0, 20.0, 70.0])]
fn warm_by_height_of_a_ball(bencher: Bencher, height_mm: f64) {
    let mut props = Props::default();
    let mut scene = table(&mut props, 540);
    scenes::lift(&mut scene, &[height_mm]);
    warm(bencher, SimdLevel::best(), &mut scene);
}

#[divan::bench(args = [0, 3, 12])]
fn warm_by_balls(bencher: Bencher, count: u16) {
    let mut props = Props::default();
    let mut scene = table(&mut props, 540);
    scenes::with_balls(&mut scene, count);
    warm(bencher, SimdLevel::best(), &mut scene);
}
