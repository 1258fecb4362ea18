//! The thread that makes pictures, so that no input ever waits for one.
//!
//! It works on one picture at a time from snapshots that nobody changes. The main thread hands it the newest moment when
//! it is idle and is woken when the picture is done; what happens in between is simply never drawn.

use crate::frame_composer::{Light, Moment, Picture};
use crate::hud::{Chrome, Times};
use crate::{Failure, Snapshot, Table};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use tracer::Frame;

/// A picture to make.
pub struct Order {
    /// The earlier tick.
    pub previous: Arc<Snapshot>,
    /// The later tick.
    pub current: Arc<Snapshot>,
    /// How far from the earlier to the later, 0 to 1.
    pub alpha: f64,
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// At which resolution light is found.
    pub light: Light,
    /// How much larger than the window the table is drawn.
    pub zoom: f64,
    /// What the window adds.
    pub chrome: Chrome,
    /// The table, if it is another than the last time.
    pub table: Option<Arc<Table>>,
    /// A picture that is not needed any more: its memory is used again.
    pub used: Frame,
}

/// A picture that is done.
pub struct Done {
    /// The picture, or why there is none.
    pub frame: Result<Frame, Failure>,
    /// What its parts cost.
    pub times: Times,
}

/// The thread's two ends.
pub struct Painter {
    orders: Sender<Order>,
    done: Receiver<Done>,
    busy: bool,
}

impl Painter {
    /// Starts the thread; `wake` is called on it after every picture.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(mut picture: Picture, wake: impl Fn() + Send + 'static) -> Result<Painter, Failure> {
        let (orders, inbox) = channel::<Order>();
        let (outbox, done) = channel();
        let work = move || {
            for order in inbox {
                if outbox.send(paint(&mut picture, order)).is_err() {
                    return;
                }
                wake();
            }
        };
        std::thread::Builder::new()
            .name("painter".to_string())
            .spawn(work)
            .map_err(|error| Failure::new(format!("cannot start a thread: {error}; close some programs")))?;
        Ok(Painter { orders, done, busy: false })
    }

    /// Whether a picture is being made.
    pub fn is_busy(&self) -> bool {
        self.busy
    }

    /// Asks for a picture; only while none is being made.
    pub fn order(&mut self, order: Order) {
        self.busy = self.orders.send(order).is_ok();
    }

    /// The picture that was asked for, when it is done.
    pub fn take(&mut self) -> Option<Done> {
        let done = self.done.try_recv().ok();
        self.busy &= done.is_none();
        done
    }
}

fn paint(picture: &mut Picture, order: Order) -> Done {
    if let Some(table) = order.table {
        picture.set_table(table);
    }
    picture.set_light(order.light);
    picture.set_zoom(order.zoom);
    let moment = Moment { previous: &order.previous, current: &order.current, alpha: order.alpha };
    let mut copy = order.used;
    let frame = picture.draw(moment, order.width, order.height, &order.chrome).map(|frame| {
        (copy.width, copy.height) = (frame.width, frame.height);
        copy.pixels.clear();
        copy.pixels.extend_from_slice(&frame.pixels);
        copy
    });
    Done { frame, times: picture.times() }
}
