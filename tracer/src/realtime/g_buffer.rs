//! The G-buffer of one tile: which surfaces are seen at its pixels, how much of them, which way they lean, and their
//! albedo. It is fetched from the tile's cache, or found anew where that is empty.
//!
//! The highest top is looked at first, so that nothing is shaded that is hidden.

use crate::cache::cached_g_buffer::CachedGBuffer;
use crate::cache::validity::Validity;
use crate::realtime::frame_context::FrameContext;
use crate::shading::albedo_map::{self, Albedo};
use crate::shading::coverage::SignedDistance;
use crate::shading::surface::{Normals, Surface};
use crate::shading::top_layer::{MIN_COVERAGE, TopLayer};
use crate::simd::dispatch::{LANES, clamp};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{AREA, BLACK, Plane, RgbTile, RowMask, TILE};
use crate::tile::rect::TileRect;

/// The surfaces of one tile.
pub(crate) struct GBuffer {
    /// Whether the floor has a sample at every pixel; else its samples are packed.
    is_dense: bool,
    /// The floor's samples, where they are packed.
    packed: PackedSamples,
    /// The floor at its samples.
    pub floor: Surface,
    /// How much of each pixel is floor.
    pub floor_weight: Plane,
    /// The floor's albedo at every pixel, where its samples are packed.
    albedo: RgbTile,
    /// The tops' samples, the highest first; there may be more layers, which are not seen.
    layers: Vec<TopLayer>,
    tops: usize,
    scratch: Scratch,
}

struct Scratch {
    distance: SignedDistance,
    print: Albedo,
    normals: Normals,
}

impl GBuffer {
    /// Floor alone.
    pub fn new() -> GBuffer {
        GBuffer {
            is_dense: true,
            packed: PackedSamples::none(),
            floor: Surface::none(),
            floor_weight: [[0.0; LANES]; TILE],
            albedo: BLACK,
            layers: Vec::new(),
            tops: 0,
            scratch: Scratch { distance: SignedDistance::none(), print: Albedo::none(), normals: Normals::flat() },
        }
    }

    /// The samples of every top that is seen, the highest first.
    pub fn tops(&self) -> &[TopLayer] {
        &self.layers[..self.tops]
    }

    /// Whether any floor is seen.
    pub fn has_floor(&self) -> bool {
        self.is_dense || self.packed.count > 0
    }

    /// The floor's samples.
    pub fn floor_samples<'a>(&'a self, frame: &FrameContext<'a>) -> &'a PackedSamples {
        if self.is_dense { frame.full_tile } else { &self.packed }
    }

    /// The floor's samples, where they are not every pixel in order.
    pub fn packed_floor(&self) -> Option<&PackedSamples> {
        (!self.is_dense).then_some(&self.packed)
    }

    /// The blocks of the floor's samples that are in some rows.
    pub fn floor_blocks(&self, rows: RowMask) -> u16 {
        if self.is_dense { rows } else { self.packed.blocks_in(rows) }
    }

    /// The floor's albedo at every pixel.
    pub fn floor_albedo(&self) -> &RgbTile {
        if self.is_dense { &self.floor.albedo } else { &self.albedo }
    }

    /// Becomes the surfaces of a tile, from its cache, which is filled first where it is empty; `tops` are the slots of the
    /// tops near the tile.
    pub fn fetch(&mut self, frame: &FrameContext, rect: &TileRect, tops: &[usize], cached: &mut CachedGBuffer) {
        if !cached.validity.is_valid() {
            self.find_surfaces(frame, rect, tops);
            self.read_prints(frame, rect);
            self.store(cached);
        }
        let mm_per_px = frame.scene.view.mm_per_px as f32;
        self.is_dense = cached.is_dense;
        if !self.is_dense {
            self.packed.take(&cached.floor, mm_per_px);
        }
        if cached.floor_weight.is_empty() {
            self.floor_weight = [[1.0; LANES]; TILE];
        } else {
            self.floor_weight.copy_from_slice(&cached.floor_weight);
        }
        self.tops = cached.tops().len();
        if self.layers.len() < self.tops {
            self.layers.resize_with(self.tops, TopLayer::new);
        }
        for (top, layer) in cached.tops().iter().zip(&mut self.layers) {
            top.unpack(mm_per_px, layer);
        }
        self.read_floor(frame, rect);
    }

    fn store(&self, cached: &mut CachedGBuffer) {
        cached.validity = Validity::Valid;
        cached.is_dense = self.is_dense;
        cached.floor.clear();
        if !self.is_dense {
            cached.floor.extend_from_slice(&self.packed.pixel[..self.packed.count]);
        }
        cached.floor_weight.clear();
        if self.tops > 0 {
            cached.floor_weight.extend_from_slice(&self.floor_weight);
        }
        cached.keep_tops(self.tops());
    }

