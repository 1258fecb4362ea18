//! The race is fair only if every method draws the same picture.

use shadow_race::{Method, RaceRenderer, SIDE, Threads, circles};
use tracer::{Frame, SimdLevel};

/// Moments and sizes: with whole blocks of 16 pixels and without, narrower than one, and a single pixel.
const PICTURES: [(f64, usize, usize); 8] = [
    (0.0, 256, 256),
    (1.3, 211, 97),
    (7.9, 320, 180),
    (30.0, 64, 300),
    (2.2, 1920, 1080),
    (4.1, 7, 400),
    (0.6, 1000, 1),
    (0.0, 1, 1),
];

/// A picture, made where another one was.
fn frame(
    renderer: &mut RaceRenderer,
    method: Method,
    threads: Threads,
    (seconds, width, height): (f64, usize, usize),
) -> Frame {
    let mut frame = Frame::new(width, height);
    frame.pixels.fill(0xff_00ff);
    renderer.render(method, threads, seconds, &mut frame);
    frame
}

/// To one 8-bit level, every byte: where an edge of a shadow passes within rounding of a pixel's middle, the fast
/// methods ask as the literal loops do.
#[test]
fn every_method_draws_the_same_picture() {
    let moments = (0..40).map(|moment| (f64::from(moment) * 0.731, 640, 480));
    for picture in PICTURES.into_iter().chain(moments) {
        let expected = frame(&mut RaceRenderer::default(), Method::Literal, Threads::One, picture).to_rgb8();
        for method in [Method::Simd, Method::Spans] {
            let got = frame(&mut RaceRenderer::default(), method, Threads::One, picture).to_rgb8();
            let other = expected.iter().zip(&got).filter(|(a, b)| a.abs_diff(**b) > 1).count();
            assert!(other == 0, "{} at {picture:?}: {other} bytes differ", method.name());
        }
    }
}

#[test]
fn every_instruction_set_and_number_of_threads_gives_the_same_bits() {
    for method in Method::ALL {
        for picture in PICTURES {
            let expected = frame(&mut RaceRenderer::default(), method, Threads::One, picture);
            for level in SimdLevel::available() {
                for count in [1, 2, 3, 5] {
                    let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().expect("a pool");
                    let got = pool.install(|| frame(&mut RaceRenderer::on(level), method, Threads::All, picture));
                    assert!(got == expected, "{} at {picture:?} on {}, {count} threads", method.name(), level.name());
                }
                assert!(
                    frame(&mut RaceRenderer::on(level), method, Threads::One, picture) == expected,
                    "{}",
                    level.name()
                );
            }
        }
    }
}

/// Nothing of a wider, narrower or earlier picture is left.
#[test]
fn one_renderer_makes_pictures_of_any_size_in_turn() {
    let mut renderer = RaceRenderer::default();
    for picture in PICTURES {
        let expected = frame(&mut RaceRenderer::default(), Method::Spans, Threads::One, picture);
        assert!(frame(&mut renderer, Method::Spans, Threads::One, picture) == expected, "{picture:?}");
    }
    for (width, height) in [(0, 0), (0, 5), (5, 0)] {
        for threads in [Threads::One, Threads::All] {
            assert_eq!(frame(&mut renderer, Method::Spans, threads, (0.0, width, height)).pixels, [0u32; 0]);
        }
    }
}

#[test]
fn circles_stay_within_the_walls_and_apart() {
    for tenth in 0..200 {
        let circles = circles(f64::from(tenth) * 0.1);
        for (at, circle) in circles.iter().enumerate() {
            let box_ = circle.bounds();
            assert!(box_.min.min_element() > 0.0 && box_.max.max_element() < SIDE);
            for other in &circles[at + 1..] {
                assert!(circle.center.distance(other.center) > 2.0);
            }
        }
    }
}
