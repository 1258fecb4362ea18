//! Heights above the floor's level, one for each pixel of a view.
//!
//! Refuses to know what made them.

use rayon::prelude::*;

/// Heights, mm, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Heights {
    width: usize,
    mm: Vec<f32>,
}

impl Heights {
    /// The heights that `of` gives for the pixel x, y.
    pub fn new(width: usize, height: usize, of: impl Fn(usize, usize) -> f32 + Sync) -> Heights {
        let mut mm = vec![0.0; width * height];
        let rows = mm.par_chunks_mut(width.max(1)).enumerate();
        rows.for_each(|(y, row)| row.iter_mut().enumerate().for_each(|(x, height)| *height = of(x, y)));
        Heights { width, mm }
    }

    /// The height of a pixel; beyond the edge it goes on as at the edge.
    pub fn at(&self, x: isize, y: isize) -> f32 {
        let last = (self.mm.len() / self.width) as isize - 1;
        let (x, y) = (x.clamp(0, self.width as isize - 1), y.clamp(0, last));
        self.mm[y as usize * self.width + x as usize]
    }

    /// The heights of a pixel and what stands on it, of the same view.
    pub fn plus(&self, other: &Heights) -> Heights {
        Heights { width: self.width, mm: self.mm.iter().zip(&other.mm).map(|(a, b)| a + b).collect() }
    }

    /// How the height changes along x and along y, mm a mm, by Sobel's operator: central differences, each the mean of
    /// three rows with the weights 1, 2, 1.
    pub fn slope(&self, x: usize, y: usize, mm_per_px: f64) -> [f32; 2] {
        let (x, y) = (x as isize, y as isize);
        let at = |i: isize, j: isize| self.at(x + i, y + j);
        let across = at(1, -1) - at(-1, -1) + 2.0 * (at(1, 0) - at(-1, 0)) + at(1, 1) - at(-1, 1);
        let down = at(-1, 1) - at(-1, -1) + 2.0 * (at(0, 1) - at(0, -1)) + at(1, 1) - at(1, -1);
        let per_mm = 1.0 / (8.0 * mm_per_px as f32);
        [across * per_mm, down * per_mm]
    }

    /// The heights blurred by a Gaussian of this standard deviation, px; under a fifth of a pixel nothing changes.
    pub fn blurred(&self, deviation_px: f64) -> Heights {
        if deviation_px < 0.2 { self.clone() } else { self.drawn_to(&gaussian(deviation_px), f32::INFINITY) }
    }

    /// The smoothest heights that a raster of steps of `step` may stand for: every height may move by half a step, and
    /// becomes the mean of its neighbours as far as that lets it, near neighbours after far ones. A slope that was cut
    /// into terraces is whole again. An edge stays where it is: what bends by more than rounding can is no terrace.
    pub fn without_terraces(&self, step: f32) -> Heights {
        let mut smooth = self.clone();
        for far in [16, 8, 4, 2, 1, 8, 4, 2, 1] {
            smooth = smooth.drawn_to(&[(far, 0.25)], 2.5 * step);
            let heights = smooth.mm.par_chunks_mut(self.width).zip(self.mm.par_chunks(self.width));
            heights.for_each(|(row, given)| {
                for (height, given) in row.iter_mut().zip(given) {
                    *height = height.clamp(given - 0.5 * step, given + 0.5 * step);
                }
            });
        }
        smooth
    }

