//! Work, counted in steps instead of time, so that every machine stops a script at the same place.
//!
//! A step is one node of the script evaluated, one value copied or compared, or 16 bytes of text read or written.
//! Values have no `Clone`, no `PartialEq` and no `Display`: whoever copies, compares or prints one needs a meter.

use super::stop::{Stop, fail};

/// Longest text, bytes.
pub const MAX_TEXT: usize = 4096;
/// Longest list and largest map.
pub const MAX_ITEMS: usize = 4096;

/// Bytes of text that are one step.
const STEP_BYTES: usize = 16;

/// The steps that are left.
#[derive(Debug)]
pub struct Meter {
    allowed: u64,
    left: u64,
}

impl Meter {
    /// A meter that allows so many steps.
    pub fn new(allowed: u64) -> Meter {
        Meter { allowed, left: allowed }
    }

    /// The steps that were taken.
    pub fn spent(&self) -> u64 {
        self.allowed - self.left
    }

    /// Takes steps, before the work is done that they stand for.
    ///
    /// # Errors
    /// If fewer are left; then none are.
    pub fn charge(&mut self, steps: u64) -> Result<(), Stop> {
        match self.left.checked_sub(steps) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => {
                self.left = 0;
                Err(Stop::spent())
            }
        }
    }

    /// Takes a step for each of so many values, and one more.
    ///
    /// # Errors
    /// If fewer are left.
    pub fn values(&mut self, count: usize) -> Result<(), Stop> {
        self.charge(1 + count as u64)
    }

    /// Takes the steps of so many bytes of text.
    ///
    /// # Errors
    /// If fewer are left.
    pub fn bytes(&mut self, count: usize) -> Result<(), Stop> {
        self.charge(text_steps(count))
    }
}

/// The steps that reading or writing so many bytes of text takes.
pub fn text_steps(bytes: usize) -> u64 {
    1 + (bytes / STEP_BYTES) as u64
}

/// Whether a text may become so long.
///
/// # Errors
/// A sentence if not.
pub fn check_text(bytes: usize) -> Result<(), Stop> {
    if bytes > MAX_TEXT { Err(fail(format!("a text may be {MAX_TEXT} bytes long and no longer"))) } else { Ok(()) }
}

/// Whether a list or a map may become so large.
///
/// # Errors
/// A sentence if not.
pub fn check_items(count: usize) -> Result<(), Stop> {
    if count > MAX_ITEMS {
        Err(fail(format!("a list or a map may hold {MAX_ITEMS} values and no more")))
    } else {
        Ok(())
    }
}
