//! Art in sRGB bytes as the reflectance that light works with.

use crate::film::srgb::decode_fast;
use crate::shading::surface::Normals;
use crate::simd::dispatch::{LANES, Lanes, SimdLevel, max, multiversion};
use crate::tile::planes::{AREA, AlbedoTile, BLACK, Plane, RgbTile, TILE};
use crate::{Floor, Scene};
use rayon::prelude::*;

/// The floor's reflectance and lean, tile by tile: read from the art once, since tiles are lit again and again.
#[derive(Clone, Debug, Default)]
pub(crate) struct AlbedoMap {
    /// Tiles across.
    across: usize,
    /// Red, green, blue of every tile, in 65,535ths.
    tiles: Vec<AlbedoTile>,
    /// Which way every tile leans, if any does: x and y of the normal, in 127ths; nothing for a flat tile.
    normals: Vec<Option<Box<[[i8; AREA]; 2]>>>,
}

impl AlbedoMap {
    /// Takes the art of a scene: grey where it has none of the view's size.
    pub fn set(&mut self, simd: SimdLevel, scene: &Scene) {
        let (width, height) = (scene.view.width, scene.view.height);
        self.across = width.div_ceil(TILE);
        self.tiles.clear();
        self.tiles.resize(self.across * height.div_ceil(TILE), [[u16::MAX / 2; AREA]; 3]);
        self.normals.clear();
        let floor = scene.floor;
        if !floor.fits(scene) {
            return;
        }
        let across = self.across;
        if !floor.normals.is_empty() {
            let tile = |at: usize| normals_of_tile(floor, at % across * TILE, at / across * TILE);
            self.normals.par_extend((0..self.tiles.len()).into_par_iter().map(tile));
        }
        self.tiles.par_iter_mut().enumerate().for_each(|(at, tile)| {
            let (x, y) = (at % across * TILE, at / across * TILE);
            let (inside, below) = (TILE.min(width - x), TILE.min(height - y));
            let mut albedo = Albedo::none();
            read_opaque(simd, &floor.floor, floor.width, x, y, inside, below, &mut albedo);
            albedo.clamp_to_edge(inside, below);
            for (kept, plane) in tile.iter_mut().zip(&albedo.color) {
                for (kept, value) in kept.iter_mut().zip(plane.as_flattened()) {
                    *kept = (value * 65_535.0 + 0.5) as u16;
                }
            }
        });
    }

    /// The normals of the tile whose upper left pixel is (`x`, `y`); says whether it leans, and if it does not, leaves
    /// `out` alone.
    pub fn read_normals(&self, simd: SimdLevel, x: usize, y: usize, out: &mut Normals) -> bool {
        let tile = self.normals.get(y / TILE * self.across + x / TILE).and_then(|tile| tile.as_deref());
        tile.is_some_and(|tile| {
            decode_normals(simd, tile, out);
            true
        })
    }

    /// The paint of the tile whose upper left pixel is (`x`, `y`).
    pub fn tile(&self, x: usize, y: usize) -> &AlbedoTile {
        &self.tiles[y / TILE * self.across + x / TILE]
    }

    /// The reflectance of the tile whose upper left pixel is (`x`, `y`).
    pub fn read(&self, simd: SimdLevel, x: usize, y: usize, out: &mut RgbTile) {
        decode_albedo(simd, self.tile(x, y), out);
    }
}

/// The normals of a tile; beyond the picture's edge it leans as it does there.
fn normals_of_tile(floor: &Floor, x: usize, y: usize) -> Option<Box<[[i8; AREA]; 2]>> {
    let mut tile = Box::new([[0; AREA]; 2]);
    for at in 0..AREA {
        let (row, column) = ((y + at / LANES).min(floor.height - 1), (x + at % LANES).min(floor.width - 1));
        [tile[0][at], tile[1][at]] = floor.normals[row * floor.width + column];
    }
    tile.as_flattened().iter().any(|&decode_normals| decode_normals != 0).then_some(tile)
}

multiversion! {
    fn decode_normals(tile: &[[i8; AREA]; 2], out: &mut Normals) = decode_normals_lanes;
}