    /// Draws each height, along x and then along y, to those that are an offset away on either side, with each offset's
    /// weight, unless they bend from it by more than `limit`.
    fn drawn_to(&self, offsets: &[(usize, f32)], limit: f32) -> Heights {
        let (width, last) = (self.width, self.mm.len() / self.width - 1);
        let reach = offsets.iter().map(|&(offset, _)| offset).max().unwrap_or(0);
        let mut across = self.mm.clone();
        across.par_chunks_mut(width).zip(self.mm.par_chunks(width)).for_each(|(out, row)| {
            // The row goes on beyond its ends, so that no place in it is special.
            let padded = [vec![row[0]; reach], row.to_vec(), vec![row[width - 1]; reach]].concat();
            for &(offset, weight) in offsets {
                draw(out, row, [&padded[reach - offset..], &padded[reach + offset..]], weight, limit);
            }
        });
        let row = |y: usize| &across[y * width..(y + 1) * width];
        let mut mm = across.clone();
        mm.par_chunks_mut(width).enumerate().for_each(|(y, out)| {
            for &(offset, weight) in offsets {
                draw(out, row(y), [row(y.saturating_sub(offset)), row((y + offset).min(last))], weight, limit);
            }
        });
        Heights { width, mm }
    }
}

/// Adds to `out` how far each pair of neighbours is from the height between them.
fn draw(out: &mut [f32], row: &[f32], [before, after]: [&[f32]; 2], weight: f32, limit: f32) {
    for (((out, height), before), after) in out.iter_mut().zip(row).zip(before).zip(after) {
        let bend = before + after - 2.0 * height;
        *out += if bend.abs() <= limit { weight * bend } else { 0.0 };
    }
}

/// The weights of the pairs of neighbours, so that with the middle's own they add up to 1.
fn gaussian(deviation_px: f64) -> Vec<(usize, f32)> {
    let reach = (3.0 * deviation_px).ceil().min(64.0) as usize;
    let weight = |offset: usize| libm::exp(-0.5 * (offset as f64 / deviation_px).powi(2));
    let whole: f64 = 1.0 + 2.0 * (1..=reach).map(weight).sum::<f64>();
    (1..=reach).map(|offset| (offset, (weight(offset) / whole) as f32)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_has_its_slope_everywhere_inside() {
        let plane = Heights::new(20, 20, |x, y| 0.25 * x as f32 - 0.125 * y as f32);
        for (x, y) in [(1, 1), (10, 7), (18, 18)] {
            assert_eq!(plane.slope(x, y, 0.5), [0.5, -0.25]);
        }
    }

    #[test]
    fn a_blur_keeps_the_volume_and_has_its_deviation() {
        let spike = Heights::new(81, 81, |x, y| if (x, y) == (40, 40) { 1.0 } else { 0.0 });
        let soft = spike.blurred(4.0);
        let (mut volume, mut variance) = (0.0, 0.0);
        for y in 0..81 {
            for x in 0..81 {
                let height = f64::from(soft.at(x, y));
                volume += height;
                variance += height * ((x - 40) * (x - 40)) as f64;
            }
        }
        assert!((volume - 1.0).abs() < 1e-5 && (variance.sqrt() - 4.0).abs() < 0.1, "{volume} {variance}");
        assert_eq!(spike.blurred(0.1), spike);
    }

    /// Eight-bit grey cut a long soft slope into flat steps, and every step was seen as a line.
    #[test]
    fn terraces_become_a_slope_and_edges_stay() {
        // One step in 16 px, and a wall of 50 steps at 200.
        let true_height = |x: usize| x as f32 / 16.0 + if x >= 200 { 50.0 } else { 0.0 };
        let steps = Heights::new(400, 9, |x, _| true_height(x).round());
        let smooth = steps.without_terraces(1.0);
        let worst = |heights: &Heights| {
            let inside = (64..190).chain(212..340);
            inside.map(|x| (heights.slope(x, 4, 1.0)[0] * 16.0 - 1.0).abs()).fold(0.0, f32::max)
        };
        assert!(worst(&steps) > 6.0, "the steps are steep: {}", worst(&steps));
        assert!(worst(&smooth) < 0.35, "a slope is left: {}", worst(&smooth));
        for x in 0..400 {
            assert!((smooth.at(x as isize, 4) - true_height(x).round()).abs() <= 0.5);
        }
    }
}
