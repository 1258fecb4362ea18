//! What it takes to print art, next to what is estimated before: how long a million of the estimate's operations are.
//!
//! Each drawing is the most of one kind; what is estimated too low of any of them would let art in that takes minutes.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::art;
use crate::table::{Table, TableSources};
use crate::{Failure, screen};
use geometry::trig;
use std::f64::consts::TAU;
use tracer::View;

/// The picture that costs are for.
const PICTURE: screen::Size = screen::Size { width: 1080, height: 2160 };

/// How the corners of a path lie.
#[derive(Clone, Copy)]
enum Corners {
    /// There and back along one line.
    Same,
    /// All over the playfield, so that every edge crosses many others.
    Crossing,
    /// Along a spiral, close together.
    Near,
}

/// What is printed: a name, how many corners its path has and how they lie, and the path's attributes.
const PATHS: [(&str, usize, Corners, &str); 18] = [
    ("fill, edges that cross", 4000, Corners::Crossing, ""),
    ("fill, edges that cross", 16_000, Corners::Crossing, ""),
    ("fill, edges on each other", 20_000, Corners::Same, ""),
    ("fill, short edges", 100_000, Corners::Near, ""),
    ("stroke, lines on each other", 20_000, Corners::Same, "fill='none' stroke='red'"),
    ("stroke, lines that cross", 2000, Corners::Crossing, "fill='none' stroke='red'"),
    ("stroke, lines that cross", 8000, Corners::Crossing, "fill='none' stroke='red'"),
    ("stroke, short lines", 100_000, Corners::Near, "fill='none' stroke='red'"),
    ("hairline, lines that cross", 4000, Corners::Crossing, "fill='none' stroke='red' stroke-width='.2'"),
    ("stroke, bevels", 50_000, Corners::Near, "fill='none' stroke='red' stroke-linejoin='bevel'"),
    ("stroke, round joins", 50_000, Corners::Near, "fill='none' stroke='red' stroke-linejoin='round'"),
    ("stroke, wide", 50_000, Corners::Near, "fill='none' stroke='red' stroke-width='20'"),
    (
        "stroke, wide, round joins",
        50_000,
        Corners::Near,
        "fill='none' stroke='red' stroke-width='20' stroke-linejoin='round'",
    ),
    ("stroke, wide, lines that cross", 1000, Corners::Crossing, "fill='none' stroke='red' stroke-width='20'"),
    ("dashes", 1000, Corners::Crossing, "fill='none' stroke='red' stroke-dasharray='2 2'"),
    (
        "dashes, round caps",
        500,
        Corners::Crossing,
        "fill='none' stroke='red' stroke-dasharray='2 4' stroke-linecap='round'",
    ),
    ("dashes, wide", 500, Corners::Crossing, "fill='none' stroke='red' stroke-width='20' stroke-dasharray='3 3'"),
    ("dashes of a curve", 50_000, Corners::Near, "fill='none' stroke='red' stroke-dasharray='1 1'"),
];

/// How long each takes, and what is estimated of it.
///
/// # Errors
/// If one of them cannot be printed.
pub fn rows() -> Result<Vec<Row>, Failure> {
    let sheet = "<rect width='500' height='1000' fill='red' fill-opacity='.01'/>";
    let sheets = [("sheets".to_string(), sheet.repeat(200)), ("a blur".to_string(), blur())];
    let paths = PATHS.iter().map(|&(name, count, corners, attributes)| {
        (format!("{name}, {count}"), format!("<path d='{}' {attributes}/>", path(count, corners)))
    });
    let (nothing, _) = printed("")?;
    let row = |(variant, drawn): (String, String)| {
        let (ms, mops) = printed(&drawn)?;
        Ok(Row {
            bench: "art",
            variant,
            size: Some(format!("{}x{}", PICTURE.width, PICTURE.height)),
            threads: 1,
            ms: ms - nothing,
            mops: Some(mops),
            ..Row::default()
        })
    };
    sheets.into_iter().chain(paths).map(row).collect()
}

fn blur() -> String {
    "<filter id='f'><feGaussianBlur stdDeviation='20'/></filter><rect width='500' height='1000' filter='url(#f)'/>"
        .to_string()
}

/// Milliseconds that it takes to print `drawn` on a table, and million operations that are estimated.
fn printed(drawn: &str) -> Result<(f64, f64), Failure> {
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 500 1000'>\
         <line id='f' class='flipper' data-side='left' data-up-deg='50' x1='150' y1='850' x2='210' y2='885'/>\
         <line class='drain' x1='100' y1='980' x2='400' y2='980' stroke-width='20'/>\
         <line class='plunger' x1='480' y1='900' x2='480' y2='950' stroke-width='24'/>{drawn}</svg>"
    );
    let (name, origin, folder) = ("art".to_string(), String::new(), String::new());
    let files = [svg.as_str(), "", ""].map(|text| Ok(text.as_bytes().to_vec()));
    let table = Table::parse(TableSources { name, origin, folder, files }).map_err(Failure::of_many)?;
    let cost = art::check(&table)?;
    let view = View::fit(PICTURE.width, PICTURE.height, table.size_mm);
    let mut floor = Ok(());
    let mut print = || time_ms(|| floor = art::floor(&table, &view).map(|_| ()));
    let ms = quantile(&mut [print(), print(), print()], 0.5);
    floor.map(|()| (ms, cost.operations * 1e-6))
}

/// The data of a path with so many corners.
fn path(count: usize, corners: Corners) -> String {
    let at = |i: usize| match corners {
        Corners::Same => [[20.0, 20.0], [480.0, 980.0]][i % 2],
        // Steps of two irrational parts of the playfield come to every place of it.
        Corners::Crossing => [part(i, 0.618_034) * 500.0, part(i, 0.754_878) * 1000.0],
        Corners::Near => {
            let turn = TAU * i as f64 / 400.0;
            let radius = 20.0 + 220.0 * i as f64 / count as f64;
            let way = trig::direction(turn);
            [250.0 + radius * way.x, 500.0 + 2.0 * radius * way.y]
        }
    };
    let points = (0..count).map(at).map(|[x, y]| format!("{x:.3} {y:.3}"));
    format!("M{}", points.collect::<Vec<_>>().join("L"))
}

fn part(i: usize, step: f64) -> f64 {
    (i as f64 * step).fract()
}
