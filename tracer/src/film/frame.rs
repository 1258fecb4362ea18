//! A finished picture.

/// Pixels as a window takes them: 0x00RRGGBB, sRGB, row by row from the top.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Frame {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// `width * height` pixels.
    pub pixels: Vec<u32>,
}

impl Frame {
    /// A black picture.
    pub fn new(width: usize, height: usize) -> Frame {
        Frame { width, height, pixels: vec![0; width * height] }
    }

    /// The picture as bytes R, G, B, row by row.
    pub fn to_rgb8(&self) -> Vec<u8> {
        self.pixels.iter().flat_map(|&p| [(p >> 16) as u8, (p >> 8) as u8, p as u8]).collect()
    }
}
