//! The viewer as an application of the desktop's shell: what the mouse and the keys do to a drawing.

use super::ViewerOptions;
use super::camera::Camera;
use super::document::Document;
use super::overlay::{self, Overlay};
use super::pick;
use super::refiner::{Order, Refiner, Shown};
use crate::Failure;
use crate::desktop::{App, Commands, Event, Pointer};
use crate::drawn_scene::DrawnScene;
use crate::input::Key;
use crate::screen::Size;
use crate::storage::FileWatch;
use geometry::DVec2;
use std::sync::Arc;
use std::time::Duration;

/// How near the mouse must be to a line to take it, pixels.
const REACH_PX: f64 = 6.0;
/// How much nearer one line of the wheel, or a key, brings the page.
const ZOOM: f64 = 1.15;
/// How long a notice stands.
const NOTICE: Duration = Duration::from_secs(5);

/// What stands at the foot in the beginning.
const WELCOME: &str = "drag a lamp, a lens or a prism \u{b7} H tells the keys";

/// A drawing in a window.
pub struct SceneViewer {
    pub(super) document: Document,
    pub(super) camera: Camera,
    options: ViewerOptions,
    size: Size,
    pointer: DVec2,
    drag: Option<Drag>,
    watch: FileWatch,
    now: Duration,
    notice: Option<(String, Duration)>,
    /// Why the file cannot be read, for as long as it cannot.
    unreadable: Option<String>,
    is_help: bool,
    /// The next frame of the picture that is asked for is that alone, and is saved.
    is_bare: bool,
    /// The frame that is being painted is bare.
    painted_bare: bool,
    /// The person was told that leaving loses what was moved.
    is_warned: bool,
    refiner: Refiner,
    orders: u64,
    /// What the last order was of.
    ordered: Option<Ordered>,
    shown: Option<Shown>,
}

/// What the mouse holds.
enum Drag {
    /// A shape of the scene that there was when it was taken, and where that was, mm.
    Shape { from: Arc<DrawnScene>, shape: usize, start_mm: DVec2 },
    /// The page: where the mouse was, pixels.
    Page { last: DVec2 },
}

/// What makes another picture.
#[derive(Clone, PartialEq)]
struct Ordered {
    version: u64,
    camera: Camera,
    size: Size,
    is_moving: bool,
}

