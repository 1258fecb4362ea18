//! Planes of a tile: one number for each pixel, row by row.

use crate::simd::dispatch::{LANES, Lanes};

/// Pixels along a tile's side. A row of a tile is one block of [`LANES`].
pub(crate) const TILE: usize = LANES;

/// Pixels of a tile.
pub(crate) const AREA: usize = TILE * TILE;

/// One number a pixel of a tile, or a sample of a layer.
pub(crate) type Plane = [Lanes; TILE];

/// Red, green and blue of a tile's pixels, linear: radiance or reflectance.
pub(crate) type RgbTile = [Plane; 3];

/// No light.
pub(crate) const BLACK: RgbTile = [[[0.0; LANES]; TILE]; 3];

/// The visible fraction where nothing is in the way. A static, since it is handed out by reference in inner loops.
pub(crate) static FULLY_VISIBLE: Plane = [[1.0; LANES]; TILE];

/// The albedo of a tile's floor, red, green, blue, in 65,535ths: half of the memory of [`RgbTile`].
pub(crate) type AlbedoTile = [[u16; AREA]; 3];

/// Rows of a tile, one bit each, the topmost in the lowest.
pub(crate) type RowMask = u16;

/// Every row.
pub(crate) const ALL_ROWS: RowMask = !0;
