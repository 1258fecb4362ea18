//! A finished picture that knows what it shows, so that only what has changed is drawn again.

use crate::Frame;
use crate::glare::Pyramid;

/// Pixels, and what they were made of.
///
/// Keep one and draw on it again and again: it allocates only when the size changes.
#[derive(Clone, Debug, Default)]
pub struct Film {
    pub(crate) frame: Frame,
    pub(crate) glare: Pyramid,
    /// Which renderer drew it, which of its pictures it is, and how it was exposed.
    pub(crate) drawn: Option<((u64, u64), f32)>,
}

impl Film {
    /// The picture.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Makes the picture `width` x `height` pixels; what was in it is lost if that is another size.
    pub(crate) fn resize(&mut self, width: usize, height: usize) {
        if (width, height) != (self.frame.width, self.frame.height) {
            (self.frame.width, self.frame.height) = (width, height);
            self.frame.pixels.clear();
            self.frame.pixels.resize(width * height, 0);
            self.glare.resize(width, height);
            self.drawn = None;
        }
    }
}