impl SceneViewer {
    /// Shows a drawing; light is found by `pool`.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn new(document: Document, options: ViewerOptions, pool: rayon::ThreadPool) -> Result<SceneViewer, Failure> {
        let camera = Camera::whole(document.scene().drawing.size_mm);
        let watch = FileWatch::new(vec![document.path().to_path_buf()]);
        Ok(SceneViewer {
            document,
            camera,
            options,
            size: Size { width: 1, height: 1 },
            pointer: DVec2::ZERO,
            drag: None,
            watch,
            now: Duration::ZERO,
            notice: Some((WELCOME.to_string(), NOTICE)),
            unreadable: None,
            is_help: false,
            is_bare: false,
            painted_bare: false,
            is_warned: false,
            refiner: Refiner::start(pool)?,
            orders: 0,
            ordered: None,
            shown: None,
        })
    }

    fn tell(&mut self, text: impl Into<String>) {
        self.notice = Some((text.into(), self.now + NOTICE));
    }

    /// A place of the window on the page, mm.
    fn place(&self, pixel: DVec2) -> DVec2 {
        let view = self.camera.view(self.size);
        view.origin_mm + pixel * view.mm_per_px
    }

    fn pick(&self) -> Option<usize> {
        let reach = REACH_PX * self.camera.view(self.size).mm_per_px;
        pick::shape_at(self.document.scene(), self.place(self.pointer), reach)
    }

    fn pointer(&mut self, pointer: Pointer) {
        match pointer {
            Pointer::Moved(to) => {
                self.pointer = to;
                self.drag_on();
            }
            Pointer::Pressed => {
                self.drag = Some(match self.pick() {
                    Some(shape) => {
                        let start_mm = self.place(self.pointer);
                        Drag::Shape { from: self.document.begin_step(), shape, start_mm }
                    }
                    None => Drag::Page { last: self.pointer },
                });
            }
            Pointer::Released => self.end_drag(),
            Pointer::Wheel(lines) => self.zoom(libm::pow(ZOOM, lines.clamp(-10.0, 10.0)), self.pointer),
        }
    }

    fn drag_on(&mut self) {
        let place = self.place(self.pointer);
        match &mut self.drag {
            Some(Drag::Shape { from, shape, start_mm }) => {
                let moved = self.document.move_shape(from, *shape, place - *start_mm);
                // It stays where it could be last.
                if let Err(failure) = moved {
                    self.tell(failure.to_string());
                }
            }
            Some(Drag::Page { last }) => {
                let by = (*last - self.pointer) * self.camera.view(self.size).mm_per_px;
                *last = self.pointer;
                self.camera = self.camera.moved(by);
            }
            None => {}
        }
    }

    fn end_drag(&mut self) {
        if let Some(Drag::Shape { .. }) = self.drag.take() {
            self.document.end_step();
        }
    }

    fn zoom(&mut self, factor: f64, at: DVec2) {
        self.camera = self.camera.zoomed(factor, at, self.size);
    }

    fn key(&mut self, key: Key, commands: &mut Commands) {
        let middle = DVec2::new(self.size.width as f64, self.size.height as f64) * 0.5;
        match key {
            Key::KeyQ | Key::Escape => commands.quit = self.may_leave(),
            Key::KeyP | Key::F12 => self.is_bare = true,
            Key::F11 => commands.toggle_fullscreen = true,
            Key::KeyH | Key::F1 => self.is_help = !self.is_help,
            Key::Digit0 | Key::Numpad0 => self.camera = Camera::whole(self.camera.page_mm),
            Key::Equal | Key::NumpadAdd => self.zoom(ZOOM, middle),
            Key::Minus | Key::NumpadSubtract => self.zoom(1.0 / ZOOM, middle),
            Key::KeyX => {
                // The next picture is exposed by its own light.
                (self.shown, self.ordered) = (None, None);
            }
            Key::KeyZ => {
                self.end_drag();
                if !self.document.undo() {
                    self.tell("nothing was moved");
                }
            }
            Key::KeyE => self.save(),
            _ => {}
        }
    }

    /// Whether nothing is lost, or the person knows what is.
    fn may_leave(&mut self) -> bool {
        if !self.document.is_changed() || self.is_warned {
            return true;
        }
        self.is_warned = true;
        self.tell("what was moved is not written: E writes it, Q again leaves without");
        false
    }

    fn save(&mut self) {
        self.end_drag();
        let path = self.document.path().display().to_string();
        let told = match (self.document.is_changed(), self.document.save()) {
            (_, Err(failure)) => failure.to_string(),
            (true, Ok(())) => format!("written: {path}"),
            (false, Ok(())) => format!("{path} is as it is here"),
        };
        self.watch.forget_changes();
        self.tell(told);
    }

    /// Reads the file again if another program has saved it.
    fn follow_file(&mut self) {
        if self.drag.is_some() || self.watch.changed(self.now).is_empty() {
            return;
        }
        self.unreadable = None;
        match self.document.reload() {
            Ok(true) => {
                let page_mm = self.document.scene().drawing.size_mm;
                if page_mm != self.camera.page_mm {
                    self.camera = Camera::whole(page_mm);
                }
                let warning = self.document.scene().warnings.first().map(ToString::to_string);
                self.tell(warning.unwrap_or_else(|| "read again".to_string()));
            }
            Ok(false) => {}
            Err(failure) => {
                // Nothing stands before it.
                (self.notice, self.unreadable) = (None, Some(failure.to_string()));
            }
        }
    }

    /// Orders a picture if what is to be seen is another one.
    fn order(&mut self, commands: &Commands) {
        let is_moving = self.drag.is_some();
        let ordered = Ordered { version: self.document.version(), camera: self.camera, size: self.size, is_moving };
        if self.size.width <= 1 || self.ordered.as_ref() == Some(&ordered) {
            return;
        }
        self.ordered = Some(ordered);
        self.orders += 1;
        let order = Order {
            number: self.orders,
            view: self.camera.view(self.size),
            scene: self.document.scene().clone(),
            is_moving,
            exposure: self.shown.as_ref().map(|shown| shown.exposure),
            integrator: self.options.integrator,
            white_kelvin: self.options.white_kelvin,
        };
        self.refiner.order(order, commands.waker());
    }

    /// The outline of what is held, or would be taken.
    fn outline(&self) -> Option<usize> {
        match &self.drag {
            Some(Drag::Shape { shape, .. }) => Some(*shape),
            Some(Drag::Page { .. }) => None,
            None => self.pick(),
        }
    }

    /// What stands at the foot of the window.
    pub(super) fn status(&self) -> String {
        if let Some((notice, _)) = &self.notice {
            return notice.clone();
        }
        if let Some(failure) = &self.unreadable {
            return failure.clone();
        }
        let changed = if self.document.is_changed() { "moved, E writes it \u{b7} " } else { "" };
        let report = self.shown.as_ref().map_or("", |shown| shown.report.as_str());
        format!("{changed}{report}")
    }
}

impl App for SceneViewer {
    type FrameInput = Overlay;
    type FrameReport = ();

    fn update(&mut self, now: Duration, commands: &mut Commands) {
        self.now = now;
        let told = self.status();
        self.follow_file();
        match self.refiner.take() {
            Some(Ok(shown)) => {
                self.shown = Some(shown);
                commands.redraw = true;
            }
            Some(Err(failure)) => self.tell(failure.to_string()),
            None => {}
        }
        if self.notice.as_ref().is_some_and(|(_, until)| now > *until) {
            self.notice = None;
        }
        // Nobody may be at the mouse or the keys.
        commands.redraw |= self.status() != told;
        self.order(commands);
    }

    fn event(&mut self, event: Event<()>, commands: &mut Commands) {
        match event {
            Event::Key { key, down: true } => self.key(key, commands),
            Event::Pointer(pointer) => {
                self.is_warned = false;
                self.pointer(pointer);
            }
            Event::FocusLost => self.end_drag(),
            Event::Message(text) => self.tell(text),
            Event::FrameShown { .. } if self.painted_bare => {
                (self.is_bare, self.painted_bare) = (false, false);
                commands.screenshot = true;
            }
            Event::Key { down: false, .. } | Event::FrameShown { .. } => return,
        }
        commands.redraw = true;
        self.order(commands);
    }

    fn frame_input(&mut self, size: Size) -> Overlay {
        self.size = size;
        let view = self.camera.view(size);
        let is_bare = self.is_bare && self.shown.as_ref().is_some_and(|shown| shown.view == view);
        self.painted_bare = is_bare;
        Overlay {
            size,
            view,
            picture: self.shown.as_ref().map(|shown| (shown.frame.clone(), shown.view)),
            outline: self
                .outline()
                .filter(|_| !is_bare)
                .map(|shape| overlay::outline(self.document.scene(), shape, &view)),
            status: if is_bare { String::new() } else { self.status() },
            is_help: self.is_help && !is_bare,
        }
    }

    fn is_animating(&self) -> bool {
        self.drag.is_some()
    }
}
