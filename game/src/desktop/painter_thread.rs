//! The painter's thread, which paints frames, so that no input ever waits for one.
//!
//! It paints one frame at a time. The main thread hands it the newest input when it is idle and is woken when the frame
//! is done; what happens in between is simply never painted.

use super::Waker;
use crate::Failure;
use std::sync::mpsc::{Receiver, Sender, channel};
use tracer::Frame;

/// What paints a frame from `I` and tells `R` of it.
pub type Painter<I, R> = Box<dyn FnMut(I, &mut Frame) -> Result<R, Failure> + Send>;

/// A frame and what the painter told of it, or why there is none.
pub type Painted<R> = Result<(Frame, R), Failure>;

/// The thread's two ends.
pub struct PainterThread<I, R> {
    orders: Sender<(I, Frame)>,
    painted: Receiver<Painted<R>>,
    busy: bool,
}

impl<I: Send + 'static, R: Send + 'static> PainterThread<I, R> {
    /// Starts the thread; it wakes the main thread after every frame.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(mut painter: Painter<I, R>, waker: Waker) -> Result<PainterThread<I, R>, Failure> {
        let (orders, inbox) = channel::<(I, Frame)>();
        let (outbox, painted) = channel();
        let work = move || {
            for (input, mut frame) in inbox {
                let report = painter(input, &mut frame);
                if outbox.send(report.map(|report| (frame, report))).is_err() {
                    return;
                }
                waker.wake();
            }
        };
        std::thread::Builder::new()
            .name("painter".to_string())
            .spawn(work)
            .map_err(|error| Failure::new(format!("cannot start a thread: {error}; close some programs")))?;
        Ok(PainterThread { orders, painted, busy: false })
    }

    /// Whether a frame is being painted.
    pub fn is_busy(&self) -> bool {
        self.busy
    }

    /// Asks for a frame, in the memory of `spare`; only while none is being painted.
    pub fn order(&mut self, input: I, spare: Frame) {
        self.busy = self.orders.send((input, spare)).is_ok();
    }

    /// The frame that was asked for, when it is done.
    pub fn take(&mut self) -> Option<Painted<R>> {
        let painted = self.painted.try_recv().ok();
        self.busy &= painted.is_none();
        painted
    }
}
