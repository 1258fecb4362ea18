//! The head-up display (HUD): what is told to the player around and over the table.
//!
//! A night observatory: blue-black, brass hairlines, an amber dot matrix. Everything that lasts is drawn once and
//! copied; it is drawn again only when what it says changes. The HUD is a function of the snapshot and of the UI state;
//! it refuses to know a clock, a key or a file.

mod backdrop;
mod debug_overlay;
mod dialog;
mod dmd;
mod frame_times;
mod key_help;
mod notice;
mod palette;
mod panel;
mod replay_bar;
mod text;
mod ui_state;

pub use debug_overlay::{DebugInfo, TrailContact};
pub use dialog::Dialog;
pub use dmd::{has_dots, reading_ms};
pub use frame_times::{FrameRates, FrameTimes};
pub use key_help::{HELP as KEYS, REPLAY_HELP as REPLAY_KEYS};
pub use palette::{BRASS, IVORY, NIGHT};
pub use replay_bar::ReplayProgress;
pub use text::{Anchor, FontFamily, TextRenderer, TextStyle};
pub use ui_state::{Badge, UiState};

use crate::screen::{CachedLayer, Canvas, Placement, Rect, ScreenFromTable, Side};
use crate::simulation::Snapshot;
use crate::{Failure, Table};
use debug_overlay::{DebugOverlay, OverlayView};
use dmd::{DmdRaster, Dots};
use panel::{PanelText, ProgressLines};
use tracer::Frame;

/// The HUD and everything that it keeps from frame to frame.
pub struct Hud {
    text_renderer: TextRenderer,
    placement: Option<Placement>,
    backdrop: Frame,
    dmd_raster: DmdRaster,
    dots: Option<Dots>,
    panel_text: Option<PanelText>,
    progress_lines: ProgressLines,
    dialog_pane: CachedLayer<()>,
    notice_pane: CachedLayer<()>,
    replay_bar: CachedLayer<i32>,
    debug_overlay: DebugOverlay,
}

impl Hud {
    /// A HUD that has drawn nothing yet.
    ///
    /// # Errors
    /// If a font in the program is damaged.
    pub fn new() -> Result<Hud, Failure> {
        Ok(Hud {
            text_renderer: TextRenderer::new()?,
            placement: None,
            backdrop: Frame::default(),
            dmd_raster: DmdRaster::new(0),
            dots: None,
            panel_text: None,
            progress_lines: ProgressLines::default(),
            dialog_pane: CachedLayer::default(),
            notice_pane: CachedLayer::default(),
            replay_bar: CachedLayer::default(),
            debug_overlay: DebugOverlay::default(),
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
        self.debug_overlay = DebugOverlay::default();
        self.dmd_raster = DmdRaster::new(placement.pitch);
        (self.placement, self.dots, self.panel_text) = (Some(placement), None, None);
    }

    /// Puts back what surrounds the table in `rect`.
    pub fn restore(&self, frame: &mut Frame, rect: Rect) {
        Canvas::new(frame).copy(&self.backdrop, rect, (rect.x, rect.y));
    }

    /// Draws what has changed around the table.
    pub fn draw_around(&mut self, table: &Table, snapshot: &Snapshot, ui_state: &UiState, frame: &mut Frame) {
        let Some(placement) = self.placement else { return };
        let dots = dmd::animation_dots(&snapshot.display, snapshot.tick);
        if placement.pitch > 0 && self.dots.as_ref() != Some(&dots) {
            self.dmd_raster.draw(&mut Canvas::new(frame), placement.matrix, &dots);
            self.dots = Some(dots);
        }
        let panel_text = PanelText::new(table, snapshot, ui_state);
        if self.panel_text.as_ref() != Some(&panel_text) {
            self.draw_words(&placement, &panel_text, frame);
            self.panel_text = Some(panel_text);
        }
    }

    fn draw_words(&mut self, placement: &Placement, panel_text: &PanelText, frame: &mut Frame) {
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
            panel::draw(
                &mut canvas.within(rect),
                &mut self.text_renderer,
                &mut self.progress_lines,
                placement,
                panel_text,
            );
        }
    }

    /// Draws what lies over the table, whose points are where `screen_from_table` says; the table itself must have been
    /// drawn anew.
    pub fn draw_over(
        &mut self,
        table: &Table,
        snapshot: &Snapshot,
        ui_state: &UiState,
        screen_from_table: ScreenFromTable,
        frame: &mut Frame,
    ) {
        let Some(placement) = self.placement else { return };
        let mut canvas = Canvas::new(frame);
        let mut canvas = canvas.within(placement.table);
        let text = &mut self.text_renderer;
        if let Some(debug) = &ui_state.debug {
            let view = OverlayView { table, placement: &placement, screen_from_table, snapshot };
            self.debug_overlay.draw(&mut canvas, text, &view, debug);
        }
        if let Some(progress) = &ui_state.replay {
            replay_bar::draw(&mut canvas, text, &mut self.replay_bar, placement.table, progress);
        }
        if let Some(dialog) = ui_state.dialog {
            dialog::draw(&mut canvas, text, &mut self.dialog_pane, placement.table, dialog);
        }
        if let Some(sentence) = &ui_state.notice {
            let bottom =
                ui_state.replay.as_ref().map_or(placement.table.bottom(), |_| replay_bar::pane(placement.table).y);
            let free = Rect { height: bottom - placement.table.y, ..placement.table };
            notice::draw(&mut canvas, text, &mut self.notice_pane, free, sentence);
        }
    }
}
