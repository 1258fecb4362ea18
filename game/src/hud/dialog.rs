//! A dialog over the table: the pause, the keys.

use super::palette::{AMBER, BRASS, IVORY, MIST, NIGHT};
use super::text::{Anchor, FontFamily, TextRenderer, TextStyle};
use crate::screen::{CachedLayer, Canvas, Rect};

/// A dark pane with a title, a table of keys, and a line at its foot.
pub struct Dialog {
    /// The title.
    pub title: &'static str,
    /// Keys and what they do.
    pub rows: &'static [(&'static str, &'static str)],
    /// The last line.
    pub foot: &'static str,
}

/// Dims the table and lays the dialog on it; `cached` keeps its pane from frame to frame.
pub fn draw(canvas: &mut Canvas, text: &mut TextRenderer, cached: &mut CachedLayer<()>, table: Rect, dialog: &Dialog) {
    canvas.fill(table, NIGHT, 150);
    let unit = (table.width as f32 / 26.0).clamp(4.0, 30.0);
    let line = (unit * 1.75) as i32;
    let height = line * dialog.rows.len() as i32 + (unit * 7.0) as i32;
    let pane = table.centred((table.width * 9 / 10).min((unit * 25.0) as i32), height.min(table.height));
    cached.lay(canvas, pane, (), |layer| {
        layer.fill(pane, NIGHT, 225);
        layer.frame(pane, BRASS, 200);
        layer.frame(pane.grown(-3), BRASS, 70);
    });
    let title = TextStyle { family: FontFamily::Title, size_px: unit * 1.9, tracking: 0.12, color: BRASS, alpha: 255 };
    let middle = (pane.x + pane.width / 2) as f32;
    let room = pane.width as f32 - 2.0 * unit;
    let title = text.fitted(dialog.title, title, room);
    text.write(canvas, dialog.title, title, Anchor::centre(middle, pane.y as f32 + unit * 2.6));
    let plain = TextStyle { family: FontFamily::Plain, size_px: unit * 0.86, tracking: 0.02, color: IVORY, alpha: 255 };
    for (index, (keys, action)) in dialog.rows.iter().enumerate() {
        let y = pane.y as f32 + unit * 4.7 + (line * index as i32) as f32;
        let keys_style = text.fitted(keys, TextStyle { color: AMBER, ..plain }, room * 0.58);
        text.write(canvas, keys, keys_style, Anchor::left(pane.x as f32 + unit, y));
        let action_style = text.fitted(action, plain, room * 0.42 - unit * 0.4);
        text.write(canvas, action, action_style, Anchor::right(pane.right() as f32 - unit, y));
    }
    let foot = text.fitted(dialog.foot, TextStyle { family: FontFamily::Engraved, color: MIST, ..plain }, room);
    text.write(canvas, dialog.foot, foot, Anchor::centre(middle, pane.bottom() as f32 - unit * 1.1));
}
