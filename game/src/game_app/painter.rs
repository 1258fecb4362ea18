//! The game's painter: from the input of one frame to its pixels, on a thread of its own.

use crate::frame_composer::{FrameComposer, Interpolation, LightResolution};
use crate::hud::{FrameTimes, UiState};
use crate::screen::Size;
use crate::{Failure, Snapshot, Table};
use std::sync::Arc;
use tracer::Frame;

/// All that one frame of the game is painted from.
pub struct FrameInput {
    /// The snapshot of the earlier tick.
    pub previous: Arc<Snapshot>,
    /// The snapshot of the later tick.
    pub current: Arc<Snapshot>,
    /// How far from the earlier to the later, 0 to 1.
    pub alpha: f64,
    /// The frame's size.
    pub size: Size,
    /// At which resolution light is found.
    pub light: LightResolution,
    /// How much larger than the window the table is drawn.
    pub zoom: f64,
    /// What the application adds to the snapshots.
    pub ui_state: UiState,
    /// The table, if it is another than the last time.
    pub table: Option<Arc<Table>>,
}

/// What the painter tells of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameReport {
    /// What it cost.
    pub times: FrameTimes,
    /// The later of the ticks that it lies between.
    pub tick: u64,
    /// Its light was found at the resolution that was asked for.
    pub as_asked: bool,
    /// It is not yet all that was asked for: another one is wanted.
    pub preparing: bool,
}

/// What paints the game's frames with this composer, and tells of each.
pub fn painter(
    mut composer: FrameComposer,
) -> impl FnMut(FrameInput, &mut Frame) -> Result<FrameReport, Failure> + Send + 'static {
    composer.prepare_beside();
    move |input, frame| {
        if let Some(table) = input.table {
            composer.set_table(table);
        }
        composer.set_light_resolution(input.light);
        composer.set_zoom(input.zoom);
        let interpolation = Interpolation { previous: &input.previous, current: &input.current, alpha: input.alpha };
        copy(composer.draw(interpolation, input.size, &input.ui_state)?, frame);
        Ok(FrameReport {
            times: composer.times(),
            tick: input.current.tick,
            as_asked: composer.drawn_light() == Some(input.light),
            preparing: composer.is_preparing(),
        })
    }
}

/// Copies a frame into the memory of another.
fn copy(from: &Frame, to: &mut Frame) {
    (to.width, to.height) = (from.width, from.height);
    to.pixels.clear();
    to.pixels.extend_from_slice(&from.pixels);
}
