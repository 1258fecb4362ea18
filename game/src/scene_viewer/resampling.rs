//! Resampling: a picture of another view or of fewer pixels, until the one that is asked for is there.

use crate::rendering::Picture;
use tracer::{Frame, View};

/// A frame that shows `from`, as it looks in `to`: the nearest pixel of each; `beside` where it shows nothing.
pub fn frame_in_view(frame: &Frame, from: &View, to: &View, beside: u32) -> Vec<u32> {
    let column = |x: usize| from.screen_from_table(to.table_from_pixel(x, 0)).x.floor();
    let row = |y: usize| from.screen_from_table(to.table_from_pixel(0, y)).y.floor();
    let within = |place: f64, count: usize| (place >= 0.0 && place < count as f64).then_some(place as usize);
    let columns: Vec<Option<usize>> = (0..to.width).map(|x| within(column(x), frame.width)).collect();
    let mut pixels = Vec::with_capacity(to.width * to.height);
    for y in 0..to.height {
        match within(row(y), frame.height) {
            Some(row) => {
                let row = &frame.pixels[row * frame.width..][..frame.width];
                pixels.extend(columns.iter().map(|column| column.map_or(beside, |column| row[column])));
            }
            None => pixels.resize(pixels.len() + to.width, beside),
        }
    }
    pixels
}

/// A picture of [`View::halved`] in all pixels of the view, bilinear: pixel middles lie a quarter of a large pixel beside its middle.
pub fn doubled(half: &Picture, width: usize, height: usize) -> Picture {
    let near = |at: usize, count: usize| {
        let (own, other) = (at / 2, if at.is_multiple_of(2) { (at / 2).saturating_sub(1) } else { at / 2 + 1 });
        [own, other.min(count - 1)]
    };
    let mut pixels = Vec::with_capacity(width * height);
    for y in 0..height {
        let rows = near(y, half.height).map(|row| &half.pixels[row * half.width..][..half.width]);
        for x in 0..width {
            let [own, other] = near(x, half.width);
            let across = |row: &[[f32; 3]], channel: usize| 0.75 * row[own][channel] + 0.25 * row[other][channel];
            pixels
                .push(std::array::from_fn(|channel| 0.75 * across(rows[0], channel) + 0.25 * across(rows[1], channel)));
        }
    }
    Picture { width, height, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::DVec2;

    /// What is under the mouse stays under it while the new picture is being made.
    #[test]
    fn a_frame_is_seen_from_another_view() {
        let frame = Frame { width: 4, height: 2, pixels: (1..=8).collect() };
        let from = View { width: 4, height: 2, origin_mm: DVec2::ZERO, mm_per_px: 1.0 };
        assert_eq!(frame_in_view(&frame, &from, &from, 0), frame.pixels);
        let nearer = View { origin_mm: DVec2::new(1.0, 0.0), mm_per_px: 0.5, ..from };
        assert_eq!(frame_in_view(&frame, &from, &nearer, 0), [2, 2, 3, 3, 2, 2, 3, 3]);
        let beside = View { origin_mm: DVec2::new(3.0, -1.0), ..from };
        assert_eq!(frame_in_view(&frame, &from, &beside, 9), [9, 9, 9, 9, 4, 9, 9, 9]);
    }

    #[test]
    fn a_ramp_that_is_doubled_is_that_ramp() {
        let light = |x: usize| [x as f32, 2.0, 0.5];
        let half = Picture { width: 4, height: 3, pixels: (0..12).map(|at| light(at % 4)).collect() };
        let whole = doubled(&half, 7, 5);
        assert_eq!(whole.pixels.len(), 35);
        for x in 1..6 {
            // The middle of pixel x is at x / 2 - 1/4 of large pixels.
            assert_eq!(whole.pixels[14 + x], [x as f32 * 0.5 - 0.25, 2.0, 0.5]);
        }
    }
}
