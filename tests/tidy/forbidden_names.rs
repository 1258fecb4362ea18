//! Who may name whom, how long a file may be, and that nothing is left for later.

use super::code::words;
use super::tree::{Source, crates, read, sources};

/// The lines of code under `folder` that name `word`, as `path:line`.
fn naming(folder: &str, word: &str) -> Vec<String> {
    let found = sources(folder).into_iter().flat_map(|source| {
        let named = words(&source.code).into_iter().filter(|found| found.text == word);
        named.map(|found| format!("{}:{}", source.path, found.line)).collect::<Vec<_>>()
    });
    found.collect()
}

/// Every Rust file of the repository.
fn everything() -> Vec<Source> {
    ["game", "physics", "tracer", "tests"].into_iter().flat_map(sources).collect()
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
        ("tiny_skia", &["game/src/screen/", "game/src/art/"]),
        ("resvg", &["game/src/art/"]),
        ("plotters", &["game/src/commands/plot/"]),
        ("rhai", &["game/pinball/src/rules/"]),
        ("rapier2d", &["physics/src/"]),
    ];
    for (library, allowed) in rooms {
        for folder in crates() {
            let strangers: Vec<_> = naming(&format!("{folder}/src"), library)
                .into_iter()
                .filter(|place| !allowed.iter().any(|room| place.starts_with(room)))
                .collect();
            assert!(strangers.is_empty(), "{library} is named outside {allowed:?}: {strangers:?}");
        }
    }
}

#[test]
fn the_simulation_reads_no_clock_starts_no_thread_and_has_no_hash_order() {
    for word in ["Instant", "SystemTime", "thread", "rayon", "HashMap", "HashSet", "fs", "PathBuf", "env"] {
        for room in ["physics/src", "game/pinball/src", "tracer/geometry/src"] {
            assert_eq!(naming(room, word), [""; 0], "{word} in {room}");
        }
    }
}

#[test]
fn what_decides_a_game_knows_nothing_of_light_and_window() {
    for word in ["tracer", "winit", "softbuffer", "tiny_skia", "resvg", "png", "clap"] {
        for folder in ["physics", "game/pinball", "tracer/geometry"] {
            assert_eq!(naming(folder, word), [""; 0], "{word} in {folder}");
            let manifest: toml::Table = toml::from_str(&read(&format!("{folder}/Cargo.toml"))).expect("TOML");
            let dependencies = manifest["dependencies"].as_table().expect("dependencies");
            assert!(!dependencies.contains_key(&word.replace('_', "-")), "{folder} depends on {word}");
        }
    }
}

#[test]
fn pinball_names_no_file_and_no_stream() {
    for word in ["Path", "File", "process", "stdin", "stdout", "stderr", "directories"] {
        assert_eq!(naming("game/pinball/src", word), [""; 0], "{word} in game/pinball");
    }
}

#[test]
fn a_file_is_one_noun() {
    for source in everything() {
        let lines = source.text.lines().count();
        assert!(lines <= 450, "{} has {lines} lines: it holds more than one noun", source.path);
    }
}

#[test]
fn nothing_is_left_for_later() {
    for source in everything() {
        for word in [concat!("todo", "!("), concat!("unimplemented", "!("), concat!("TO", "DO"), concat!("FIX", "ME")] {
            assert!(!source.text.contains(word), "{} has {word}", source.path);
        }
    }
}
