//! Whatever a file says, a terminal only shows it.

use super::command_line::{Folder, program};
use game::recording::Header;
use std::fs;

/// What a terminal must never get: an escape, an 8-bit control, a bell, an override of the writing direction.
const EVIL: &str = "\u{1b}]0;title\u{7}\u{9b}31m\u{202e}\u{2066}\u{7f}\r";

/// A table whose every text is evil. XML allows no C0 controls, but for line breaks.
fn evil_table(folder: &Folder, rules: &str, toml: &str) -> String {
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 500 1000\">
<line id=\"left\" class=\"flipper\" data-side=\"left\" data-up-deg=\"50\" x1=\"150\" y1=\"850\" x2=\"210\" y2=\"885\"/>
<line class=\"drain\" x1=\"100\" y1=\"980\" x2=\"400\" y2=\"980\" stroke-width=\"20\"/>
<line id=\"plunger\" class=\"plunger\" x1=\"480\" y1=\"900\" x2=\"480\" y2=\"950\" stroke-width=\"24\"/>
<line id=\"t\u{9b}31m\u{202e}&#10;caustic: forged\" class=\"target\" x1=\"100\" y1=\"100\" x2=\"140\" y2=\"100\"/>
</svg>";
    let path = folder.path(&format!("{EVIL}table"));
    fs::create_dir_all(&path).expect("a folder");
    for (file, text) in [("table.svg", svg), ("table.toml", toml), ("rules.rhai", rules)] {
        fs::write(format!("{path}/{file}"), text).expect("a file");
    }
    path
}

/// Runs the program; fails if anything but plain text comes out. What it said.
fn plain(words: &[&str]) -> String {
    let output = program(words).output().expect("the program runs");
    let said = [&output.stdout[..], &output.stderr].concat();
    let said = String::from_utf8(said).expect("text");
    let evil = said.chars().find(|&c| c != '\n' && (c.is_control() || ['\u{202e}', '\u{2066}'].contains(&c)));
    assert_eq!(evil, None, "{words:?}: {}", said.escape_debug());
    let forged = said.lines().any(|line| line.starts_with("caustic: forged"));
    assert!(!forged && !said.is_empty(), "{words:?}: {said}");
    said
}

const TITLE: &str = "name = \"\\u001b[2J\\u0007\\u202E\\ncaustic: forged\"";

#[test]
fn no_command_lets_a_terminal_obey_what_a_table_says() {
    let folder = Folder::new("terminal");
    let rules = "fn on_start() { after(5, \"a\"); } fn on_timer(name) { throw \"\\x1b[31m\\ncaustic: forged\"; }";
    let table = evil_table(&folder, rules, TITLE);
    let (out, png, games) = (folder.path(&format!("{EVIL}out")), folder.path("x.png"), folder.path("games"));
    assert!(plain(&["check", &table]).contains("\\u{1b}"));
    assert!(plain(&["play", "--table", &table]).contains("no display"));
    let words = ["simulate", "--games", "1", "--minutes", "0.02", "--table", &table, "--save-all", &games];
    let said = plain(&words);
    assert!(said.contains("\\u{202e}\\u{a}caustic: forged"), "the name of a target that is never hit: {said}");
    assert!(said.contains("rules.rhai:1: \\u{1b}[31m\\u{a}caustic: forged"), "what a rule throws: {said}");
    let recording = folder.path("games/game-1.caustic");
    plain(&["verify", &recording]);
    fs::remove_dir_all(&table).expect("the table goes");
    let (size, fps) = (["--size", "64x64"], ["--fps", "1"]);
    let shown = plain(&[&["frame", "--replay", &recording, "--out", &png][..], &size].concat());
    assert!(shown.contains("without its art"), "{shown}");
    plain(&[&["dump", &recording, "--out", &out][..], &size, &fps].concat());
    plain(&[&["dump", &recording, "--out", &out][..], &size, &fps].concat());
    plain(&["replay", &recording]);
    plain(&["plot", "restitution", "--table", &out, "--out", &out]);
    plain(&["frame", "--table", &table, "--out", &png]);
    plain(&["verify", &out, &format!("{recording}{EVIL}")]);
}

#[test]
fn no_mistake_in_a_table_reaches_the_terminal_as_it_stands() {
    for (name, rules, toml) in [
        ("throw", "fn on_start() { throw \"\\x1b[31m\\ncaustic: forged\"; }", TITLE),
        ("compile", "fn on_start() { let \u{1b}[2J = \u{202e}; }", TITLE),
        ("names", "fn on_switch(\u{9b}) { lamp(\"\u{1b}[31m\u{202e}\", 1000); }", TITLE),
        ("numbers", "", "\"\\u001b[31m\" = 3\n[\"\\u202e\\ncaustic: forged\"]\na = 1"),
        ("broken", "", "a = \u{1b}[31m\u{202e}"),
    ] {
        let folder = Folder::new(&format!("mistakes-{name}"));
        let table = evil_table(&folder, rules, toml);
        plain(&["check", &table]);
        plain(&["simulate", "--games", "1", "--minutes", "0.01", "--table", &table]);
    }
}

#[test]
fn nothing_that_a_recording_says_of_its_table_reaches_the_terminal_as_it_stands() {
    let folder = Folder::new("header");
    let (file, png) = (folder.path("evil.caustic"), folder.path("x.png"));
    let (table, place) = (format!("{EVIL}mine"), format!("/{EVIL}\ncaustic: forged"));
    let version = game::simulation::SIMULATION_VERSION;
    let header = Header { simulation_version: version, table, folder: place, table_hash: 1, seed: 1 };
    fs::write(&file, super::recording::format_1(&header)).expect("a file");
    for words in [&["verify", &file][..], &["replay", &file], &["frame", "--replay", &file, "--out", &png]] {
        assert!(plain(words).contains("\\u{1b}"), "{words:?}");
    }
}
