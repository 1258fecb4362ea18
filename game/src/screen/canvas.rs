//! A finished frame that is drawn on: pixels, copies and layers, blended over what is there.
//!
//! Everything is clipped, so nothing that is drawn can be out of place. Lines and shapes are a [`super::Layer`]'s.

use rayon::prelude::*;
use tracer::Frame;

/// Rows that one task copies.
const COPIED: usize = 128;

/// A colour, sRGB, 0x00RRGGBB.
pub type Color = u32;

/// Some pixels of a frame; it may reach beyond it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rect {
    /// The leftmost pixel.
    pub x: i32,
    /// The topmost pixel.
    pub y: i32,
    /// Pixels across, 0 or more.
    pub width: i32,
    /// Pixels down, 0 or more.
    pub height: i32,
}

impl Rect {
    /// The rectangle with this corner and this size; a negative size is none.
    pub fn new(x: i32, y: i32, width: i32, height: i32) -> Rect {
        Rect { x, y, width: width.max(0), height: height.max(0) }
    }

    /// The column after the last.
    pub fn right(&self) -> i32 {
        self.x + self.width
    }

    /// The row after the last.
    pub fn bottom(&self) -> i32 {
        self.y + self.height
    }

    /// Larger by `by` pixels on every side (smaller if negative).
    #[must_use]
    pub fn grown(self, by: i32) -> Rect {
        Rect::new(self.x - by, self.y - by, self.width + 2 * by, self.height + 2 * by)
    }

    /// The same size, elsewhere.
    #[must_use]
    pub fn moved(self, x: i32, y: i32) -> Rect {
        Rect { x: self.x + x, y: self.y + y, ..self }
    }

    /// What both share.
    #[must_use]
    pub fn clipped(self, other: Rect) -> Rect {
        let (x, y) = (self.x.max(other.x), self.y.max(other.y));
        Rect::new(x, y, self.right().min(other.right()) - x, self.bottom().min(other.bottom()) - y)
    }

    /// A rectangle of this size with the same middle.
    #[must_use]
    pub fn centred(self, width: i32, height: i32) -> Rect {
        Rect::new(self.x + (self.width - width) / 2, self.y + (self.height - height) / 2, width, height)
    }

    /// Whether no pixel is in it.
    pub fn is_empty(&self) -> bool {
        self.width <= 0 || self.height <= 0
    }
}

/// A frame that is being drawn on, inside `clip`.
pub struct Canvas<'a> {
    frame: &'a mut Frame,
    clip: Rect,
}

impl<'a> Canvas<'a> {
    /// Draws on all of `frame`.
    pub fn new(frame: &'a mut Frame) -> Canvas<'a> {
        let clip = Rect::new(0, 0, frame.width as i32, frame.height as i32);
        Canvas { frame, clip }
    }

    /// Draws on what lies in `clip` only.
    pub fn within(&mut self, clip: Rect) -> Canvas<'_> {
        Canvas { clip: self.clip.clipped(clip), frame: self.frame }
    }

    /// What can be drawn on.
    pub fn clip(&self) -> Rect {
        self.clip
    }

    /// One pixel, `alpha` of 255 of it.
    pub fn dot(&mut self, x: i32, y: i32, color: Color, alpha: u32) {
        if x >= self.clip.x && x < self.clip.right() && y >= self.clip.y && y < self.clip.bottom() {
            let pixel = &mut self.frame.pixels[y as usize * self.frame.width + x as usize];
            *pixel = over(*pixel, color, alpha);
        }
    }

    /// A rectangle of one colour, `alpha` of 255 of it.
    pub fn fill(&mut self, rect: Rect, color: Color, alpha: u32) {
        self.each_row(rect, |_, _, row| row.iter_mut().for_each(|pixel| *pixel = over(*pixel, color, alpha)));
    }

