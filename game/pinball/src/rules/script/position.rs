//! Positions in lists and texts: from the front, or (below 0) from the back.

use super::stop::{Stop, fail};

/// The position from which a function goes on: from the front, or (below 0) from the back; the length where that is past
/// the end.
pub fn offset(start: i64, length: usize) -> usize {
    let from_end = usize::try_from(start.unsigned_abs()).unwrap_or(usize::MAX).min(length);
    if start < 0 { length - from_end } else { from_end }
}

/// The position of an index from the front, or (below 0) from the back.
///
/// # Errors
/// If there is nothing.
pub fn position(index: i64, length: usize) -> Result<usize, Stop> {
    let from_front = if index < 0 { index.saturating_add(length as i64) } else { index };
    let found = usize::try_from(from_front).ok().filter(|position| *position < length);
    found.ok_or_else(|| fail(format!("there is no item {index} among {length}")))
}
