//! The question of the literal loops, asked for 16 pixels of a row at a time and without a branch.

use crate::literal;
use crate::moment::{Disc, Moment, corner};
use crate::run::{color, pack};
use tracer::simd::dispatch::{LANES, Lanes, min, multiversion};

multiversion! {
    /// Makes the rows from `first_row` on.
    pub(crate) fn band(moment: &Moment, first_row: usize, pixels: &mut [u32]) = band_lanes;
}

#[inline(always)]
fn band_lanes(moment: &Moment, first_row: usize, pixels: &mut [u32]) {
    for (row, pixels) in pixels.chunks_mut(moment.width).enumerate() {
        let y = moment.y(first_row + row);
        let lamps = [0, 1, 2, 3].map(|lamp| Lamp::new(&moment.discs, y, corner(lamp)));
        for start in (0..moment.width).step_by(LANES) {
            let mut chunk = [0; LANES];
            let mut margins = [0.0; LANES];
            for i in 0..LANES {
                chunk[i] = pixel(&lamps, &moment.discs, moment.x(start + i), y, &mut margins[i]);
            }
            if margins.iter().fold(f32::MAX, |least, &margin| min(least, margin)) < DOUBT {
                settle(moment, start, y, &margins, &mut chunk);
            }
            match pixels[start..].first_chunk_mut::<LANES>() {
                Some(whole) => *whole = chunk,
                None => pixels[start..].copy_from_slice(&chunk[..moment.width - start]),
            }
        }
    }
}

/// Asks the literal question where the edge of a shadow passes too near.
#[cold]
#[inline(never)]
fn settle(moment: &Moment, start: usize, y: f32, margins: &Lanes, chunk: &mut [u32; LANES]) {
    for i in (0..LANES).filter(|&i| margins[i] < DOUBT) {
        chunk[i] = literal::pixel(moment, moment.x(start + i), y);
    }
}

/// Squares that differ by less, of some 25 at most, may be the other way round for all that rounding knows.
const DOUBT: f32 = 1e-4;

/// A lamp as a row of pixels sees it.
#[derive(Clone, Copy, Debug)]
struct Lamp {
    x: f32,
    /// The square of the way down to it.
    down: f32,
    /// What may hide it.
    discs: [Obstacle; 3],
}

/// A circle between a row of pixels and a lamp. With w the way from a pixel to the lamp and c the way to the circle's
/// middle, it is the parts of w x c and w . c that are the same along the row.
#[derive(Clone, Copy, Debug)]
struct Obstacle {
    /// w x c at x = 0.
    across: f32,
    /// How much more it is for each 1 to the right.
    slope: f32,
    /// The product of the ways down.
    along: f32,
}

impl Lamp {
    #[inline(always)]
    fn new(discs: &[Disc; 3], y: f32, (x, lamp_y): (f32, f32)) -> Lamp {
        let down = lamp_y - y;
        let obstacle = |disc: &Disc| Obstacle {
            across: x * (disc.y - y) - down * disc.x,
            slope: lamp_y - disc.y,
            along: down * (disc.y - y),
        };
        Lamp { x, down: down * down, discs: [obstacle(&discs[0]), obstacle(&discs[1]), obstacle(&discs[2])] }
    }
}

/// A pixel is in a circle, or the line to the lamp meets the circle, which is where (w x c)^2 < r^2 w^2, and does so on
/// the lamp's side, where w . c > 0. That it may meet it beyond the lamp need not be asked: a lamp stands in a corner,
/// and there is nothing beyond. `margin` becomes how far from the other answer the
/// nearest of all is.
#[inline(always)]
fn pixel(lamps: &[Lamp; 4], discs: &[Disc; 3], x: f32, y: f32, margin: &mut f32) -> u32 {
    let (mut inside, mut least) = (false, f32::MAX);
    for disc in discs {
        let square = (disc.x - x) * (disc.x - x) + (disc.y - y) * (disc.y - y);
        inside |= square < disc.square;
        least = min(least, (square - disc.square).abs());
    }
    let mut sum = [0.0; 3];
    for (number, lamp) in lamps.iter().enumerate() {
        let wx = lamp.x - x;
        let way = wx * wx + lamp.down;
        let mut hidden = inside;
        for (disc, obstacle) in discs.iter().zip(&lamp.discs) {
            let across = obstacle.across + obstacle.slope * x;
            let along = obstacle.along + wx * (disc.x - x);
            let (left, right) = (across * across, disc.square * way);
            hidden |= (left < right) & (along > 0.0);
            least = min(least, (left - right).abs());
        }
        let light = if hidden { 0.0 } else { 1.0 / (1.0 + way) };
        for channel in 0..3 {
            sum[channel] += color(number, channel) * light;
        }
    }
    *margin = least;
    pack(sum[0], sum[1], sum[2])
}
