//! The light that leaves the table towards the eye, before exposure and tone map.

use crate::film::frame_id::FrameId;
use crate::simd::dispatch::LANES;
use crate::tile::planes::{Plane, RgbTile};

/// A picture in linear light, unbounded above: three planes of `f32`, and its bloom.
///
/// Keep one and render into it again and again: it allocates only when the size changes.
#[derive(Clone, Debug, Default)]
pub struct Radiance {
    width: usize,
    height: usize,
    stride: usize,
    /// Red, green, blue; `stride * height` each.
    pub(crate) planes: [Vec<f32>; 3],
    pub(crate) bloom: crate::film::bloom::BloomPyramid,
    /// The frame that it holds.
    pub(crate) source: Option<FrameId>,
}

/// The same light, whoever drew it.
impl PartialEq for Radiance {
    fn eq(&self, other: &Radiance) -> bool {
        let size = |radiance: &Radiance| (radiance.width, radiance.height);
        size(self) == size(other) && self.planes == other.planes && self.bloom == other.bloom
    }
}

impl Radiance {
    /// A black picture.
    pub fn new(width: usize, height: usize) -> Radiance {
        let mut radiance = Radiance::default();
        radiance.resize(width, height);
        radiance
    }

    /// Makes the picture `width` x `height` pixels; what was in it is lost if that is another size.
    pub fn resize(&mut self, width: usize, height: usize) {
        if (width, height) == (self.width, self.height) {
            return;
        }
        (self.width, self.height) = (width, height);
        self.source = None;
        self.stride = width.next_multiple_of(LANES);
        for plane in &mut self.planes {
            plane.clear();
            plane.resize(self.stride * height, 0.0);
        }
        self.bloom.resize(width, height);
    }

    /// Pixels across.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Pixels down.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Numbers from the start of one row to the start of the next, a multiple of [`LANES`].
    pub(crate) fn stride(&self) -> usize {
        self.stride
    }

    /// The tile whose upper left pixel is (`x`, `y`); what is below the picture is left as it is.
    pub(crate) fn read_tile(&self, x: usize, y: usize, light: &mut RgbTile) {
        for (channel, tile) in light.iter_mut().enumerate() {
            self.read_plane(channel, x, y, tile);
        }
    }

    /// One channel of [`Radiance::read_tile`].
    pub(crate) fn read_plane(&self, channel: usize, x: usize, y: usize, tile: &mut Plane) {
        for (row, line) in tile.iter_mut().enumerate().take(self.height - y) {
            line.copy_from_slice(&self.planes[channel][(y + row) * self.stride + x..][..LANES]);
        }
    }

    /// The light at a pixel.
    pub fn pixel(&self, x: usize, y: usize) -> [f32; 3] {
        let at = y * self.stride + x;
        [self.planes[0][at], self.planes[1][at], self.planes[2][at]]
    }
}
