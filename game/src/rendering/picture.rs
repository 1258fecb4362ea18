//! A picture in linear light.

/// Pixels in linear sRGB, unbounded above, inside the gamut.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Row by row.
    pub pixels: Vec<[f32; 3]>,
}
