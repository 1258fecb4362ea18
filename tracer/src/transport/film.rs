//! The film of transport: what light leaves in each pixel, summed up as whole numbers.
//!
//! A path segment leaves `power * chord / area` in every pixel that it crosses: exactly the mean of the fluence over the pixel.
//! Whole numbers add up to the same sum in any order, so a picture has the same bytes on any number of threads.

use super::pixel_walk::{PixelSegment, PixelWalk};
use crate::View;
use crate::simd::dispatch::{SimdLevel, multiversion};

/// Bits behind the point in the sums of packets: each is about 1, and there may be 10^11 in a pixel.
pub const PACKET_BITS: u32 = 24;

/// Red, green, blue, and nothing: a register's four.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(align(32))]
struct Sums([i64; 4]);

/// Pixels of a block, each way: a way that goes down has them in the same page of memory, not each in another one.
const BLOCK: usize = 8;

/// The sums of a picture's pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SplatFilm {
    width: usize,
    height: usize,
    /// What a unit is in the sums.
    bits: u32,
    simd: SimdLevel,
    /// What a column, and what a row, adds to the place of its pixels' sums; and those of rows and columns from the other side.
    /// Two more than there are: the last one again.
    places: [[Vec<u32>; 2]; 2],
    /// Signed, since single wavelengths are outside a screen's gamut. Block by block.
    sums: Vec<Sums>,
}

impl SplatFilm {
    /// A black film of this view's pixels, whose sums have so many bits behind the point.
    pub fn new(view: &View, bits: u32) -> SplatFilm {
        let View { width, height, .. } = *view;
        let blocks = [width.div_ceil(BLOCK), height.div_ceil(BLOCK)];
        let place = |of: usize, block: usize, pixel: usize| (of / BLOCK * block + of % BLOCK * pixel) as u32;
        let places = |count: usize, block: usize, pixel: usize| {
            let ahead = |of: usize| place(of.min(count - 1), block, pixel);
            let back = |of: usize| place((count - 1).saturating_sub(of), block, pixel);
            [(0..count + 2).map(ahead).collect(), (0..count + 2).map(back).collect()]
        };
        let size = BLOCK * BLOCK;
        SplatFilm {
            width,
            height,
            bits,
            simd: SimdLevel::best(),
            places: [places(width, size, 1), places(height, size * blocks[0], BLOCK)],
            sums: vec![Sums::default(); blocks[0] * blocks[1] * size],
        }
    }

    /// The same film, whose inner loop runs at another SIMD level.
    pub fn with_simd(self, simd: SimdLevel) -> SplatFilm {
        SplatFilm { simd, ..self }
    }

    /// Adds light of one colour along a way.
    pub fn splat(&mut self, segment: &PixelSegment, color: [f32; 3]) {
        if let Some(walk) = self.walk(segment) {
            self.splat_walk(&walk, color);
        }
    }

    /// The walk of a way across the picture; `None` where it does not cross it.
    pub(super) fn walk(&self, segment: &PixelSegment) -> Option<PixelWalk> {
        PixelWalk::new(segment, self.width, self.height)
    }

    /// Adds light of one colour along a walk.
    pub(super) fn splat_walk(&mut self, walk: &PixelWalk, color: [f32; 3]) {
        let unit = self.unit();
        let [r, g, b] = color.map(|channel| f64::from(channel) * unit);
        if [r, g, b].iter().any(|channel| channel.abs() > MOST_ROUNDED) {
            return self.splat_varying_walk(walk, |_| color);
        }
        let [columns, rows] = self.of_walk(walk);
        let (columns, rows) = (&self.places[columns.0][columns.1], &self.places[rows.0][rows.1]);
        splat(self.simd, &mut self.sums, columns, rows, walk, &[r, g, b, 0.0]);
    }

    /// The same, where the colour changes on the way: `color` is asked for the pixels from `from`.
    pub fn splat_varying(&mut self, segment: &PixelSegment, color: impl Fn(f64) -> [f32; 3]) {
        if let Some(walk) = self.walk(segment) {
            self.splat_varying_walk(&walk, color);
        }
    }

    fn splat_varying_walk(&mut self, walk: &PixelWalk, color: impl Fn(f64) -> [f32; 3]) {
        let (unit, size) = (self.unit(), [self.width, self.height]);
        walk.visit(size, |[x, y], chord, middle| {
            let color = color(middle);
            let at = self.place(x, y);
            let sums = &mut self.sums[at].0;
            (0..3).for_each(|of| sums[of] += (chord * f64::from(color[of]) * unit) as i64);
        });
    }

