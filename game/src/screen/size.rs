//! The size of a frame or a window, and which sizes there can be.

/// A size in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
}

impl Size {
    /// The smallest side of a frame or a window.
    pub const MIN: usize = 64;
    /// The largest side of a frame or a window.
    pub const MAX: usize = 16384;
    /// The most pixels of a frame or a window: 4096 x 8192, which take 2.2 GB to draw, and 4.8 GB at half light.
    pub const MAX_PIXELS: usize = 1 << 25;

    /// Whether a frame or a window may have this size.
    pub fn is_drawable(self) -> bool {
        let sides = [self.width, self.height].iter().all(|side| *side <= Size::MAX);
        sides && self.width * self.height <= Size::MAX_PIXELS
    }

    /// The size that `text` gives as `WIDTHxHEIGHT`.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(text: &str) -> Result<Size, String> {
        let numbers = text.split_once(['x', 'X']).map(|(w, h)| (w.trim().parse(), h.trim().parse()));
        match numbers {
            Some((Ok(width), Ok(height)))
                if [width, height].iter().all(|side| (Size::MIN..=Size::MAX).contains(side)) =>
            {
                let size = Size { width, height };
                let millions = Size::MAX_PIXELS / 1_000_000;
                size.is_drawable().then_some(size).ok_or_else(|| format!("it has more than {millions} million pixels"))
            }
            Some((Ok(_), Ok(_))) => Err(format!("each side must be from {} to {} pixels", Size::MIN, Size::MAX)),
            _ => Err("write it as WIDTHxHEIGHT, for example 540x1080".to_string()),
        }
    }
}
