//! The tile renderer: the passes that make one tile. Each takes the frame context, where the tile is and what it works
//! on, and returns what it finds; planes are written where the caller says.
//!
//! Lamps are the outer loop: what stands between a lamp and the tile is found once, and serves the floor and every top
//! in the tile.

use crate::cache::cached_g_buffer::CachedGBuffer;
use crate::cache::cell_means::{TileMeans, means_of};
use crate::cache::lamp_layer::{FloorLight, WeightedSlot};
use crate::cache::tile_cache::{Illumination, TileCache};
use crate::realtime::ambient_light::{shade_ambient, shade_glow};
use crate::realtime::block_context::BlockContext;
use crate::realtime::contact_shadow::{has_contacts, shade_contacts};
use crate::realtime::direct_light::{LampLight, LampOnTile, LightScratch, LitResult, add};
use crate::realtime::frame_context::FrameContext;
use crate::realtime::g_buffer::GBuffer;
use crate::shading::chrome_ball::BallSprite;
use crate::tile::planes::{ALL_ROWS, BLACK, FULLY_VISIBLE, RgbTile, RowMask};
use crate::tile::rect::TileRect;
use crate::visibility::blockers::VisibilityClass;

/// The scratch that one thread makes tiles with; kept, so that nothing is allocated once it is warm.
pub(crate) struct TileRenderer {
    /// What the tile's block has found out.
    pub block: BlockContext,
    /// The tile's surfaces.
    pub g_buffer: GBuffer,
    /// The tile in the light of one lamp.
    pub light: LampLight,
    /// Scratch for that.
    pub scratch: LightScratch,
    /// A tile's light that no lamp gives, or its sum.
    radiance: RgbTile,
    /// The slots of the lamps, and the places of the glows, whose layers have to be made anew.
    lamps_to_make: Vec<usize>,
    glows_to_make: Vec<usize>,
    /// The planes that a tile's sum is made of.
    weighted: Vec<WeightedSlot>,
}

impl TileRenderer {
    /// Nothing yet.
    pub fn new() -> TileRenderer {
        TileRenderer {
            block: BlockContext::default(),
            g_buffer: GBuffer::new(),
            light: LampLight::new(),
            scratch: LightScratch::new(),
            radiance: BLACK,
            lamps_to_make: Vec::new(),
            glows_to_make: Vec::new(),
            weighted: Vec::new(),
        }
    }

    /// Makes anew what is not valid in a tile's cache, and sets the weights of its sum; the means of the sum's cells.
    pub fn update(&mut self, frame: &FrameContext, rect: &TileRect, cache: &mut TileCache) -> TileMeans {
        self.block.gather(frame);
        self.find_out_of_date(frame, rect, cache);
        let makes_base = !cache.base().is_valid();
        if makes_base || !self.lamps_to_make.is_empty() || !self.glows_to_make.is_empty() {
            self.g_buffer.fetch(frame, rect, self.block.tops(), &mut cache.g_buffer);
        }
        if makes_base {
            self.update_base(frame, rect, cache);
        }
        for index in 0..self.lamps_to_make.len() {
            let at = frame.lamps.places[self.lamps_to_make[index]];
            self.update_lamp(frame, at, rect, cache);
        }
        for &at in &self.glows_to_make {
            let glow = &frame.scene.glows[at];
            shade_glow(&self.g_buffer, rect, glow.mask, &mut self.radiance);
            rect.clamp_to_edge(&mut self.radiance.each_mut());
            cache.keep_glow(glow.key(), frame.simd, &self.radiance);
        }
        self.weigh(frame, rect, cache)
    }

    /// Finds the layers that are out of date. One of a lamp whose light does not come here is dark without a look.
    fn find_out_of_date(&mut self, frame: &FrameContext, rect: &TileRect, cache: &mut TileCache) {
        let lamps = frame.lamps;
        self.lamps_to_make.clear();
        self.lamps_to_make.extend(cache.out_of_date(self.block.reaching()));
        self.lamps_to_make.retain(|&slot| {
            let lamp = &lamps.list[lamps.places[slot]];
            let reached = rect.is_reached_by(&lamp.lamp);
            if !reached {
                cache.keep_dark(slot, None);
            }
            reached
        });
        self.glows_to_make.clear();
        for (at, glow) in frame.scene.glows.iter().enumerate() {
            if rect.overlaps_mask(glow.mask) && !cache.glow(glow.key()).is_valid() {
                self.glows_to_make.push(at);
            }
        }
    }

    /// Makes the base layer anew: of bare floor its albedo is enough, whatever the ambient light.
    fn update_base(&mut self, frame: &FrameContext, rect: &TileRect, cache: &mut TileCache) {
        if self.g_buffer.tops().is_empty() {
            return cache.keep_floor_base(frame.simd, &self.g_buffer.floor.albedo);
        }
        shade_ambient(frame, &self.g_buffer, &mut self.scratch.packed, &mut self.radiance);
        rect.clamp_to_edge(&mut self.radiance.each_mut());
        cache.keep_base(frame.simd, &self.radiance);
    }

