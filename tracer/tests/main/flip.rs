//! FLIP on pictures whose difference is known.

use tracer::{Frame, flip};

fn plain(color: u32) -> Frame {
    Frame { width: 48, height: 40, pixels: vec![color; 48 * 40] }
}

fn painted(paint: impl Fn(usize, usize) -> u32) -> Frame {
    let mut frame = plain(0);
    for (at, pixel) in frame.pixels.iter_mut().enumerate() {
        *pixel = paint(at % 48, at / 48);
    }
    frame
}

/// A grey picture with some structure, moved to the right.
fn checks(shift: usize) -> Frame {
    painted(|x, y| if ((x + 48 - shift) / 6 + y / 5).is_multiple_of(2) { 0x40_4040 } else { 0xa0_a0a0 })
}

#[test]
fn a_picture_does_not_differ_from_itself() {
    assert_eq!(flip::mean(&checks(0), &checks(0)), 0.0);
}

/// By hand: L* is 0 and 100, so the difference is 100^0.7 = 25.12; the largest, from green to blue, is 203.3^0.7 = 41.3,
/// and the knee is at 16.5: 0.95 + 0.05 * (25.12 - 16.5) / (41.3 - 16.5) = 0.967. There is no edge.
#[test]
fn black_and_white_are_nearly_as_different_as_can_be() {
    let difference = flip::mean(&plain(0), &plain(0xff_ffff));
    assert!((difference - 0.967).abs() < 1e-3, "{difference}");
    let most = flip::mean(&plain(0x00_ff00), &plain(0x00_00ff));
    assert!((most - 1.0).abs() < 1e-6, "{most}");
}

#[test]
fn it_does_not_matter_which_picture_is_the_first() {
    let (one, other) = (checks(0), painted(|x, y| (x * 5) as u32 * 0x1_0100 + y as u32 * 6));
    let (there, back) = (flip::map(&one, &other, 67.0), flip::map(&other, &one, 67.0));
    assert!(there.iter().zip(&back).all(|(a, b)| (a - b).abs() < 1e-12));
    assert!(there.iter().all(|difference| (0.0..=1.0).contains(difference)));
}

#[test]
fn a_picture_that_moves_differs_more_the_farther_it_goes() {
    let [one, two, three] = [1, 2, 3].map(|shift| flip::mean(&checks(0), &checks(shift)));
    assert!(0.02 < one && one < two && two < three, "{one} {two} {three}");
}

#[test]
fn one_level_of_a_screen_is_hardly_seen_and_detail_is_lost_far_away() {
    assert!(flip::mean(&plain(0x80_8080), &plain(0x81_8181)) < 0.05);
    let fine = painted(|x, y| if (x + y).is_multiple_of(2) { 0 } else { 0xff_ffff });
    let other = painted(|x, y| if (x + y).is_multiple_of(2) { 0xff_ffff } else { 0 });
    let [near, far] = [8.0, 300.0].map(|density| flip::map(&fine, &other, density).iter().sum::<f64>() / 1920.0);
    assert!(near > 0.8 && far < 0.3, "{near} near, {far} far away");
}
