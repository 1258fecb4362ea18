//! The film of transport: what light leaves in each pixel, summed up as whole numbers.
//!
//! A path segment leaves `power * chord / area` in every pixel that it crosses: exactly the mean of the fluence over the pixel.
//! Whole numbers add up to the same sum in any order, so a picture has the same bytes on any number of threads.

use crate::View;
use geometry::DVec2;

/// Bits behind the point in the sums of packets: each is about 1, and there may be 10^11 in a pixel.
pub const PACKET_BITS: u32 = 24;

/// Bits behind the point in the sums of beams: all of them together are about 1, and each may be 10^-8.
pub const BEAM_BITS: u32 = 48;

/// The sums of a picture's pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SplatFilm {
    width: usize,
    height: usize,
    /// What a unit is in the sums.
    bits: u32,
    /// Red, green, blue: signed, since single wavelengths are outside a screen's gamut.
    sums: Vec<[i64; 3]>,
}

/// A way across the picture, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSegment {
    /// Where it begins, pixels from the upper left corner.
    pub from: DVec2,
    /// Where it ends.
    pub to: DVec2,
}

impl SplatFilm {
    /// A black film of this view's pixels, whose sums have so many bits behind the point.
    pub fn new(view: &View, bits: u32) -> SplatFilm {
        SplatFilm { width: view.width, height: view.height, bits, sums: vec![[0; 3]; view.width * view.height] }
    }

    /// Adds light of one colour along a way.
    pub fn splat(&mut self, segment: &PixelSegment, color: [f32; 3]) {
        let unit = self.unit();
        let color = color.map(|channel| f64::from(channel) * unit);
        let (width, height) = (self.width, self.height);
        cross(segment, width, height, |pixel, chord, _| {
            let sums = &mut self.sums[pixel];
            (0..3).for_each(|channel| sums[channel] += (chord * color[channel]) as i64);
        });
    }

    /// The same, where the colour changes on the way: `color` is asked for the pixels from `from`.
    pub fn splat_varying(&mut self, segment: &PixelSegment, color: impl Fn(f64) -> [f32; 3]) {
        let (width, height, unit) = (self.width, self.height, self.unit());
        cross(segment, width, height, |pixel, chord, middle| {
            let color = color(middle);
            let sums = &mut self.sums[pixel];
            (0..3).for_each(|channel| sums[channel] += (chord * f64::from(color[channel]) * unit) as i64);
        });
    }

    /// Adds light to a pixel.
    pub fn deposit(&mut self, x: usize, y: usize, light: [f64; 3]) {
        let unit = self.unit();
        let sums = &mut self.sums[y * self.width + x];
        (0..3).for_each(|channel| sums[channel] += (light[channel] * unit) as i64);
    }

    /// Adds what another film of the same size holds.
    pub fn add(&mut self, other: &SplatFilm) {
        for (sums, more) in self.sums.iter_mut().zip(&other.sums) {
            (0..3).for_each(|channel| sums[channel] += more[channel]);
        }
    }

    /// The light of a pixel, a unit of colour over a pixel's side being `scale`.
    pub fn pixel(&self, x: usize, y: usize, scale: f64) -> [f64; 3] {
        self.sums[y * self.width + x].map(|sum| sum as f64 / self.unit() * scale)
    }

    fn unit(&self) -> f64 {
        (1_u64 << self.bits) as f64
    }

    /// Pixels across.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Pixels down.
    pub fn height(&self) -> usize {
        self.height
    }
}

