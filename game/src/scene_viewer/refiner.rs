//! The refiner: a thread that makes a scene's picture, first at once, then better and better, until another is asked for.

use super::resampling::doubled;
use crate::desktop::Waker;
use crate::drawn_scene::DrawnScene;
use crate::rendering::{Integrator, Passes, Picture, Settings, Stopped, add_art, develop, expose, finds_all_by_beams};
use crate::{Failure, art};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};
use tracer::{Frame, View, tone_map};

/// From one picture that is being refined to the next.
const INTERVAL: Duration = Duration::from_millis(250);
/// Beams of a family, packets or directions a pixel with which a picture is done; a preview has fewer beams.
const BEAMS: u32 = 64;
const PREVIEW_BEAMS: u32 = 32;
const SAMPLES: u32 = 1024;
/// Pieces of beams beyond which photons refine the picture; a preview has fewer.
const MOST_PIECES: u64 = 3_000_000;
const PREVIEW_PIECES: u64 = 100_000;
/// Packets a pixel from which on photons are calmer than what the preview lacks.
const CALM: f64 = 1.0;

/// What is to be shown.
#[derive(Clone)]
pub struct Order {
    /// Counts up with each order.
    pub number: u64,
    /// The scene.
    pub scene: Arc<DrawnScene>,
    /// Where it is on the screen.
    pub view: View,
    /// Something is being dragged: another order follows at once.
    pub is_moving: bool,
    /// The factor by which light is multiplied; by default as the picture's own light asks for.
    pub exposure: Option<f64>,
    /// What refines it.
    pub integrator: Option<Integrator>,
    /// The temperature of the light that is white, K.
    pub white_kelvin: Option<f64>,
}

/// A picture of an order.
#[derive(Clone)]
pub struct Shown {
    /// Its pixels.
    pub frame: Arc<Frame>,
    /// Where they are on the page.
    pub view: View,
    /// The factor by which light was multiplied.
    pub exposure: f64,
    /// How it was made, for a person.
    pub report: String,
}

/// The thread's two ends.
pub struct Refiner {
    orders: Sender<(Order, Waker)>,
    newest: Arc<AtomicU64>,
    shown: Receiver<Result<Shown, Failure>>,
}

impl Refiner {
    /// Starts the thread; light is found by `pool`.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(pool: rayon::ThreadPool) -> Result<Refiner, Failure> {
        let (orders, inbox) = channel::<(Order, Waker)>();
        let (outbox, shown) = channel();
        let newest = Arc::new(AtomicU64::new(0));
        let worker = Worker { newest: newest.clone(), outbox };
        let work = move || {
            while let Ok(mut next) = inbox.recv() {
                while let Ok(newer) = inbox.try_recv() {
                    next = newer;
                }
                let (order, waker) = next;
                pool.install(|| worker.make(&order, &waker));
            }
        };
        let thread = std::thread::Builder::new().name("refiner".to_string()).spawn(work);
        thread.map_err(|_| Failure::new("the system gives no thread to find light on"))?;
        Ok(Refiner { orders, newest, shown })
    }

    /// Asks for a picture; what is being made for an older order is left.
    pub fn order(&self, order: Order, waker: Waker) {
        self.newest.store(order.number, Ordering::Relaxed);
        // The thread ends only with this end.
        let _ = self.orders.send((order, waker));
    }

    /// The newest picture since the last call.
    pub fn take(&self) -> Option<Result<Shown, Failure>> {
        self.shown.try_iter().last()
    }
}

struct Worker {
    newest: Arc<AtomicU64>,
    outbox: Sender<Result<Shown, Failure>>,
}

impl Worker {
    fn is_old(&self, order: &Order) -> bool {
        self.newest.load(Ordering::Relaxed) != order.number
    }

    fn make(&self, order: &Order, waker: &Waker) {
        if let Err(failure) = self.try_make(order, waker) {
            // Nobody waits for it any more when the window is being closed.
            let _ = self.outbox.send(Err(failure));
            waker.wake();
        }
    }

