//! What went wrong, as one sentence for a person.

use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::{error, fmt};

/// One plain sentence: what went wrong, where, and what to do. Printed to standard error with exit code 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure(String);

impl Failure {
    /// The failure that this sentence tells.
    pub fn new(sentence: impl Into<String>) -> Failure {
        Failure(sentence.into())
    }

    /// All of `failures` as one, a line each.
    pub fn of_many(failures: Vec<Failure>) -> Failure {
        Failure(failures.into_iter().map(|failure| failure.0).collect::<Vec<_>>().join("\n"))
    }

    /// `doing` (as in "write the picture") cannot be done with the file or folder `path`, and what to do about it.
    pub fn of_file(doing: &str, path: &Path, error: &io::Error) -> Failure {
        let reason = match missing_folder(path) {
            Some(folder) if error.kind() == ErrorKind::NotFound => {
                format!("there is no folder {}; make it first", folder.display())
            }
            _ => because(error),
        };
        Failure(format!("cannot {doing} {}: {reason}", path.display()))
    }

    /// The same failure, with the file that it is about before it.
    pub fn in_file(self, path: &Path) -> Failure {
        Failure(format!("{}: {}", path.display(), self.0))
    }

    /// Tells it on standard error. When nobody reads that, there is nobody to tell.
    pub fn tell(&self) {
        let _ = writeln!(io::stderr(), "caustic: {self}");
    }
}

/// What the system says, in plain words and with what to do.
pub fn because(error: &io::Error) -> String {
    let plain = match error.kind() {
        ErrorKind::NotFound => "there is no such file",
        ErrorKind::PermissionDenied => "you have no permission to; choose a file or folder of your own",
        ErrorKind::IsADirectory => "it is a folder; name a file",
        ErrorKind::NotADirectory => "a part of this path is a file, not a folder",
        ErrorKind::AlreadyExists => "there is already one of that name; choose another name or move it away",
        ErrorKind::StorageFull => "the disk is full; make room or choose another place",
        ErrorKind::ReadOnlyFilesystem => "it lies on a disk that cannot be written; choose another place",
        _ => {
            let said = error.to_string();
            return said.split(" (os error").next().unwrap_or(&said).to_string();
        }
    };
    plain.to_string()
}

/// The folder that `path` should be in, if there is no such folder.
fn missing_folder(path: &Path) -> Option<&Path> {
    let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty())?;
    (!parent.exists()).then_some(parent)
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl error::Error for Failure {}
