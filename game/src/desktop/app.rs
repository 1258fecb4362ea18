//! The main thread: what the window's events do, and when a picture is made and shown.

use super::painter::Painter;
use super::screenshot::Screenshot;
use super::surface::Surface;
use super::table_reload::Reload;
use super::{Look, Wake, opening};
use crate::frame_composer::{Picture, Quality};
use crate::hud::Times;
use crate::input::{Act, Held, Meaning, meaning};
use crate::session::{Clock, Cover, Session, Speed, complaint, title, zoom};
use crate::{Buttons, Failure, Table};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tracer::Frame;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::keyboard::KeyCode;
use winit::window::{Fullscreen, Window};

mod events;
mod pictures;

/// How long a notice stands.
const NOTICE: Duration = Duration::from_secs(5);
/// The longest that the simulation waits for its ticks while a picture is being made.
const TICKING: Duration = Duration::from_millis(8);
/// How often a window in which nothing happens looks around.
const RESTING: Duration = Duration::from_millis(200);
/// Everything that the main thread has.
pub struct App {
    session: Session,
    look: Look,
    /// Which light holds the monitor's rate.
    quality: Quality,
    proxy: EventLoopProxy<Wake>,
    /// Until there is a window to paint for.
    picture: Option<Picture>,
    painter: Option<Painter>,
    window: Option<Arc<Window>>,
    surface: Option<Surface>,
    reload: Option<Reload>,
    new_table: Option<Arc<Table>>,
    held: Held,
    clock: Clock,
    clock_at: Instant,
    started: Instant,
    cover: Cover,
    overlay: bool,
    hidden: bool,
    /// The keyboard is ours.
    focused: bool,
    /// Something has changed since the last picture was ordered.
    dirty: bool,
    notice: Option<(String, Instant)>,
    saving: Screenshot,
    shown: Frame,
    used: Frame,
    times: Times,
    shown_at: Instant,
    next_frame: Instant,
    interval: Duration,
    failure: Option<Failure>,
}

impl App {
    /// An application that has no window yet.
    pub fn new(session: Session, picture: Picture, look: Look, proxy: EventLoopProxy<Wake>) -> App {
        let now = now();
        let reload = match &session {
            Session::Game(game) if !game.is_bound_to_table() => Some(Reload::new(&picture.table().dir)),
            _ => None,
        };
        App {
            session,
            look,
            quality: Quality::default(),
            proxy,
            picture: Some(picture),
            painter: None,
            window: None,
            surface: None,
            reload,
            new_table: None,
            held: Held::default(),
            clock: Clock::default(),
            clock_at: now,
            started: now,
            cover: Cover::None,
            overlay: false,
            hidden: false,
            focused: false,
            dirty: true,
            notice: None,
            saving: Screenshot::default(),
            shown: Frame::default(),
            used: Frame::default(),
            times: Times::default(),
            shown_at: now,
            next_frame: now,
            interval: opening::interval(None),
            failure: None,
        }
    }

    /// Writes the end of the recordings, when the window is closed.
    ///
    /// # Errors
    /// What made the window close, if it was not the player.
    pub fn finish(mut self) -> Result<(), Failure> {
        let recorded = match &mut self.session {
            Session::Game(game) => game.finish(),
            Session::Viewing(_) => Ok(()),
        };
        self.failure.map_or(recorded, Err)
    }

    fn open(&mut self, events: &ActiveEventLoop) -> Result<(), Failure> {
        let title = title(&self.session, self.picture.as_ref().map_or("", |picture| &picture.table().title));
        let window = Arc::new(opening::window(events, self.look, &title)?);
        self.surface = Some(Surface::new(events.owned_display_handle(), window.clone())?);
        self.interval = opening::interval(window.current_monitor());
        self.window = Some(window);
        if let Some(picture) = self.picture.take() {
            let proxy = self.proxy.clone();
            self.painter = Some(Painter::start(picture, move || wake(&proxy))?);
        }
        self.clock_at = now();
        Ok(())
    }

    fn is_running(&self) -> bool {
        let moves = match &self.session {
            Session::Game(_) => true,
            Session::Viewing(viewing) => !viewing.paused,
        };
        moves && self.cover == Cover::None
    }

    /// Plays the ticks that are due: called before anything that may change what they are played with.
    fn catch_up(&mut self) {
        let now = now();
        let elapsed_ns = now.duration_since(self.clock_at).as_nanos() as u64;
        self.clock_at = now;
        if !self.is_running() {
            return;
        }
        let ticks = match &mut self.session {
            Session::Game(game) => {
                let ticks = self.clock.ticks(elapsed_ns, Speed::REAL);
                game.play(ticks, self.held.buttons());
                ticks
            }
            Session::Viewing(viewing) => {
                let ticks = self.clock.ticks(elapsed_ns, viewing.speed);
                viewing.play(ticks);
                ticks
            }
        };
        self.dirty |= ticks > 0;
        self.follow_session();
    }

    /// What the session has come to by itself.
    fn follow_session(&mut self) {
        if let Session::Game(game) = &mut self.session
            && game.has_watched()
        {
            game.return_to_game();
            self.cover = Cover::Paused;
        }
        let complaint = complaint(&mut self.session);
        if let Some(complaint) = complaint {
            self.tell(complaint);
        }
    }

