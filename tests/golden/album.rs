//! A folder of golden frames, and what is shown when a frame is not the golden one.
//!
//! Refuses to know what is in the pictures.

#![expect(clippy::disallowed_methods, reason = "a golden frame is the repository's own")]

use game::storage::save_png;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use tracer::Frame;

/// What makes all golden frames anew.
const BLESS: &str = "CAUSTIC_BLESS=1 cargo test -p game --test system golden";

/// Where golden frames are, and where differences go.
pub struct Album {
    /// The folder of the golden frames.
    pub golden: PathBuf,
    /// The folder for pictures of what differs.
    pub differences: PathBuf,
}

/// How far two frames are from each other.
struct Difference {
    /// Pixels that are not the same, or only in one of them.
    pixels: usize,
    /// The largest difference in a channel, in levels of 255.
    most: u8,
}

impl Album {
    fn file(&self, name: &str) -> PathBuf {
        self.golden.join(name).with_extension("png")
    }

    /// Makes `frame` the golden one called `name`.
    pub fn renew(&self, name: &str, frame: &Frame) {
        save(frame, &self.file(name));
    }

    /// Compares `frame` with the golden one called `name`, exactly.
    ///
    /// # Errors
    /// If it is not the same, or there is none to compare with: what differs, where to see it and what to do.
    pub fn compare(&self, name: &str, frame: &Frame) -> Result<(), String> {
        let (golden, shown) = (self.file(name), self.differences.join(name).with_extension("png"));
        let (path, seen) = (golden.display(), shown.display());
        let expected = match read(&golden) {
            Ok(expected) => expected,
            Err(why) => {
                save(frame, &shown);
                return Err(format!("{path} {why}: look at the new picture, {seen}, and make it with `{BLESS}`"));
            }
        };
        if expected == *frame {
            return Ok(());
        }
        let Difference { pixels, most } = difference(&expected, frame);
        let gain = 255 / usize::from(most.max(1));
        save(&side_by_side(&expected, frame, gain), &shown);
        Err(format!(
            "{path} is not what is drawn now{}: {pixels} pixels differ, by {most} levels of 255 at most; see {seen} \
             (expected | difference x {gain} | actual), and if the new one is right, renew it with `{BLESS}`",
            resized(&expected, frame)
        ))
    }
}

fn save(frame: &Frame, path: &Path) {
    fs::create_dir_all(path.parent().expect("a file in a folder")).expect("a folder for pictures");
    save_png(frame, path).expect("the picture can be written");
}

/// The picture in a PNG file of 8-bit red, green, blue; or what is wrong with it, to be said after its name.
fn read(path: &Path) -> Result<Frame, String> {
    let file = File::open(path).map_err(|_| "is missing")?;
    let damaged = |error: png::DecodingError| format!("is damaged ({error})");
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info().map_err(damaged)?;
    if reader.output_color_type() != (png::ColorType::Rgb, png::BitDepth::Eight) {
        return Err("is not of 8-bit red, green, blue".to_string());
    }
    let mut bytes = vec![0; reader.output_buffer_size().ok_or("is too large")?];
    let info = reader.next_frame(&mut bytes).map_err(damaged)?;
    let pixels = bytes.chunks_exact(3).map(|rgb| u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]])).collect();
    Ok(Frame { width: info.width as usize, height: info.height as usize, pixels })
}

/// A pixel, if the frame has it.
fn pixel(frame: &Frame, x: usize, y: usize) -> Option<u32> {
    (x < frame.width && y < frame.height).then(|| frame.pixels[y * frame.width + x])
}

/// By how many levels each channel differs: by 255 where only one frame has the pixel.
fn levels(a: Option<u32>, b: Option<u32>) -> [u8; 4] {
    match (a, b) {
        (Some(a), Some(b)) => {
            let (a, b) = (a.to_be_bytes(), b.to_be_bytes());
            std::array::from_fn(|channel| a[channel].abs_diff(b[channel]))
        }
        (None, None) => [0; 4],
        _ => [0, 255, 255, 255],
    }
}

/// Width and height that hold both frames.
fn extent(a: &Frame, b: &Frame) -> (usize, usize) {
    (a.width.max(b.width), a.height.max(b.height))
}

/// Says which sizes two frames have, if they are not the same.
fn resized(expected: &Frame, actual: &Frame) -> String {
    let [before, now] = [expected, actual].map(|frame| format!("{}x{}", frame.width, frame.height));
    if before == now { String::new() } else { format!(" ({before}, now {now})") }
}

