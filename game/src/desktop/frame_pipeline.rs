//! The frame pipeline: when a frame is ordered from the painter, and what becomes of it.

use super::FrameTiming;
use super::painter_thread::{Painted, PainterThread};
use super::shell_window::ShellWindow;
use crate::screen::Size;
use std::time::{Duration, Instant};
use tracer::Frame;

/// The frames on their way from the painter to the window.
pub struct FramePipeline<I, R> {
    thread: PainterThread<I, R>,
    /// The frame in the window.
    shown: Frame,
    shown_at: Instant,
    /// When the shell was started.
    started: Instant,
    /// The memory of the frame before that, for the next.
    spare: Frame,
    /// From one frame of the monitor to the next.
    interval: Duration,
    /// When the next frame may be ordered.
    next_frame: Instant,
    /// Something has changed since the last frame was ordered.
    dirty: bool,
    /// No part of the window can be seen.
    hidden: bool,
}

impl<I: Send + 'static, R: Send + 'static> FramePipeline<I, R> {
    /// A pipeline for a monitor that shows a frame every `interval`, of a shell that was started then.
    pub fn new(thread: PainterThread<I, R>, interval: Duration, started: Instant) -> FramePipeline<I, R> {
        let now = now();
        FramePipeline {
            thread,
            shown: Frame::default(),
            shown_at: now,
            started,
            spare: Frame::default(),
            interval,
            next_frame: now,
            dirty: true,
            hidden: false,
        }
    }

    /// The frame in the window.
    pub fn shown(&self) -> &Frame {
        &self.shown
    }

    /// A new frame is wanted.
    pub fn mark_dirty(&mut self) {
        self.dirty = true;
    }

    /// No part of the window can be seen any more, or one can again.
    pub fn set_hidden(&mut self, hidden: bool) {
        self.hidden = hidden;
        self.dirty = true;
    }

    /// What the painter has finished.
    pub fn take(&mut self) -> Option<Painted<R>> {
        self.thread.take()
    }

    /// Shows a frame in the window.
    pub fn show(&mut self, frame: Frame, window: &mut ShellWindow) -> FrameTiming {
        self.spare = std::mem::replace(&mut self.shown, frame);
        let start = now();
        window.present(&self.shown);
        let end = now();
        let between = end.duration_since(self.shown_at);
        self.shown_at = end;
        let ms = |duration: Duration| duration.as_secs_f64() * 1000.0;
        FrameTiming {
            shown_at: end.duration_since(self.started),
            present_ms: ms(end.duration_since(start)),
            between_ms: ms(between),
            monitor_ms: ms(self.interval),
        }
    }

    /// Whether a frame of this size is due.
    pub fn is_due(&self, size: Size) -> bool {
        let nowhere = self.hidden || size.width == 0 || size.height == 0 || !size.is_drawable();
        !self.thread.is_busy() && self.dirty && now() >= self.next_frame && !nowhere
    }

    /// Orders a frame from the painter.
    pub fn order(&mut self, input: I) {
        let now = now();
        self.dirty = false;
        self.next_frame = (self.next_frame + self.interval).max(now + self.interval / 2);
        self.thread.order(input, std::mem::take(&mut self.spare));
    }

    /// When the main thread must look again, `rest` from now at the latest.
    pub fn wake_at(&self, rest: Duration) -> Instant {
        let until = now() + rest;
        if self.dirty && !self.thread.is_busy() && !self.hidden { until.min(self.next_frame) } else { until }
    }
}

/// The time that frames are paced by.
#[expect(clippy::disallowed_methods, reason = "the shell is where real time comes in")]
pub fn now() -> Instant {
    Instant::now()
}
