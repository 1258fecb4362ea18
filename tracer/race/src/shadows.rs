//! Where on a row of pixels the circles' shadows begin and end.
//!
//! Seen from a lamp, the circle and what lies behind it are a convex region: on one row it is one interval. Its ends are
//! on the circle until the row is past where a tangent touches, and on the tangent from there on. As the lamps stand in
//! the corners and the circles nowhere touch a wall, both tangents run away from the lamp across every row.

use crate::literal::hides;
use crate::moment::{Moment, SIDE_F32, corner};
use tracer::simd::dispatch::{LANES, Lanes, max, min};

/// An end that passes so near to a pixel's middle may be on its other side, for all that rounding knows; in pixels.
const DOUBT: f32 = 0.01;

/// Where half of a circle's width on a row is less, the ends are that unsure too, and more.
const TIP: f32 = 0.01;

/// One end of every shadow.
#[derive(Clone, Copy, Debug, Default)]
struct Ends {
    /// How far down from the lamp's wall the tangent touches.
    touch: Lanes,
    /// How far across the tangent comes on a way down of 1, to the right.
    slope: Lanes,
}

/// Every lamp's and circle's shadow, in the lanes of lamp times 3 plus circle.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shadows {
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
    ends: [Ends; 2],
    /// Pixels across the room.
    width: f32,
    /// Pixels for a length of 1.
    scale: f32,
}

impl Shadows {
    #[inline(always)]
    pub fn new(moment: &Moment) -> Shadows {
        let mut shadows = Shadows {
            width: moment.width as f32,
            scale: moment.width as f32 / SIDE_F32,
            begin: [f32::MAX; LANES],
            ..Shadows::default()
        };
        for lamp in 0..4 {
            for (number, disc) in moment.discs.iter().enumerate() {
                let at = lamp * 3 + number;
                let (lamp_x, lamp_y) = corner(lamp);
                // As seen from the lamp, across and down its walls.
                let (across, down) = ((disc.x - lamp_x).abs(), (disc.y - lamp_y).abs());
                let far = across * across + down * down;
                let tangent = (far - disc.square).sqrt();
                (shadows.lamp_x[at], shadows.lamp_y[at]) = (lamp_x, lamp_y);
                (shadows.x[at], shadows.y[at], shadows.square[at]) = (disc.x, disc.y, disc.square);
                shadows.begin[at] = down - disc.radius;
                let side = if lamp % 2 == 0 { 1.0 } else { -1.0 };
                for (end, turn) in [(0, side), (1, -side)] {
                    // The tangent's direction is the middle's, turned by the angle whose sine is radius / sqrt(far).
                    let tx = across * tangent - turn * down * disc.radius;
                    let ty = down * tangent + turn * across * disc.radius;
                    shadows.ends[end].slope[at] = side * tx / ty;
                    shadows.ends[end].touch[at] = ty * tangent / far;
                }
            }
        }
        shadows
    }

    /// The first column of each shadow on the row at height `y`, and the one after its last: the same one where there is
    /// no shadow.
    #[inline(always)]
    pub fn on_row(&self, moment: &Moment, y: f32) -> [[u32; LANES]; 2] {
        let mut columns = [[0; LANES]; 2];
        let mut doubts = [0u32; LANES];
        for i in 0..LANES {
            let down = (y - self.lamp_y[i]).abs();
            let off = y - self.y[i];
            let half = max(self.square[i] - off * off, 0.0).sqrt();
            let end = |end: usize, half: f32| {
                let Ends { touch, slope } = &self.ends[end];
                let x = if down < touch[i] { self.x[i] + half } else { self.lamp_x[i] + slope[i] * down };
                min(max(x * self.scale, 0.0), self.width)
            };
            let (low, high) = (end(0, -half), end(1, half));
            let high = if down > self.begin[i] { max(high, low) } else { low };
            // 2^23 rounds to a whole column: the first whose middle is past the end.
            let rounded = [low + 8_388_608.0, high + 8_388_608.0];
            columns[0][i] = rounded[0].to_bits() & 0x7f_ffff;
            columns[1][i] = rounded[1].to_bits() & 0x7f_ffff;
            let off_by = |end: f32, rounded: f32| (end - (rounded - 8_388_608.0)).abs();
            let near = max(off_by(low, rounded[0]), off_by(high, rounded[1])) > 0.5 - DOUBT;
            let tip = (self.square[i] - off * off).abs() < TIP * TIP;
            doubts[i] = u32::from(near | tip);
        }
        if doubts.iter().fold(0, |any, doubt| any | doubt) != 0 {
            self.settle(moment, y, &doubts, &mut columns);
        }
        columns
    }

    /// Asks the literal question of the pixels beside ends that are in doubt.
    #[cold]
    #[inline(never)]
    fn settle(&self, moment: &Moment, y: f32, doubts: &[u32; LANES], columns: &mut [[u32; LANES]; 2]) {
        for shadow in (0..12).filter(|&shadow| doubts[shadow] != 0) {
            let ((lamp_x, lamp_y), disc) = (corner(shadow / 3), &moment.discs[shadow % 3]);
            let dark = |column: &u32| {
                let x = moment.x(*column as usize);
                hides(disc, x, y, lamp_x - x, lamp_y - y)
            };
            let (low, high) = (columns[0][shadow], columns[1][shadow]);
            let around = |column: u32| column.saturating_sub(2)..(column + 2).min(moment.width as u32);
            columns[0][shadow] = around(low).find(dark).unwrap_or(low);
            columns[1][shadow] = around(high).rev().find(dark).map_or(columns[0][shadow], |last| last + 1);
        }
    }
}

/// The shadows' ends on a row, from left to right.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edges {
    /// The column, and in the lowest 8 bits the shadow's number times two, plus one if it ends.
    keys: [i32; KEYS],
}

/// Both ends of each lane.
const KEYS: usize = LANES * 2;

/// What is greater than any key.
const NONE: i32 = i32::MAX;

impl Edges {
    /// Sorts without a branch, for no two rows are alike: a key's place is the number of keys that are less.
    #[inline(always)]
    pub fn new(columns: &[[u32; LANES]; 2]) -> Edges {
        let mut keys = [NONE; KEYS];
        for shadow in 0..LANES {
            let (low, high) = (columns[0][shadow] as i32, columns[1][shadow] as i32);
            let number = (shadow as i32) << 1;
            keys[shadow] = if low < high { low << 8 | number } else { NONE };
            keys[LANES + shadow] = if low < high { high << 8 | number | 1 } else { NONE };
        }
        let mut places = [0i32; KEYS];
        for other in keys {
            for at in 0..KEYS {
                places[at] += i32::from(other < keys[at]);
            }
        }
        let mut edges = Edges { keys: [NONE; KEYS] };
        for at in 0..KEYS {
            edges.keys[places[at] as usize % KEYS] = keys[at];
        }
        edges
    }

    /// From left to right, the column in which a shadow begins or ends, the shadow's lamp, and whether it ends.
    #[inline(always)]
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, bool)> {
        let there = self.keys.iter().take_while(|&&key| key != NONE);
        there.map(|&key| ((key >> 8) as usize, (key as usize >> 1 & 15) / 3, key & 1 == 1))
    }
}
