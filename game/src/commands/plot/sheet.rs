//! A sheet with a title, what was done, a place for the curves, their legend, and what was found.
//!
//! Everything is placed in units: a sheet is as large as fits 1200 x 800 of them, or longer one way. It is drawn finer
//! than it will be and then shrunk, which is what smooths its edges.

use super::ink;
use crate::Failure;
use crate::fonts::FONTS;
use crate::screen::Size;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::register_font;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::fmt::Display;
use tracer::Frame;

/// From the edges to what is written, units.
const MARGIN: f64 = 48.0;
/// The legend's width, units.
const LEGEND: f64 = 176.0;

/// What a sheet says in words.
pub struct Words {
    /// What it shows.
    pub title: String,
    /// What was done, as one sentence.
    pub experiment: String,
    /// What was found, as one sentence with the key figures.
    pub finding: String,
}

/// A place on the sheet, units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The left edge.
    pub left: f64,
    /// The upper edge.
    pub top: f64,
    /// The right edge.
    pub right: f64,
    /// The lower edge.
    pub bottom: f64,
}

/// How a line of text is set.
#[derive(Clone, Copy)]
pub struct Lettering {
    /// The file of its font in `assets/fonts`.
    pub font: &'static str,
    /// Its size, units.
    pub size: f64,
    /// Its colour.
    pub color: RGBColor,
    /// Where it goes from its anchor.
    pub anchor: (HPos, VPos),
    /// Whether it runs upwards.
    pub upright: bool,
}

/// Numbers and names.
pub const PLAIN: Lettering = Lettering {
    font: "Oxanium-Regular.ttf",
    size: 18.0,
    color: ink::MIST,
    anchor: (HPos::Left, VPos::Center),
    upright: false,
};

/// A sheet that is being drawn.
pub struct Sheet<'a> {
    pub(super) area: DrawingArea<BitMapBackend<'a>, Shift>,
    /// Fine pixels in a unit.
    pub(super) unit: f64,
    width: f64,
    height: f64,
}

/// A picture of a sheet with these words, on which `curves` draws the rest.
///
/// # Errors
/// Those of `curves`; or if something cannot be drawn, which is a mistake in the program.
pub fn picture(
    size: Size,
    words: &Words,
    curves: impl FnOnce(&Sheet) -> Result<(), Failure>,
) -> Result<Frame, Failure> {
    for (name, bytes) in FONTS {
        register_font(name, FontStyle::Normal, bytes)
            .map_err(|_| Failure::new(format!("the built-in font {name} is damaged; build the game anew")))?;
    }
    let fineness = fineness(size);
    let (across, down) = (size.width * fineness, size.height * fineness);
    let mut fine = vec![0; across * down * 3];
    let unit = (across as f64 / 1200.0).min(down as f64 / 800.0);
    let area = BitMapBackend::with_buffer(&mut fine, (across as u32, down as u32)).into_drawing_area();
    let sheet = Sheet { area, unit, width: across as f64 / unit, height: down as f64 / unit };
    sheet.write(words)?;
    curves(&sheet)?;
    sheet.area.present().map_err(undrawn)?;
    drop(sheet);
    Ok(shrunk(&fine, size, fineness))
}

/// What to say when something cannot be drawn.
pub(super) fn undrawn(error: impl Display) -> Failure {
    Failure::new(format!("the plot cannot be drawn ({error}); please report this"))
}

/// How many times finer a sheet is drawn than it will be: less for very large ones, for the sake of memory.
fn fineness(size: Size) -> usize {
    match size.width * size.height {
        0..=4_000_000 => 3,
        4_000_001..=16_000_000 => 2,
        _ => 1,
    }
}

/// The means of `fineness` x `fineness` pixels.
fn shrunk(fine: &[u8], size: Size, fineness: usize) -> Frame {
    let mut frame = Frame::new(size.width, size.height);
    let count = (fineness * fineness) as u32;
    for (index, pixel) in frame.pixels.iter_mut().enumerate() {
        let (x, y) = (index % size.width * fineness, index / size.width * fineness);
        let mut sums = [0; 3];
        for row in y..y + fineness {
            let start = (row * size.width * fineness + x) * 3;
            for rgb in fine[start..start + fineness * 3].chunks(3) {
                sums.iter_mut().zip(rgb).for_each(|(sum, channel)| *sum += u32::from(*channel));
            }
        }
        let [red, green, blue] = sums.map(|sum| (sum + count / 2) / count);
        *pixel = red << 16 | green << 8 | blue;
    }
    frame
}

impl Sheet<'_> {
    fn write(&self, words: &Words) -> Result<(), Failure> {
        self.area.fill(&ink::NIGHT).map_err(undrawn)?;
        let title = Lettering { font: "Cinzel-SemiBold.ttf", size: 38.0, color: ink::IVORY, ..PLAIN };
        self.text((MARGIN, 46.0), &words.title, title)?;
        let experiment = Lettering { font: "Marcellus-Regular.ttf", size: 22.0, ..PLAIN };
        self.text((MARGIN, 86.0), &words.experiment, experiment)?;
        let finding = Lettering { size: 21.0, color: ink::AMBER, ..PLAIN };
        self.text((MARGIN, self.height - 40.0), &words.finding, finding)
    }

    /// Where curves and the numbers on their axes go.
    pub fn curves(&self) -> Place {
        Place { left: 118.0, top: 122.0, right: self.width - MARGIN - LEGEND - 28.0, bottom: self.height - 132.0 }
    }

    /// Writes `text` at a place, units.
    pub(super) fn text(&self, at: (f64, f64), text: &str, lettering: Lettering) -> Result<(), Failure> {
        let Lettering { font, size, color, anchor, upright } = lettering;
        let turn = if upright { FontTransform::Rotate270 } else { FontTransform::None };
        let style =
            (font, size * self.unit).into_font().transform(turn).color(&color).pos(Pos::new(anchor.0, anchor.1));
        // The middle of a line's box is above the middle of its capitals and figures.
        let sink = if matches!(anchor.1, VPos::Center) { 0.17 * size } else { 0.0 };
        let at = if upright { (at.0 + sink, at.1) } else { (at.0, at.1 + sink) };
        self.area.draw_text(text, &style, self.pixel(at)).map_err(undrawn)
    }

    /// What each colour means, below `heading`, to the right of the curves.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn legend(&self, heading: &str, entries: &[(RGBColor, String)]) -> Result<(), Failure> {
        let left = self.width - MARGIN - LEGEND;
        let top = self.curves().top + 8.0;
        self.text((left, top), heading, PLAIN)?;
        for (row, (color, name)) in entries.iter().enumerate() {
            let y = top + 32.0 + 28.0 * row as f64;
            let swatch = [self.pixel((left, y - 2.5)), self.pixel((left + 22.0, y + 2.5))];
            self.area.draw(&Rectangle::new(swatch, color.filled())).map_err(undrawn)?;
            self.text((left + 34.0, y), name, Lettering { color: ink::IVORY, ..PLAIN })?;
        }
        Ok(())
    }

    /// The fine pixel at a place in units.
    pub(super) fn pixel(&self, (x, y): (f64, f64)) -> (i32, i32) {
        (self.fine(x), self.fine(y))
    }

    /// A length in units, in fine pixels.
    pub(super) fn fine(&self, units: f64) -> i32 {
        (units * self.unit).round() as i32
    }
}
