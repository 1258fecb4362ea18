//! The race is fair only if everybody draws the same picture.

use tracer::Frame;
use tracer::room::{Method, Room, SIDE, circles};

fn frame(method: Method, seconds: f64, width: usize, height: usize) -> Frame {
    let mut frame = Frame::default();
    Room::default().render(method, seconds, width, height, &mut frame);
    frame
}

/// To one 8-bit level; but where an edge of a shadow passes within rounding of a pixel's middle, the ways may take
/// different sides, so one pixel in five thousand may differ.
#[test]
fn every_method_draws_the_same_picture() {
    for (seconds, width, height) in [(0.0, 256, 256), (1.3, 211, 97), (7.9, 320, 180), (30.0, 64, 300)] {
        let expected = frame(Method::Literal, seconds, width, height).to_rgb8();
        for method in Method::ALL {
            if method == Method::Fill {
                continue;
            }
            let got = frame(method, seconds, width, height).to_rgb8();
            let other = expected.iter().zip(&got).filter(|(a, b)| a.abs_diff(**b) > 1).count();
            assert!(other <= expected.len() / 5000, "{} at {seconds}: {other} bytes differ", method.name());
        }
    }
}

#[test]
fn circles_stay_in_the_room_and_apart() {
    for tenth in 0..200 {
        let circles = circles(f64::from(tenth) * 0.1);
        for (at, circle) in circles.iter().enumerate() {
            let box_ = circle.bounds();
            assert!(box_.min.min_element() >= 0.0 && box_.max.max_element() <= SIDE);
            for other in &circles[at + 1..] {
                assert!(circle.center.distance(other.center) > 2.0);
            }
        }
    }
}
