//! The examples: each renders, and shows what it says that it shows.

#[path = "../../examples/one_lamp.rs"]
#[expect(dead_code, reason = "an example's main is not run here: it would take the tests' command line for its own")]
mod one_lamp;
#[path = "../../examples/soft_shadow.rs"]
#[expect(dead_code, reason = "as above")]
mod soft_shadow;

use tracer::Frame;

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
