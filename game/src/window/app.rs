//! The main thread: what the window's events do, and when a picture is made and shown.

use super::clock::{Clock, Speed};
use super::game::Game;
use super::keys::{Act, Held, Meaning, meaning};
use super::painter::{Order, Painter};
use super::reload::Reload;
use super::surface::Surface;
use super::viewing::Viewing;
use super::{Look, Wake, icon};
use crate::hud::{Badge, Card, Chrome, Debug, KEYS, REPLAY_KEYS, Times};
use crate::picture::{Picture, save_png};
use crate::{Buttons, Failure, Snapshot, Table};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant, SystemTime};
use tracer::Frame;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{ElementState, KeyEvent, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::keyboard::{KeyCode, PhysicalKey};
use winit::window::{Fullscreen, Window, WindowId};

/// A game or a recording.
pub enum Session {
    /// A game in play.
    Game(Box<Game>),
    /// A recording that is watched.
    Viewing(Box<Viewing>),
}

/// How long a notice stands.
const NOTICE: Duration = Duration::from_secs(5);
/// The longest that the simulation waits for its ticks while a picture is being made.
const TICKING: Duration = Duration::from_millis(8);
/// How often a window in which nothing happens looks around.
const RESTING: Duration = Duration::from_millis(200);
/// Pictures a second where the monitor does not say.
const USUAL_HZ: f64 = 60.0;
/// The part of the monitor's height that a new window takes.
const HEIGHT_PART: f64 = 0.86;

static PAUSED: Card = Card { title: "PAUSED", rows: KEYS, foot: "Esc  go on      Q  leave" };
static HELP: Card = Card { title: "KEYS", rows: KEYS, foot: "H  go on      Q  leave" };
static REPLAY_HELP: Card = Card { title: "KEYS", rows: REPLAY_KEYS, foot: "H  go on" };

/// What covers the table, and stops the game while it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Cover {
    None,
    Paused,
    Help,
}

/// Everything that the main thread has.
pub struct App {
    session: Session,
    look: Look,
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
    news: Receiver<String>,
    news_in: Sender<String>,
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
        let (news_in, news) = channel();
        let now = now();
        let reload = match &session {
            Session::Game(game) if !game.is_bound_to_table() => Some(Reload::new(&picture.table().dir)),
            _ => None,
        };
        App {
            session,
            look,
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
            news,
            news_in,
            shown: Frame::default(),
            used: Frame::default(),
            times: Times::default(),
            shown_at: now,
            next_frame: now,
            interval: Duration::from_secs_f64(1.0 / USUAL_HZ),
            failure: None,
        }
    }

    /// Writes the end of the recordings, when the window is closed.
    ///
    /// # Errors
    /// What made the window close, if it was not the player.
    pub fn finish(mut self) -> Result<(), Failure> {
        if let Session::Game(game) = &mut self.session {
            game.finish();
        }
        self.failure.map_or(Ok(()), Err)
    }

    fn open(&mut self, events: &ActiveEventLoop) -> Result<(), Failure> {
        let title = match (&self.session, &self.picture) {
            (Session::Viewing(_), Some(picture)) => format!("Caustic \u{2013} {} (replay)", picture.table().title),
            (_, Some(picture)) => format!("Caustic \u{2013} {}", picture.table().title),
            _ => "Caustic".to_string(),
        };
        let monitor = events.primary_monitor().or_else(|| events.available_monitors().next());
        let size = match (self.look.size, &monitor) {
            (Some(size), _) => PhysicalSize::new(size.width as u32, size.height as u32),
            (None, Some(monitor)) => usual_size(monitor.size()),
            (None, None) => PhysicalSize::new(540, 1080),
        };
        let attributes = Window::default_attributes()
            .with_title(title)
            .with_inner_size(size)
            .with_min_inner_size(PhysicalSize::new(64, 64))
            .with_window_icon(icon::icon())
            .with_fullscreen(self.look.fullscreen.then_some(Fullscreen::Borderless(None)));
        let window = events.create_window(attributes);
        let window = Arc::new(window.map_err(|error| Failure::new(format!("no window could be opened: {error}")))?);
        window.set_cursor_visible(!self.look.fullscreen);
        self.surface = Some(Surface::new(events.owned_display_handle(), window.clone())?);
        let hz = window.current_monitor().or(monitor).and_then(|monitor| monitor.refresh_rate_millihertz());
        let hz = hz.map_or(USUAL_HZ, |millihertz| f64::from(millihertz) / 1000.0);
        self.interval = Duration::from_secs_f64(1.0 / hz.clamp(10.0, 1000.0));
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
        let complaint = match &mut self.session {
            Session::Game(game) => {
                if game.has_watched() {
                    game.return_to_game();
                    self.cover = Cover::Paused;
                }
                game.complaints().pop()
            }
            Session::Viewing(viewing) => viewing.complaint(),
        };
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

    /// Saves the picture that is in the window, on a thread of its own.
    fn screenshot(&mut self) {
        let (frame, news, proxy) = (self.shown.clone(), self.news_in.clone(), self.proxy.clone());
        let save = move || {
            let told = screenshot_path().and_then(|path| save_png(&frame, &path).map(|()| path));
            let text = told.map_or_else(|failure| failure.to_string(), |path| format!("Saved as {}", path.display()));
            // When the window is closed meanwhile, nobody reads it.
            let _ = news.send(text);
            wake(&proxy);
        };
        if std::thread::Builder::new().name("screenshot".to_string()).spawn(save).is_err() {
            self.tell("The system gives no thread to save the picture with.".to_string());
        }
    }

    /// Takes what other threads have done.
    fn collect(&mut self) {
        while let Ok(text) = self.news.try_recv() {
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
                    self.used = std::mem::replace(&mut self.shown, frame);
                    self.present();
                    self.times.between_ms = milliseconds(self.shown_at, now());
                    self.shown_at = now();
                }
                Err(failure) => self.tell(failure.to_string()),
            }
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
                eprintln!("caustic: {failure}");
                self.tell(failure.to_string());
            }
        }
    }

    fn present(&mut self) {
        if let Some(surface) = &mut self.surface {
            let start = now();
            surface.present(&self.shown);
            self.times.present_ms = milliseconds(start, now());
        }
    }

    /// Orders a picture if one is due.
    fn order(&mut self) {
        let now = now();
        let (Some(window), Some(painter)) = (&self.window, &mut self.painter) else { return };
        let size = window.inner_size();
        let nowhere = self.hidden || size.width == 0 || size.height == 0;
        if painter.is_busy() || !self.dirty || now < self.next_frame || nowhere {
            return;
        }
        self.dirty = false;
        self.next_frame = (self.next_frame + self.interval).max(now + self.interval / 2);
        let (previous, current) = snapshots(&self.session);
        let chrome = chrome(&self.session, self.cover, self.notice.as_ref(), self.overlay.then_some(self.times));
        painter.order(Order {
            previous: previous.clone(),
            current: current.clone(),
            alpha: self.clock.alpha(),
            width: size.width as usize,
            height: size.height as usize,
            chrome,
            table: self.new_table.take(),
            used: std::mem::take(&mut self.used),
        });
    }

    fn wait(&self) -> ControlFlow {
        let now = now();
        let busy = self.painter.as_ref().is_some_and(Painter::is_busy);
        let rest = if self.is_running() { TICKING } else { RESTING };
        let until = now + rest;
        ControlFlow::WaitUntil(if self.dirty && !busy && !self.hidden { until.min(self.next_frame) } else { until })
    }
}

