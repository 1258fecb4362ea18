//! Failures, told to whoever reads standard error.

use crate::Failure;
use crate::terminal::escaped;
use std::io::{self, Write};

/// Tells a failure, a line for each sentence. When nobody reads standard error, there is nobody to tell.
pub fn tell(failure: &Failure) {
    let lines: Vec<_> = failure.sentences().map(escaped).collect();
    let _ = writeln!(io::stderr(), "caustic: {}", lines.join("\n"));
}
