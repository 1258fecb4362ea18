//! What lies over the table for a while: the pause, the keys, a notice, the line of a replay.

use super::text::{Align, Family, Lettering, Style};
use super::{AMBER, BRASS, IVORY, MIST, NIGHT};
use crate::screen::{Canvas, Kept, Layer, Rect};
use geometry::{DVec2, Shape};

/// A dark pane with a title, a table of keys, and a line at its foot.
pub struct Card {
    /// The title.
    pub title: &'static str,
    /// Keys and what they do.
    pub rows: &'static [(&'static str, &'static str)],
    /// The last line.
    pub foot: &'static str,
}

/// How far a replay is.
#[derive(Clone, Debug, PartialEq)]
pub struct Seek {
    /// Where it is, seconds.
    pub at_s: f64,
    /// How long it is, seconds.
    pub length_s: f64,
    /// Speed in parts of real time, as it is told: `x1/4`.
    pub speed: String,
    /// It stands still.
    pub paused: bool,
}

/// The panes under what is written, kept from picture to picture.
#[derive(Default)]
pub struct Panes {
    card: Kept<()>,
    notice: Kept<()>,
    seek: Kept<i32>,
}

/// Dims the table and lays the card on it.
pub fn draw(canvas: &mut Canvas, lettering: &mut Lettering, panes: &mut Panes, table: Rect, card: &Card) {
    canvas.fill(table, NIGHT, 150);
    let unit = (table.width as f32 / 26.0).clamp(4.0, 30.0);
    let line = (unit * 1.75) as i32;
    let height = line * card.rows.len() as i32 + (unit * 7.0) as i32;
    let pane = table.centred((table.width * 9 / 10).min((unit * 25.0) as i32), height.min(table.height));
    panes.card.lay(canvas, pane, (), |layer| {
        layer.fill(pane, NIGHT, 225);
        layer.frame(pane, BRASS, 200);
        layer.frame(pane.grown(-3), BRASS, 70);
    });
    let title = Style { family: Family::Title, size_px: unit * 1.9, tracking: 0.12, color: BRASS, alpha: 255 };
    let middle = (pane.x + pane.width / 2) as f32;
    let room = pane.width as f32 - 2.0 * unit;
    let title = lettering.fitted(card.title, title, room);
    lettering.write(canvas, card.title, title, Align::Centre, middle, pane.y as f32 + unit * 2.6);
    let plain = Style { family: Family::Plain, size_px: unit * 0.86, tracking: 0.02, color: IVORY, alpha: 255 };
    for (index, (keys, action)) in card.rows.iter().enumerate() {
        let y = pane.y as f32 + unit * 4.7 + (line * index as i32) as f32;
        let keys_style = lettering.fitted(keys, Style { color: AMBER, ..plain }, room * 0.58);
        lettering.write(canvas, keys, keys_style, Align::Left, pane.x as f32 + unit, y);
        let action_style = lettering.fitted(action, plain, room * 0.42 - unit * 0.4);
        lettering.write(canvas, action, action_style, Align::Right, pane.right() as f32 - unit, y);
    }
    let foot = lettering.fitted(card.foot, Style { family: Family::Engraved, color: MIST, ..plain }, room);
    lettering.write(canvas, card.foot, foot, Align::Centre, middle, pane.bottom() as f32 - unit * 1.1);
}

/// A sentence at the foot of the table.
pub fn notice(canvas: &mut Canvas, lettering: &mut Lettering, panes: &mut Panes, table: Rect, text: &str) {
    let size = (table.width as f32 / 30.0).clamp(7.0, 20.0);
    let style = Style { family: Family::Plain, size_px: size, tracking: 0.01, color: IVORY, alpha: 255 };
    let lines = wrapped(lettering, text, style, table.width as f32 * 0.88);
    let line = (size * 1.4) as i32;
    let height = line * lines.len() as i32 + line * 3 / 4;
    let pane = Rect::new(table.x, table.bottom() - height - line, table.width, height);
    panes.notice.lay(canvas, pane, (), |layer| {
        layer.fill(pane, NIGHT, 215);
        layer.fill(Rect { height: 1, ..pane }, BRASS, 160);
    });
    for (index, text) in lines.iter().enumerate() {
        let y = (pane.y + line * (index as i32 + 1)) as f32;
        let style = lettering.fitted(text, style, table.width as f32 * 0.96);
        lettering.write(canvas, text, style, Align::Centre, (pane.x + pane.width / 2) as f32, y);
    }
}

/// The most lines of a notice.
const NOTICE_LINES: usize = 6;

fn wrapped(lettering: &Lettering, text: &str, style: Style, room: f32) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.len() - 1;
        let longer = if lines[last].is_empty() { word.to_string() } else { format!("{} {word}", lines[last]) };
        if lettering.width(&longer, style) <= room || lines[last].is_empty() {
            lines[last] = longer;
        } else {
            lines.push(word.to_string());
        }
    }
    lines.truncate(NOTICE_LINES);
    lines
}

/// The slim line of a replay at the foot of the table.
pub fn seek(canvas: &mut Canvas, lettering: &mut Lettering, panes: &mut Panes, table: Rect, seek: &Seek) {
    let size = (table.width as f32 / 36.0).clamp(6.0, 18.0);
    let y = table.bottom() - (size * 0.8) as i32;
    let bar = Rect::new(table.x + size as i32, y, table.width - 2 * size as i32, 2);
    let pane = Rect::new(table.x, y - (size * 2.0) as i32, table.width, (size * 2.8) as i32);
    let part = if seek.length_s > 0.0 { (seek.at_s / seek.length_s).clamp(0.0, 1.0) } else { 1.0 };
    let done = (f64::from(bar.width) * part) as i32;
    panes.seek.lay(canvas, pane, done, |layer| {
        layer.fill(pane, NIGHT, 150);
        progress(layer, bar, done);
    });
    let style = Style { family: Family::Plain, size_px: size, tracking: 0.04, color: IVORY, alpha: 230 };
    let baseline = y as f32 - size * 0.55;
    let clock = format!("{} / {}", clock(seek.at_s), clock(seek.length_s));
    lettering.write(canvas, &clock, style, Align::Left, bar.x as f32, baseline);
    let speed = if seek.paused { format!("paused  {}", seek.speed) } else { seek.speed.clone() };
    lettering.write(canvas, &speed, style, Align::Right, bar.right() as f32, baseline);
}

/// Minutes, seconds and tenths.
fn clock(seconds: f64) -> String {
    let tenths = (seconds.max(0.0) * 10.0) as u64;
    format!("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10)
}

/// A brass line, amber as far as the replay is, with a bead where it is now.
fn progress(layer: &mut Layer, bar: Rect, done: i32) {
    layer.fill(bar, BRASS, 90);
    layer.fill(Rect { width: done, ..bar }, AMBER, 255);
    let bead = DVec2::new(f64::from(bar.x + done), f64::from(bar.y) + f64::from(bar.height) * 0.5);
    layer.shape(&Shape::disc(bead, 3.5), IVORY, 255);
}
