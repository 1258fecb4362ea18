//! A notice: a sentence at the foot of the table.

use super::palette::{BRASS, IVORY, NIGHT};
use super::text::{Anchor, FontFamily, TextRenderer, TextStyle};
use crate::screen::{CachedLayer, Canvas, Rect};

/// Draws a sentence at the foot of the table; `cached` keeps its pane from frame to frame.
pub fn draw(canvas: &mut Canvas, text: &mut TextRenderer, cached: &mut CachedLayer<()>, table: Rect, sentence: &str) {
    let size = (table.width as f32 / 30.0).clamp(7.0, 20.0);
    let style = TextStyle { family: FontFamily::Plain, size_px: size, tracking: 0.01, color: IVORY, alpha: 255 };
    let lines = wrapped(text, sentence, style, table.width as f32 * 0.88);
    let line = (size * 1.4) as i32;
    let height = line * lines.len() as i32 + line * 3 / 4;
    let pane = Rect::new(table.x, table.bottom() - height - line, table.width, height);
    cached.lay(canvas, pane, (), |layer| {
        layer.fill(pane, NIGHT, 215);
        layer.fill(Rect { height: 1, ..pane }, BRASS, 160);
    });
    for (index, line_text) in lines.iter().enumerate() {
        let y = (pane.y + line * (index as i32 + 1)) as f32;
        let style = text.fitted(line_text, style, table.width as f32 * 0.96);
        text.write(canvas, line_text, style, Anchor::centre((pane.x + pane.width / 2) as f32, y));
    }
}

/// The most lines of a notice.
const NOTICE_LINES: usize = 6;

fn wrapped(text: &TextRenderer, sentence: &str, style: TextStyle, room: f32) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in sentence.split_whitespace() {
        let last = lines.len() - 1;
        let longer = if lines[last].is_empty() { word.to_string() } else { format!("{} {word}", lines[last]) };
        if text.width(&longer, style) <= room || lines[last].is_empty() {
            lines[last] = longer;
        } else {
            lines.push(word.to_string());
        }
    }
    lines.truncate(NOTICE_LINES);
    lines
}