    fn tell(&mut self, text: String) {
        self.notice = Some((text, now() + NOTICE));
        self.dirty = true;
    }

    fn key(&mut self, events: &ActiveEventLoop, key: KeyCode, down: bool) {
        self.catch_up();
        if !down {
            self.held.release(key);
            return;
        }
        self.dirty = true;
        if let Session::Viewing(viewing) = &mut self.session
            && self.cover == Cover::None
        {
            match key {
                KeyCode::Space => return viewing.toggle_pause(),
                KeyCode::ArrowLeft => return viewing.seek(false),
                KeyCode::ArrowRight => return viewing.seek(true),
                KeyCode::ArrowUp => return viewing.speed = viewing.speed.faster(),
                KeyCode::ArrowDown => return viewing.speed = viewing.speed.slower(),
                _ => {}
            }
        }
        match meaning(key) {
            Some(Meaning::Act(act)) => self.act(events, act),
            Some(Meaning::Button(buttons)) => self.held.press(key, buttons),
            Some(Meaning::Plunge) => self.plunge(key),
            None => {}
        }
    }

    /// When the keyboard goes to another window, nothing is held any more and the player's game waits. A window that
    /// never had it (some systems say so as it opens) has nothing to lose.
    fn focus(&mut self, focused: bool) {
        self.catch_up();
        let lost = std::mem::replace(&mut self.focused, focused) && !focused;
        if !lost {
            return;
        }
        self.held.release_all();
        let plays = matches!(&self.session, Session::Game(game) if game.badge().is_none());
        if plays && self.cover == Cover::None {
            self.cover_with(Cover::Paused);
        }
    }

    fn plunge(&mut self, key: KeyCode) {
        match &self.session {
            // A card goes away without a ball being shot.
            _ if self.cover != Cover::None => self.uncover(),
            Session::Game(game) if game.is_on() => self.held.press(key, Buttons::PLUNGER),
            Session::Game(_) => self.held.press(key, Buttons::START),
            Session::Viewing(_) => {}
        }
    }

    fn act(&mut self, events: &ActiveEventLoop, act: Act) {
        match act {
            Act::Pause => self.pause_key(events),
            Act::Help if self.cover == Cover::Help => self.uncover(),
            Act::Help => self.cover_with(Cover::Help),
            Act::Quit if self.cover != Cover::None || matches!(self.session, Session::Viewing(_)) => events.exit(),
            Act::Quit => {}
            Act::Fullscreen => self.toggle_fullscreen(),
            Act::Overlay => self.overlay = !self.overlay,
            Act::Screenshot => self.screenshot(),
            Act::LastBall => self.last_ball(),
            Act::Closer => self.look.zoom = zoom::closer(self.look.zoom),
            Act::Farther => self.look.zoom = zoom::farther(self.look.zoom),
        }
    }

    fn pause_key(&mut self, events: &ActiveEventLoop) {
        match &mut self.session {
            Session::Viewing(_) if self.cover == Cover::None => events.exit(),
            Session::Game(game) if game.is_watching() => {
                game.return_to_game();
                self.cover_with(Cover::Paused);
            }
            _ if self.cover != Cover::None => self.uncover(),
            _ => self.cover_with(Cover::Paused),
        }
    }

    fn cover_with(&mut self, cover: Cover) {
        self.held.release_all();
        self.cover = cover;
        self.dirty = true;
    }

    fn uncover(&mut self) {
        self.held.release_all();
        self.cover = Cover::None;
        self.clock_at = now();
    }

    fn last_ball(&mut self) {
        let Session::Game(game) = &mut self.session else { return };
        if game.is_watching() {
            game.return_to_game();
            self.cover_with(Cover::Paused);
        } else if game.watch_last_ball() {
            self.uncover();
        } else {
            self.tell("No ball has been played yet.".to_string());
        }
    }

    fn toggle_fullscreen(&mut self) {
        let Some(window) = &self.window else { return };
        let fills = window.fullscreen().is_some();
        window.set_fullscreen((!fills).then_some(Fullscreen::Borderless(None)));
        window.set_cursor_visible(fills);
    }

    fn screenshot(&mut self) {
        let proxy = self.proxy.clone();
        if let Err(failure) = self.saving.save(&self.shown, move || wake(&proxy)) {
            self.tell(failure.to_string());
        }
    }

    fn wait(&self) -> ControlFlow {
        let now = now();
        let busy = self.painter.as_ref().is_some_and(Painter::is_busy);
        let rest = if self.is_running() { TICKING } else { RESTING };
        let until = now + rest;
        ControlFlow::WaitUntil(if self.dirty && !busy && !self.hidden { until.min(self.next_frame) } else { until })
    }
}

/// Wakes the main thread. Its loop is gone only when the window has been closed: then nobody waits for anything.
fn wake(proxy: &EventLoopProxy<Wake>) {
    let _ = proxy.send_event(Wake);
}

#[expect(clippy::disallowed_methods, reason = "the window is where real time comes in")]
fn now() -> Instant {
    Instant::now()
}

fn milliseconds(from: Instant, to: Instant) -> f64 {
    to.duration_since(from).as_secs_f64() * 1000.0
}
