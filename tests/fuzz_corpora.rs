//! What fuzzing has found worth keeping is read again: an input that was bad once, and those that come to every place of
//! the code that any came to.

#![expect(clippy::disallowed_methods, reason = "the corpora are the repository's own")]

use flate2::read::GzDecoder;
use rayon::prelude::*;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

#[path = "../fuzz/src/lib.rs"]
mod subjects;

/// A file's name, and what is in it.
type Input = (String, Vec<u8>);

fn fuzz_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz")
}

fn seeds(target: &str) -> Vec<Input> {
    let entries = fs::read_dir(fuzz_folder().join("seeds").join(target)).expect("a folder of seeds");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths.map(|path| (path.display().to_string(), fs::read(&path).expect("a seed"))).collect()
}

fn corpus(target: &str) -> Vec<Input> {
    let file = File::open(fuzz_folder().join("corpora").join(target).with_extension("tar.gz")).expect("a corpus");
    let mut archive = tar::Archive::new(GzDecoder::new(file));
    let files = archive.entries().expect("an archive").map(|entry| entry.expect("an entry"));
    let inputs = files.filter(|entry| entry.header().entry_type().is_file()).map(|mut entry| {
        let name = entry.path().expect("a name").display().to_string();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).expect("an input");
        (name, bytes)
    });
    inputs.collect()
}

fn read_again(target: &str, run: fn(&[u8])) {
    let (seeds, corpus) = (seeds(target), corpus(target));
    assert!(!seeds.is_empty() && corpus.len() > 500, "fuzzing of {target} has nothing to begin with");
    let all = [seeds, corpus].concat();
    all.par_iter().for_each(|(name, bytes)| {
        let run = std::panic::catch_unwind(|| run(bytes));
        assert!(run.is_ok(), "{target}: {name} fails");
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
