//! Guard: the libraries that read and print art are called where their panic ends in a sentence.
//!
//! What is known to be too much for them is refused before (`written_out.rs`, `cost/`); this is the net below that. They
//! go as deep as art lies in each other, so they have a stack of their own.

use crate::Failure;
use std::cell::Cell;
use std::panic;
use std::sync::Once;
use std::thread::Builder;

/// Room for art that lies as deep in each other as is let through, in a debug build too, bytes.
const STACK_BYTES: usize = 128 << 20;

thread_local! {
    /// Whether a panic of this thread becomes a sentence, so that nothing else is to be said of it.
    static IS_GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// What `work` gives.
///
/// # Errors
/// As `work`, or if it panics.
pub(super) fn guarded<T: Send>(work: impl FnOnce() -> Result<T, Failure> + Send) -> Result<T, Failure> {
    silence_guarded_panics();
    let work = move || {
        IS_GUARDED.set(true);
        work()
    };
    std::thread::scope(|scope| {
        let worker = Builder::new().name("art".to_string()).stack_size(STACK_BYTES).spawn_scoped(scope, work);
        let worker = worker.map_err(|error| Failure::new(format!("its art needs a thread to be printed: {error}")))?;
        worker.join().unwrap_or_else(|_| Err(Failure::new(GAVE_UP)))
    })
}

/// What is said of a panic.
const GAVE_UP: &str = "its art cannot be printed: something in it is beyond what can be drawn (numbers that are very \
                       large or very small, as a rule); take elements out until it can be";

/// A guarded panic is told by a sentence; every other is told as before.
fn silence_guarded_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let others = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if !IS_GUARDED.get() {
                others(panic);
            }
        }));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_sentence_and_anything_else_comes_through() {
        assert_eq!(guarded(|| Ok(7)), Ok(7));
        assert_eq!(guarded::<()>(|| Err(Failure::new("no"))), Err(Failure::new("no")));
        assert_eq!(guarded::<()>(|| panic!("a bug of a library")), Err(Failure::new(GAVE_UP)));
        assert!(!IS_GUARDED.get(), "only the thread of the work is silent");
    }
}
