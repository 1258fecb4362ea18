//! The test of the literal loops for 16 pixels of a row at a time, without a branch.

use crate::literal;
use crate::scene::{Disc, Scene, color, corner};
use crate::span_shading::pack;
use tracer::simd::dispatch::{LANES, Lanes, min, multiversion};

multiversion! {
    /// Makes the rows from `first_row` on.
    pub(crate) fn render_band(scene: &Scene, first_row: usize, pixels: &mut [u32]) = render_band_lanes;
}

#[inline(always)]
fn render_band_lanes(scene: &Scene, first_row: usize, pixels: &mut [u32]) {
    for (row, pixels) in pixels.chunks_mut(scene.width).enumerate() {
        let y = scene.y(first_row + row);
        let lamps = [0, 1, 2, 3].map(|lamp| RowLamp::new(&scene.discs, y, corner(lamp)));
        for start in (0..scene.width).step_by(LANES) {
            let mut chunk = [0; LANES];
            let mut margins = [0.0; LANES];
            for i in 0..LANES {
                chunk[i] = pixel(&lamps, &scene.discs, scene.x(start + i), y, &mut margins[i]);
            }
            if margins.iter().fold(f32::MAX, |least, &margin| min(least, margin)) < AMBIGUOUS {
                resolve(scene, start, y, &margins, &mut chunk);
            }
            match pixels[start..].first_chunk_mut::<LANES>() {
                Some(whole) => *whole = chunk,
                None => pixels[start..].copy_from_slice(&chunk[..scene.width - start]),
            }
        }
    }
}

/// Decides ambiguous pixels with the literal loops.
#[cold]
#[inline(never)]
fn resolve(scene: &Scene, start: usize, y: f32, margins: &Lanes, chunk: &mut [u32; LANES]) {
    for i in (0..LANES).filter(|&i| margins[i] < AMBIGUOUS) {
        chunk[i] = literal::pixel(scene, scene.x(start + i), y);
    }
}

/// Rounding may swap two squares that differ by less; they are 50 at most.
const AMBIGUOUS: f32 = 1e-4;

/// A lamp as a row of pixels sees it.
#[derive(Clone, Copy, Debug)]
struct RowLamp {
    x: f32,
    /// The square of the way down to it.
    down: f32,
    /// What may hide it.
    discs: [DiscTerms; 3],
}

/// A circle between a row of pixels and a lamp. With w the vector from a pixel to the lamp and c the vector to the
/// circle's centre, these are the terms of w x c and w . c that are the same along the row.
#[derive(Clone, Copy, Debug)]
struct DiscTerms {
    /// w x c at x = 0.
    across: f32,
    /// How much more it is for each 1 to the right.
    slope: f32,
    /// The product of the ways down.
    along: f32,
}

impl RowLamp {
    #[inline(always)]
    fn new(discs: &[Disc; 3], y: f32, (x, lamp_y): (f32, f32)) -> RowLamp {
        let down = lamp_y - y;
        let terms = |disc: &Disc| DiscTerms {
            across: x * (disc.y - y) - down * disc.x,
            slope: lamp_y - disc.y,
            along: down * (disc.y - y),
        };
        RowLamp { x, down: down * down, discs: [terms(&discs[0]), terms(&discs[1]), terms(&discs[2])] }
    }
}

/// A pixel is in a circle, or the line to the lamp meets the circle, which is where (w x c)^2 < r^2 w^2, and does so on
/// the lamp's side, where w . c > 0. That it may meet it beyond the lamp need not be asked: a lamp stands in a corner,
/// and there is nothing beyond. `margin` becomes how far from the other answer the
/// nearest of all is.
#[inline(always)]
fn pixel(lamps: &[RowLamp; 4], discs: &[Disc; 3], x: f32, y: f32, margin: &mut f32) -> u32 {
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
        for (disc, terms) in discs.iter().zip(&lamp.discs) {
            let across = terms.across + terms.slope * x;
            let along = terms.along + wx * (disc.x - x);
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