    fn try_make(&self, order: &Order, waker: &Waker) -> Result<(), Failure> {
        let drawing = &order.scene.drawing;
        let art = art::drawing(&drawing.svg, drawing.size_mm, &order.view)?;
        let preview = Settings {
            samples: PREVIEW_BEAMS,
            most_pieces: Some(PREVIEW_PIECES),
            is_preview: true,
            ..settings(order, Integrator::Beams)
        };
        let mut factor = order.exposure;
        // A quarter of the pixels is there three times as soon.
        let half = order.view.halved();
        let mut passes = Passes::new(&order.scene.scene, half, &preview);
        self.run(order, &mut passes, None)?;
        if self.is_old(order) {
            return Ok(());
        }
        let (picture, report) = developed(order, &passes, &half, &mut factor);
        self.show(order, doubled(&picture, order.view.width, order.view.height), report, &art, factor, waker);
        if order.is_moving {
            return Ok(());
        }
        let usual = if finds_all_by_beams(&order.scene.scene) { Integrator::Beams } else { Integrator::Photons };
        let mut integrator = order.integrator.unwrap_or(usual);
        if integrator == Integrator::Beams {
            let limit = if order.integrator.is_none() { Some(MOST_PIECES) } else { None };
            let settings = Settings { most_pieces: limit, ..settings(order, integrator) };
            let mut passes = Passes::new(&order.scene.scene, order.view, &settings);
            match self.run(order, &mut passes, None)? {
                Stopped::TooManyBeams => integrator = Integrator::Photons,
                _ if self.is_old(order) => return Ok(()),
                _ => {
                    let (picture, report) = developed(order, &passes, &order.view, &mut factor);
                    self.show(order, picture, report, &art, factor, waker);
                    return Ok(());
                }
            }
        }
        self.refine(order, integrator, &art, &mut factor, waker)
    }

    /// Shows better and better pictures until it is done or another is asked for.
    fn refine(
        &self,
        order: &Order,
        integrator: Integrator,
        art: &[[u8; 4]],
        factor: &mut Option<f64>,
        waker: &Waker,
    ) -> Result<(), Failure> {
        let mut passes = Passes::new(&order.scene.scene, order.view, &settings(order, integrator));
        let pixels = (order.view.width * order.view.height) as f64;
        loop {
            let stopped = self.run(order, &mut passes, Some(INTERVAL))?;
            if self.is_old(order) {
                return Ok(());
            }
            let calm = passes.counts().is_none_or(|counts| counts.sent as f64 > CALM * pixels);
            if calm || stopped == Stopped::Done {
                let (picture, report) = developed(order, &passes, &order.view, factor);
                self.show(order, picture, report, art, *factor, waker);
            }
            if stopped == Stopped::Done {
                return Ok(());
            }
        }
    }

    /// Goes on with passes for a while, or to their end.
    #[expect(clippy::disallowed_methods, reason = "a person who waits sees how a picture comes along")]
    fn run(&self, order: &Order, passes: &mut Passes, time: Option<Duration>) -> Result<Stopped, Failure> {
        let begin = Instant::now();
        let is_over = || time.is_some_and(|time| begin.elapsed() >= time);
        let stopped = passes.run(|_, _| !(self.is_old(order) || is_over()), &|| self.is_old(order));
        stopped.map_err(Failure::new)
    }

    fn show(
        &self,
        order: &Order,
        mut picture: Picture,
        report: String,
        art: &[[u8; 4]],
        exposure: Option<f64>,
        waker: &Waker,
    ) {
        add_art(&mut picture, art, order.scene.ambient);
        let frame = Arc::new(tone_map::map_pixels(&picture.pixels, picture.width, 1.0));
        let shown = Shown { frame, view: order.view, exposure: exposure.unwrap_or(1.0), report };
        let _ = self.outbox.send(Ok(shown));
        waker.wake();
    }
}

/// The picture of what passes have found, and how it was made; the first one is exposed by its own light.
fn developed(order: &Order, passes: &Passes, view: &View, factor: &mut Option<f64>) -> (Picture, String) {
    let fluence = passes.fluence();
    let (picture, used) = match *factor {
        Some(factor) => (expose(&fluence, view, factor), factor),
        None => develop(&fluence, view, order.scene.stops),
    };
    *factor = Some(used);
    (picture, passes.amount(passes.steps().0))
}

fn settings(order: &Order, integrator: Integrator) -> Settings {
    let samples = if integrator == Integrator::Beams { BEAMS } else { SAMPLES };
    let white_kelvin = order.white_kelvin;
    Settings { integrator, samples, seed: 0, depth: None, most_pieces: None, is_preview: false, white_kelvin }
}
