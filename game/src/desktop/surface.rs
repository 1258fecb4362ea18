//! The pixels of the window.

use crate::Failure;
use crate::screen::Size;
use std::num::NonZeroU32;
use std::sync::Arc;
use tracer::Frame;
use winit::event_loop::OwnedDisplayHandle;
use winit::window::Window;

/// What the window shows around a frame of another size, while a new one is being painted.
const BLACK: u32 = 0x05_070c;

/// The pixels of a window.
pub struct Surface {
    surface: softbuffer::Surface<OwnedDisplayHandle, Arc<Window>>,
    window: Arc<Window>,
}

impl Surface {
    /// The surface of this window.
    ///
    /// # Errors
    /// If the display takes no pixels from a program.
    pub fn new(display: OwnedDisplayHandle, window: Arc<Window>) -> Result<Surface, Failure> {
        let wrong = |error: softbuffer::SoftBufferError| {
            Failure::new(format!("the window takes no pixels ({error}); `caustic dump` writes a game as pictures"))
        };
        let context = softbuffer::Context::new(display).map_err(wrong)?;
        let surface = softbuffer::Surface::new(&context, window.clone()).map_err(wrong)?;
        Ok(Surface { surface, window })
    }

    /// Shows a frame in the window, which has this size now. A frame of another size is scaled to it, all of it in the
    /// window's middle; a window that is larger than any screen is left as it is.
    pub fn present(&mut self, frame: &Frame, size: Size) {
        let side = |side: usize| NonZeroU32::new(side as u32);
        let (Some(width), Some(height)) = (side(size.width), side(size.height)) else { return };
        if !size.is_drawable() {
            return;
        }
        // A window that is just being closed or hidden takes no pixels; the next frame finds out whether it is back.
        if self.surface.resize(width, height).is_err() {
            return;
        }
        let Ok(mut buffer) = self.surface.buffer_mut() else { return };
        if (frame.width, frame.height) == (size.width, size.height) {
            buffer.copy_from_slice(&frame.pixels);
        } else {
            scale(frame, &mut buffer, size);
        }
        self.window.pre_present_notify();
        let _ = buffer.present();
    }
}

/// Scales `frame` into the middle of a buffer of another size, as large as all of it fits: each pixel shows the frame's
/// pixel that its middle falls on. It stands for a moment, until a frame of the buffer's size has been painted.
fn scale(frame: &Frame, buffer: &mut [u32], size: Size) {
    buffer.fill(BLACK);
    if frame.pixels.is_empty() {
        return;
    }
    let wide = size.width * frame.height > size.height * frame.width;
    let shown = if wide {
        Size { width: (frame.width * size.height / frame.height).max(1), height: size.height }
    } else {
        Size { width: size.width, height: (frame.height * size.width / frame.width).max(1) }
    };
    let (left, top) = ((size.width - shown.width) / 2, (size.height - shown.height) / 2);
    let from = |to: usize, shown: usize, all: usize| (2 * to + 1) * all / (2 * shown);
    let columns: Vec<usize> = (0..shown.width).map(|x| from(x, shown.width, frame.width)).collect();
    for y in 0..shown.height {
        let row = &frame.pixels[from(y, shown.height, frame.height) * frame.width..][..frame.width];
        let to = &mut buffer[(top + y) * size.width + left..][..shown.width];
        to.iter_mut().zip(&columns).for_each(|(pixel, x)| *pixel = row[*x]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_another_size_is_shown_whole_in_the_middle() {
        let frame = Frame { width: 2, height: 1, pixels: vec![1, 2] };
        let mut larger = [9; 12];
        scale(&frame, &mut larger, Size { width: 4, height: 3 });
        assert_eq!(larger, [1, 1, 2, 2, 1, 1, 2, 2, BLACK, BLACK, BLACK, BLACK]);
        let mut flat = [9; 5];
        scale(&frame, &mut flat, Size { width: 5, height: 1 });
        assert_eq!(flat, [BLACK, 1, 2, BLACK, BLACK]);
    }

    #[test]
    fn no_size_is_too_odd_to_scale_to() {
        for (width, height) in [(1, 1), (1, 700), (900, 1), (3, 7)] {
            let frame = Frame { width, height, pixels: vec![7; width * height] };
            for (width, height) in [(1, 1), (2, 999), (999, 2), (640, 480)] {
                let mut buffer = vec![9; width * height];
                scale(&frame, &mut buffer, Size { width, height });
                assert!(buffer.contains(&7) && !buffer.contains(&9), "{frame:?} in {width} x {height}");
            }
        }
        let mut buffer = [9; 2];
        scale(&Frame::default(), &mut buffer, Size { width: 2, height: 1 });
        assert_eq!(buffer, [BLACK, BLACK], "before the first frame");
    }
}
