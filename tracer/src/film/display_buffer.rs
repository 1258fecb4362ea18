//! The display buffer: a tone-mapped picture that knows which frame it holds, so that only what has changed is drawn again.

use crate::Frame;
use crate::film::bloom::BloomPyramid;
use crate::film::frame_id::FrameId;
use crate::tile::planes::TILE;

/// Pixels, and what they were made of.
///
/// Keep one and draw on it again and again: it allocates only when the size changes.
#[derive(Clone, Debug, Default)]
pub struct DisplayBuffer {
    pub(crate) frame: Frame,
    pub(crate) bloom: BloomPyramid,
    /// The scissor rectangle, if not all is wanted: the first column and row, and those after the last.
    pub(crate) scissor: Option<[usize; 4]>,
    /// The frame that it holds, and how that was exposed.
    pub(crate) source: Option<(FrameId, f32)>,
}

impl DisplayBuffer {
    /// The picture.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// From now on, only the pixels from (`x`, `y`) on, `width` x `height` of them, are wanted: all others may be left as
    /// they are. Their light is known all the same, so that the picture does not depend on earlier scissor rectangles.
    pub fn set_scissor(&mut self, x: usize, y: usize, width: usize, height: usize) {
        self.scissor = Some([x, y, x + width, y + height]);
    }

    /// Whether a tile, given by its upper left pixel, has a pixel in a scissor rectangle.
    pub(crate) fn in_scissor(scissor: Option<[usize; 4]>, x: usize, y: usize) -> bool {
        scissor.is_none_or(|[left, top, right, bottom]| x < right && x + TILE > left && y < bottom && y + TILE > top)
    }

    /// Makes the picture `width` x `height` pixels; what was in it is lost if that is another size.
    pub(crate) fn resize(&mut self, width: usize, height: usize) {
        if (width, height) != (self.frame.width, self.frame.height) {
            (self.frame.width, self.frame.height) = (width, height);
            self.frame.pixels.clear();
            self.frame.pixels.resize(width * height, 0);
            self.bloom.resize(width, height);
            self.source = None;
        }
    }
}
