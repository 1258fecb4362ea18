//! Where on a row of pixels the circles' shadows begin and end.
//!
//! Seen from a lamp, the circle and what lies behind it are a convex region: on one row it is one interval. Its ends are
//! on the circle until the row is past where a tangent touches, and on the tangent from there on. As the lamps stand in
//! the corners and the circles nowhere touch a wall, both tangents run away from the lamp across every row.

use super::moment::{Moment, SIDE_F32, corner};
use crate::lanes::{LANES, Lanes, max, min};

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
pub(super) struct Shadows {
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
    pub fn on_row(&self, y: f32) -> [[u32; LANES]; 2] {
        let mut columns = [[0; LANES]; 2];
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
            columns[0][i] = (low + 8_388_608.0).to_bits() & 0x7f_ffff;
            columns[1][i] = (high + 8_388_608.0).to_bits() & 0x7f_ffff;
        }
        columns
    }
}

/// The shadows' ends on a row, from left to right.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edges {
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
