//! Interrupts: a person or the system asks the program to end, by Ctrl-C, a closed terminal, or the end of the session.

use crate::Failure;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

/// What a program ends with that a person has interrupted (128 + SIGINT).
const INTERRUPTED: i32 = 130;

static ASKED: AtomicBool = AtomicBool::new(false);

/// From now on an interrupt is a wish: [`is_interrupted`] knows of it, and `wake` is called once, on a thread of its own.
/// A second interrupt ends the program at once.
///
/// # Errors
/// If the system does not tell of interrupts, or they are listened to already.
pub fn listen(wake: impl Fn() + Send + 'static) -> Result<(), Failure> {
    let handler = move || {
        if ASKED.swap(true, Ordering::SeqCst) {
            process::exit(INTERRUPTED);
        }
        wake();
    };
    ctrlc::set_handler(handler).map_err(|error| Failure::new(format!("interrupts cannot be listened to: {error}")))
}

/// Whether there is something to keep when the program is interrupted.
static IS_WORKING: AtomicBool = AtomicBool::new(false);

/// From now on an interrupt ends the program at once, but while [`work`] works: then it is a wish.
///
/// # Errors
/// As [`listen`].
pub fn listen_while_working() -> Result<(), Failure> {
    listen(|| {
        if !IS_WORKING.load(Ordering::SeqCst) {
            process::exit(INTERRUPTED);
        }
    })
}

/// What `work` gives, which asks [`is_interrupted`] now and then.
pub fn work<T>(work: impl FnOnce() -> T) -> T {
    IS_WORKING.store(true, Ordering::SeqCst);
    let done = work();
    IS_WORKING.store(false, Ordering::SeqCst);
    done
}

/// Whether the program has been asked to end.
pub fn is_interrupted() -> bool {
    ASKED.load(Ordering::SeqCst)
}
