//! The panel: what is written around the dot-matrix display: players, ball, what has been collected, and the keys.

use super::dmd::grouped;
use super::key_help;
use super::palette::{AMBER, BRASS, IVORY, MIST};
use super::text::{Align, Anchor, FontFamily, TextRenderer, TextStyle};
use super::ui_state::{Badge, UiState};
use crate::Table;
use crate::screen::{CachedLayer, Canvas, Color, Layer, Placement, Rect, Side, title_height};
use crate::simulation::{Display, Snapshot};
use geometry::DVec2;

/// Everything that the panel says; it is drawn again only when this changes.
#[derive(Clone, Debug, PartialEq)]
pub struct PanelText {
    /// The table's title.
    pub title: String,
    /// Of the display.
    pub display: Display,
    /// A ball that drains now comes back.
    pub shoot_again: bool,
    /// Who plays.
    pub badge: Option<Badge>,
    /// Keys and what they do.
    pub keys: &'static [(&'static str, &'static str)],
}

/// The lamp that says on the table what the panel repeats: a ball that drains now comes back.
const SHOOT_AGAIN: &str = "insert-shoot-again";

impl PanelText {
    /// What the panel says of a snapshot: the display's message is the dot-matrix display's alone.
    pub fn new(table: &Table, snapshot: &Snapshot, ui_state: &UiState) -> PanelText {
        let display = Display { message: Vec::new(), message_tick: 0, message_until: None, ..snapshot.display.clone() };
        let lamp = table.lamp(SHOOT_AGAIN).and_then(|lamp| snapshot.lamps.get(lamp));
        let shoot_again = display.playing && lamp.is_some_and(|lamp| lamp.level > 300);
        let keys = if ui_state.replay.is_some() { key_help::REPLAY_HELP } else { key_help::HELP };
        PanelText { title: table.title.to_uppercase(), display, shoot_again, badge: ui_state.badge, keys }
    }
}

/// Draws the panel's text where `placement` has room for them.
pub fn draw(
    canvas: &mut Canvas,
    text_renderer: &mut TextRenderer,
    lines: &mut ProgressLines,
    placement: &Placement,
    panel_text: &PanelText,
) {
    let mut page = Page { canvas, text_renderer, lines };
    match placement.side {
        Side::Band(left, right) if placement.pitch == 0 => page.tiny(left, right, &panel_text.display),
        Side::Band(left, right) => {
            page.ball_cell(left, panel_text);
            page.progress(right, &panel_text.display.progress);
        }
        Side::Panel(panel) => page.panel(panel, placement, panel_text),
    }
}

/// The spectral lines, each kept until it grows: its colour, what has been collected, and of how many.
#[derive(Default)]
pub struct ProgressLines([CachedLayer<(Color, i64, i64)>; MOST_ROWS]);

struct Page<'a, 'b> {
    canvas: &'a mut Canvas<'b>,
    text_renderer: &'a mut TextRenderer,
    lines: &'a mut ProgressLines,
}

fn label(size_px: f32) -> TextStyle {
    TextStyle { family: FontFamily::Plain, size_px, tracking: 0.14, color: MIST, alpha: 255 }
}

fn value(size_px: f32, color: Color) -> TextStyle {
    TextStyle { family: FontFamily::Bold, size_px, tracking: 0.0, color, alpha: 255 }
}

fn left_at(x: i32, y: i32) -> Anchor {
    Anchor { align: Align::Left, x: x as f32, y: y as f32 }
}

fn centre_at(x: i32, y: i32) -> Anchor {
    Anchor { align: Align::Centre, x: x as f32, y: y as f32 }
}

fn right_at(x: i32, y: i32) -> Anchor {
    Anchor { align: Align::Right, x: x as f32, y: y as f32 }
}

/// The most things whose progress is shown.
const MOST_ROWS: usize = 12;

/// Text smaller than this is a smudge: better none.
const LEGIBLE_PX: f32 = 6.0;

impl Page<'_, '_> {
    fn text(&mut self, text: &str, style: TextStyle, anchor: Anchor, room: i32) {
        let style = self.text_renderer.fitted(text, style, room as f32);
        if style.size_px >= LEGIBLE_PX {
            self.text_renderer.write(self.canvas, text, style, anchor);
        }
    }

    /// No room for dots: the score in letters.
    fn tiny(&mut self, left: Rect, right: Rect, display: &Display) {
        let score = grouped(display.scores.get(display.player).copied().unwrap_or_default());
        let size = (left.height as f32 * 0.8).min(22.0);
        self.text(&score, value(size, AMBER), left_at(left.x, left.bottom() - 2), left.width + right.width * 2 / 3);
        if display.playing {
            let ball = format!("{}/{}", display.ball, display.balls);
            self.text(&ball, value(size * 0.8, MIST), right_at(right.right(), right.bottom() - 2), right.width / 3);
        }
    }

