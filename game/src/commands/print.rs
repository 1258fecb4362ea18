//! Standard output. Who reads it may stop at any time (`caustic bench | head -3`); that is no failure.

use crate::Failure;
use crate::storage::because;
use std::io::{self, ErrorKind, Write};

/// Prints a text and ends its line.
///
/// # Errors
/// If standard output cannot be written, but not because nobody reads on.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let written = writeln!(out, "{}", text.trim_end()).and_then(|()| out.flush());
    written.or_else(forgive).map_err(|error| unwritable(&error))
}

/// Nothing is wrong when nobody reads on.
pub fn forgive(error: io::Error) -> io::Result<()> {
    if error.kind() == ErrorKind::BrokenPipe { Ok(()) } else { Err(error) }
}

/// What to say when standard output cannot be written.
pub fn unwritable(error: &io::Error) -> Failure {
    Failure::new(format!("cannot write to standard output: {}", because(error)))
}
