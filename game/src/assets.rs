//! Where the game's data lies: tables, demos and fonts.
//!
//! Refuses to know what is in them.

use crate::Failure;
use std::path::{Path, PathBuf};

/// The fonts of `assets/fonts`, built in: a picture must be the same on every machine, so neither the system's fonts
/// nor a file that may be missing are read.
pub const FONTS: [(&str, &[u8]); 4] = [
    ("Cinzel-SemiBold.ttf", include_bytes!("../../assets/fonts/Cinzel-SemiBold.ttf")),
    ("Marcellus-Regular.ttf", include_bytes!("../../assets/fonts/Marcellus-Regular.ttf")),
    ("Oxanium-Bold.ttf", include_bytes!("../../assets/fonts/Oxanium-Bold.ttf")),
    ("Oxanium-Regular.ttf", include_bytes!("../../assets/fonts/Oxanium-Regular.ttf")),
];

/// The folders that may hold `assets`: where the game was started, those that its program lies in, and its source.
fn roots() -> Vec<PathBuf> {
    let mut roots = vec![PathBuf::from(".")];
    if let Ok(program) = std::env::current_exe() {
        roots.extend(program.ancestors().skip(1).map(Path::to_path_buf));
    }
    roots.push(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
    roots
}

/// The first file or folder `assets/RELATIVE` that there is.
pub fn find(relative: impl AsRef<Path>) -> Option<PathBuf> {
    roots().into_iter().map(|root| root.join("assets").join(relative.as_ref())).find(|path| path.exists())
}

/// The folder of the table called `name`, or the folder `name` itself if it holds a drawing.
///
/// # Errors
/// If there is no such table: which ones there are.
pub fn table_dir(name: &str) -> Result<PathBuf, Failure> {
    let folder = Path::new(name);
    if folder.join("table.svg").is_file() {
        return Ok(folder.to_path_buf());
    }
    let is_plain = folder.components().count() == 1 && folder.file_name().is_some();
    let known = is_plain.then(|| find(Path::new("tables").join(name).join("table.svg"))).flatten();
    if let Some(dir) = known.as_deref().and_then(Path::parent) {
        return Ok(dir.to_path_buf());
    }
    if folder.is_dir() {
        return Err(Failure::new(format!("the folder {name} has no table.svg, so it is no table")));
    }
    let names = table_names();
    let there_are = match names.as_slice() {
        [] => "no assets/tables folder was found; start the game where its assets are".to_string(),
        names => format!("there are {}; or give the folder of one", names.join(", ")),
    };
    Err(Failure::new(format!("there is no table called {name}: {there_are}")))
}

/// The recorded demos, in order.
///
/// # Errors
/// If the folder of the demos cannot be found or read.
pub fn demos() -> Result<Vec<PathBuf>, Failure> {
    let folder = find("demos")
        .ok_or_else(|| Failure::new("no assets/demos folder was found; start the game where its assets are"))?;
    let entries = std::fs::read_dir(&folder)
        .map_err(|error| Failure::new(format!("cannot read {}: {error}", folder.display())))?;
    let mut demos: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    demos.retain(|path| path.extension().is_some_and(|extension| extension == "caustic"));
    demos.sort();
    Ok(demos)
}

/// The names of the tables there are, in order.
pub fn table_names() -> Vec<String> {
    let folders = roots().into_iter().filter_map(|root| std::fs::read_dir(root.join("assets/tables")).ok());
    let tables = folders.flatten().flatten().filter(|entry| entry.path().join("table.svg").is_file());
    let mut names: Vec<String> = tables.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names.dedup();
    names
}
