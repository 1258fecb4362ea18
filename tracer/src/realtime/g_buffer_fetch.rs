//! What can be seen at the pixels of a tile: from memory, or found anew. The highest top is looked at first, so that
//! nothing is lit that is hidden.

use crate::cache::g_buffer::Surfaces;
use crate::realtime::tile_renderer::{Stage, Workspace};
use crate::shading::top_layer::{MIN_COVERAGE, TopLayer};
use crate::simd::dispatch::{LANES, clamp};
use crate::tile::planes::{AREA, TILE};
use crate::tile::rect::TileRect;

impl Workspace {
    /// The tile's surfaces with their art, from memory if that holds; says how many tops there are.
    pub(crate) fn recall(&mut self, stage: &Stage, rect: &TileRect, kept: &mut Surfaces) -> usize {
        if !kept.holds {
            let layers = self.find_surfaces(stage, rect);
            self.read_prints(stage, rect, layers);
            self.keep_surfaces(layers, kept);
        }
        let mm_per_px = stage.scene.view.mm_per_px as f32;
        self.whole = kept.whole;
        if !self.whole {
            self.floor.take(&kept.floor, mm_per_px);
        }
        if kept.floor_weight.is_empty() {
            self.remaining = [[1.0; LANES]; TILE];
        } else {
            self.remaining.copy_from_slice(&kept.floor_weight);
        }
        let layers = kept.tops().len();
        if self.tops.len() < layers {
            self.tops.resize_with(layers, TopLayer::new);
        }
        for (sprite, layer) in kept.tops().iter().zip(&mut self.tops) {
            sprite.unpack(mm_per_px, layer);
        }
        self.read_art(stage, rect);
        layers
    }

    fn keep_surfaces(&self, layers: usize, kept: &mut Surfaces) {
        kept.holds = true;
        kept.whole = self.whole;
        kept.floor.clear();
        if !self.whole {
            kept.floor.extend_from_slice(&self.floor.pixel[..self.floor.count]);
        }
        kept.floor_weight.clear();
        if layers > 0 {
            kept.floor_weight.extend_from_slice(&self.remaining);
        }
        kept.keep_tops(&self.tops[..layers]);
    }

    /// Packs what is seen of every top, the highest first, and of the floor; says how many tops there are.
    fn find_surfaces(&mut self, stage: &Stage, rect: &TileRect) -> usize {
        let mm_per_px = stage.scene.view.mm_per_px;
        let &TileRect { middle_mm: middle, bounds, .. } = rect;
        self.remaining = [[1.0; LANES]; TILE];
        let mut layers = 0;
        for &at in self.forms.iter().rev() {
            let Some(form) = stage.tops.outline(at) else { continue };
            if !form.bounds.overlaps(&bounds) {
                continue;
            }
            form.evaluate(stage.simd, stage.full_tile, middle, mm_per_px, &mut self.edge);
            if self.tops.len() == layers {
                self.tops.push(TopLayer::new());
            }
            let layer = &mut self.tops[layers];
            layer.form = at;
            let opacity = clamp(stage.tops.top(at).finish.opacity, 0.0, 1.0);
            layer.pack(&self.edge, form.bevel_mm(), opacity, mm_per_px as f32, &mut self.remaining);
            layers += usize::from(layer.points.count > 0);
        }
        let hides = |rest: &f32| u32::from(*rest < MIN_COVERAGE);
        let hidden = || self.remaining.iter().map(|row| row.iter().map(hides).sum::<u32>()).sum::<u32>();
        self.whole = layers == 0 || hidden() < AREA as u32 / 8;
        if !self.whole {
            self.floor.count = 0;
            for pixel in 0..AREA {
                if self.remaining[pixel / LANES][pixel % LANES] >= MIN_COVERAGE {
                    self.floor.push_pixel(pixel, mm_per_px as f32);
                }
            }
            self.floor.pad();
        }
        layers
    }
}