fn difference(a: &Frame, b: &Frame) -> Difference {
    let (width, height) = extent(a, b);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let most = places.map(|(x, y)| levels(pixel(a, x, y), pixel(b, x, y)).into_iter().max().unwrap_or(0));
    let differing: Vec<u8> = most.filter(|&most| most > 0).collect();
    Difference { pixels: differing.len(), most: differing.into_iter().max().unwrap_or(0) }
}

/// `expected | difference times gain | actual`, each as large as the larger of the two, with black where there is nothing.
fn side_by_side(expected: &Frame, actual: &Frame, gain: usize) -> Frame {
    let (width, height) = extent(expected, actual);
    let mut frame = Frame::new(3 * width, height);
    for (at, out) in frame.pixels.iter_mut().enumerate() {
        let (x, y) = (at % (3 * width), at / (3 * width));
        let (a, b) = (pixel(expected, x % width, y), pixel(actual, x % width, y));
        *out = match x / width {
            0 => a.unwrap_or(0),
            1 => u32::from_be_bytes(levels(a, b).map(|level| (usize::from(level) * gain).min(255) as u8)),
            _ => b.unwrap_or(0),
        };
    }
    frame
}

/// An album of this test's own, in folders that are not there yet.
fn empty_album(name: &str) -> Album {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("album-{name}"));
    let _ = fs::remove_dir_all(&folder);
    Album { golden: folder.join("golden"), differences: folder.join("differences") }
}

/// A small picture with every pixel another colour.
fn sample(width: usize, height: usize) -> Frame {
    let pixels = (0..width * height).map(|at| (at as u32 * 0x01_0307) & 0xff_ffff).collect();
    Frame { width, height, pixels }
}

#[test]
fn golden_frames_are_read_as_they_were_written() {
    let album = empty_album("same");
    album.renew("sample", &sample(31, 17));
    assert_eq!(album.compare("sample", &sample(31, 17)), Ok(()));
    assert!(!album.differences.exists(), "nothing differs");
}

#[test]
fn one_changed_pixel_fails_and_is_shown_between_the_expected_and_the_actual_frame() {
    let album = empty_album("pixel");
    let (expected, mut actual) = (sample(31, 17), sample(31, 17));
    let (x, y) = (5, 9);
    actual.pixels[y * 31 + x] ^= 0x00_0200;
    album.renew("sample", &expected);
    let said = album.compare("sample", &actual).unwrap_err();
    assert!(said.contains("is not what is drawn now: 1 pixels differ, by 2 levels of 255 at most"), "{said}");
    assert!(said.contains(BLESS), "{said}");
    let shown = album.differences.join("sample.png");
    assert!(said.contains(&shown.display().to_string()), "{said}");
    let shown = read(&shown).unwrap();
    assert_eq!((shown.width, shown.height), (93, 17));
    for (at, &shown) in shown.pixels.iter().enumerate() {
        let (column, row) = (at % 93, at / 93);
        let place = row * 31 + column % 31;
        let wanted = match column / 31 {
            0 => expected.pixels[place],
            1 => [0, 0x00_fe00][usize::from((column - 31, row) == (x, y))],
            _ => actual.pixels[place],
        };
        assert_eq!(shown, wanted, "at {column}, {row}");
    }
    assert_eq!(read(&album.file("sample")).unwrap(), expected, "the golden frame stays");
}

#[test]
fn a_frame_of_another_size_fails_with_both_sizes() {
    let album = empty_album("size");
    album.renew("sample", &sample(6, 4));
    let taller = Frame { width: 6, height: 5, pixels: [sample(6, 4).pixels, vec![0; 6]].concat() };
    let said = album.compare("sample", &taller).unwrap_err();
    assert!(said.contains("is not what is drawn now (6x4, now 6x5): 6 pixels differ, by 255 levels"), "{said}");
    let shown = read(&album.differences.join("sample.png")).unwrap();
    assert_eq!((shown.width, shown.height), (18, 5));
    assert_eq!(shown.pixels[4 * 18..][..18], [[0; 6], [0xff_ffff; 6], [0; 6]].concat());
}

#[test]
fn a_golden_frame_that_is_missing_or_damaged_says_how_it_is_made() {
    let album = empty_album("missing");
    let said = album.compare("sample", &sample(3, 3)).unwrap_err();
    assert!(said.contains("sample.png is missing: ") && said.contains(BLESS), "{said}");
    assert_eq!(read(&album.differences.join("sample.png")).unwrap(), sample(3, 3), "there it can be looked at");
    fs::create_dir_all(&album.golden).unwrap();
    fs::write(album.file("sample"), "no picture").unwrap();
    let said = album.compare("sample", &sample(3, 3)).unwrap_err();
    assert!(said.contains("sample.png is damaged") && said.contains(BLESS), "{said}");
}
