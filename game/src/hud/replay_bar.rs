//! The replay bar: how far a replay is, at the foot of the table.

use super::palette::{AMBER, BRASS, IVORY, NIGHT};
use super::text::{Anchor, FontFamily, TextRenderer, TextStyle};
use crate::screen::{CachedLayer, Canvas, Layer, Rect};
use geometry::{DVec2, Shape};

/// How far a replay is.
#[derive(Clone, Debug, PartialEq)]
pub struct ReplayProgress {
    /// Where it is, seconds.
    pub at_s: f64,
    /// How long it is, seconds.
    pub length_s: f64,
    /// Speed in parts of real time, as it is told: `x1/4`.
    pub speed: String,
    /// It stands still.
    pub paused: bool,
}

/// Where the bar lies at the foot of the table.
pub fn pane(table: Rect) -> Rect {
    let size = size(table);
    let height = (size * 2.8) as i32;
    Rect::new(table.x, bar_y(table) - (size * 2.0) as i32, table.width, height)
}

/// The size of its letters, pixels.
fn size(table: Rect) -> f32 {
    (table.width as f32 / 36.0).clamp(6.0, 18.0)
}

/// The row of its line.
fn bar_y(table: Rect) -> i32 {
    table.bottom() - (size(table) * 0.8) as i32
}

/// Draws the slim bar of a replay at the foot of the table; `cached` keeps it while its length stays the same.
pub fn draw(
    canvas: &mut Canvas,
    text: &mut TextRenderer,
    cached: &mut CachedLayer<i32>,
    table: Rect,
    progress: &ReplayProgress,
) {
    let (size, y, pane) = (size(table), bar_y(table), pane(table));
    let bar = Rect::new(table.x + size as i32, y, table.width - 2 * size as i32, 2);
    let part = if progress.length_s > 0.0 { (progress.at_s / progress.length_s).clamp(0.0, 1.0) } else { 1.0 };
    let done = (f64::from(bar.width) * part) as i32;
    cached.lay(canvas, pane, done, |layer| {
        layer.fill(pane, NIGHT, 150);
        draw_line(layer, bar, done);
    });
    let style = TextStyle { family: FontFamily::Plain, size_px: size, tracking: 0.04, color: IVORY, alpha: 230 };
    let baseline = y as f32 - size * 0.55;
    let clock = format!("{} / {}", clock(progress.at_s), clock(progress.length_s));
    text.write(canvas, &clock, style, Anchor::left(bar.x as f32, baseline));
    let speed = if progress.paused { format!("paused  {}", progress.speed) } else { progress.speed.clone() };
    text.write(canvas, &speed, style, Anchor::right(bar.right() as f32, baseline));
}

/// Minutes, seconds and tenths.
fn clock(seconds: f64) -> String {
    let tenths = (seconds.max(0.0) * 10.0) as u64;
    format!("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10)
}

/// A brass line, amber as far as the replay is, with a bead where it is now.
fn draw_line(layer: &mut Layer, bar: Rect, done: i32) {
    layer.fill(bar, BRASS, 90);
    layer.fill(Rect { width: done, ..bar }, AMBER, 255);
    let bead = DVec2::new(f64::from(bar.x + done), f64::from(bar.y) + f64::from(bar.height) * 0.5);
    layer.shape(&Shape::disc(bead, 3.5), IVORY, 255);
}
