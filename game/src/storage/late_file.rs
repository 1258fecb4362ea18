//! A late file: what is written stays in memory until there is a reason to keep it.
//!
//! A window that nobody plays must leave no file behind, however it ends, and a process that is killed cannot tidy up:
//! so there is no file before somebody plays. An hour of waiting takes a third of a megabyte.

use std::fs::File;
use std::io::{self, Cursor, Seek, SeekFrom, Write};

/// What is written, in memory or in a file.
pub(super) enum LateFile {
    /// Nobody has played yet.
    Memory(Cursor<Vec<u8>>),
    /// From now on every write goes to the file.
    File(File),
}

impl LateFile {
    /// Nothing, in memory.
    pub fn new() -> LateFile {
        LateFile::Memory(Cursor::new(Vec::new()))
    }

    /// Writes what there is to `file`, and everything from now on.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn keep_in(&mut self, mut file: File) -> io::Result<()> {
        if let LateFile::Memory(written) = self {
            file.write_all(written.get_ref())?;
            file.flush()?;
            *self = LateFile::File(file);
        }
        Ok(())
    }
}

impl Write for LateFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            LateFile::Memory(memory) => memory.write(bytes),
            LateFile::File(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            LateFile::Memory(_) => Ok(()),
            LateFile::File(file) => file.flush(),
        }
    }
}

impl Seek for LateFile {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match self {
            LateFile::Memory(memory) => memory.seek(to),
            LateFile::File(file) => file.seek(to),
        }
    }
}
