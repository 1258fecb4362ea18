//! File failures: what goes wrong with files, in plain words.

use crate::Failure;
use std::io::{self, ErrorKind};
use std::path::Path;

/// `doing` (as in "write the picture") cannot be done with the file or folder `path`, and what to do about it.
pub fn file_failure(doing: &str, path: &Path, error: &io::Error) -> Failure {
    // What is to be made and has its folder is refused by a file system of the kernel's own, as /proc is.
    let makes = ["write", "make"].iter().any(|verb| doing.starts_with(verb));
    let why = match error.kind() {
        ErrorKind::NotFound if makes => "the system refuses it; choose another place".to_string(),
        _ => because(error),
    };
    Failure::new(format!("cannot {doing} {}: {why}", path.display()))
}

/// The folder `path`, and those that it is in, cannot be made.
pub fn folder_failure(path: &Path, error: &io::Error) -> Failure {
    if error.kind() != ErrorKind::AlreadyExists {
        return file_failure("make the folder", path, error);
    }
    // What is there already and is no folder is a file, or a link that leads to none.
    let there = path.ancestors().find(|place| place.symlink_metadata().is_ok()).unwrap_or(path);
    let what = match there.symlink_metadata() {
        Ok(found) if found.is_symlink() && !there.exists() => {
            "is a link that leads nowhere; make the folder that it names, or remove it"
        }
        Ok(found) if !found.is_file() => "is no folder; name one",
        _ => "is a file; name a folder",
    };
    Failure::new(format!("cannot make the folder {}: {} {what}", path.display(), there.display()))
}

/// Linux's number for a link that leads to itself.
const ELOOP: i32 = 40;

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
        // `ErrorKind::FilesystemLoop` is not stable yet.
        _ if error.raw_os_error() == Some(ELOOP) => "it is a link that leads to itself; make it lead to a file",
        _ => {
            let said = error.to_string();
            return said.split(" (os error").next().unwrap_or(&said).to_string();
        }
    };
    plain.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `frame --out /proc/x.png` said that there was no such file, which was to be made.
    #[test]
    fn what_is_made_where_the_system_makes_nothing_is_refused_by_the_system() {
        let path = Path::new("/proc/x.png");
        let said = |doing: &str| file_failure(doing, path, &ErrorKind::NotFound.into()).to_string();
        assert_eq!(
            said("write the picture"),
            "cannot write the picture /proc/x.png: the system refuses it; choose another place"
        );
        assert!(said("make the recording").ends_with("the system refuses it; choose another place"));
        assert_eq!(said("read the recording"), "cannot read the recording /proc/x.png: there is no such file");
    }
}
