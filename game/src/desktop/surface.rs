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
        Ok(Surface { surface: softbuffer::Surface::new(&context, window).map_err(wrong)? })
    }

    /// Shows a frame. One of another size than the window's is shown in its middle; a window that is larger than any
    /// screen is left as it is.
    pub fn present(&mut self, frame: &Frame) {
        let window = self.surface.window().clone();
        let size = window.inner_size();
        let (Some(width), Some(height)) = (NonZeroU32::new(size.width), NonZeroU32::new(size.height)) else { return };
        if !(Size { width: size.width as usize, height: size.height as usize }).is_drawable() {
            return;
        }
        // A window that is just being closed or hidden takes no pixels; the next frame finds out whether it is back.
        if self.surface.resize(width, height).is_err() {
            return;
        }
        let Ok(mut buffer) = self.surface.buffer_mut() else { return };
        if (frame.width, frame.height) == (size.width as usize, size.height as usize) {
            buffer.copy_from_slice(&frame.pixels);
        } else {
            centre(frame, &mut buffer, size.width as usize, size.height as usize);
        }
        window.pre_present_notify();
        let _ = buffer.present();
    }
}

/// Puts `frame` into the middle of a buffer of another size, cut where it is too large.
fn centre(frame: &Frame, buffer: &mut [u32], width: usize, height: usize) {
    buffer.fill(BLACK);
    let place = |inner: usize, outer: usize| {
        let shown = inner.min(outer);
        ((inner - shown) / 2, (outer - shown) / 2, shown)
    };
    let (from_x, to_x, columns) = place(frame.width, width);
    let (from_y, to_y, rows) = place(frame.height, height);
    for row in 0..rows {
        let from = (from_y + row) * frame.width + from_x;
        let to = (to_y + row) * width + to_x;
        buffer[to..to + columns].copy_from_slice(&frame.pixels[from..from + columns]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_another_size_is_shown_in_the_middle() {
        let frame = Frame { width: 2, height: 1, pixels: vec![1, 2] };
        let mut larger = [9; 12];
        centre(&frame, &mut larger, 4, 3);
        assert_eq!(larger[4..8], [BLACK, 1, 2, BLACK]);
        let mut smaller = [9; 2];
        centre(&frame, &mut smaller, 1, 2);
        assert_eq!(smaller, [1, BLACK]);
    }
}
