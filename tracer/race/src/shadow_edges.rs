//! The shadow intervals of the circles on a row of pixels, and their ends in order.
//!
//! Seen from a lamp, the circle and what lies behind it are a convex region: on one row it is one interval. Its ends
//! are on the circle until the row is past where a tangent touches, and on the tangent from there on. As the lamps
//! stand in the corners and the circles nowhere touch a wall, both tangents run away from the lamp across every row.

use crate::literal::hides;
use crate::scene::{SIDE_F32, Scene, corner};
use crate::span_shading::ROUNDING;
use tracer::simd::dispatch::{LANES, Lanes, max, min};

/// An end that is nearer than this to a pixel's centre may be on its other side after rounding, pixels.
const AMBIGUOUS_PX: f32 = 0.01;

/// Near a circle's top and bottom, where half of its width on a row is less than this, the square root magnifies
/// rounding: its ends are ambiguous too.
const TIP_HALF_WIDTH: f32 = 0.01;

/// One end of every shadow, as far as the tangent from the lamp bounds it.
#[derive(Clone, Copy, Debug, Default)]
struct TangentEdge {
    /// How far down from the lamp's wall the tangent touches.
    touch: Lanes,
    /// How far across the tangent comes on a way down of 1, to the right.
    slope: Lanes,
}

/// Every lamp's and circle's shadow, in the lanes of lamp times 3 plus circle.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ShadowEdges {
    /// Where the lamp is.
    lamp_x: Lanes,
    lamp_y: Lanes,
    /// Where the circle is.
    x: Lanes,
    y: Lanes,
    /// The square of its radius.
    square: Lanes,
    /// How far down from the lamp's wall the circle begins.
    begin: Lanes,
    ends: [TangentEdge; 2],
    /// Pixels across the frame.
    width: f32,
    /// Pixels for a length of 1.
    scale: f32,
}

impl ShadowEdges {
    #[inline(always)]
    pub fn new(scene: &Scene) -> ShadowEdges {
        let mut shadows = ShadowEdges {
            width: scene.width as f32,
            scale: scene.width as f32 / SIDE_F32,
            begin: [f32::MAX; LANES],
            ..ShadowEdges::default()
        };
        for lamp in 0..4 {
            for (number, disc) in scene.discs.iter().enumerate() {
                let at = lamp * 3 + number;
                let (lamp_x, lamp_y) = corner(lamp);
                // The circle's centre in the lamp's quadrant: across and down from the corner.
                let (across, down) = ((disc.x - lamp_x).abs(), (disc.y - lamp_y).abs());
                let far = across * across + down * down;
                let tangent = (far - disc.square).sqrt();
                (shadows.lamp_x[at], shadows.lamp_y[at]) = (lamp_x, lamp_y);
                (shadows.x[at], shadows.y[at], shadows.square[at]) = (disc.x, disc.y, disc.square);
                shadows.begin[at] = down - disc.radius;
                let side = if lamp % 2 == 0 { 1.0 } else { -1.0 };
                for (end, turn) in [(0, side), (1, -side)] {
                    // The tangent's direction is the centre's, turned by the angle whose sine is radius / sqrt(far).
                    let tx = across * tangent - turn * down * disc.radius;
                    let ty = down * tangent + turn * across * disc.radius;
                    shadows.ends[end].slope[at] = side * tx / ty;
                    shadows.ends[end].touch[at] = ty * tangent / far;
                }
            }
        }
        shadows
    }