    /// The tables of places of a walk's columns, and of the pixels in them: the axis, and whether from the other side.
    fn of_walk(&self, walk: &PixelWalk) -> [(usize, usize); 2] {
        [(walk.axis, 0), (1 - walk.axis, usize::from(walk.mirrored))]
    }

    /// Adds what another film of the same size holds.
    pub fn add(&mut self, other: &SplatFilm) {
        for (sums, more) in self.sums.iter_mut().zip(&other.sums) {
            (0..3).for_each(|channel| sums.0[channel] += more.0[channel]);
        }
    }

    /// The light of a pixel, a unit of colour over a pixel's side being `scale`.
    pub fn pixel(&self, x: usize, y: usize, scale: f64) -> [f64; 3] {
        let [r, g, b, _] = self.sums[self.place(x, y)].0;
        [r, g, b].map(|sum| sum as f64 / self.unit() * scale)
    }

    fn place(&self, x: usize, y: usize) -> usize {
        (self.places[0][0][x] + self.places[1][0][y]) as usize
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

/// 1.5 * 2^52: the sum with it has no room for a fraction, and the rounded number is in its lowest bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Numbers up to this one are rounded so, times a pixel's longest chord.
const MOST_ROUNDED: f64 = (1_u64 << 50) as f64;

multiversion! {
    fn splat(sums: &mut [Sums], columns: &[u32], rows: &[u32], walk: &PixelWalk, color: &[f64; 4]) = splat_body;
}

#[inline(always)]
fn splat_body(sums: &mut [Sums], columns: &[u32], rows: &[u32], walk: &PixelWalk, color: &[f64; 4]) {
    for column in walk.columns() {
        let at = columns[column.column];
        let [row, next] = column.rows;
        // Two pixels in any case: what is stored in one is not at once read again.
        let [before, behind] = column.chords;
        let chords = if row == next { [before + behind, 0.0] } else { column.chords };
        for (row, chord) in [row, row + 1].into_iter().zip(chords) {
            let Sums(sums) = &mut sums[(at + rows[row]) as usize];
            for lane in 0..4 {
                let rounded = (chord * color[lane] + ROUNDER).to_bits();
                sums[lane] += rounded as i64 - ROUNDER.to_bits() as i64;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::DVec2;
    use geometry::rng::SplitMix64;

    fn view() -> View {
        View { width: 43, height: 30, origin_mm: DVec2::ZERO, mm_per_px: 1.0 }
    }

    /// Random ways through and past the picture.
    fn ways() -> Vec<PixelSegment> {
        let mut random = SplitMix64::new(4);
        let mut point = || DVec2::new(random.uniform(-20.0, 60.0), random.uniform(-20.0, 50.0));
        (0..500).map(|_| PixelSegment { from: point(), to: point() }).collect()
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

    /// Every SIMD level leaves the same bits.
    #[test]
    fn films_are_the_same_at_every_simd_level() {
        let film = |simd: SimdLevel| {
            let mut film = SplatFilm::new(&view(), PACKET_BITS).with_simd(simd);
            ways().iter().for_each(|way| film.splat(way, [0.3, -0.1, 7.5]));
            film.with_simd(SimdLevel::best())
        };
        let films: Vec<SplatFilm> = SimdLevel::available().into_iter().map(film).collect();
        assert!(films.windows(2).all(|two| two[0] == two[1]));
    }

    /// A colour that does not change may be told either way: a sum's unit for each way is the difference, since one rounds and the
    /// other one cuts. A picture's size is no multiple of a block's.
    #[test]
    fn a_colour_that_changes_nowhere_is_one_colour() {
        let (mut plain, mut varying) = (SplatFilm::new(&view(), PACKET_BITS), SplatFilm::new(&view(), PACKET_BITS));
        let color = [0.3, -0.1, 7.5];
        for way in ways() {
            plain.splat(&way, color);
            varying.splat_varying(&way, |_| color);
        }
        let unit = f64::from(1_u32 << PACKET_BITS);
        for (x, y) in (0..43).flat_map(|x| (0..30).map(move |y| (x, y))) {
            let [one, other] = [&plain, &varying].map(|film| film.pixel(x, y, 1.0));
            assert!((0..3).all(|of| (one[of] - other[of]).abs() <= 2.0 * 500.0 / unit), "{x} {y} {one:?} {other:?}");
        }
        assert!(plain.pixel(20, 15, 1.0)[2] > 1.0);
    }
}
