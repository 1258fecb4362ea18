//! What is written around the dot-matrix display: players, ball, what has been collected, and the keys.

use super::canvas::{Canvas, Color, Rect};
use super::lettering::{Align, Family, Lettering, Style};
use super::programme::grouped;
use super::{AMBER, BRASS, Badge, IVORY, MIST, keys};
use crate::picture::placement::{Placement, Side, title_height};
use crate::simulation::Display;
use geometry::{DVec2, Shape};

/// Everything that the panel says; it is drawn again only when this changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Words {
    /// The table's title.
    pub title: String,
    /// Of the display.
    pub display: Display,
    /// Who plays.
    pub badge: Option<Badge>,
}

impl Words {
    /// What the panel says of a display: its message is the matrix's alone.
    pub fn new(title: &str, display: &Display, badge: Option<Badge>) -> Words {
        let display = Display { message: Vec::new(), message_tick: 0, ..display.clone() };
        Words { title: title.to_string(), display, badge }
    }
}

/// Draws the words where `placement` has room for them.
pub fn draw(canvas: &mut Canvas, lettering: &mut Lettering, placement: &Placement, words: &Words) {
    let mut page = Page { canvas, lettering };
    match placement.side {
        Side::Band(left, right) if placement.pitch == 0 => page.tiny(left, right, &words.display),
        Side::Band(left, right) => {
            page.ball_cell(left, words);
            page.progress(right, &words.display.progress);
        }
        Side::Panel(panel) => page.panel(panel, placement, words),
    }
}

struct Page<'a, 'b> {
    canvas: &'a mut Canvas<'b>,
    lettering: &'a mut Lettering,
}

fn label(size_px: f32) -> Style {
    Style { family: Family::Plain, size_px, tracking: 0.14, color: MIST, alpha: 255 }
}

fn value(size_px: f32, color: Color) -> Style {
    Style { family: Family::Bold, size_px, tracking: 0.0, color, alpha: 255 }
}

/// Text smaller than this is a smudge: better none.
const LEGIBLE_PX: f32 = 6.0;

impl Page<'_, '_> {
    fn text(&mut self, text: &str, style: Style, align: Align, x: i32, y: i32, room: i32) {
        let style = self.lettering.fitted(text, style, room as f32);
        if style.size_px >= LEGIBLE_PX {
            self.lettering.write(self.canvas, text, style, align, x as f32, y as f32);
        }
    }

    /// No room for dots: the score in letters.
    fn tiny(&mut self, left: Rect, right: Rect, display: &Display) {
        let score = grouped(display.scores.get(display.player).copied().unwrap_or_default());
        let size = (left.height as f32 * 0.8).min(22.0);
        self.text(&score, value(size, AMBER), Align::Left, left.x, left.bottom() - 2, left.width + right.width * 2 / 3);
        if display.playing {
            let ball = format!("{}/{}", display.ball, display.balls);
            self.text(&ball, value(size * 0.8, MIST), Align::Right, right.right(), right.bottom() - 2, right.width / 3);
        }
    }

    fn ball_cell(&mut self, cell: Rect, words: &Words) {
        let display = &words.display;
        let (size, x) = ((cell.height as f32 * 0.1).min(cell.width as f32 * 0.22), cell.x + cell.width / 2);
        let ball = if display.playing { format!("{}/{}", display.ball, display.balls) } else { "\u{2013}".to_string() };
        let player = if display.playing { (display.player + 1).to_string() } else { "\u{2013}".to_string() };
        let state = state(words);
        let half = cell.height / 2;
        for (row, (name, number)) in [("BALL", ball), ("PLAYER", player)].into_iter().enumerate() {
            let top = cell.y + half * row as i32;
            self.text(name, label(size), Align::Centre, x, top + half * 34 / 100, cell.width);
            let color = if display.playing { IVORY } else { MIST };
            self.text(&number, value(size * 2.1, color), Align::Centre, x, top + half * 84 / 100, cell.width);
        }
        if let Some((text, color)) = state {
            let style = Style { color, ..label(size) };
            self.canvas.fill(Rect::new(cell.x, cell.bottom() - half, cell.width, half), super::NIGHT, 255);
            self.text(text, style, Align::Centre, x, cell.bottom() - half / 3, cell.width);
        }
    }

    /// What has been collected: for each thing its name and a row of small lamps, or a bar if they are many.
    fn progress(&mut self, room: Rect, progress: &[(String, i64, i64)]) {
        let count = progress.len().clamp(1, 6) as i32;
        let each = (room.height / count).min(room.height / 2);
        for (index, (name, done, of)) in progress.iter().take(6).enumerate() {
            let cell = Rect::new(room.x, room.y + each * index as i32, room.width, each);
            let size = (each as f32 * 0.24).min(room.width as f32 * 0.2).min(15.0);
            self.text(&name.to_uppercase(), label(size), Align::Left, cell.x, cell.y + (size * 1.2) as i32, cell.width);
            let below = (size * 1.7) as i32;
            let lamps = Rect::new(cell.x, cell.y + below, cell.width, (cell.height - below - 3).max(0));
            self.lamps(lamps, name, *done, *of);
        }
    }

