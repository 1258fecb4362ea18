//! Every example draws a picture.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The names of the files in `examples`.
fn examples() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    files.map(|file| file.file_stem().expect("a name").to_string_lossy().into_owned()).collect()
}

/// Runs the example, which cargo has built next to this program, and says where its picture is.
fn drawn(name: &str) -> PathBuf {
    let own = std::env::current_exe().expect("a path");
    let built = own.parent().and_then(Path::parent).expect("target/PROFILE/deps").join("examples").join(name);
    let picture = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    if picture.exists() {
        fs::remove_file(&picture).expect("an old picture goes");
    }
    // The table is drawn again and again: small pictures do.
    let size: &[&str] = if name == "table" { &["54x108"] } else { &[] };
    let output = Command::new(&built).arg(&picture).args(size).output();
    let output =
        output.unwrap_or_else(|error| panic!("{}: {error}; `cargo test -p tracer` builds it", built.display()));
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    picture
}

/// The bytes of a picture's pixels.
fn pixels(picture: &Path) -> Vec<u8> {
    let file = std::io::BufReader::new(fs::File::open(picture).expect("a picture"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut pixels).expect("pixels");
    pixels
}

#[test]
fn every_example_draws_a_picture() {
    let examples = examples();
    assert!(!examples.is_empty());
    for name in examples {
        let pixels = pixels(&drawn(&name));
        let (darkest, lightest) = (pixels.iter().min().expect("pixels"), pixels.iter().max().expect("pixels"));
        assert!(lightest - darkest > 50, "{name}: all of it looks the same");
    }
}