    fn ball_cell(&mut self, cell: Rect, panel_text: &PanelText) {
        let display = &panel_text.display;
        let (size, x) = ((cell.height as f32 * 0.1).min(cell.width as f32 * 0.22), cell.x + cell.width / 2);
        let ball = if display.playing { format!("{}/{}", display.ball, display.balls) } else { "\u{2013}".to_string() };
        let player = if display.playing { (display.player + 1).to_string() } else { "\u{2013}".to_string() };
        let half = cell.height / 2;
        let mut pair = |row: i32, name: &str, number: &str| {
            let top = cell.y + half * row;
            self.text(name, label(size), centre_at(x, top + half * 34 / 100), cell.width);
            let color = if display.playing { IVORY } else { MIST };
            self.text(number, value(size * 2.1, color), centre_at(x, top + half * 84 / 100), cell.width);
        };
        pair(0, "BALL", &ball);
        let Some((text, color)) = state(panel_text) else { return pair(1, "PLAYER", &player) };
        for (line, word) in text.split(' ').enumerate() {
            let style = TextStyle { color, ..label(size * 1.1) };
            let baseline = cell.y + half + half * (40 + 28 * line as i32) / 100;
            self.text(word, style, centre_at(x, baseline), cell.width);
        }
    }

    /// What has been collected: a row for each thing, its line of the spectrum cut into as many parts as it needs.
    fn progress(&mut self, room: Rect, progress: &[(String, i64, i64)]) {
        let rows = progress.len().min(MOST_ROWS) as i32;
        if rows == 0 || room.height < 3 * rows {
            return;
        }
        let each = room.height / rows;
        let size = each as f32 * 0.56;
        let named = size >= LEGIBLE_PX && room.width as f32 > size * 14.0;
        let left = if named { room.width * 2 / 5 } else { 0 };
        for (index, (name, done, of)) in progress.iter().take(MOST_ROWS).enumerate() {
            let row = Rect::new(room.x, room.y + each * index as i32, room.width, each);
            let full = done >= of;
            if named {
                let color = if full { IVORY } else { MIST };
                let style = TextStyle { color, ..label(size) };
                self.text(&name.to_uppercase(), style, left_at(row.x, row.y + each * 68 / 100), left);
            }
            let height = (each * 2 / 5).clamp(2, 12);
            let line = Rect::new(row.x + left, row.y + (each - height) / 2, row.width - left, height);
            let (color, of, done) = (hue(name), (*of).max(1), (*done).clamp(0, (*of).max(1)));
            // The light of a whole line stays between the edges that everything in the panel shares.
            let pane = Rect { x: line.x, width: line.width, ..line.grown(line.height * 2) };
            self.lines.0[index].lay(self.canvas, pane, (color, done, of), |layer| {
                spectral_line(layer, line, color, done, of);
            });
        }
    }

    fn panel(&mut self, panel: Rect, placement: &Placement, panel_text: &PanelText) {
        let title = Rect::new(panel.x, panel.y, panel.width, title_height(panel));
        let size = title.height as f32 * 0.52;
        let style = TextStyle { family: FontFamily::Title, size_px: size, tracking: 0.1, color: BRASS, alpha: 255 };
        let middle = panel.x + panel.width / 2;
        self.text(&panel_text.title, style, centre_at(middle, title.y + title.height * 62 / 100), panel.width);
        let unit = (panel.width as f32 / 22.0).min(panel.height as f32 / 44.0);
        let top = placement.matrix.bottom().max(title.bottom()) + (unit * 1.4) as i32;
        let mut room = Rect::new(panel.x, top, panel.width, panel.bottom() - top);
        self.scores(&mut room, unit, &panel_text.display);
        self.rule(&mut room, unit);
        self.status(&mut room, unit, panel_text);
        if !panel_text.display.progress.is_empty() {
            self.rule(&mut room, unit);
            let needed = (unit * 1.45) as i32 * panel_text.display.progress.len().min(MOST_ROWS) as i32;
            let rows = take(&mut room, needed);
            if rows.height == needed {
                self.progress(rows, &panel_text.display.progress);
            }
        }
        self.key_help(room, unit, panel_text.keys);
    }

    fn scores(&mut self, room: &mut Rect, unit: f32, display: &Display) {
        for (index, score) in display.scores.iter().enumerate() {
            let active = index == display.player && display.playing;
            let size = if active { unit * 2.0 } else { unit * 1.2 };
            let row = take(room, (size * 1.35) as i32);
            if row.height < (size * 1.3) as i32 {
                return;
            }
            let baseline = row.y + (size * 1.02) as i32;
            let color = if active { AMBER } else { MIST };
            let name = format!("PLAYER {}", index + 1);
            self.text(&name, TextStyle { color, ..label(unit * 0.75) }, left_at(row.x, baseline), row.width / 3);
            self.text(&grouped(*score), value(size, color), right_at(row.right(), baseline), row.width * 2 / 3);
        }
    }