    fn lamps(&mut self, room: Rect, name: &str, done: i64, of: i64) {
        let (of, done) = (of.max(1), done.clamp(0, of.max(1)));
        let step = (room.height.min(room.width / of.min(12) as i32)).min(26);
        if of > 12 || step < 5 {
            let bar = Rect::new(room.x, room.y, room.width, room.height.min(5));
            let full = (i64::from(bar.width) * done / of) as i32;
            self.canvas.fill(bar, BRASS, 50);
            self.canvas.fill(Rect::new(bar.x, bar.y, full, bar.height), hue(name, 0, 1), 255);
            return;
        }
        for index in 0..of {
            let x = f64::from(room.x) + f64::from(step) * (index as f64 + 0.5);
            let disc = Shape::disc(DVec2::new(x, f64::from(room.y) + f64::from(step) * 0.5), f64::from(step) * 0.3);
            let color = hue(name, index, of);
            if index < done {
                self.canvas.halo(&disc, f64::from(step) * 0.35, color, 120);
                self.canvas.shape(&disc, color, 255);
            } else {
                self.canvas.shape(&disc, color, 26);
                self.canvas.outline(&disc, 1.0, BRASS, 150);
            }
        }
    }

    fn panel(&mut self, panel: Rect, placement: &Placement, words: &Words) {
        let title = Rect::new(panel.x, panel.y, panel.width, title_height(panel));
        let size = title.height as f32 * 0.52;
        let style = Style { family: Family::Title, size_px: size, tracking: 0.1, color: BRASS, alpha: 255 };
        let middle = panel.x + panel.width / 2;
        self.text(&words.title, style, Align::Centre, middle, title.y + title.height * 62 / 100, panel.width);
        let unit = (panel.width as f32 / 22.0).min(panel.height as f32 / 44.0);
        let top = placement.matrix.bottom().max(title.bottom()) + (unit * 1.4) as i32;
        let mut room = Rect::new(panel.x, top, panel.width, panel.bottom() - top);
        self.scores(&mut room, unit, &words.display);
        self.rule(&mut room, unit);
        self.status(&mut room, unit, words);
        if !words.display.progress.is_empty() {
            self.rule(&mut room, unit);
            let needed = (unit * 2.9) as i32 * words.display.progress.len().min(6) as i32;
            let rows = take(&mut room, needed);
            if rows.height == needed {
                self.progress(rows, &words.display.progress);
            }
        }
        self.key_help(room, unit);
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
            self.text(&name, Style { color, ..label(unit * 0.75) }, Align::Left, row.x, baseline, row.width / 3);
            self.text(&grouped(*score), value(size, color), Align::Right, row.right(), baseline, row.width * 2 / 3);
        }
    }

    fn status(&mut self, room: &mut Rect, unit: f32, words: &Words) {
        let row = take(room, (unit * 1.9) as i32);
        if row.height < (unit * 1.8) as i32 {
            return;
        }
        let baseline = row.y + (unit * 1.3) as i32;
        let display = &words.display;
        let ball = if display.playing { format!("{} of {}", display.ball, display.balls) } else { "\u{2013}".into() };
        self.text("BALL", label(unit * 0.75), Align::Left, row.x, baseline, row.width / 4);
        self.text(&ball, value(unit * 1.2, IVORY), Align::Left, row.x + row.width / 5, baseline, row.width / 3);
        if let Some((text, color)) = state(words) {
            let style = Style { color, ..label(unit * 0.9) };
            self.text(text, style, Align::Right, row.right(), baseline, row.width / 3);
        }
    }

    fn rule(&mut self, room: &mut Rect, unit: f32) {
        let row = take(room, (unit * 1.2) as i32);
        self.canvas.fill(Rect::new(row.x, row.y + row.height / 2, row.width, 1), BRASS, 110);
    }

    /// The keys, at the foot of the panel, if there is room.
    fn key_help(&mut self, room: Rect, unit: f32) {
        let line = (unit * 1.45) as i32;
        let needed = line * keys::HELP.len() as i32 + line;
        if room.height < needed {
            return;
        }
        let top = room.bottom() - needed;
        self.canvas.fill(Rect::new(room.x, top, room.width, 1), BRASS, 110);
        for (index, (keys, action)) in keys::HELP.iter().enumerate() {
            let y = top + line * (index as i32 + 1) + line / 2;
            let style = Style { tracking: 0.02, ..label(unit * 0.78) };
            self.text(keys, Style { color: BRASS, ..style }, Align::Left, room.x, y, room.width / 2);
            self.text(action, style, Align::Right, room.right(), y, room.width / 2);
        }
    }
}

/// The state that is worth a word.
fn state(words: &Words) -> Option<(&'static str, Color)> {
    match words.badge {
        _ if words.display.tilted => Some(("TILT", 0xff_5a3c)),
        Some(Badge::Replay) => Some(("REPLAY", 0x7f_c8ff)),
        Some(Badge::Bot) => Some(("BOT", 0x7f_c8ff)),
        None if !words.display.playing => Some(("GAME OVER", MIST)),
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

/// The colour of the lamp `index` of `of` for a thing of this name: its own if the name is a colour's, its place in
/// the spectrum if they are colours, else amber.
fn hue(name: &str, index: i64, of: i64) -> Color {
    const SPECTRUM: [Color; 7] = [0xff_4038, 0xff_8a2a, 0xff_d23c, 0x4f_e06a, 0x3c_d8e8, 0x4f_7dff, 0xb0_62ff];
    const NAMES: [&str; 7] = ["red", "orange", "yellow", "green", "cyan", "blue", "violet"];
    let name = name.to_lowercase();
    if let Some(place) = NAMES.iter().position(|color| name.contains(color)) {
        return SPECTRUM[place];
    }
    let many = ["colour", "color", "spectrum", "prism"].iter().any(|word| name.contains(word));
    if many { SPECTRUM[(index * 7 / of.max(1)).clamp(0, 6) as usize] } else { AMBER }
}