    /// The first column of each shadow on the row at height `y`, and the one after its last: the same one where there
    /// is no shadow.
    #[inline(always)]
    pub fn on_row(&self, scene: &Scene, y: f32) -> [[u32; LANES]; 2] {
        let mut columns = [[0; LANES]; 2];
        let mut ambiguous = [0u32; LANES];
        for i in 0..LANES {
            let down = (y - self.lamp_y[i]).abs();
            let off = y - self.y[i];
            let half_width = max(self.square[i] - off * off, 0.0).sqrt();
            let end = |end: usize, half_width: f32| {
                let TangentEdge { touch, slope } = &self.ends[end];
                let x = if down < touch[i] { self.x[i] + half_width } else { self.lamp_x[i] + slope[i] * down };
                min(max(x * self.scale, 0.0), self.width)
            };
            let (low, high) = (end(0, -half_width), end(1, half_width));
            let high = if down > self.begin[i] { max(high, low) } else { low };
            // Adding 2^23 rounds to a whole column: the first whose centre is past the end.
            let rounded = [low + ROUNDING, high + ROUNDING];
            columns[0][i] = rounded[0].to_bits() & 0x7f_ffff;
            columns[1][i] = rounded[1].to_bits() & 0x7f_ffff;
            let off_by = |end: f32, rounded: f32| (end - (rounded - ROUNDING)).abs();
            let near = max(off_by(low, rounded[0]), off_by(high, rounded[1])) > 0.5 - AMBIGUOUS_PX;
            let tip = (self.square[i] - off * off).abs() < TIP_HALF_WIDTH * TIP_HALF_WIDTH;
            ambiguous[i] = u32::from(near | tip);
        }
        if ambiguous.iter().fold(0, |any, bits| any | bits) != 0 {
            self.resolve(scene, y, &ambiguous, &mut columns);
        }
        columns
    }

    /// Decides ambiguous ends with the test of the literal loops, pixel by pixel.
    #[cold]
    #[inline(never)]
    fn resolve(&self, scene: &Scene, y: f32, ambiguous: &[u32; LANES], columns: &mut [[u32; LANES]; 2]) {
        for shadow in (0..12).filter(|&shadow| ambiguous[shadow] != 0) {
            let ((lamp_x, lamp_y), disc) = (corner(shadow / 3), &scene.discs[shadow % 3]);
            let dark = |column: &u32| {
                let x = scene.x(*column as usize);
                hides(disc, x, y, lamp_x - x, lamp_y - y)
            };
            let (low, high) = (columns[0][shadow], columns[1][shadow]);
            let around = |column: u32| column.saturating_sub(2)..(column + 2).min(scene.width as u32);
            columns[0][shadow] = around(low).find(dark).unwrap_or(low);
            columns[1][shadow] = around(high).rev().find(dark).map_or(columns[0][shadow], |last| last + 1);
        }
    }
}

/// The ends of the shadow intervals on a row, from left to right.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SortedEdges {
    /// The column, and in the lowest 8 bits the shadow's number times two, plus one if it ends.
    keys: [i32; KEYS],
}

/// Both ends of each shadow.
const KEYS: usize = LANES * 2;

/// No edge: greater than any key.
const NONE: i32 = i32::MAX;

impl SortedEdges {
    /// Rank sort, without a branch that could be mispredicted: a key's rank is the number of keys that are less.
    #[inline(always)]
    pub fn new(columns: &[[u32; LANES]; 2]) -> SortedEdges {
        let mut keys = [NONE; KEYS];
        for shadow in 0..LANES {
            let (low, high) = (columns[0][shadow] as i32, columns[1][shadow] as i32);
            let number = (shadow as i32) << 1;
            keys[shadow] = if low < high { low << 8 | number } else { NONE };
            keys[LANES + shadow] = if low < high { high << 8 | number | 1 } else { NONE };
        }
        let mut ranks = [0i32; KEYS];
        for other in keys {
            for at in 0..KEYS {
                ranks[at] += i32::from(other < keys[at]);
            }
        }
        let mut edges = SortedEdges { keys: [NONE; KEYS] };
        for at in 0..KEYS {
            edges.keys[ranks[at] as usize % KEYS] = keys[at];
        }
        edges
    }

    /// From left to right: the column in which a shadow begins or ends, the shadow's lamp, and whether it ends.
    #[inline(always)]
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, bool)> {
        let there = self.keys.iter().take_while(|&&key| key != NONE);
        there.map(|&key| ((key >> 8) as usize, (key as usize >> 1 & 15) / 3, key & 1 == 1))
    }
}
