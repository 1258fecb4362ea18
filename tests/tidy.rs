//! Style as tests: who may name whom, how long a file may be, and that the map of the house is true.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every Rust file under `folder`, with its text and its path from the root.
fn sources(folder: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a source folder").map(|entry| entry.expect("an entry").path()) {
            if entry.is_dir() && !entry.ends_with("target") {
                folders.push(entry);
            } else if entry.extension().is_some_and(|extension| extension == "rs") {
                let path = entry.strip_prefix(root()).expect("a path below the root").to_string_lossy().into_owned();
                found.push((path, fs::read_to_string(&entry).expect("UTF-8")));
            }
        }
    }
    found.sort();
    assert!(!found.is_empty(), "{folder} has no Rust file");
    found
}

/// The lines of code under `folder` that name `word` (comments and the file name `rules.rhai` left out), as `path:line`.
fn naming(folder: &str, word: &str) -> Vec<String> {
    sources(folder)
        .iter()
        .flat_map(|(path, text)| {
            let named = text.lines().enumerate().filter(|(_, line)| {
                let code = line.split("//").next().unwrap_or("").replace("rules.rhai", "");
                code.split(|c: char| !c.is_alphanumeric() && c != '_').any(|name| name == word)
            });
            named.map(move |(number, _)| format!("{path}:{}", number + 1)).collect::<Vec<_>>()
        })
        .collect()
}

#[test]
fn light_and_ball_never_name_each_other() {
    assert_eq!(naming("physics", "tracer"), [""; 0]);
    assert_eq!(naming("tracer", "physics"), [""; 0]);
    assert_eq!(naming("tracer/geometry/src", "rayon"), [""; 0]);
}

#[test]
fn each_library_is_named_in_its_own_room_only() {
    let rooms: [(&str, &[&str]); 7] = [
        ("winit", &["game/src/desktop/"]),
        ("softbuffer", &["game/src/desktop/"]),
        ("tiny_skia", &["game/src/screen/", "game/src/table/"]),
        ("resvg", &["game/src/table/"]),
        ("plotters", &["game/src/commands/plot/"]),
        ("rhai", &["game/src/rules/"]),
        ("rapier2d", &["physics/src/"]),
    ];
    for (library, allowed) in rooms {
        for folder in ["game/src", "physics/src", "tracer/src"] {
            let strangers: Vec<_> = naming(folder, library)
                .into_iter()
                .filter(|place| !allowed.iter().any(|room| place.starts_with(room)))
                .collect();
            assert!(strangers.is_empty(), "{library} is named outside {allowed:?}: {strangers:?}");
        }
    }
}

#[test]
fn the_simulation_reads_no_clock_starts_no_thread_and_has_no_hash_order() {
    let rooms = ["physics/src", "game/src/simulation", "game/src/rules", "game/src/bot", "tracer/geometry/src"];
    for word in ["Instant", "SystemTime", "thread", "rayon", "HashMap", "HashSet", "fs"] {
        for room in rooms {
            assert_eq!(naming(room, word), [""; 0], "{word} in {room}");
        }
    }
}

#[test]
fn a_file_is_one_noun() {
    for folder in ["game/src", "physics", "tracer", "tests"] {
        for (path, text) in sources(folder) {
            let lines = text.lines().count();
            assert!(lines <= 450, "{path} has {lines} lines: it holds more than one noun");
        }
    }
}

#[test]
fn nothing_is_left_for_later() {
    for folder in ["game/src", "physics", "tracer"] {
        for (path, text) in sources(folder) {
            for word in ["todo!(", "unimplemented!(", concat!("TO", "DO"), concat!("FIX", "ME")] {
                assert!(!text.contains(word), "{path} has {word}");
            }
        }
    }
}

#[test]
fn every_path_on_the_map_exists() {
    let map = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let paths: Vec<_> = map
        .split('`')
        .skip(1)
        .step_by(2)
        .filter(|code| code.contains('/') && !code.contains(' ') && !code.contains('*') && !code.contains("::"))
        .collect();
    assert!(paths.len() > 10, "the map names {} paths only", paths.len());
    for path in paths {
        assert!(root().join(path).exists(), "ARCHITECTURE.md names {path}, which is not there");
    }
}
