//! Scratches that balls left in the lacquer: they run beside what balls roll along, and else down the table.

use super::heights::Heights;
use super::noise;
use crate::table::Table;
use geometry::{Bounds, DVec2, Shape, trig};
use rayon::prelude::*;
use tiny_skia::{Color, LineCap, Paint, PathBuilder, Pixmap, Stroke, Transform};
use tracer::View;

/// One scratch at most begins in each square of this side, mm.
const CELL_MM: f64 = 9.0;
/// The most squares; those of a huge table are larger.
const MOST_CELLS: f64 = 20_000.0;
/// The length of a straight piece, mm.
const STEP_MM: f64 = 2.5;
/// The width and the depth of the deepest, mm.
const WIDTH_MM: f64 = 0.22;
const DEPTH_MM: f32 = 0.11;
/// How far from a wall a ball's middle is, and how far that wall still guides it, mm.
const BESIDE_MM: f64 = 13.5;
const GUIDED_MM: f64 = 45.0;
/// Walls near a scratch that are looked at.
const MOST_WALLS: usize = 48;

/// A scratch: its corners, mm, and its depth, 0 to 1.
struct Scratch {
    corners_mm: Vec<DVec2>,
    depth: f32,
}

/// The heights of the scratches; `None` if the table has none.
pub(super) fn heights(table: &Table, view: &View) -> Option<Heights> {
    let scratches = scratches(table);
    if scratches.is_empty() {
        return None;
    }
    let mut pixmap = Pixmap::new(view.width as u32, view.height as u32)?;
    let stroke = Stroke { width: (WIDTH_MM / view.mm_per_px) as f32, line_cap: LineCap::Round, ..Stroke::default() };
    for scratch in &scratches {
        let mut paint = Paint::default();
        paint.set_color(Color::from_rgba(1.0, 1.0, 1.0, scratch.depth)?);
        let mut path = PathBuilder::new();
        for (index, &corner) in scratch.corners_mm.iter().enumerate() {
            let DVec2 { x, y } = view.screen_from_table(corner);
            if index == 0 { path.move_to(x as f32, y as f32) } else { path.line_to(x as f32, y as f32) }
        }
        if let Some(path) = path.finish() {
            pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
        }
    }
    let pixels = pixmap.pixels();
    Some(Heights::new(view.width, view.height, |x, y| {
        -DEPTH_MM / 255.0 * f32::from(pixels[y * view.width + x].alpha())
    }))
}

fn scratches(table: &Table) -> Vec<Scratch> {
    let density = table.normal_map.scratches as f32;
    if density <= 0.0 {
        return Vec::new();
    }
    let walls: Vec<(Bounds, Shape)> = table
        .solids
        .iter()
        .filter(|solid| solid.part.is_some())
        .flat_map(|solid| &solid.shapes_mm)
        .map(|shape| (shape.bounds(), *shape))
        .collect();
    let size = table.size_mm;
    let cell_mm = CELL_MM.max((size.x * size.y / MOST_CELLS).sqrt());
    let [columns, rows] = [size.x, size.y].map(|side| (side / cell_mm) as i32);
    let cells: Vec<(i32, i32)> = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))).collect();
    cells.into_par_iter().filter_map(|cell| scratch(cell, cell_mm, density, size, &walls)).collect()
}

/// The scratch that begins in a square, if there is one.
fn scratch(
    (column, row): (i32, i32),
    cell_mm: f64,
    density: f32,
    size_mm: DVec2,
    walls: &[(Bounds, Shape)],
) -> Option<Scratch> {
    let chance = |about: i32| noise::unit(column.wrapping_mul(8) + about, row);
    let within = DVec2::new(f64::from(chance(0)), f64::from(chance(1)));
    let start = (DVec2::new(f64::from(column), f64::from(row)) + within) * cell_mm;
    let near: Vec<Shape> = walls
        .iter()
        .filter(|(bounds, _)| {
            let out = (bounds.min - start).max(start - bounds.max).max(DVec2::ZERO);
            out.length_squared() < GUIDED_MM * GUIDED_MM
        })
        .take(MOST_WALLS)
        .map(|&(_, shape)| shape)
        .collect();
    let guide = |at: DVec2| near.iter().map(|shape| shape.distance(at)).min_by(|a, b| a.0.total_cmp(&b.0));
    let beside = guide(start).map_or(0.0, |(distance, _)| guided(distance));
    if chance(2) >= density * (0.12 + 0.88 * beside as f32) {
        return None;
    }
    let lean = f64::from(chance(3) - 0.5) * (1.5 - 1.1 * beside);
    let steps = 3 + (chance(4) * chance(4) * 20.0) as usize;
    let mut corners_mm = vec![start];
    let (mut at, mut way) = (start, DVec2::Y);
    for _ in 0..steps {
        let mut next = DVec2::Y;
        if let Some((distance, out)) = guide(at) {
            if distance < 2.0 {
                break;
            }
            let along = if out.perp().dot(way) < 0.0 { -out.perp() } else { out.perp() };
            next = (next * (1.0 - guided(distance)) + along * guided(distance)).normalize_or(along);
        }
        way = next;
        at += trig::rotate(way, lean) * STEP_MM;
        if !(0.0..size_mm.x).contains(&at.x) || !(0.0..size_mm.y).contains(&at.y) {
            break;
        }
        corners_mm.push(at);
    }
    let depth = 0.25 + 0.75 * chance(5) * chance(5);
    (corners_mm.len() > 2).then_some(Scratch { corners_mm, depth })
}

/// How much a wall at this distance guides a ball, 0 to 1: most where a ball rolls along it.
fn guided(distance_mm: f64) -> f64 {
    let beyond = (distance_mm - BESIDE_MM).max(0.0) / (GUIDED_MM - BESIDE_MM);
    let close = (distance_mm / BESIDE_MM).clamp(0.0, 1.0);
    (1.0 - beyond).max(0.0) * close
}
