//! Texts of the user's that are read whole: scenes.

use super::file_failure::file_failure;
use super::limited_read;
use crate::Failure;
use std::path::Path;

/// The largest scene, bytes.
const LIMIT_BYTES: u64 = 8 << 20;

/// The bytes of the file `path`.
///
/// # Errors
/// If it cannot be read or is too large.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    limited_read::read(path, LIMIT_BYTES).map_err(|error| file_failure("read", path, &error))
}

/// The text of the file `path`.
///
/// # Errors
/// If it cannot be read, is too large, or is no text.
pub fn read(path: &Path) -> Result<String, Failure> {
    pinball::table::text(&path.display().to_string(), read_bytes(path)?)
}
