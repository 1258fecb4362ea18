//! Tables as folders: found by name, read, and checked with their art.

use super::assets::{find, roots};
use super::file_failure::because;
use super::limited_read::{self, special};
use crate::art;
use crate::table::{FILES, LIMITS_BYTES, TableSources};
use crate::{Failure, Table};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Reads and checks the table called `name`, or the one in the folder `name`.
///
/// # Errors
/// Every mistake in its files, one line each: file, line, what was expected.
pub fn load(name: &str) -> Result<Table, Vec<Failure>> {
    let dir = table_dir(name).map_err(|failure| vec![failure])?;
    load_dir(&dir)
}

/// Reads and checks the table in the folder `dir`.
///
/// # Errors
/// As [`load`].
pub fn load_dir(dir: &Path) -> Result<Table, Vec<Failure>> {
    let table = Table::parse(sources(dir))?;
    match art::check(&table) {
        Ok(_) => Ok(table),
        Err(failure) => {
            let failure = failure.in_file(table.file(FILES[0]));
            Err(table.warnings.into_iter().chain([failure]).collect())
        }
    }
}

fn sources(dir: &Path) -> TableSources {
    let name = folder_name(dir);
    TableSources {
        folder: recorded_folder(dir, &name),
        name,
        origin: dir.display().to_string(),
        files: [0, 1, 2].map(|file| read(&dir.join(FILES[file]), LIMITS_BYTES[file])),
    }
}

fn folder_name(dir: &Path) -> String {
    let whole = dir.canonicalize().unwrap_or_else(|_| dir.to_path_buf());
    whole.file_name().map_or_else(|| "table".to_string(), |name| name.to_string_lossy().into_owned())
}

/// The folder that a recording names, so that its reader finds the table's art; empty for a built-in table.
fn recorded_folder(dir: &Path, name: &str) -> String {
    let absolute = dir.canonicalize().ok();
    if absolute.is_some() && built_in(name).and_then(|built_in| built_in.canonicalize().ok()) == absolute {
        return String::new();
    }
    absolute.as_deref().unwrap_or(dir).to_string_lossy().into_owned()
}

/// The folder of the built-in table called `name`.
pub(super) fn built_in(name: &str) -> Option<PathBuf> {
    let is_plain = Path::new(name).components().count() == 1 && Path::new(name).file_name().is_some();
    let drawing = is_plain.then(|| find(Path::new("tables").join(name).join(FILES[0]))).flatten()?;
    drawing.parent().map(Path::to_path_buf)
}

/// The bytes of a file, or why it cannot be read.
fn read(path: &Path, limit_bytes: u64) -> Result<Vec<u8>, String> {
    limited_read::read(path, limit_bytes).map_err(|error| match error.kind() {
        ErrorKind::NotFound => "there is no such file, and a table needs it".to_string(),
        _ => format!("it cannot be read: {}", because(&error)),
    })
}

/// The folder of the table called `name`, or the folder `name` itself if anything in it is called as a drawing.
///
/// # Errors
/// If there is no such table: which ones there are.
fn table_dir(name: &str) -> Result<PathBuf, Failure> {
    let folder = Path::new(name);
    // A link that leads nowhere is there, and what is wrong with it is told when it is read.
    if folder.join(FILES[0]).symlink_metadata().is_ok() {
        return Ok(folder.to_path_buf());
    }
    if let Some(dir) = built_in(name) {
        return Ok(dir);
    }
    if folder.is_file() {
        let around = folder.parent().filter(|around| around.join(FILES[0]).exists());
        let folder = around
            .map_or_else(|| "the folder of a table".to_string(), |around| format!("its folder, {}", around.display()));
        return Err(Failure::new(format!("{name} is a file; name {folder}")));
    }
    if folder.is_dir() {
        return Err(Failure::new(format!("the folder {name} has no table.svg, so it is no table")));
    }
    if let Ok(found) = folder.metadata() {
        return Err(Failure::new(format!(
            "{name} is {} and no folder; name the folder of a table",
            special(found.file_type())
        )));
    }
    if folder.symlink_metadata().is_ok() {
        return Err(Failure::new(format!("{name} is a link that leads nowhere; name the folder of a table")));
    }
    let names = names();
    let there_are = match names.as_slice() {
        [] => "no assets/tables folder was found; start the game where its assets are".to_string(),
        [name] => format!("there is only {name}; or give the folder of one"),
        names => format!("there are {}; or give the folder of one", names.join(", ")),
    };
    Err(Failure::new(format!("there is no table called {name}: {there_are}")))
}

/// The names of the built-in tables, in order.
pub(super) fn names() -> Vec<String> {
    let folders = roots().into_iter().filter_map(|root| std::fs::read_dir(root.join("assets/tables")).ok());
    let tables = folders.flatten().flatten().filter(|entry| entry.path().join("table.svg").is_file());
    let mut names: Vec<String> = tables.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names.dedup();
    names
}
