//! Spans: a row of pixels is cut where shadows begin and end, and each piece is lit as a whole.

use crate::columns::Block;
use crate::moment::Moment;
use crate::run::{Row, light};
use crate::shadows::{Edges, Shadows};
use tracer::simd::dispatch::multiversion;

/// The bits of all four lamps.
const ALL: usize = 0b1111;

multiversion! {
    /// Makes the rows from `first_row` on.
    pub(crate) fn band(moment: &Moment, blocks: &[Block], first_row: usize, pixels: &mut [u32]) = band_lanes;
}

#[inline(always)]
fn band_lanes(moment: &Moment, blocks: &[Block], first_row: usize, pixels: &mut [u32]) {
    let shadows = Shadows::new(moment);
    for row in 0..pixels.len() / moment.width {
        let y = moment.y(first_row + row);
        let edges = Edges::new(&shadows.on_row(moment, y));
        let pixels = &mut pixels[row * moment.width..];
        let row = Row::new(y);
        // In how many shadows of each lamp the run is, the lamps that reach it, and where it begins.
        let (mut shades, mut lit, mut start) = ([0u8; 4], ALL, 0);
        for (column, lamp, ends) in edges.iter() {
            shades[lamp] = if ends { shades[lamp] - 1 } else { shades[lamp] + 1 };
            let now = if shades[lamp] == 0 { lit | 1 << lamp } else { lit & !(1 << lamp) };
            if now != lit {
                light(lit, &row, blocks, start, column, pixels);
                (lit, start) = (now, column);
            }
        }
        light(lit, &row, blocks, start, moment.width, pixels);
    }
}
