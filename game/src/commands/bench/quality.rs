//! How exact the light is: the lanes against 16,384 shadow rays a lamp, and whether that is good enough.

use super::table;
use crate::Failure;
use crate::commands::parallel;
use crate::commands::print::print_lines;
use crate::scene_builder::{RasterizedArt, SceneBuilder};
use crate::storage::tables;
use serde::Serialize;
use std::sync::Arc;
use tracer::quality::{MOST_DIFFERENCE, MOST_FLIP, MOST_RMSE, Quality, SAMPLES, judge};
use tracer::{Scene, View, scenes};

/// Points of a jumble that are compared; there are many jumbles.
const FEW: usize = 160;

/// Points of a table.
const MANY: usize = 400;

/// One scene's figures, in linear light and mean FLIP.
#[derive(Clone, Debug, Serialize)]
struct Row {
    scene: String,
    points: usize,
    rmse: f64,
    maximum: f64,
    flip: f64,
    passes: bool,
}

impl Row {
    fn new(scene: String, quality: Quality) -> Row {
        let Quality { points, rmse, maximum, flip, .. } = quality;
        Row { scene, points, rmse, maximum, flip: flip.unwrap_or(f64::NAN), passes: quality.passes() }
    }
}

/// Judges every scene and prints the figures.
///
/// # Errors
/// If the table cannot be read, or a scene does not pass.
pub fn run(threads: Option<usize>, json: bool) -> Result<(), Failure> {
    let rows = parallel::pool(threads)?.install(rows)?;
    let text = if json { serde_json::to_string_pretty(&rows).expect("plain numbers are JSON") } else { text(&rows) };
    print_lines(text.lines())?;
    let failed: Vec<&str> = rows.iter().filter(|row| !row.passes).map(|row| row.scene.as_str()).collect();
    if failed.is_empty() { Ok(()) } else { Err(Failure::new(format!("not exact enough: {}", failed.join(", ")))) }
}

fn rows() -> Result<Vec<Row>, Failure> {
    let mut rows = vec![made_up_table(), played_table()?];
    let (floor, small) = (scenes::white(250, 250), scenes::white(40, 40));
    let room = shadow_race::tracer_scene(1.3, &floor);
    rows.push(Row::new("room".to_string(), judge(&room, Some(&shadow_race::tracer_scene(1.3, &small)), MANY, 1)));
    let (floor, small) = (scenes::white(160, 160), scenes::white(16, 16));
    for seed in 0..20 {
        let scene = scenes::mixed_jumble(seed, &floor);
        let view = View { width: 16, height: 16, mm_per_px: 10.0, ..scene.view };
        let small = Scene { view, floor: &small, ..scene.clone() };
        rows.push(Row::new(format!("jumble {seed}"), judge(&scene, Some(&small), FEW, seed)));
    }
    Ok(rows)
}

/// A view for points, and a small one to look at.
fn views(size_mm: geometry::DVec2) -> [View; 2] {
    [(270, 540), (28, 56)].map(|(width, height)| View::fit(width, height, size_mm))
}

fn made_up_table() -> Row {
    let [view, small] = views(scenes::SIZE_MM);
    let [props, small_props] = [view, small].map(|view| scenes::props(&view));
    let (scene, small) = (scenes::table(view, &props), scenes::table(small, &small_props));
    Row::new("made-up table".to_string(), judge(&scene, Some(&small), MANY, 1))
}

fn played_table() -> Result<Row, Failure> {
    let table = Arc::new(tables::load("spectrum").map_err(Failure::of_many)?);
    let snapshot = table::snapshots(&table, 1)?.pop().ok_or_else(|| Failure::new("the bot has not played"))?;
    let builder = SceneBuilder::new(&table);
    let [view, small] = views(table.size_mm);
    let (art, small_art) = (RasterizedArt::new(&table, &view)?, RasterizedArt::new(&table, &small)?);
    let scene = builder.scene(&table, &snapshot, view, &art);
    let small = builder.scene(&table, &snapshot, small, &small_art);
    Ok(Row::new("spectrum in play".to_string(), judge(&scene, Some(&small), MANY, 1)))
}

fn text(rows: &[Row]) -> String {
    let mut text = format!("{:18} {:>6} {:>10} {:>10} {:>10}\n", "scene", "points", "RMSE", "maximum", "FLIP mean");
    for Row { scene, points, rmse, maximum, flip, passes } in rows {
        let verdict = if *passes { "passes" } else { "FAILS" };
        text += &format!("{scene:18} {points:>6} {rmse:>10.2e} {maximum:>10.2e} {flip:>10.2e}  {verdict}\n");
    }
    text += &format!(
        "The gate, linear light against {SAMPLES} rays a lamp: RMSE {MOST_RMSE}, maximum {MOST_DIFFERENCE}, FLIP \
         {MOST_FLIP}.\n"
    );
    text
}