#[inline(always)]
fn decode_normals_lanes([across, down]: &[[i8; AREA]; 2], out: &mut Normals) {
    for row in 0..TILE {
        let (across, down) = (&across[row * LANES..][..LANES], &down[row * LANES..][..LANES]);
        let (out_x, out_y, out_z) = (&mut out.x[row], &mut out.y[row], &mut out.z[row]);
        for i in 0..LANES {
            let (x, y) = (f32::from(across[i]) * (1.0 / 127.0), f32::from(down[i]) * (1.0 / 127.0));
            (out_x[i], out_y[i], out_z[i]) = (x, y, max(1.0 - x * x - y * y, 0.0).sqrt());
        }
    }
}

multiversion! {
    fn decode_albedo(tile: &AlbedoTile, out: &mut RgbTile) = decode_albedo_lanes;
}

#[inline(always)]
fn decode_albedo_lanes(tile: &AlbedoTile, out: &mut RgbTile) {
    for (plane, kept) in out.iter_mut().zip(tile) {
        for (line, kept) in plane.iter_mut().zip(kept.as_chunks::<LANES>().0) {
            for i in 0..LANES {
                line[i] = f32::from(kept[i]) * (1.0 / 65_535.0);
            }
        }
    }
}

/// Reflectance and coverage of the pixels of a tile.
#[derive(Clone, Debug)]
pub(crate) struct Albedo {
    /// Red, green, blue, linear, not multiplied by the coverage.
    pub color: RgbTile,
    /// 0 where there is no art, 1 where it is opaque.
    pub alpha: Plane,
}

impl Albedo {
    /// Black, and none of it.
    pub fn none() -> Albedo {
        Albedo { color: BLACK, alpha: [[0.0; LANES]; TILE] }
    }

    /// Beyond the picture's edge, tiles show what is at the edge.
    pub fn clamp_to_edge(&mut self, width: usize, height: usize) {
        for plane in self.color.iter_mut().chain([&mut self.alpha]) {
            for row in 0..TILE {
                if row >= height {
                    plane[row] = plane[height - 1];
                }
                let last = plane[row][width - 1];
                plane[row][width..].fill(last);
            }
        }
    }
}

multiversion! {
    /// Reads the rows of a tile from opaque sRGB pixels.
    fn read_opaque(
        pixels: &[[u8; 4]], stride: usize, x: usize, y: usize, width: usize, height: usize, out: &mut Albedo,
    ) = read_lanes::<true>;
}

multiversion! {
    /// Reads the rows of a tile from premultiplied sRGB pixels.
    pub(crate) fn read(
        pixels: &[[u8; 4]], stride: usize, x: usize, y: usize, width: usize, height: usize, out: &mut Albedo,
    ) = read_lanes::<false>;
}

#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn read_lanes<const OPAQUE: bool>(
    pixels: &[[u8; 4]],
    stride: usize,
    x: usize,
    y: usize,
    width: usize,
    height: usize,
    out: &mut Albedo,
) {
    for row in 0..TILE.min(height) {
        let start = (y + row) * stride + x;
        let mut packed = [0i32; LANES];
        match pixels[start..start + width].first_chunk::<LANES>() {
            Some(whole) => packed = whole.map(i32::from_le_bytes),
            None => {
                for (packed, pixel) in packed.iter_mut().zip(&pixels[start..start + width]) {
                    *packed = i32::from_le_bytes(*pixel);
                }
            }
        }
        let mut scale: Lanes = [1.0 / 255.0; LANES];
        if !OPAQUE {
            for i in 0..LANES {
                let alpha = ((packed[i] >> 24) & 255) as f32;
                out.alpha[row][i] = alpha * (1.0 / 255.0);
                scale[i] = 1.0 / max(alpha, 1.0);
            }
        }
        // Channel by channel and not in a loop, which the compiler would turn round.
        let [red, green, blue] = &mut out.color;
        read_channel::<0>(&packed, &scale, &mut red[row]);
        read_channel::<8>(&packed, &scale, &mut green[row]);
        read_channel::<16>(&packed, &scale, &mut blue[row]);
    }
}

#[inline(always)]
fn read_channel<const SHIFT: u32>(packed: &[i32; LANES], scale: &Lanes, out: &mut Lanes) {
    for i in 0..LANES {
        out[i] = decode_fast(((packed[i] >> SHIFT) & 255) as f32 * scale[i]);
    }
}
