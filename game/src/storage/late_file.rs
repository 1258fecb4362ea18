//! A late file: what is written stays in memory until there is a reason to keep it, and room for it.
//!
//! A window that nobody plays must leave no file behind, however it ends, and a process that is killed cannot tidy up:
//! so there is no file before somebody plays. An hour of waiting takes a third of a megabyte. A disk that is full is not full
//! for ever: what it does not take waits in memory as well, and is tried again with each flush.

use std::fs::File;
use std::io::{self, ErrorKind, Seek, SeekFrom, Write};

/// What is written: bytes in a file, and behind them those that wait for it in memory.
pub(super) struct LateFile<F = File> {
    /// `None` while nobody has played.
    file: Option<F>,
    /// Bytes that the file has taken.
    taken: u64,
    waiting: Vec<u8>,
    /// Why the file does not take what is waiting.
    failure: Option<io::Error>,
    /// Somebody has gone back to a place in the file: what is written from then on goes there.
    is_placed: bool,
}

impl<F: Write + Seek> LateFile<F> {
    /// Nothing, in memory.
    pub fn new() -> LateFile<F> {
        LateFile { file: None, taken: 0, waiting: Vec::new(), failure: None, is_placed: false }
    }

    /// Writes what there is to `file`, and everything from now on.
    ///
    /// # Errors
    /// If it cannot be written; it all stays in memory then.
    pub fn keep_in(&mut self, mut file: F) -> io::Result<()> {
        file.write_all(&self.waiting)?;
        file.flush()?;
        self.taken = std::mem::take(&mut self.waiting).len() as u64;
        self.file = Some(file);
        Ok(())
    }

    /// Why the file lacks something of what was written; `None` if it has everything, or there is none.
    pub fn failure(&self) -> Option<&io::Error> {
        self.failure.as_ref()
    }

    /// Writes what is waiting.
    fn catch_up(&mut self) -> io::Result<()> {
        let Some(file) = &mut self.file else { return Ok(()) };
        file.seek(SeekFrom::Start(self.taken))?;
        while !self.waiting.is_empty() {
            match file.write(&self.waiting) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(count) => {
                    self.waiting.drain(..count);
                    self.taken += count as u64;
                }
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        file.flush()
    }
}

impl<F: Write + Seek> Write for LateFile<F> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.file {
            Some(file) if self.is_placed => file.write(bytes),
            _ => self.waiting.write(bytes),
        }
    }

    /// Never fails while a game is recorded: see [`LateFile::failure`].
    fn flush(&mut self) -> io::Result<()> {
        match &mut self.file {
            Some(file) if self.is_placed => file.flush(),
            _ => {
                self.failure = self.catch_up().err();
                Ok(())
            }
        }
    }
}

impl<F: Write + Seek> Seek for LateFile<F> {
    /// Fails if the file lacks something of what was written.
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.catch_up()?;
        let file = self.file.as_mut().ok_or(ErrorKind::NotFound)?;
        self.is_placed = true;
        file.seek(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use std::io::Cursor;
    use std::rc::Rc;

    /// A disk with so much room.
    struct Disk {
        bytes: Cursor<Vec<u8>>,
        room: Rc<Cell<usize>>,
    }

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let more = self.room.get().saturating_sub(self.bytes.position() as usize).min(bytes.len());
            if more == 0 { Err(ErrorKind::StorageFull.into()) } else { self.bytes.write(&bytes[..more]) }
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Seek for Disk {
        fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
            self.bytes.seek(to)
        }
    }

    /// A recording ended when the disk was full, and did not go on when there was room again.
    #[test]
    fn what_a_full_disk_did_not_take_is_written_when_there_is_room() {
        let room = Rc::new(Cell::new(10));
        let mut late = LateFile::new();
        late.write_all(b"0123").unwrap();
        late.keep_in(Disk { bytes: Cursor::default(), room: room.clone() }).unwrap();
        for part in ["4567", "89ab", "cdef"] {
            late.write_all(part.as_bytes()).unwrap();
            late.flush().unwrap();
        }
        assert_eq!(late.failure().map(io::Error::kind), Some(ErrorKind::StorageFull));
        assert_eq!(late.file.as_ref().unwrap().bytes.get_ref(), b"0123456789");
        assert!(late.seek(SeekFrom::Start(0)).is_err(), "nobody may seal what is not whole");
        room.set(100);
        late.flush().unwrap();
        assert!(late.failure().is_none());
        assert_eq!(late.file.as_ref().unwrap().bytes.get_ref(), b"0123456789abcdef");
        late.seek(SeekFrom::Start(2)).unwrap();
        late.write_all(b"__").unwrap();
        assert_eq!(late.file.as_ref().unwrap().bytes.get_ref(), b"01__456789abcdef");
    }

    #[test]
    fn a_file_that_does_not_take_the_beginning_is_not_kept() {
        let mut late = LateFile::new();
        late.write_all(b"0123").unwrap();
        assert!(late.keep_in(Disk { bytes: Cursor::default(), room: Rc::new(Cell::new(2)) }).is_err());
        late.keep_in(Disk { bytes: Cursor::default(), room: Rc::new(Cell::new(9)) }).unwrap();
        assert_eq!(late.file.as_ref().unwrap().bytes.get_ref(), b"0123");
    }
}
