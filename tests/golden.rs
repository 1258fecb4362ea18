//! Golden frames: pictures in `tests/golden` that the program must draw again, pixel for pixel.
//!
//! A frame that differs fails with the number of pixels that differ and by how much at most, and writes
//! `expected | difference | actual` as one PNG file to `target/golden`. When a picture is meant to be another, look at it
//! there, then renew all of them and commit what has changed:
//!
//!     CAUSTIC_BLESS=1 cargo test -p game --test system golden
//!
//! Debug and release builds, any number of threads and every instruction set give these bytes. The generated table and
//! the room are claimed everywhere: their light is made of + - * / sqrt and of `libm`. The drawn table's art and letters
//! go through resvg, which computes in f32 with the platform's own sine and with SIMD that differs between processor
//! families, so those frames are claimed on x86-64 only, and not compared elsewhere.

mod album;

use album::Album;
use game::Table;
use game::frame_composer::{FrameComposer, Interpolation};
use game::hud::UiState;
use game::recording::Replay;
use game::screen::Size;
use game::storage::recordings;
use shadow_race::{Method, RaceRenderer, Threads};
use std::path::Path;
use tracer::scenes::{self, Props};
use tracer::{DisplayBuffer, Frame, Renderer, View};

/// The size of the frames of the drawn table, in pixels.
const SIZE: Size = Size { width: 216, height: 432 };

#[cfg_attr(not(target_arch = "x86_64"), ignore = "art is the same to the bit on x86-64 only")]
#[test]
fn golden_frames_of_a_game_of_the_bot() {
    compare(&played("bot-2", &[5, 20, 44]));
}

#[cfg_attr(not(target_arch = "x86_64"), ignore = "art is the same to the bit on x86-64 only")]
#[test]
fn golden_frame_of_a_game_of_three_players() {
    compare(&played("tour-1", &[90]));
}

#[cfg_attr(not(target_arch = "x86_64"), ignore = "art is the same to the bit on x86-64 only")]
#[test]
fn golden_frame_of_a_ball_on_the_ramp() {
    compare(&[("on-the-ramp".to_string(), on_the_ramp())]);
}

#[test]
fn golden_frame_of_the_generated_table() {
    let view = View::fit(150, 300, scenes::SIZE_MM);
    let props = quilted(scenes::props(&view));
    let mut display = DisplayBuffer::default();
    Renderer::new().draw(&scenes::table(view, &props), 1.0, &mut display);
    compare(&[("generated-table".to_string(), display.frame().clone())]);
}

#[test]
fn golden_frame_of_the_room() {
    let mut frame = Frame::new(128, 128);
    RaceRenderer::default().render(Method::Spans, Threads::All, 1.3, &mut frame);
    compare(&[("room".to_string(), frame)]);
}

/// A floor of lacquered pillows, 12 pixels wide, that leans every way up to 30 degrees.
fn quilted(mut props: Props) -> Props {
    let lean = |at: usize| (at % 12) as i8 * 8 - 44;
    let width = props.floor.width;
    props.floor.normals = (0..props.floor.floor.len()).map(|at| [lean(at % width), lean(at / width)]).collect();
    props.floor.gloss = 0.4;
    props
}

/// Frames of a demonstration after so many seconds, as `caustic frame --replay` draws them.
fn played(demo: &str, seconds: &[u64]) -> Vec<(String, Frame)> {
    let file = root().join("assets/demos").join(demo).with_extension("caustic");
    let mut replay = recordings::open(&file).unwrap();
    let mut composer = composer_of(&replay);
    let frame = |&second: &u64| {
        let tick = second * u64::from(physics::TICKS_PER_SECOND);
        replay.seek(tick);
        assert_eq!(replay.tick(), tick, "{} is shorter", file.display());
        let snapshot = replay.simulation().snapshot();
        let frame = composer.draw(Interpolation::at(&snapshot), SIZE, &UiState::default()).unwrap();
        (format!("{demo}-{second}s"), frame.clone())
    };
    seconds.iter().map(frame).collect()
}

/// The first frame of the demonstrations in which a ball is on the ramp.
fn on_the_ramp() -> Frame {
    for demo in 1..=5 {
        let file = root().join(format!("assets/demos/bot-{demo}.caustic"));
        let mut replay = recordings::open(&file).unwrap();
        let ramp = replay.simulation().table().part("ramp").expect("Spectrum has a ramp");
        while replay.step() {
            if replay.simulation().events().any(|event| event.part == Some(ramp)) {
                let snapshot = replay.simulation().snapshot();
                let mut composer = composer_of(&replay);
                return composer.draw(Interpolation::at(&snapshot), SIZE, &UiState::default()).unwrap().clone();
            }
        }
    }
    panic!("no ball comes to the ramp in the demonstrations: record others");
}

fn composer_of(replay: &Replay) -> FrameComposer {
    let table: &std::sync::Arc<Table> = replay.simulation().table();
    let pool = rayon::ThreadPoolBuilder::new().build().expect("threads");
    FrameComposer::new(table.clone(), pool).expect("a picture")
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace")
}

/// Compares frames with the project's golden ones of the same names; renews those instead if CAUSTIC_BLESS is 1.
fn compare(frames: &[(String, Frame)]) {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the target folder");
    let album = Album { golden: root().join("tests/golden"), differences: target.join("golden") };
    if std::env::var_os("CAUSTIC_BLESS").is_some_and(|value| value == "1") {
        frames.iter().for_each(|(name, frame)| album.renew(name, frame));
        return;
    }
    let wrong: Vec<String> = frames.iter().filter_map(|(name, frame)| album.compare(name, frame).err()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
