//! A file that appears whole or not at all.
//!
//! It is written beside its place under another name and moved there when it is complete: whatever goes wrong on the
//! way, what was there before is still there. Folders that are missing on the way to it are made.

use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Distinguishes the files that this process is writing at once.
static NUMBER: AtomicU64 = AtomicU64::new(0);

/// Lets `write` fill a new file and puts it at `path`, in place of a file that is there.
///
/// A device or a pipe at `path` is written directly: it holds nothing that could be lost.
///
/// # Errors
/// If it cannot be written; `path` is then as it was.
pub fn write(path: &Path, write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
    // What a link points to is replaced, not the link.
    let place = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    match fs::metadata(&place) {
        Ok(found) if found.is_dir() => return Err(ErrorKind::IsADirectory.into()),
        Ok(found) if !found.is_file() => return fill(File::options().write(true).open(&place)?, write),
        _ => {}
    }
    make_parents(&place)?;
    let (draft, file) = draft(&place)?;
    let written = fill(file, write).and_then(|()| fs::rename(&draft, &place));
    if written.is_err() {
        // It is of no use to anybody; if it cannot be removed either, the first error is the one to tell.
        let _ = fs::remove_file(&draft);
    }
    written
}

/// Whether a file could be put at `path`, as far as one sees before anything is done.
///
/// # Errors
/// If `path` is a folder, or something on the way to it is none.
pub fn check(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    let mut around = path.ancestors().skip(1).filter(|folder| !folder.as_os_str().is_empty());
    match around.find_map(|folder| fs::metadata(folder).ok()) {
        Some(found) if !found.is_dir() => Err(ErrorKind::NotADirectory.into()),
        _ => Ok(()),
    }
}

/// Makes the folders in which `path` is to be, where they are missing.
///
/// # Errors
/// If they cannot be made.
pub fn make_parents(path: &Path) -> io::Result<()> {
    let made = path.parent().map_or(Ok(()), fs::create_dir_all);
    // What is there already and is no folder is a file.
    made.map_err(|error| if error.kind() == ErrorKind::AlreadyExists { ErrorKind::NotADirectory.into() } else { error })
}

fn fill(file: File, write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
    let mut file = BufWriter::new(file);
    write(&mut file)?;
    file.flush()
}

/// A new file beside `place`.
fn draft(place: &Path) -> io::Result<(PathBuf, File)> {
    loop {
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let draft = place.with_file_name(format!(".caustic-{}-{number}.part", std::process::id()));
        match File::create_new(&draft) {
            Ok(file) => return Ok((draft, file)),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
}