    /// The pixels of a layer in `rect`: what `part` says of each, counted row by row from the corner of `rect`, is a
    /// colour that has been multiplied by its opacity, and the opacity, of 255.
    pub fn blend(&mut self, rect: Rect, part: impl Fn(usize) -> (Color, u32)) {
        self.each_row(rect, |x, y, row| {
            let start = (y - rect.y) as usize * rect.width as usize + (x - rect.x) as usize;
            for (offset, pixel) in row.iter_mut().enumerate() {
                match part(start + offset) {
                    (_, 0) => {}
                    (color, 255) => *pixel = color,
                    // No channel can overflow into its neighbour: a multiplied colour is at most its opacity.
                    (color, alpha) => *pixel = color + over(*pixel, 0, alpha),
                }
            }
        });
    }

    /// The pixels of `source` from its corner `from`, put into `rect` as they are, on the threads of the current rayon
    /// pool.
    pub fn copy(&mut self, source: &Frame, rect: Rect, from: (i32, i32)) {
        let (left, top) = (rect.x - from.0, rect.y - from.1);
        let whole = Rect::new(left, top, source.width as i32, source.height as i32);
        let rect = rect.clipped(whole).clipped(self.clip);
        if rect.is_empty() {
            return;
        }
        let width = self.frame.width;
        let rows = &mut self.frame.pixels[rect.y as usize * width..rect.bottom() as usize * width];
        rows.par_chunks_mut(width * COPIED).enumerate().for_each(|(chunk, rows)| {
            for (row, line) in rows.chunks_mut(width).enumerate() {
                let y = rect.y as usize + chunk * COPIED + row;
                let start = (y as i32 - top) as usize * source.width + (rect.x - left) as usize;
                let line = &mut line[rect.x as usize..rect.right() as usize];
                line.copy_from_slice(&source.pixels[start..start + line.len()]);
            }
        });
    }

    /// Calls `paint` with the first column, the row, and the row's pixels, for each row of `rect`.
    fn each_row(&mut self, rect: Rect, mut paint: impl FnMut(i32, i32, &mut [u32])) {
        let rect = rect.clipped(self.clip);
        if rect.is_empty() {
            return;
        }
        for y in rect.y..rect.bottom() {
            let start = y as usize * self.frame.width + rect.x as usize;
            paint(rect.x, y, &mut self.frame.pixels[start..start + rect.width as usize]);
        }
    }
}

/// `alpha` of 255 of `color` over `below`.
pub fn over(below: u32, color: Color, alpha: u32) -> u32 {
    let alpha = alpha.min(255);
    let channel = |shift: u32| {
        let (a, b) = ((below >> shift) & 255, (color >> shift) & 255);
        ((a * (255 - alpha) + b * alpha + 127) / 255) << shift
    };
    channel(16) | channel(8) | channel(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_drawn_outside_the_clip() {
        let mut frame = Frame::new(8, 8);
        let mut canvas = Canvas::new(&mut frame);
        let mut inner = canvas.within(Rect::new(2, 2, 3, 3));
        inner.fill(Rect::new(-50, -50, 200, 200), 0xff_ffff, 255);
        inner.blend(Rect::new(-2, -2, 20, 20), |_| (0x10_1010, 16));
        inner.copy(&Frame { width: 1, height: 1, pixels: vec![7] }, Rect::new(-9, -9, 99, 99), (4, 4));
        assert_eq!(frame.pixels.iter().filter(|pixel| **pixel != 0).count(), 9);
    }

    #[test]
    fn a_copy_lands_where_it_is_asked_to() {
        let source = Frame { width: 2, height: 2, pixels: vec![1, 2, 3, 4] };
        let mut frame = Frame::new(4, 1);
        Canvas::new(&mut frame).copy(&source, Rect::new(2, 0, 9, 9), (0, 1));
        assert_eq!(frame.pixels, [0, 0, 3, 4]);
    }

    #[test]
    fn all_or_nothing_of_a_colour_is_exact() {
        assert_eq!(over(0x12_3456, 0xab_cdef, 255), 0xab_cdef);
        assert_eq!(over(0x12_3456, 0xab_cdef, 0), 0x12_3456);
    }
}
