//! Where the table of a recording is: found by what it is, not by what it is called.
//!
//! A recording may lie in any folder and be read from any other, and a folder may be called like a built-in table: a
//! table is the one that was played on if its hash is, wherever it is. It is looked for among the built-in tables, beside
//! the recording, and where it was.

use super::tables;
use crate::recording::Header;
use crate::{Failure, Table};
use std::path::{Path, PathBuf};

/// Finds the table of a recording that lies in the file `path`, if it lies in one.
///
/// # Errors
/// If the table is not found: whether one of its name has changed since, cannot be read, or is nowhere.
pub(super) fn find(header: &Header, path: Option<&Path>) -> Result<Table, Failure> {
    let mut changed = None;
    let mut unreadable = None;
    for folder in places(header, path) {
        match tables::load_dir(&folder) {
            Ok(table) => match header.check_table(&table) {
                Ok(()) => return Ok(table),
                Err(failure) if is_namesake(&folder, header) => _ = changed.get_or_insert(failure),
                Err(_) => {}
            },
            Err(failures) => _ = unreadable.get_or_insert((folder, failures)),
        }
    }
    let unreadable = unreadable.map(|(folder, failures)| {
        let first = failures.first().map(ToString::to_string).unwrap_or_default();
        Failure::new(format!("the table {} that it may have been played on cannot be read: {first}", folder.display()))
    });
    Err(changed.or(unreadable).unwrap_or_else(|| missing(header)))
}

fn missing(header: &Header) -> Failure {
    let place = match header.folder.as_str() {
        "" => String::new(),
        folder => format!(" and not where it was, in {folder}"),
    };
    let name = &header.table;
    Failure::new(format!("its table {name} is not among the built-in ones, not beside the recording{place}"))
}

fn is_namesake(folder: &Path, header: &Header) -> bool {
    folder.ends_with(&header.table) || folder == Path::new(&header.folder)
}

/// The folders that a recording's table may be in, each once, the likeliest first.
fn places(header: &Header, path: Option<&Path>) -> Vec<PathBuf> {
    let names = tables::names();
    let is_own = |name: &&String| **name == header.table;
    let built_in = names.iter().filter(is_own).chain(names.iter().filter(|name| !is_own(name)));
    let mut places: Vec<PathBuf> = built_in.filter_map(|name| tables::built_in(name)).collect();
    if let Some(folder) = path.and_then(|path| path.canonicalize().ok()).as_deref().and_then(Path::parent) {
        // A name is one folder's: what a file says leads nowhere else.
        let name = Path::new(&header.table).file_name();
        let around = [Some(folder), folder.parent()].into_iter().flatten();
        places.extend(name.into_iter().flat_map(|name| around.clone().map(move |folder| folder.join(name))));
        places.push(folder.to_path_buf());
    }
    if !header.folder.is_empty() {
        places.push(PathBuf::from(&header.folder));
    }
    let mut seen = Vec::new();
    places.retain(|place| {
        let is_new = place.join("table.svg").is_file() && !seen.contains(place);
        seen.push(place.clone());
        is_new
    });
    places
}
