//! How the cost of a frame grows: pixels, lamps, occluders and balls, on the generated table.
//!
//! Each scene is drawn as a window would draw it, light and tone map in one go, in four states: with nothing new, with
//! every lamp flashing, with every lamp flashing and every ball rolling, and from nothing.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::Failure;
use crate::commands::parallel;
use crate::screen::Size;
use geometry::DVec2;
use rayon::ThreadPool;
use tracer::scenes::{self, Props};
use tracer::{DisplayBuffer, Renderer, Rgb, Scene, View};

/// The size that figures are quoted at.
const SIZE: Size = Size { width: 540, height: 1080 };

/// Frames of a state that are timed, after [`WARM_UP`] of it.
const FRAMES: usize = 15;

/// Frames of a state before the first that is timed.
const WARM_UP: usize = 2;

/// How far a ball rolls from one frame to the next, mm; to and fro, so that it stays where it was put.
const STEP_MM: DVec2 = DVec2::new(1.5, -2.0);

/// What is new in each frame of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Still,
    Flash,
    FlashAndRoll,
    FromNothing,
}

impl State {
    const ALL: [State; 4] = [State::Still, State::Flash, State::FlashAndRoll, State::FromNothing];

    fn name(self) -> &'static str {
        match self {
            State::Still => "still",
            State::Flash => "lamps flash",
            State::FlashAndRoll => "lamps flash, balls roll",
            State::FromNothing => "from nothing",
        }
    }
}

/// What a scene has more or less of than the generated table.
type Change = fn(&mut Scene);

/// Scenes of the size that is asked for, by what they have in them.
const SCENES: [(&str, Change); 9] = [
    ("4 lamps", |scene| scenes::with_lamps(scene, 4)),
    ("16 lamps", |scene| scenes::with_lamps(scene, 16)),
    ("64 lamps", |scene| scenes::with_lamps(scene, 64)),
    ("0 more posts", |scene| scenes::with_posts(scene, 0)),
    ("100 more posts", |scene| scenes::with_posts(scene, 100)),
    ("400 more posts", |scene| scenes::with_posts(scene, 400)),
    ("0 balls", |scene| scenes::with_balls(scene, 0)),
    ("3 balls", |scene| scenes::with_balls(scene, 3)),
    ("12 balls", |scene| scenes::with_balls(scene, 12)),
];

/// Times every scene in every state.
///
/// # Errors
/// If the system gives no threads.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let pool = parallel::pool(threads)?;
    let size = size.unwrap_or(SIZE);
    let mut rows = Vec::new();
    for size in sizes(size) {
        let props = scenes::props(&view(size));
        rows.extend(states("the table", size, &props, |_| {}, &pool));
    }
    let props = scenes::props(&view(size));
    for (name, change) in SCENES {
        rows.extend(states(name, size, &props, change, &pool));
    }
    Ok(rows)
}

/// A quarter as many pixels, as many, and four times as many where a frame may be so large.
fn sizes(size: Size) -> impl Iterator<Item = Size> {
    let scaled = move |by: usize| Size { width: size.width * by / 2, height: size.height * by / 2 };
    [1, 2, 4].into_iter().map(scaled).filter(|size| size.is_drawable())
}

fn view(size: Size) -> View {
    View::fit(size.width, size.height, scenes::SIZE_MM)
}

/// A row for each state of a scene.
fn states(name: &str, size: Size, props: &Props, change: Change, pool: &ThreadPool) -> Vec<Row> {
    let mut scene = scenes::table(view(size), props);
    change(&mut scene);
    let (mut renderer, mut display) = (Renderer::new(), DisplayBuffer::default());
    let row = |state: State| {
        let ms = pool.install(|| median_ms(&mut scene, state, &mut renderer, &mut display));
        Row {
            bench: "growth",
            variant: format!("{name}, {}", state.name()),
            size: Some(format!("{}x{}", size.width, size.height)),
            threads: pool.current_num_threads(),
            ms,
            ns_per_pixel: Some(ms * 1e6 / (size.width * size.height) as f64),
            ..Row::default()
        }
    };
    State::ALL.into_iter().map(row).collect()
}

/// Draws frames of a scene in one state, the first ones to warm up.
fn median_ms(scene: &mut Scene, state: State, renderer: &mut Renderer, display: &mut DisplayBuffer) -> f64 {
    let colors: Vec<Rgb> = scene.lamps.iter().map(|lamp| lamp.color).collect();
    let mut times_ms = Vec::new();
    for frame in 0..WARM_UP + FRAMES {
        match state {
            State::Still => {}
            State::Flash => flash(scene, &colors, frame),
            State::FlashAndRoll => {
                flash(scene, &colors, frame);
                scenes::roll(scene, if frame.is_multiple_of(2) { STEP_MM } else { -STEP_MM });
            }
            State::FromNothing => renderer.invalidate(),
        }
        let ms = time_ms(|| renderer.draw(scene, 1.0, display));
        if frame >= WARM_UP {
            times_ms.push(ms);
        }
    }
    scene.lamps.iter_mut().zip(colors).for_each(|(lamp, color)| lamp.color = color);
    quantile(&mut times_ms, 0.5)
}

/// Makes every lamp as bright as it is not in the frames before and after, each in a rhythm of its own.
fn flash(scene: &mut Scene, colors: &[Rgb], frame: usize) {
    for (lamp, (light, color)) in scene.lamps.iter_mut().zip(colors).enumerate() {
        let level = 0.25 + ((frame * 97 + lamp * 331) % 750) as f32 * 1e-3;
        light.color = color.map(|channel| channel * level);
    }
}
