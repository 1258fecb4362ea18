//! The game's application: a session, and what the window has to know beside it.

use super::DisplayOptions;
use super::frame_statistics::FrameStatistics;
use super::painter::{FrameInput, FrameReport};
use super::table_reload::TableReload;
use crate::desktop::{App, Commands, Event, FrameTiming};
use crate::frame_composer::{DynamicResolution, LightResolution};
use crate::hud::FrameTimes;
use crate::input::HeldKeys;
use crate::screen::Size;
use crate::session::{Modal, Session, TickClock};
use crate::{Failure, Table, tell};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// How long a notice stands.
const NOTICE: Duration = Duration::from_secs(5);

/// A session in a window.
pub struct GameApp {
    pub(super) session: Session,
    pub(super) modal: Modal,
    pub(super) held: HeldKeys,
    pub(super) view: ViewSettings,
    clock: SessionClock,
    notice: Option<Notice>,
    cost: FrameCost,
    table: TableUpdates,
}

/// How the table is looked at.
pub(super) struct ViewSettings {
    /// How much larger than the window the table is drawn.
    pub zoom: f64,
    /// The debug overlay is on.
    pub debug_overlay: bool,
    /// At which resolution light is found; `None` for the highest that holds the monitor's rate.
    light: Option<LightResolution>,
}

/// Up to when the session has been played.
#[derive(Default)]
struct SessionClock {
    now: Duration,
    ticks: TickClock,
}

/// A sentence for the player, for a while.
struct Notice {
    text: String,
    until: Duration,
}

/// What the last frames cost, and what follows from that.
#[derive(Default)]
struct FrameCost {
    times: FrameTimes,
    statistics: FrameStatistics,
    resolution: DynamicResolution,
}

/// The table's files, and the table that they were last read as.
struct TableUpdates {
    /// `None` if the session is bound to its table.
    reload: Option<TableReload>,
    /// For the next frame.
    new: Option<Arc<Table>>,
}

impl GameApp {
    /// An application that shows `session`, whose table was read from `table_dir`.
    pub fn new(session: Session, options: DisplayOptions, table_dir: &Path) -> GameApp {
        let reload = match &session {
            Session::Live(game) if !game.is_bound_to_table() => Some(TableReload::new(table_dir)),
            _ => None,
        };
        GameApp {
            session,
            modal: Modal::None,
            held: HeldKeys::default(),
            view: ViewSettings { zoom: options.zoom, debug_overlay: false, light: options.light },
            clock: SessionClock::default(),
            notice: None,
            cost: FrameCost::default(),
            table: TableUpdates { reload, new: None },
        }
    }

    /// Writes the end of the recordings, when the window is closed.
    ///
    /// # Errors
    /// If the recording that was asked for is not whole.
    pub fn finish(mut self) -> Result<(), Failure> {
        match &mut self.session {
            Session::Live(game) => game.finish(),
            Session::Replay(_) => Ok(()),
        }
    }

    fn is_running(&self) -> bool {
        self.session.is_moving() && self.modal == Modal::None
    }

    /// Plays the ticks that are due: called before anything that may change what they are played with.
    fn play(&mut self, now: Duration, commands: &mut Commands) {
        let elapsed = now.saturating_sub(std::mem::replace(&mut self.clock.now, now));
        if !self.is_running() {
            return;
        }
        let speed = self.session.speed();
        let ticks = self.clock.ticks.ticks(elapsed.as_nanos() as u64, speed);
        match &mut self.session {
            Session::Live(game) => game.play(ticks, self.held.buttons()),
            Session::Replay(replay) => replay.play(ticks),
        }
        commands.redraw |= ticks > 0;
        self.follow_session(commands);
    }

    /// What the session has come to by itself.
    fn follow_session(&mut self, commands: &mut Commands) {
        if let Session::Live(game) = &mut self.session
            && game.has_watched()
        {
            game.return_to_game();
            self.modal = Modal::Paused;
        }
        if let Some(complaint) = self.session.complaint() {
            self.tell(complaint, commands);
        }
    }

