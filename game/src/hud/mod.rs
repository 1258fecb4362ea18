//! The display: what is told to the player around and over the table.
//!
//! A night observatory: blue-black, brass hairlines, an amber dot matrix. Everything that lasts is drawn once and
//! copied; it is drawn again only when what it says changes. The display is a function of the moment and of what the
//! window adds; it refuses to know a clock, a key or a file.

mod backdrop;
mod debug_overlay;
mod dialog;
mod dmd;
mod key_help;
mod panel;
mod text;

pub use debug_overlay::{Debug, Times, Touch};
pub use dialog::{Card, Seek};
pub use key_help::{HELP as KEYS, REPLAY_HELP as REPLAY_KEYS};

use crate::screen::{Canvas, Lens, Placement, Rect, Side};
use crate::simulation::Snapshot;
use crate::{Failure, Table};
use dialog::Panes;
use dmd::{Dots, Matrix};
use panel::{Lines, Words};
use text::Lettering;
use tracer::Frame;

const NIGHT: u32 = 0x06_0810;
const BRASS: u32 = 0xb0_8d57;
const AMBER: u32 = 0xff_b347;
const IVORY: u32 = 0xec_e6d6;
const MIST: u32 = 0x86_8fa3;

/// Who is at the machine, if not the player.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Badge {
    /// A recording.
    Replay,
    /// The bot.
    Bot,
}

/// What a window adds to the moment.
#[derive(Clone, Default)]
pub struct Chrome {
    /// Who is at the machine.
    pub badge: Option<Badge>,
    /// A sentence for the player.
    pub notice: Option<String>,
    /// What covers the table.
    pub card: Option<&'static Card>,
    /// How far a replay is.
    pub seek: Option<Seek>,
    /// What happens behind the picture.
    pub debug: Option<Debug>,
}

/// The display and everything that it keeps.
pub struct Hud {
    lettering: Lettering,
    placement: Option<Placement>,
    backdrop: Frame,
    matrix: Matrix,
    dots: Option<Dots>,
    words: Option<Words>,
    lines: Lines,
    panes: Panes,
    overlay: debug_overlay::Overlay,
}

impl Hud {
    /// A display that has drawn nothing yet.
    ///
    /// # Errors
    /// If a font in the program is damaged.
    pub fn new() -> Result<Hud, Failure> {
        Ok(Hud {
            lettering: Lettering::new()?,
            placement: None,
            backdrop: Frame::default(),
            matrix: Matrix::new(0),
            dots: None,
            words: None,
            lines: Lines::default(),
            panes: Panes::default(),
            overlay: debug_overlay::Overlay::default(),
        })
    }

    /// Draws what surrounds the table at a new size; `frame` must have that size.
    pub fn fit(&mut self, placement: Placement, frame: &mut Frame) {
        if self.placement == Some(placement) {
            return;
        }
        self.backdrop = Frame::new(placement.width, placement.height);
        backdrop::draw(&mut Canvas::new(&mut self.backdrop), &placement);
        frame.clone_from(&self.backdrop);
        self.overlay = debug_overlay::Overlay::default();
        self.matrix = Matrix::new(placement.pitch);
        (self.placement, self.dots, self.words) = (Some(placement), None, None);
    }

    /// Puts back what surrounds the table in `rect`.
    pub fn restore(&self, frame: &mut Frame, rect: Rect) {
        Canvas::new(frame).copy(&self.backdrop, rect, (rect.x, rect.y));
    }

    /// Draws what has changed around the table.
    pub fn draw_around(&mut self, table: &Table, moment: &Snapshot, chrome: &Chrome, frame: &mut Frame) {
        let Some(placement) = self.placement else { return };
        let dots = dmd::page(&moment.display, moment.tick);
        if placement.pitch > 0 && self.dots.as_ref() != Some(&dots) {
            self.matrix.draw(&mut Canvas::new(frame), placement.matrix, &dots);
            self.dots = Some(dots);
        }
        let words = Words::new(table, moment, chrome);
        if self.words.as_ref() != Some(&words) {
            self.draw_words(&placement, &words, frame);
            self.words = Some(words);
        }
    }

    fn draw_words(&mut self, placement: &Placement, words: &Words, frame: &mut Frame) {
        let rects = match placement.side {
            Side::Band(left, right) => vec![left, right],
            Side::Panel(panel) => {
                let below = placement.matrix.bottom().max(panel.y);
                let above = Rect::new(panel.x, panel.y, panel.width, placement.matrix.y - panel.y);
                vec![above, Rect::new(panel.x, below, panel.width, panel.bottom() - below)]
            }
        };
        for rect in rects {
            self.restore(frame, rect);
            let canvas = &mut Canvas::new(frame);
            panel::draw(&mut canvas.within(rect), &mut self.lettering, &mut self.lines, placement, words);
        }
    }

    /// Draws what lies over the table, whose points are where `lens` says; the table itself must have been drawn anew.
    pub fn draw_over(&mut self, table: &Table, moment: &Snapshot, chrome: &Chrome, lens: Lens, frame: &mut Frame) {
        let Some(placement) = self.placement else { return };
        let mut canvas = Canvas::new(frame);
        let mut canvas = canvas.within(placement.table);
        if let Some(debug) = &chrome.debug {
            let subject = debug_overlay::Subject { table, placement: &placement, lens, moment };
            self.overlay.draw(&mut canvas, &mut self.lettering, &subject, debug);
        }
        if let Some(seek) = &chrome.seek {
            dialog::seek(&mut canvas, &mut self.lettering, &mut self.panes, placement.table, seek);
        }
        if let Some(card) = chrome.card {
            dialog::draw(&mut canvas, &mut self.lettering, &mut self.panes, placement.table, card);
        }
        if let Some(text) = &chrome.notice {
            dialog::notice(&mut canvas, &mut self.lettering, &mut self.panes, placement.table, text);
        }
    }
}
