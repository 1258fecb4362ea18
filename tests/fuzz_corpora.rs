//! What fuzzing has found worth keeping is read again: an input that was bad once, and those that come to every place of
//! the code that any came to.

#![expect(clippy::disallowed_methods, reason = "the corpora are the repository's own")]

use rayon::prelude::*;
use std::path::{Path, PathBuf};

#[path = "../fuzz/src/lib.rs"]
mod subjects;

fn files(folder: &str, target: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz").join(folder).join(target);
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.sort();
    files
}

fn read_again(target: &str, run: fn(&[u8])) {
    let seeds = files("seeds", target);
    assert!(!seeds.is_empty(), "fuzzing of {target} has nothing to begin with");
    let all = [seeds, files("corpus", target)].concat();
    all.par_iter().for_each(|path| {
        let bytes = std::fs::read(path).expect("an input");
        let run = std::panic::catch_unwind(|| run(&bytes));
        assert!(run.is_ok(), "{} fails", path.display());
    });
    println!("{target}: {} inputs", all.len());
}

#[test]
fn every_drawing_is_a_table_or_sentences() {
    read_again("drawing", subjects::drawing::run);
}

#[test]
fn every_text_of_numbers_is_a_table_or_sentences() {
    read_again("numbers", subjects::numbers::run);
}

#[test]
fn every_script_is_run_or_refused() {
    read_again("script", subjects::script::run);
}

#[test]
fn every_recording_is_played_or_refused() {
    read_again("recording", subjects::recording::run);
}

#[test]
fn every_table_can_be_played() {
    read_again("table", subjects::table::run);
}
