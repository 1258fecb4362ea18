//! The tile schedule: a picture in bands of blocks of tiles, which threads share out, and where tiles are put.

use crate::cache::cell_means::TileMeans;
use crate::film::bloom::{CELL_PX, MipLevel};
use crate::tile::planes::{RgbTile, TILE};
use crate::tile::rect::TileRect;
use crate::{Scene, View};
use rayon::prelude::*;

/// Pixels along the side of a block of tiles, which share what is found out about their neighbourhood.
pub(crate) const BLOCK: usize = 2 * TILE;

/// Calls `work` for every tile of a band of blocks, with what belongs to each: first a block's tiles, then the next's.
pub(crate) fn each_tile<T>(
    scene: &Scene,
    band: usize,
    items: impl Iterator<Item = T>,
    mut work: impl FnMut(&TileRect, T),
) {
    let top = band * BLOCK;
    let rows = (top..(top + BLOCK).min(scene.view.height)).step_by(TILE);
    let blocks = (0..scene.view.width).step_by(BLOCK);
    let rects = blocks.flat_map(|left| {
        let columns = move || (left..(left + BLOCK).min(scene.view.width)).step_by(TILE);
        rows.clone().flat_map(move |y| columns().map(move |x| (x, y)))
    });
    for ((x, y), item) in rects.zip(items) {
        work(&TileRect::new(&scene.view, x, y), item);
    }
}

/// The band and the place in it of the tile that a pixel is in.
pub(crate) fn tile_at(view: &View, x: usize, y: usize) -> (usize, usize) {
    let (band, block) = (y / BLOCK, x / BLOCK);
    let tiles = |from: usize, end: usize| (end.min(from + BLOCK) - from).div_ceil(TILE);
    let (rows, columns) = (tiles(band * BLOCK, view.height), tiles(block * BLOCK, view.width));
    (band, block * (BLOCK / TILE) * rows + y % BLOCK / TILE * columns + x % BLOCK / TILE)
}

/// The rows of cells of every band of blocks.
pub(crate) fn means_bands(
    level: MipLevel,
    [red, green, blue]: [&mut [f32]; 3],
) -> impl IndexedParallelIterator<Item = [&mut [f32]; 3]> {
    let band = level.stride * (BLOCK / CELL_PX);
    let rows = red.par_chunks_mut(band).zip(green.par_chunks_mut(band)).zip(blue.par_chunks_mut(band));
    rows.map(|((red, green), blue)| [red, green, blue])
}

/// Writes a tile into a band of planes, as far as they reach.
pub(crate) fn write_planes(tile: &RgbTile, x: usize, y: usize, stride: usize, planes: &mut [&mut [f32]; 3]) {
    for (plane, tile) in planes.iter_mut().zip(tile) {
        for (row, line) in plane[y * stride..].chunks_mut(stride).zip(tile) {
            row[x..x + TILE].copy_from_slice(line);
        }
    }
}

/// Writes the means of a tile into a band of cells, as far as the level reaches.
pub(crate) fn write_means(found: &TileMeans, x: usize, y: usize, level: &MipLevel, means: &mut [&mut [f32]; 3]) {
    for (plane, found) in means.iter_mut().zip(found) {
        let rows = plane[y / CELL_PX * level.stride..].chunks_mut(level.stride);
        for (row, cells) in rows.zip(found.as_chunks::<{ TILE / CELL_PX }>().0) {
            let row = &mut row[1 + x / CELL_PX..1 + level.width];
            match row.first_chunk_mut() {
                Some(whole) => *whole = *cells,
                None => row.copy_from_slice(&cells[..row.len()]),
            }
        }
    }
}
