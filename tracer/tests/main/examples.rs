//! Every example writes a picture, and shows what it says that it shows.

#![expect(clippy::disallowed_methods, reason = "the test reads what an example has written")]

#[path = "../../examples/one_lamp.rs"]
#[expect(dead_code, reason = "an example's main is not run here: it would take the tests' command line for its own")]
mod one_lamp;
#[path = "../../examples/soft_shadow.rs"]
#[expect(dead_code, reason = "as above")]
mod soft_shadow;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tracer::Frame;

/// The names of the files in `examples`.
fn examples() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let sources = files.filter(|file| file.extension().is_some_and(|extension| extension == "rs"));
    sources.map(|file| file.file_stem().expect("a name").to_string_lossy().into_owned()).collect()
}

/// Runs the example, which cargo has built next to this program, and says where its picture is.
fn drawn(name: &str) -> PathBuf {
    let own = std::env::current_exe().expect("a path");
    let built = own.parent().and_then(Path::parent).expect("target/PROFILE/deps").join("examples").join(name);
    let picture = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    if picture.exists() {
        fs::remove_file(&picture).expect("an old picture goes");
    }
    let output = Command::new(&built).arg(&picture).output();
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

fn channel(frame: &Frame, shift: u32, x: usize, y: usize) -> i64 {
    i64::from(frame.pixels[y * frame.width + x] >> shift & 0xff)
}

/// In the ring it is bright, behind a post it is dark.
#[test]
fn one_lamp_lights_the_ring_and_leaves_umbrae_behind_the_posts() {
    let frame = one_lamp::picture();
    let red = |x: usize, y: usize| channel(&frame, 16, x, y);
    assert!(red(360, 360) > 200 && red(560, 360) < 10, "{} {}", red(360, 360), red(560, 360));
}

/// The point lamp is red, the disc lamp green: somewhere red steps from pixel to pixel, green nowhere does so.
#[test]
fn soft_shadow_has_a_hard_edge_and_a_soft_one() {
    let frame = soft_shadow::picture();
    let steepest = |shift: u32| {
        let pixels = (360..frame.height).flat_map(|y| (1..frame.width).map(move |x| (x, y)));
        pixels.map(|(x, y)| (channel(&frame, shift, x, y) - channel(&frame, shift, x - 1, y)).abs()).max().unwrap_or(0)
    };
    assert!(steepest(16) > 80 && steepest(8) < 60, "{} {}", steepest(16), steepest(8));
}