    fn status(&mut self, room: &mut Rect, unit: f32, panel_text: &PanelText) {
        let row = take(room, (unit * 1.9) as i32);
        if row.height < (unit * 1.8) as i32 {
            return;
        }
        let baseline = row.y + (unit * 1.3) as i32;
        let display = &panel_text.display;
        let ball = if display.playing { format!("{} of {}", display.ball, display.balls) } else { "\u{2013}".into() };
        self.text("BALL", label(unit * 0.75), left_at(row.x, baseline), row.width / 4);
        self.text(&ball, value(unit * 1.2, IVORY), left_at(row.x + row.width / 5, baseline), row.width / 3);
        if let Some((text, color)) = state(panel_text) {
            let style = TextStyle { color, ..label(unit * 0.9) };
            self.text(text, style, right_at(row.right(), baseline), row.width / 3);
        }
    }

    fn rule(&mut self, room: &mut Rect, unit: f32) {
        let row = take(room, (unit * 1.2) as i32);
        self.hairline(Rect::new(row.x, row.y + row.height / 2, row.width, 1));
    }

    fn hairline(&mut self, rect: Rect) {
        let mut layer = Layer::new(rect);
        layer.fill(rect, BRASS, 110);
        layer.lay(self.canvas);
    }

    /// The keys, at the foot of the panel, if there is room.
    fn key_help(&mut self, room: Rect, unit: f32, keys: &[(&str, &str)]) {
        let line = (unit * 1.45) as i32;
        let needed = line * keys.len() as i32 + line;
        if room.height < needed {
            return;
        }
        let top = room.bottom() - needed;
        self.hairline(Rect::new(room.x, top, room.width, 1));
        for (index, (keys, action)) in keys.iter().enumerate() {
            let y = top + line * (index as i32 + 1) + line / 2;
            let style = TextStyle { tracking: 0.02, ..label(unit * 0.78) };
            self.text(keys, TextStyle { color: BRASS, ..style }, left_at(room.x, y), room.width / 2);
            self.text(action, style, right_at(room.right(), y), room.width / 2);
        }
    }
}

/// A line of the spectrum in as many parts as there are things to collect; it shines when it is whole.
fn spectral_line(layer: &mut Layer, line: Rect, color: Color, done: i64, of: i64) {
    // More parts than this are too narrow to be told apart: then it is one.
    let parts = if of * 5 > i64::from(line.width) { 1 } else { of };
    if done == of {
        let (y, end) = (f64::from(line.y) + f64::from(line.height) * 0.5, f64::from(line.height) * 0.5);
        let (a, b) = (DVec2::new(f64::from(line.x) + end, y), DVec2::new(f64::from(line.right()) - end, y));
        layer.halo(a, b, f64::from(line.height) * 1.7, color, 180);
    }
    for part in 0..parts {
        let at = |part: i64| line.x + (i64::from(line.width) * part / parts) as i32;
        let gap = if part + 1 < parts { 2 } else { 0 };
        let cell = Rect::new(at(part), line.y, at(part + 1) - at(part) - gap, line.height);
        layer.fill(cell, color, 38);
        let lit =
            if parts == 1 { i64::from(cell.width) * done / of } else { i64::from(cell.width) * i64::from(part < done) };
        layer.fill(Rect { width: lit as i32, ..cell }, color, 255);
    }
}

/// The state that is worth a word.
fn state(panel_text: &PanelText) -> Option<(&'static str, Color)> {
    match panel_text.badge {
        _ if panel_text.display.tilted => Some(("TILT", 0xff_5a3c)),
        Some(Badge::Replay) => Some(("REPLAY", 0x7f_c8ff)),
        Some(Badge::Bot) => Some(("BOT", 0x7f_c8ff)),
        None if panel_text.shoot_again => Some(("SHOOT AGAIN", AMBER)),
        None if !panel_text.display.playing => Some(("GAME OVER", MIST)),
        None => None,
    }
}

/// Cuts `height` rows off the top of `room`, fewer if it has not so many.
fn take(room: &mut Rect, height: i32) -> Rect {
    let height = height.min(room.height);
    let row = Rect::new(room.x, room.y, room.width, height);
    *room = Rect::new(room.x, room.y + height, room.width, room.height - height);
    row
}

/// The colour for a thing of this name: its own if the name is a colour's, else amber.
fn hue(name: &str) -> Color {
    const COLORS: [(&str, Color); 9] = [
        ("red", 0xff_4038),
        ("orange", 0xff_8a2a),
        ("yellow", 0xff_d23c),
        ("green", 0x4f_e06a),
        ("cyan", 0x3c_d8e8),
        ("blue", 0x3c_a4ff),
        ("indigo", 0x6a_6cff),
        ("violet", 0xc0_62ff),
        ("white", 0xf4_f1e8),
    ];
    let name = name.to_lowercase();
    COLORS.iter().find(|(color, _)| name.contains(color)).map_or(AMBER, |(_, color)| *color)
}
