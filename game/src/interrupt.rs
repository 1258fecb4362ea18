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

/// Whether the program has been asked to end.
pub fn is_interrupted() -> bool {
    ASKED.load(Ordering::SeqCst)
}