    /// Shows the player a sentence for a while.
    pub(super) fn tell(&mut self, text: String, commands: &mut Commands) {
        self.notice = Some(Notice { text, until: self.clock.now + NOTICE });
        commands.redraw = true;
    }

    fn end_notice(&mut self, commands: &mut Commands) {
        if self.notice.as_ref().is_some_and(|notice| self.clock.now > notice.until) {
            self.notice = None;
            commands.redraw = true;
        }
    }

    /// Goes on with the table as it was last saved, if it was.
    fn update_table(&mut self, commands: &mut Commands) {
        let Some(reload) = &mut self.table.reload else { return };
        reload.look(self.clock.now, commands.waker());
        let Some(loaded) = reload.take() else { return };
        let taken = loaded.and_then(|table| {
            if let Session::Live(game) = &mut self.session {
                game.set_table(table.clone())?;
            }
            Ok(table)
        });
        match taken {
            Ok(table) => {
                self.table.new = Some(table);
                self.tell("The table was read again.".to_string(), commands);
            }
            Err(failure) => {
                tell(&failure);
                self.tell(failure.to_string(), commands);
            }
        }
    }

    fn frame_shown(&mut self, report: FrameReport, timing: FrameTiming, commands: &mut Commands) {
        let FrameReport { times, tick, as_asked, preparing } = report;
        let FrameTiming { shown_at, present_ms, between_ms, monitor_ms } = timing;
        self.cost.statistics.shown(shown_at, tick);
        self.cost.times = FrameTimes { present_ms, between_ms, rates: self.cost.statistics.rates(), ..times };
        // While nothing moves, a frame costs next to nothing, and says as much; one of another resolution says nothing.
        if self.is_running() && as_asked {
            self.cost.resolution.judge(times.drawn_ms(), monitor_ms);
        }
        commands.redraw |= preparing;
    }

    /// A button went down or came up: its picture is waited for, if it changes what is seen.
    pub(super) fn await_picture(&mut self) {
        match &self.session {
            Session::Live(game) if self.is_running() && !game.is_watching() => {
                let next = game.snapshots().1.tick + 1;
                self.cost.statistics.input(self.clock.now, next);
            }
            _ => self.cost.statistics.forget_inputs(),
        }
    }
}

impl App for GameApp {
    type FrameInput = FrameInput;
    type FrameReport = FrameReport;

    fn update(&mut self, now: Duration, commands: &mut Commands) {
        self.play(now, commands);
        self.end_notice(commands);
        self.update_table(commands);
    }

    fn event(&mut self, event: Event<FrameReport>, commands: &mut Commands) {
        match event {
            Event::Key { key, down } => self.key(key, down, commands),
            Event::Pointer(_) => {}
            Event::FocusLost => self.lose_focus(commands),
            Event::FrameShown { report, timing } => self.frame_shown(report, timing, commands),
            Event::Message(text) => self.tell(text, commands),
        }
    }

    fn frame_input(&mut self, size: Size) -> FrameInput {
        let (previous, current) = self.session.snapshots();
        let notice = self.notice.as_ref().map(|notice| notice.text.clone());
        FrameInput {
            previous: previous.clone(),
            current: current.clone(),
            // What stands still is a tick itself, so that it can be found again in the recording.
            alpha: if self.is_running() { self.clock.ticks.alpha() } else { 1.0 },
            size,
            light: self.view.light.unwrap_or(self.cost.resolution.light()),
            zoom: self.view.zoom,
            ui_state: self.session.ui_state(self.modal, notice, self.view.debug_overlay.then_some(self.cost.times)),
            table: self.table.new.take(),
        }
    }

    fn is_animating(&self) -> bool {
        self.is_running()
    }
}
