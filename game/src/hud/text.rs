//! The text renderer: the project's own fonts, each glyph rasterized once and kept.

use crate::Failure;
use crate::screen::{Canvas, Color};
use fontdue::{Font, FontSettings, Metrics};
use std::collections::BTreeMap;

/// The fonts of the display.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FontFamily {
    /// Oxanium, for numbers and labels.
    Plain,
    /// Oxanium bold, for scores.
    Bold,
    /// Cinzel, for titles.
    Title,
    /// Marcellus, for sentences.
    Engraved,
}

/// How a line is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextStyle {
    /// The font.
    pub family: FontFamily,
    /// Its size, pixels.
    pub size_px: f32,
    /// Extra space between letters, in parts of the size.
    pub tracking: f32,
    /// The colour.
    pub color: Color,
    /// How much of it, of 255.
    pub alpha: u32,
}

/// Which way a line goes from its anchor point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// It begins there.
    Left,
    /// Its middle is there.
    Centre,
    /// It ends there.
    Right,
}

/// The point that a line of text is set at: on its baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Which way the line goes from here.
    pub align: Align,
    /// Pixels from the left.
    pub x: f32,
    /// Pixels from the top, of the baseline.
    pub y: f32,
}

impl Anchor {
    /// The line begins here.
    pub fn left(x: f32, y: f32) -> Anchor {
        Anchor { align: Align::Left, x, y }
    }

    /// The line's middle is here.
    pub fn centre(x: f32, y: f32) -> Anchor {
        Anchor { align: Align::Centre, x, y }
    }

    /// The line ends here.
    pub fn right(x: f32, y: f32) -> Anchor {
        Anchor { align: Align::Right, x, y }
    }
}

/// Fonts and the glyphs that have been rasterized with them.
pub struct TextRenderer {
    fonts: [Font; 4],
    glyphs: BTreeMap<(FontFamily, char, u32), (Metrics, Vec<u8>)>,
}

/// Glyphs that are kept before the cache starts anew (sizes change only with the window's).
const MOST_GLYPHS: usize = 4096;

impl TextRenderer {
    /// Reads the fonts.
    ///
    /// # Errors
    /// If a font in the program is damaged.
    pub fn new() -> Result<TextRenderer, Failure> {
        Ok(TextRenderer {
            fonts: [
                font(include_bytes!("../../../assets/fonts/Oxanium-Regular.ttf"))?,
                font(include_bytes!("../../../assets/fonts/Oxanium-Bold.ttf"))?,
                font(include_bytes!("../../../assets/fonts/Cinzel-SemiBold.ttf"))?,
                font(include_bytes!("../../../assets/fonts/Marcellus-Regular.ttf"))?,
            ],
            glyphs: BTreeMap::new(),
        })
    }

    /// How wide a line is, pixels.
    pub fn width(&self, text: &str, style: TextStyle) -> f32 {
        let advances: f32 = text.chars().map(|character| self.advance(character, style)).sum();
        (advances - style.tracking * style.size_px).max(0.0)
    }

    /// `style`, made smaller if `text` would be wider than `width_px`.
    pub fn fitted(&self, text: &str, style: TextStyle, width_px: f32) -> TextStyle {
        let width = self.width(text, style);
        if width <= width_px {
            style
        } else {
            TextStyle { size_px: style.size_px * width_px.max(1.0) / width, ..style }
        }
    }

    /// Writes one line.
    pub fn write(&mut self, canvas: &mut Canvas, text: &str, style: TextStyle, anchor: Anchor) {
        let width = self.width(text, style);
        let mut pen = match anchor.align {
            Align::Left => anchor.x,
            Align::Centre => anchor.x - width * 0.5,
            Align::Right => anchor.x - width,
        };
        for character in text.chars() {
            let cell = self.advance(character, style);
            self.glyph(canvas, character, style, (pen, anchor.y));
            pen += cell;
        }
    }

    /// From one glyph to the next. Digits all take the same room, so that a score does not dance as it counts.
    fn advance(&self, character: char, style: TextStyle) -> f32 {
        let measured = if character.is_ascii_digit() { '0' } else { character };
        let width = self.fonts[style.family as usize].metrics(measured, style.size_px).advance_width;
        width + style.tracking * style.size_px
    }

    fn glyph(&mut self, canvas: &mut Canvas, character: char, style: TextStyle, (pen, baseline): (f32, f32)) {
        if self.glyphs.len() > MOST_GLYPHS {
            self.glyphs.clear();
        }
        let font = &self.fonts[style.family as usize];
        let key = (style.family, character, style.size_px.to_bits());
        let (metrics, coverage) = self.glyphs.entry(key).or_insert_with(|| font.rasterize(character, style.size_px));
        let slack = if character.is_ascii_digit() {
            (font.metrics('0', style.size_px).advance_width - metrics.advance_width) * 0.5
        } else {
            0.0
        };
        let left = (pen + slack).round() as i32 + metrics.xmin;
        let top = baseline.round() as i32 - metrics.height as i32 - metrics.ymin;
        for (index, &part) in coverage.iter().enumerate().filter(|(_, part)| **part > 0) {
            let (x, y) = (index % metrics.width, index / metrics.width);
            canvas.dot(left + x as i32, top + y as i32, style.color, u32::from(part) * style.alpha / 255);
        }
    }
}

fn font(bytes: &'static [u8]) -> Result<Font, Failure> {
    Font::from_bytes(bytes, FontSettings::default())
        .map_err(|error| Failure::new(format!("a font of this build is damaged ({error}); build it again")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tracer::Frame;

    const STYLE: TextStyle =
        TextStyle { family: FontFamily::Bold, size_px: 20.0, tracking: 0.0, color: 0xff_ffff, alpha: 255 };

    #[test]
    fn a_score_does_not_dance_as_it_counts() {
        let text_renderer = TextRenderer::new().expect("the fonts are whole");
        assert_eq!(text_renderer.width("1,111,111", STYLE), text_renderer.width("8,888,888", STYLE));
    }

    #[test]
    fn fitted_text_is_never_wider_than_its_room() {
        let text_renderer = TextRenderer::new().expect("the fonts are whole");
        for (keys, action) in super::super::key_help::HELP.iter().chain(super::super::key_help::REPLAY_HELP) {
            for room in [10.0, 40.0, 90.0, 300.0] {
                for text in [*keys, *action] {
                    let width = text_renderer.width(text, text_renderer.fitted(text, STYLE, room));
                    assert!(width <= room * 1.001, "{text}: {width} in {room}");
                }
            }
        }
    }

    #[test]
    fn every_letter_of_the_help_is_in_the_fonts() {
        let mut text_renderer = TextRenderer::new().expect("the fonts are whole");
        let told = super::super::key_help::HELP.iter().flat_map(|(keys, action)| [*keys, *action]);
        for character in told.flat_map(str::chars).filter(|character| !character.is_whitespace()) {
            let mut frame = Frame::new(40, 40);
            let mut canvas = Canvas::new(&mut frame);
            text_renderer.write(&mut canvas, &character.to_string(), STYLE, Anchor::left(5.0, 25.0));
            assert!(frame.pixels.iter().any(|pixel| *pixel != 0), "{character} is blank");
            assert!(text_renderer.fonts[0].has_glyph(character), "{character} has no glyph");
        }
    }
}