/// Shows `visit` each pixel that the way crosses, the length of its chord and how far from the start its middle is, in pixels:
/// J. Amanatides and A. Woo, "A fast voxel traversal algorithm for ray tracing", Eurographics 1987.
pub(super) fn cross(segment: &PixelSegment, width: usize, height: usize, mut visit: impl FnMut(usize, f64, f64)) {
    let way = segment.to - segment.from;
    let length = way.length();
    if !(length > 0.0 && length.is_finite()) {
        return;
    }
    let direction = way / length;
    let size = DVec2::new(width as f64, height as f64);
    let Some([begin, end]) = clip(segment.from, direction, length, size) else { return };
    let start = segment.from + direction * begin;
    let [mut x, mut y] = [0, 1].map(|axis| (start[axis].floor() as i64).clamp(0, size[axis] as i64 - 1));
    let step = [0, 1].map(|axis| if direction[axis] < 0.0 { -1 } else { 1 });
    // The distance at which the next line of each axis is crossed, and from one to the next.
    let per_pixel = [0, 1].map(|axis| 1.0 / direction[axis].abs());
    let mut next = [(0, x), (1, y)].map(|(axis, cell)| {
        let line = if step[axis] > 0 { cell + 1 } else { cell } as f64;
        // A way along the lines never crosses one: infinity, or no number where it starts on one.
        let to_line = (line - segment.from[axis]) / direction[axis];
        if to_line.is_nan() { f64::INFINITY } else { to_line }
    });
    let mut at = begin;
    loop {
        let axis = usize::from(next[1] < next[0]);
        let leaves = next[axis].min(end);
        if leaves > at {
            visit(y as usize * width + x as usize, leaves - at, 0.5 * (leaves + at));
            at = leaves;
        }
        if next[axis] >= end {
            return;
        }
        next[axis] += per_pixel[axis];
        let cell = if axis == 0 { &mut x } else { &mut y };
        *cell += step[axis];
        if *cell < 0 || *cell >= size[axis] as i64 {
            return;
        }
    }
}

/// Where the way is within the picture, from and to, pixels from its start.
fn clip(from: DVec2, direction: DVec2, length: f64, size: DVec2) -> Option<[f64; 2]> {
    let (mut begin, mut end) = (0.0_f64, length);
    for axis in 0..2 {
        let (start, along) = (from[axis], direction[axis]);
        if along == 0.0 {
            if !(0.0..=size[axis]).contains(&start) {
                return None;
            }
            continue;
        }
        let (low, high) = (-start / along, (size[axis] - start) / along);
        begin = begin.max(low.min(high));
        end = end.min(low.max(high));
    }
    (begin < end).then_some([begin, end])
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::rng::SplitMix64;

    fn view() -> View {
        View { width: 40, height: 30, origin_mm: DVec2::ZERO, mm_per_px: 1.0 }
    }

    /// The chords of a way add up to its length within the picture, and each lies in its pixel.
    #[test]
    fn chords_add_up_to_the_way_within_the_picture() {
        let mut random = SplitMix64::new(4);
        let size = DVec2::new(40.0, 30.0);
        for turn in 0..20_000 {
            let mut point = || DVec2::new(random.uniform(-20.0, 60.0), random.uniform(-20.0, 50.0));
            let (mut from, mut to) = (point(), point());
            match turn % 5 {
                0 => to.y = from.y,
                1 => (from.x, to.x) = (from.x.round(), from.x.round()),
                2 => (from, to) = (from.round(), to.round()),
                _ => {}
            }
            let (length, direction) = (from.distance(to), (to - from).normalize_or_zero());
            let expected = clip(from, direction, length, size).map_or(0.0, |[begin, end]| end - begin);
            let mut sum = 0.0;
            cross(&PixelSegment { from, to }, 40, 30, |pixel, chord, middle| {
                sum += chord;
                let at = from + direction * middle;
                let cell = DVec2::new((pixel % 40) as f64, (pixel / 40) as f64);
                let slack = 1e-9;
                assert!(at.cmpge(cell - slack).all() && at.cmple(cell + 1.0 + slack).all(), "{from} {to}");
                assert!(chord <= std::f64::consts::SQRT_2 + 1e-9);
            });
            assert!((sum - expected).abs() < 1e-7, "{from} {to}: {sum} {expected}");
        }
    }

    #[test]
    fn films_add_up_in_any_order() {
        let segments = [[1.0, 2.0, 30.0, 20.0], [35.0, -4.0, 2.0, 29.0], [0.0, 15.5, 40.0, 15.5]];
        let films = segments.map(|[a, b, c, d]| {
            let mut film = SplatFilm::new(&view(), PACKET_BITS);
            film.splat(&PixelSegment { from: DVec2::new(a, b), to: DVec2::new(c, d) }, [0.3, -0.1, 1e-3]);
            film
        });
        let sum = |order: [usize; 3]| {
            let mut film = SplatFilm::new(&view(), PACKET_BITS);
            order.iter().for_each(|at| film.add(&films[*at]));
            film
        };
        assert_eq!(sum([0, 1, 2]), sum([2, 0, 1]));
        assert!((sum([0, 1, 2]).pixel(20, 15, 2.0)[0] - 0.6).abs() < 0.7);
    }
}