    /// Packs what is seen of every top, the highest first, and of the floor.
    fn find_surfaces(&mut self, frame: &FrameContext, rect: &TileRect, tops: &[usize]) {
        let mm_per_px = frame.scene.view.mm_per_px;
        self.floor_weight = [[1.0; LANES]; TILE];
        self.tops = 0;
        for &slot in tops.iter().rev() {
            let Some(outline) = frame.tops.outline(slot) else { continue };
            if !outline.bounds.overlaps(&rect.bounds) {
                continue;
            }
            let distance = &mut self.scratch.distance;
            outline.evaluate(frame.simd, frame.full_tile, rect.middle_mm, mm_per_px, distance);
            if self.layers.len() == self.tops {
                self.layers.push(TopLayer::new());
            }
            let layer = &mut self.layers[self.tops];
            layer.slot = slot;
            let opacity = clamp(frame.tops.top(slot).finish.opacity, 0.0, 1.0);
            layer.pack(distance, outline.bevel_mm(), opacity, mm_per_px as f32, &mut self.floor_weight);
            self.tops += usize::from(layer.samples.count > 0);
        }
        self.pack_floor_samples(mm_per_px as f32);
    }

    /// Packs the floor's samples, where an eighth of the tile is hidden.
    fn pack_floor_samples(&mut self, mm_per_px: f32) {
        let hides = |rest: &f32| u32::from(*rest < MIN_COVERAGE);
        let hidden = || self.floor_weight.iter().map(|row| row.iter().map(hides).sum::<u32>()).sum::<u32>();
        self.is_dense = self.tops == 0 || hidden() < AREA as u32 / 8;
        if self.is_dense {
            return;
        }
        self.packed.count = 0;
        for pixel in 0..AREA {
            if self.floor_weight[pixel / LANES][pixel % LANES] >= MIN_COVERAGE {
                self.packed.push_pixel(pixel, mm_per_px);
            }
        }
        self.packed.pad();
    }

    /// Reads what is printed on the tops that were found.
    fn read_prints(&mut self, frame: &FrameContext, rect: &TileRect) {
        let (scene, floor) = (frame.scene, frame.scene.floor);
        let (width, height) = rect.visible_px;
        let has_art = |layer: &TopLayer| floor.fits(scene) && frame.tops.top(layer.slot).finish.art;
        let print = &mut self.scratch.print;
        if self.layers[..self.tops].iter().any(has_art) {
            albedo_map::read(frame.simd, &floor.tops, floor.width, rect.x, rect.y, width, height, print);
            print.clamp_to_edge(width, height);
        }
        for layer in &mut self.layers[..self.tops] {
            layer.printed = false;
            if has_art(layer) {
                layer.pack_print(print);
            }
        }
    }

    /// Reads the floor's albedo and normals, and packs them at its samples.
    fn read_floor(&mut self, frame: &FrameContext, rect: &TileRect) {
        let &TileRect { x, y, .. } = rect;
        let floor = &mut self.floor;
        if self.is_dense {
            frame.albedo.read(frame.simd, x, y, &mut floor.albedo);
            floor.has_normals = frame.albedo.read_normals(frame.simd, x, y, &mut floor.normals);
            floor.weight.copy_from_slice(&self.floor_weight);
        } else {
            frame.albedo.read(frame.simd, x, y, &mut self.albedo);
            floor.has_normals = frame.albedo.read_normals(frame.simd, x, y, &mut self.scratch.normals);
            self.pack_floor();
        }
        if !self.floor.has_normals {
            let blocks = if self.is_dense { TILE } else { self.packed.blocks() };
            let Normals { x, y, z } = &mut self.floor.normals;
            for plane in [x, y] {
                plane[..blocks].fill([0.0; LANES]);
            }
            z[..blocks].fill([1.0; LANES]);
        }
    }

    /// Packs the floor's albedo, weight and normals at its samples.
    fn pack_floor(&mut self) {
        let GBuffer { packed, floor, floor_weight, albedo, scratch: Scratch { normals, .. }, .. } = self;
        for (at, &pixel) in packed.pixel[..packed.count].iter().enumerate() {
            let (row, i) = (usize::from(pixel) / LANES, usize::from(pixel) % LANES);
            let (block, lane) = (at / LANES, at % LANES);
            floor.weight[block][lane] = floor_weight[row][i];
            for (packed, albedo) in floor.albedo.iter_mut().zip(&*albedo) {
                packed[block][lane] = albedo[row][i];
            }
            if floor.has_normals {
                floor.normals.x[block][lane] = normals.x[row][i];
                floor.normals.y[block][lane] = normals.y[row][i];
                floor.normals.z[block][lane] = normals.z[row][i];
            }
        }
    }
}
