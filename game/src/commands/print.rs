//! Standard output. Who reads it may stop at any time (`caustic bench | head -3`); that is no failure.

use crate::Failure;
use crate::storage::because;
use crate::terminal::escaped;
use std::io::{self, ErrorKind, Write};

/// Prints a line.
///
/// # Errors
/// As [`print_lines`].
pub fn print(line: &str) -> Result<(), Failure> {
    print_lines([line])
}

/// Prints some lines; what cannot be part of a line is escaped.
///
/// # Errors
/// If standard output cannot be written, but not because nobody reads on.
pub fn print_lines(lines: impl IntoIterator<Item = impl AsRef<str>>) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let text: String = lines.into_iter().map(|line| format!("{}\n", escaped(line.as_ref()))).collect();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
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
