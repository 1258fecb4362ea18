//! Reading: the one way by which a file of the user's comes into the program.
//!
//! A file may be a pipe that nobody writes to, a device that never ends, or larger than the memory, and what its metadata
//! say of its length need not be so. So only what is a plain file is opened, and no more of it is read than a limit.

use std::fs::{self, File, FileType, OpenOptions};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// The largest recording, bytes: four days of play.
pub(super) const RECORDING_LIMIT_BYTES: u64 = 32 << 20;

/// The bytes of the plain file `path`.
///
/// # Errors
/// If it cannot be read, is no plain file, or has more than `limit_bytes`.
pub(super) fn read(path: &Path, limit_bytes: u64) -> io::Result<Vec<u8>> {
    let file = open(path)?;
    if file.metadata()?.len() > limit_bytes {
        return Err(too_large(limit_bytes));
    }
    let mut bytes = Vec::new();
    file.take(limit_bytes + 1).read_to_end(&mut bytes).map_err(unending)?;
    if bytes.len() as u64 > limit_bytes { Err(too_large(limit_bytes)) } else { Ok(bytes) }
}

/// The plain file `path`, opened.
///
/// # Errors
/// If it cannot be opened or is no plain file.
pub(super) fn open(path: &Path) -> io::Result<File> {
    check_kind(fs::metadata(path)?.file_type())?;
    without_waiting(OpenOptions::new().read(true)).open(path)
}

/// The kernel calls some of its own a plain file though what reads them waits for more (`/proc/kmsg`, `trace_pipe`): they
/// are read as far as they go. On a plain file this changes nothing.
#[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
fn without_waiting(options: &mut OpenOptions) -> &mut OpenOptions {
    use std::os::unix::fs::OpenOptionsExt;
    const O_NONBLOCK: i32 = 0o4000;
    options.custom_flags(O_NONBLOCK)
}

#[cfg(not(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64"))))]
fn without_waiting(options: &mut OpenOptions) -> &mut OpenOptions {
    options
}

fn unending(error: io::Error) -> io::Error {
    if error.kind() != ErrorKind::WouldBlock {
        return error;
    }
    io::Error::new(ErrorKind::InvalidInput, "it has no end, but goes on as the system writes it; name a file")
}

fn too_large(limit_bytes: u64) -> io::Error {
    io::Error::new(ErrorKind::FileTooLarge, format!("it is larger than {} kB", limit_bytes >> 10))
}

/// A pipe, a socket or a device is never opened: that alone could wait for ever.
fn check_kind(kind: FileType) -> io::Result<()> {
    if kind.is_file() {
        return Ok(());
    }
    if kind.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    Err(io::Error::new(ErrorKind::InvalidInput, format!("it is {} and no file; name a file", special(kind))))
}

/// What it is that is neither a file nor a folder.
#[cfg(unix)]
pub(super) fn special(kind: FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    if kind.is_fifo() {
        "a pipe"
    } else if kind.is_socket() {
        "a socket"
    } else {
        "a device"
    }
}

#[cfg(not(unix))]
pub(super) fn special(_: FileType) -> &'static str {
    "a device"
}