fn snapshots(session: &Session) -> (&Arc<Snapshot>, &Arc<Snapshot>) {
    match session {
        Session::Game(game) => game.snapshots(),
        Session::Viewing(viewing) => viewing.snapshots(),
    }
}

fn chrome(session: &Session, cover: Cover, notice: Option<&(String, Instant)>, overlay: Option<Times>) -> Chrome {
    let (badge, seek, help) = match session {
        Session::Game(game) => (game.badge(), None, &HELP),
        Session::Viewing(viewing) => (Some(Badge::Replay), Some(viewing.progress()), &REPLAY_HELP),
    };
    let card = match cover {
        Cover::None => None,
        Cover::Paused => Some(&PAUSED),
        Cover::Help => Some(help),
    };
    let debug = overlay.map(|times| {
        let touches = match session {
            Session::Game(game) => game.touches(),
            Session::Viewing(viewing) => viewing.touches(),
        };
        Debug { times, touches }
    });
    Chrome { badge, notice: notice.map(|(text, _)| text.clone()), card, seek, debug }
}

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.window.is_some() {
            return;
        }
        if let Err(failure) = self.open(events) {
            self.failure = Some(failure);
            events.exit();
        }
    }

    fn user_event(&mut self, _events: &ActiveEventLoop, _wake: Wake) {
        // What woke the loop is collected before it waits again.
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _window: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => events.exit(),
            WindowEvent::RedrawRequested => self.present(),
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => self.dirty = true,
            WindowEvent::Occluded(hidden) => {
                self.hidden = hidden;
                self.dirty = true;
            }
            WindowEvent::Focused(focused) => self.focus(focused),
            WindowEvent::KeyboardInput {
                event: KeyEvent { physical_key: PhysicalKey::Code(key), state, repeat: false, .. },
                is_synthetic,
                ..
            } => {
                let down = state == ElementState::Pressed;
                // A key that was already down when the window got the focus was not pressed for the game.
                if !(is_synthetic && down) {
                    self.key(events, key, down);
                }
            }
            _ => {}
        }
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        self.catch_up();
        self.collect();
        self.order();
        events.set_control_flow(self.wait());
    }
}

/// Wakes the main thread. Its loop is gone only when the window has been closed: then nobody waits for anything.
fn wake(proxy: &EventLoopProxy<Wake>) {
    let _ = proxy.send_event(Wake);
}

/// Most of the monitor's height, and the shape of a table with its display above it.
fn usual_size(monitor: PhysicalSize<u32>) -> PhysicalSize<u32> {
    let height = (f64::from(monitor.height) * HEIGHT_PART).max(240.0);
    let width = (height * 0.5).min(f64::from(monitor.width.max(240)));
    PhysicalSize::new(width as u32, height as u32)
}

/// A new file in the folder of pictures, or beside the recordings where there is no such folder.
#[expect(clippy::disallowed_methods, reason = "a picture is named after the moment that it was taken")]
fn screenshot_path() -> Result<PathBuf, Failure> {
    let pictures = directories::UserDirs::new().and_then(|dirs| dirs.picture_dir().map(PathBuf::from));
    let data = || directories::ProjectDirs::from("", "", "Caustic").map(|dirs| dirs.data_dir().join("pictures"));
    let folder = pictures.or_else(data).ok_or_else(|| Failure::new("this system names no folder for pictures"))?;
    let wrong = |error| Failure::new(format!("cannot make the folder {}: {error}", folder.display()));
    std::fs::create_dir_all(&folder).map_err(wrong)?;
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    Ok(folder.join(format!("caustic-{}-{:03}.png", since.as_secs(), since.subsec_millis())))
}

#[expect(clippy::disallowed_methods, reason = "the window is where real time comes in")]
fn now() -> Instant {
    Instant::now()
}

fn milliseconds(from: Instant, to: Instant) -> f64 {
    to.duration_since(from).as_secs_f64() * 1000.0
}
