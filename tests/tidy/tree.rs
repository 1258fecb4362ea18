//! The tree as the tests read it: its crates, their files, and their text without comments, strings and test code.

#![expect(clippy::disallowed_methods, reason = "the sources are the repository's own")]

use std::fs;
use std::path::{Path, PathBuf};

use super::code;

/// The repository's folder.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A file's text, by its path from the root.
pub fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The folders of the workspace's crates, as `Cargo.toml` lists them.
pub fn crates() -> Vec<String> {
    let manifest: toml::Table = toml::from_str(&read("Cargo.toml")).expect("Cargo.toml is TOML");
    let members = manifest["workspace"]["members"].as_array().expect("members");
    members.iter().map(|member| member.as_str().expect("a folder").to_string()).collect()
}

/// The paths of the files below `folder` for which `wanted` holds, from the root, in order. Build output, hidden
/// folders and, below a crate, the crates nested in it are left out.
pub fn files(folder: &str, wanted: impl Fn(&Path) -> bool) -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            let name = entry.file_name().expect("a name").to_string_lossy().into_owned();
            if entry.is_dir() && name != "target" && (!name.starts_with('.') || name == ".ci") {
                folders.push(entry);
            } else if entry.is_file() && wanted(&entry) {
                found.push(entry.strip_prefix(root()).expect("a path below the root").to_string_lossy().into_owned());
            }
        }
    }
    found.sort();
    found
}

/// A Rust file.
pub struct Source {
    /// From the root, with slashes.
    pub path: String,
    /// As it stands in the file.
    pub text: String,
    /// The text with comments, strings and characters blanked, line by line the same.
    pub code: String,
}

/// Every Rust file under `folder`.
pub fn sources(folder: &str) -> Vec<Source> {
    let found: Vec<_> = files(folder, |path| path.extension().is_some_and(|extension| extension == "rs"))
        .into_iter()
        .map(|path| {
            let text = read(&path);
            let code = code::blanked(&text);
            Source { path, text, code }
        })
        .collect();
    assert!(!found.is_empty(), "{folder} has no Rust file");
    found
}

/// What a library is built from: every Rust file under `folder` without its test code. Files that are modules of tests
/// (`#[cfg(test)] mod tests;`) and all below them are left out.
pub fn production(folder: &str) -> Vec<Source> {
    let mut found = sources(folder);
    let mut test_modules = Vec::new();
    for source in &mut found {
        let (code, modules) = code::without_tests(&source.code);
        let folder = module_folder(&source.path);
        test_modules.extend(modules.iter().map(|module| format!("{folder}/{module}")));
        source.code = code;
    }
    let below = |path: &str, module: &String| {
        path.strip_prefix(module.as_str()).is_some_and(|rest| rest.starts_with(['.', '/']))
    };
    found.retain(|source| !test_modules.iter().any(|module| below(&source.path, module)));
    found
}

/// Where the modules that a file declares lie: `a` for `a/mod.rs` and `a/lib.rs`, `a/b` for `a/b.rs`.
fn module_folder(path: &str) -> String {
    let stem = path.strip_suffix(".rs").expect("a Rust file");
    let (folder, name) = stem.rsplit_once('/').expect("a file in a folder");
    if ["mod", "lib", "main"].contains(&name) { folder.to_string() } else { stem.to_string() }
}

/// The module path of a file below `source`, the crate's source folder: `["a", "b"]` for `a/b.rs` and `a/b/mod.rs`.
pub fn module_path(source: &str, path: &str) -> Vec<String> {
    let folder = module_folder(path);
    let below = folder.strip_prefix(source).expect("a file of the crate").trim_start_matches('/');
    below.split('/').filter(|name| !name.is_empty()).map(str::to_string).collect()
}
