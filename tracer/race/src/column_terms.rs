//! Column terms: what is the same in every row of a picture: the terms of the light that depend on the column alone.

use crate::scene::{SIDE_F32, Scene, color};
use tracer::simd::dispatch::{LANES, Lanes};

/// The terms of [`LANES`] columns side by side.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(crate) struct ColumnTerms {
    /// The square of the distance to the left wall.
    pub left_square: Lanes,
    /// The same to the right wall.
    pub right_square: Lanes,
    /// For the upper and the lower pair of lamps, in red, green and blue: the left lamp's colour times `right_square`
    /// and the right lamp's times `left_square`, added.
    pub crossed: [[Lanes; 3]; 2],
}

impl ColumnTerms {
    #[inline(always)]
    fn new(scene: &Scene, first_column: usize) -> ColumnTerms {
        let mut block = ColumnTerms::default();
        for i in 0..LANES {
            let x = scene.x(first_column + i);
            block.left_square[i] = x * x;
            block.right_square[i] = (SIDE_F32 - x) * (SIDE_F32 - x);
            for pair in 0..2 {
                for channel in 0..3 {
                    let (left, right) = (color(pair * 2, channel), color(pair * 2 + 1, channel));
                    block.crossed[pair][channel][i] = left * block.right_square[i] + right * block.left_square[i];
                }
            }
        }
        block
    }
}

/// Computes the terms of every column; the last block may go past the last of them.
pub(crate) fn fill(blocks: &mut Vec<ColumnTerms>, scene: &Scene) {
    blocks.clear();
    blocks.extend((0..scene.width).step_by(LANES).map(|column| ColumnTerms::new(scene, column)));
}