    /// Makes anew what is not valid of the tile in the light of one lamp.
    fn update_lamp(&mut self, frame: &FrameContext, at: usize, rect: &TileRect, cache: &mut TileCache) {
        let TileRenderer { block, g_buffer, light, scratch, .. } = self;
        let lamp = &frame.lamps.list[at];
        // Beyond the picture's edge rows are repeated.
        let mut rows = if rect.is_unclipped() { cache.lamp(lamp.slot).rows_to_make() } else { ALL_ROWS };
        let on_tile = LampOnTile::new(frame, lamp, rect, g_buffer);
        let occluders = block.occluders(frame, at, rect);
        let mut lit = on_tile.light(occluders, rows, scratch, light);
        let changes_format = match lit {
            LitResult::Nothing { .. } => false,
            LitResult::Floor(_) => cache.changes_format(lamp.slot, false),
            LitResult::Rgb => cache.changes_format(lamp.slot, true),
        };
        if changes_format && rows != ALL_ROWS {
            rows = ALL_ROWS;
            lit = on_tile.light(occluders, rows, scratch, light);
        }
        if lit == LitResult::Rgb && (changes_format || !cache.lamp(lamp.slot).has_step) {
            cache.set_step(lamp.slot, on_tile.unoccluded_step(scratch, light));
        }
        store_lamp(frame, &on_tile, (lit, rows), light, cache);
    }

    /// Weighs the layers of a tile whose cache is valid by the colours of their light; the means of the sum's cells.
    fn weigh(&mut self, frame: &FrameContext, rect: &TileRect, cache: &mut TileCache) -> TileMeans {
        let shaded = has_contacts(frame, rect);
        let light = Illumination { ambient: frame.scene.ambient, shaded, lamps: &frame.lamps.colors };
        let mut means = cache.weigh(frame.simd, &light, frame.glows(), &mut self.weighted);
        if shaded {
            compose(frame, rect, cache, &[], &mut self.radiance);
            means_of(frame.simd, &self.radiance, &mut means);
        }
        means
    }

    /// The tile under all lamps, with nothing cached and nothing quantized.
    pub fn render_uncached(&mut self, frame: &FrameContext, rect: &TileRect, out: &mut RgbTile) {
        self.render_unlit(frame, rect, out);
        for index in 0..self.block.lamps().len() {
            let at = self.block.lamps()[index];
            let TileRenderer { block, g_buffer, light, scratch, .. } = self;
            let lamp = &frame.lamps.list[at];
            if !rect.is_reached_by(&lamp.lamp) {
                continue;
            }
            let on_tile = LampOnTile::new(frame, lamp, rect, g_buffer);
            match on_tile.light(block.occluders(frame, at, rect), ALL_ROWS, scratch, light) {
                LitResult::Nothing { .. } => continue,
                LitResult::Floor(class) => shade_bare_floor(&on_tile, class, scratch, light),
                LitResult::Rgb => {}
            }
            add(&light.radiance, lamp.lamp.color, out);
        }
        self.render_glows(frame, rect, out);
    }

    /// The tile in ambient light, with its surfaces in [`TileRenderer::g_buffer`].
    pub fn render_unlit(&mut self, frame: &FrameContext, rect: &TileRect, out: &mut RgbTile) {
        self.block.gather(frame);
        self.g_buffer.fetch(frame, rect, self.block.tops(), &mut CachedGBuffer::default());
        shade_ambient(frame, &self.g_buffer, &mut self.scratch.packed, out);
        shade_contacts(frame, rect, out);
    }

    /// Adds the light of glows: the last of an uncached tile.
    pub fn render_glows(&mut self, frame: &FrameContext, rect: &TileRect, out: &mut RgbTile) {
        for glow in frame.scene.glows.iter().filter(|glow| rect.overlaps_mask(glow.mask)) {
            shade_glow(&self.g_buffer, rect, glow.mask, &mut self.radiance);
            add(&self.radiance, glow.color, out);
        }
        rect.clamp_to_edge(&mut out.each_mut());
    }
}

/// Stores some rows of a tile in the light of one lamp.
fn store_lamp(
    frame: &FrameContext,
    on_tile: &LampOnTile,
    (lit, rows): (LitResult, RowMask),
    light: &mut LampLight,
    cache: &mut TileCache,
) {
    let (slot, rect, simd) = (on_tile.lamp.slot, on_tile.rect, frame.simd);
    match lit {
        LitResult::Nothing { hidden_by } => cache.keep_dark(slot, hidden_by),
        LitResult::Floor(class) => {
            let LampLight { irradiance, specular, visibility, .. } = light;
            rect.clamp_to_edge(&mut [&mut *irradiance, specular, visibility]);
            let visibility = if class == VisibilityClass::Lit { &FULLY_VISIBLE } else { &*visibility };
            let floor = FloorLight { albedo: &on_tile.g_buffer.floor.albedo, irradiance, specular, visibility };
            cache.keep_floor(slot, simd, &floor, rows);
        }
        LitResult::Rgb => {
            rect.clamp_to_edge(&mut light.radiance.each_mut());
            cache.keep_rgb(slot, simd, &light.radiance, rows);
        }
    }
}

/// Makes the radiance of a tile of bare floor from the floor's planes.
fn shade_bare_floor(on_tile: &LampOnTile, class: VisibilityClass, scratch: &mut LightScratch, light: &mut LampLight) {
    if class == VisibilityClass::Partial {
        on_tile.apply_floor_visibility(ALL_ROWS, light);
    }
    let LampLight { irradiance, specular, radiance, .. } = light;
    *radiance = BLACK;
    on_tile.shade_floor(ALL_ROWS, [irradiance, specular], &mut scratch.packed, radiance);
}

/// Puts together what a tile whose cache is valid shows, with the balls over it.
pub(crate) fn compose(
    frame: &FrameContext,
    rect: &TileRect,
    cache: &TileCache,
    sprites: &[BallSprite],
    out: &mut RgbTile,
) {
    let albedo = frame.albedo.tile(rect.x, rect.y);
    let shade = has_contacts(frame, rect).then_some(|out: &mut RgbTile| shade_contacts(frame, rect, out));
    cache.compose(frame.simd, albedo, shade, out);
    for sprite in sprites {
        sprite.blend(rect.x, rect.y, out);
    }
}
