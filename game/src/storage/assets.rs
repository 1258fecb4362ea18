//! Where the game's data lies: tables and demos.
//!
//! Refuses to know what is in them.

use crate::Failure;
use std::path::{Path, PathBuf};

/// The folders that may hold `assets`: where the game was started, those that its program lies in, and its source.
pub(super) fn roots() -> Vec<PathBuf> {
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
