//! Pictures, from the order to the screen, and what else other threads have done meanwhile.

use super::{App, milliseconds, now, wake};
use crate::cli::LightChoice;
use crate::desktop::painter::{Order, Painter};
use crate::desktop::surface;
use crate::hud::Times;
use crate::session::{Session, chrome, snapshots};

impl App {
    /// Takes what other threads have done.
    pub(super) fn collect(&mut self) {
        if let Some(text) = self.saving.news() {
            self.tell(text);
        }
        if self.notice.as_ref().is_some_and(|(_, until)| now() > *until) {
            self.notice = None;
            self.dirty = true;
        }
        self.collect_table();
        if let Some(done) = self.painter.as_mut().and_then(Painter::take) {
            self.times = Times { present_ms: self.times.present_ms, between_ms: self.times.between_ms, ..done.times };
            match done.frame {
                Ok(frame) => {
                    self.judge();
                    self.used = std::mem::replace(&mut self.shown, frame);
                    self.present();
                    self.times.between_ms = milliseconds(self.shown_at, now());
                    self.shown_at = now();
                }
                Err(failure) => self.tell(failure.to_string()),
            }
        }
    }

    /// While nothing moves, a picture costs next to nothing, and says as much.
    fn judge(&mut self) {
        if self.is_running() {
            self.quality.judge(self.times.drawn_ms(), self.interval.as_secs_f64() * 1000.0);
        }
    }

    fn collect_table(&mut self) {
        let Some(reload) = &mut self.reload else { return };
        let proxy = self.proxy.clone();
        reload.look(now().duration_since(self.started), move || wake(&proxy));
        let Some(loaded) = reload.take() else { return };
        let taken = loaded.and_then(|table| {
            if let Session::Game(game) = &mut self.session {
                game.set_table(table.clone())?;
            }
            Ok(table)
        });
        match taken {
            Ok(table) => {
                self.new_table = Some(table);
                self.tell("The table was read again.".to_string());
            }
            Err(failure) => {
                failure.tell();
                self.tell(failure.to_string());
            }
        }
    }

    pub(super) fn present(&mut self) {
        if let Some(surface) = &mut self.surface {
            let start = now();
            surface.present(&self.shown);
            self.times.present_ms = milliseconds(start, now());
        }
    }

    /// Orders a picture if one is due.
    pub(super) fn order(&mut self) {
        let (now, running) = (now(), self.is_running());
        let (Some(window), Some(painter)) = (&self.window, &mut self.painter) else { return };
        let size = window.inner_size();
        let nowhere = self.hidden || size.width == 0 || size.height == 0 || !surface::takes(size);
        if painter.is_busy() || !self.dirty || now < self.next_frame || nowhere {
            return;
        }
        self.dirty = false;
        // What stands still is a tick itself, so that it can be found again in the recording.
        let alpha = if running { self.clock.alpha() } else { 1.0 };
        self.next_frame = (self.next_frame + self.interval).max(now + self.interval / 2);
        let (previous, current) = snapshots(&self.session);
        let notice = self.notice.as_ref().map(|(text, _)| text.clone());
        let chrome = chrome(&self.session, self.cover, notice, self.overlay.then_some(self.times));
        painter.order(Order {
            previous: previous.clone(),
            current: current.clone(),
            alpha,
            width: size.width as usize,
            height: size.height as usize,
            light: if self.look.light == LightChoice::Auto { self.quality.light() } else { self.look.light.at_rest() },
            zoom: self.look.zoom,
            chrome,
            table: self.new_table.take(),
            used: std::mem::take(&mut self.used),
        });
    }
}
