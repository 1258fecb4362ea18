//! The baked indirect light of a table: how long a bake takes, and how far it is from photons.

use super::Row;
use super::clock::time_ms;
use super::levels::{Difference, apart, levels};
use crate::commands::parallel;
use crate::rendering::table_scene;
use crate::scene_builder::{RasterizedArt, SceneBuilder};
use crate::storage::tables;
use crate::{Failure, Table};
use geometry::{Bounds, DVec2};
use std::sync::Arc;
use tracer::View;
use tracer::transport::bake::{Bake, BakeOptions, bake};
use tracer::transport::spectrum::Weights;
use tracer::transport::{PhotonPicture, PhotonTracer, Scene};

/// Pixels of the pictures that are compared, mm.
const PIXEL_MM: f64 = 8.0;

/// Packets of the converged pictures; the noise of their halves is told.
const PACKETS: u64 = 1 << 22;

/// Points along a side of a pixel in which a bake is asked.
const POINTS: usize = 8;

/// Pixels across that are timed.
const TIMED: (usize, usize) = (540, 1080);

/// A table's light, lamp by lamp.
struct TableLight {
    scene: Scene,
    colors: Vec<[f64; 3]>,
    size_mm: DVec2,
}

/// Bakes the Spectrum table and compares it with photons.
///
/// # Errors
/// If the table cannot be read.
pub fn rows(threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let table = Arc::new(tables::load("spectrum").map_err(Failure::of_many)?);
    let light = light(&table)?;
    let pool = parallel::pool(threads)?;
    let threads = pool.current_num_threads();
    pool.install(|| measured(&light, threads))
}

fn light(table: &Arc<Table>) -> Result<TableLight, Failure> {
    let snapshot = super::table::snapshots(table, 1)?.pop().ok_or_else(|| Failure::new("the bot has not played"))?;
    let view = View::fit(28, 56, table.size_mm);
    let art = RasterizedArt::new(table, &view)?;
    let (scene, colors) = table_scene(&SceneBuilder::new(table).scene(table, &snapshot, view, &art));
    Ok(TableLight { scene, colors, size_mm: table.size_mm })
}

fn measured(light: &TableLight, threads: usize) -> Result<Vec<Row>, Failure> {
    let region = Bounds { min: DVec2::ZERO, max: light.size_mm };
    let options = BakeOptions::over(region);
    let weights = Weights::equal_energy();
    let mut made = None;
    let bake_ms = time_ms(|| made = bake(&light.scene, &weights, &options, &|_, _| true));
    let baked = made.ok_or_else(|| Failure::new("the bake has stopped"))?;
    let (width, height) = TIMED;
    let view = View::fit(width, height, light.size_mm);
    let frame_ms = time_ms(|| drop(picture(&baked, &light.colors, &view, 1)));
    let mut bytes = Vec::new();
    let write_ms = time_ms(|| bytes = baked.to_bytes());
    let mut read = Err(String::new());
    let read_ms = time_ms(|| read = Bake::from_bytes(&bytes, &light.scene, &weights));
    read.map_err(Failure::new)?;
    let row = |variant: String, ms: f64| Row { bench: "bake", variant, threads, ms, ..Row::default() };
    let (lamps, walls) = (baked.layers(), light.scene.bodies.len());
    let mut rows = vec![
        row(format!("{lamps} lamps, {walls} walls"), bake_ms),
        row(format!("a frame from it, {width}x{height}"), frame_ms),
        row(format!("written, {} bytes", bytes.len()), write_ms),
        row("read".to_string(), read_ms),
    ];
    let mut compared = Row::default();
    let ms = time_ms(|| compared = compare(light, &baked, &options));
    rows.push(Row { ms, threads, ..compared });
    Ok(rows)
}

/// How far the bake is from converged photons on a screen, the straight light in both.
fn compare(light: &TableLight, baked: &Bake, options: &BakeOptions) -> Row {
    let pixels = (light.size_mm / PIXEL_MM).floor();
    let view =
        View { width: pixels.x as usize, height: pixels.y as usize, origin_mm: DVec2::ZERO, mm_per_px: PIXEL_MM };
    let mut lit = light.scene.clone();
    for (source, color) in lit.sources.iter_mut().zip(&light.colors) {
        source.emission = tracer::transport::spectrum::Emission::Color(*color);
    }
    let photons = |seed: u64, most_surfaces: u32| {
        let tracer = PhotonTracer::new(&lit, Weights::equal_energy(), seed).with_most_surfaces(most_surfaces);
        let mut picture = PhotonPicture::new(tracer, view);
        picture.expose(PACKETS / 2);
        picture.fluence()
    };
    // The straight piece of each way, and one from each wall.
    let halves = [1, 2].map(|seed| {
        let (all, straight) = (photons(seed, options.bounces + 1), photons(seed, 1));
        let indirect: Vec<[f64; 3]> = combined(&all, &straight, |all, straight| all - straight);
        (straight, indirect)
    });
    let [(one, a), (other, b)] = &halves;
    let (direct, indirect) = (combined(one, other, mean), combined(a, b, mean));
    let own = picture(baked, &light.colors, &view, POINTS);
    let screen = |indirect: &[[f64; 3]]| levels(&combined(&direct, indirect, |a, b| a + b));
    let Difference { most, rms, pixels } = apart(&screen(&own), &screen(&indirect));
    let noise = 0.5 * apart(&screen(a), &screen(b)).rms;
    Row {
        bench: "bake",
        variant: format!("against photons: rms {rms:.3} levels, noise {noise:.3}"),
        size: Some(format!("{}x{}", view.width, view.height)),
        most_levels_off: Some(most),
        pixels_off: Some(pixels),
        ..Row::default()
    }
}

fn mean(a: f64, b: f64) -> f64 {
    0.5 * (a + b)
}

fn combined(one: &[[f64; 3]], other: &[[f64; 3]], with: impl Fn(f64, f64) -> f64) -> Vec<[f64; 3]> {
    one.iter().zip(other).map(|(one, other)| std::array::from_fn(|at| with(one[at], other[at]))).collect()
}

/// The bake in the pixels' means over so many points along a side.
fn picture(baked: &Bake, colors: &[[f64; 3]], view: &View, points: usize) -> Vec<[f64; 3]> {
    use rayon::prelude::*;
    let mixed = baked.mixed(colors);
    let pixel = |at: usize| {
        let mut sum = [0.0; 3];
        for part in 0..points * points {
            let offset = DVec2::new((part % points) as f64 + 0.5, (part / points) as f64 + 0.5) / points as f64;
            let place = DVec2::new((at % view.width) as f64, (at / view.width) as f64) + offset;
            let light = mixed.fluence(view.origin_mm + place * view.mm_per_px);
            (0..3).for_each(|channel| sum[channel] += light[channel] / (points * points) as f64);
        }
        sum
    };
    (0..view.width * view.height).into_par_iter().map(pixel).collect()
}
