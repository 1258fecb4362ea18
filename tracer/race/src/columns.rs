//! What is the same in every row of a picture: the terms of the light that depend on the column alone.

use crate::moment::{Moment, SIDE_F32};
use crate::run::color;
use tracer::simd::dispatch::{LANES, Lanes};

/// The terms of [`LANES`] columns side by side.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(crate) struct Block {
    /// The square of the distance to the left wall.
    pub left: Lanes,
    /// The same to the right wall.
    pub right: Lanes,
    /// For the upper and the lower pair of lamps, in red, green and blue: the left lamp's colour times `right` and the
    /// right lamp's times `left`, added.
    pub crossed: [[Lanes; 3]; 2],
}

impl Block {
    #[inline(always)]
    fn new(moment: &Moment, first_column: usize) -> Block {
        let mut block = Block::default();
        for i in 0..LANES {
            let x = moment.x(first_column + i);
            block.left[i] = x * x;
            block.right[i] = (SIDE_F32 - x) * (SIDE_F32 - x);
            for pair in 0..2 {
                for channel in 0..3 {
                    let (left, right) = (color(pair * 2, channel), color(pair * 2 + 1, channel));
                    block.crossed[pair][channel][i] = left * block.right[i] + right * block.left[i];
                }
            }
        }
        block
    }
}

/// Computes the terms of every column; the last block may go past the last of them.
pub(crate) fn fill(blocks: &mut Vec<Block>, moment: &Moment) {
    blocks.clear();
    blocks.extend((0..moment.width).step_by(LANES).map(|column| Block::new(moment, column)));
}
