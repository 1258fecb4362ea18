//! Failures, told to whoever reads standard error.

use crate::Failure;
use std::io::{self, Write};

/// Tells a failure. When nobody reads standard error, there is nobody to tell.
pub fn tell(failure: &Failure) {
    let _ = writeln!(io::stderr(), "caustic: {failure}");
}
