//! The renderer: from a scene to the light that leaves it, or to pixels. It prepares what all tiles share, makes the
//! tiles' caches valid, then the balls that mirror them, then the bloom, then the tiles themselves.

use crate::cache::damage::Damage;
use crate::cache::frame_history::FrameHistory;
use crate::film::bloom::BloomPyramid;
use crate::film::frame_id::FrameId;
use crate::film::tone_map;
use crate::realtime::ball_pass::{blend_balls, render_balls};
use crate::realtime::frame_context::FrameContext;
use crate::realtime::passes::{compose_tiles, render_tiles, tone_map_tiles, update_tiles};
use crate::realtime::prepared_frame::PreparedFrame;
use crate::realtime::schedule::tile_at;
use crate::realtime::tile_renderer::TileRenderer;
use crate::scene::validation::{self, CheckScratch};
use crate::shading::chrome_ball::BallSprite;
use crate::simd::dispatch::SimdLevel;
use crate::tile::planes::RgbTile;
use crate::tile::rect::TileRect;
use crate::{DisplayBuffer, Radiance, RenderStage, Scene, View};
use std::borrow::Cow;

#[cfg(test)]
mod cache_state_tests;

/// Renders scenes in exact direct light. Keep one from frame to frame: it allocates only when a scene has more in it than
/// before.
pub(crate) struct ExactRenderer {
    simd: SimdLevel,
    frame: PreparedFrame,
    history: FrameHistory,
    /// The last frame.
    id: FrameId,
    sprites: Vec<BallSprite>,
    /// The light of uncached frames that are tone-mapped.
    radiance: Radiance,
    /// Room to check a scene in.
    scratch: CheckScratch,
}

impl ExactRenderer {
    /// A renderer on a chosen instruction set: the same bits on each.
    pub fn on(simd: SimdLevel) -> ExactRenderer {
        ExactRenderer {
            simd,
            frame: PreparedFrame::default(),
            history: FrameHistory::default(),
            id: FrameId::of_new_renderer(),
            sprites: Vec::new(),
            radiance: Radiance::default(),
            scratch: CheckScratch::default(),
        }
    }

    /// Renders `scene` with exact shadows, on the threads of the current rayon pool: the same bits on any
    /// number.
    /// What [`Scene::check`] refuses is not drawn; of a view that it refuses there is no picture.
    pub fn render(&mut self, scene: &Scene, radiance: &mut Radiance) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return radiance.resize(0, 0) };
        radiance.resize(scene.view.width, scene.view.height);
        if !self.prepare(scene, radiance.source == Some(self.id)) {
            return self.render_prepared(scene, radiance, TileRenderer::render_uncached);
        }
        self.frame.leave_still_balls();
        self.update(scene, &mut radiance.bloom);
        let frame = self.frame.context(self.simd, scene);
        if self.history.any_redrawn() {
            render_balls(&frame, &mut self.sprites, &mut radiance.bloom);
            radiance.bloom.compute(self.simd);
        }
        compose_tiles(&frame, &self.history.bands, &self.sprites, radiance);
        radiance.source = Some(self.id.advance());
    }

    /// Renders `scene` and tone-maps it in one go: the same pixels, several times as fast, since no tile leaves the
    /// processor's cache in between. Tiles that still show what they should are left as they are. Calls `done` after each
    /// stage.
    pub fn draw_timed(
        &mut self,
        scene: &Scene,
        exposure: f32,
        display: &mut DisplayBuffer,
        done: &mut (dyn FnMut(RenderStage) + Send),
    ) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return display.resize(0, 0) };
        display.resize(scene.view.width, scene.view.height);
        if !self.prepare(scene, display.source == Some((self.id, exposure))) {
            return self.draw_uncached(scene, exposure, display);
        }
        self.frame.leave_still_balls();
        done(RenderStage::Prepared);
        self.update(scene, &mut display.bloom);
        done(RenderStage::Shaded);
        let (frame, redrawn) = (self.frame.context(self.simd, scene), self.history.any_redrawn());
        if redrawn {
            render_balls(&frame, &mut self.sprites, &mut display.bloom);
        }
        done(RenderStage::BallsRendered);
        if redrawn {
            display.bloom.compute(self.simd);
        }
        done(RenderStage::Bloomed);
        if redrawn || display.scissor.is_some() {
            tone_map_tiles(&frame, &mut self.history.bands, &self.sprites, exposure, display);
        }
        done(RenderStage::ToneMapped);
        display.source = Some((self.id.advance(), exposure));
    }

    /// Renders `scene` with nothing cached and nothing quantized: the slow twin of [`ExactRenderer::render`].
    pub fn render_uncached(&mut self, scene: &Scene, radiance: &mut Radiance) {
        self.render_with(scene, radiance, TileRenderer::render_uncached);
    }

    /// Renders `scene` uncached, each tile by `render`.
    pub(crate) fn render_with(
        &mut self,
        scene: &Scene,
        radiance: &mut Radiance,
        render: impl Fn(&mut TileRenderer, &FrameContext, &TileRect, &mut RgbTile) + Sync,
    ) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return radiance.resize(0, 0) };
        self.prepare(scene, false);
        self.render_prepared(scene, radiance, render);
    }

    /// Makes every tile anew in the next frame, with the same bits.
    pub fn invalidate(&mut self) {
        self.history = FrameHistory::default();
        self.frame.damage = Damage::default();
        self.id.advance();
    }

    /// Finds what all tiles share, and what is new; `buffer_is_last` says that the buffer holds the last frame. Whether the
    /// tile caches can be used.
    fn prepare(&mut self, scene: &Scene, buffer_is_last: bool) -> bool {
        self.frame.prepare(self.simd, scene, &mut self.history, buffer_is_last)
    }

    /// Makes the tile caches of a scene that was prepared valid, and the means of what is redrawn.
    fn update(&mut self, scene: &Scene, bloom: &mut BloomPyramid) {
        update_tiles(&self.frame.context(self.simd, scene), &mut self.history.bands, bloom);
        self.frame.lamps.list.iter().for_each(|lamp| self.history.lamp_updated(lamp.slot));
    }

    /// Renders a scene that was prepared, uncached, with its balls and its bloom.
    fn render_prepared(
        &mut self,
        scene: &Scene,
        radiance: &mut Radiance,
        render: impl Fn(&mut TileRenderer, &FrameContext, &TileRect, &mut RgbTile) + Sync,
    ) {
        let frame = self.frame.context(self.simd, scene);
        render_tiles(&frame, radiance, render);
        render_balls(&frame, &mut self.sprites, &mut radiance.bloom);
        radiance.bloom.compute(self.simd);
        blend_balls(&self.sprites, radiance);
        self.invalidate();
    }

    /// Draws a scene that was prepared, uncached.
    fn draw_uncached(&mut self, scene: &Scene, exposure: f32, display: &mut DisplayBuffer) {
        let mut radiance = std::mem::take(&mut self.radiance);
        self.render_prepared(scene, &mut radiance, TileRenderer::render_uncached);
        tone_map::map_on(self.simd, &radiance, exposure, &mut display.frame);
        self.radiance = radiance;
        display.source = None;
    }
}

/// The renderer's frame as a layer of another one: [`crate::realtime::half_resolution::HalfRenderer`] puts frames together from several.
impl ExactRenderer {
    /// Renders `scene` without the balls themselves, though with their shadows, and without bloom: of that, only the
    /// means of cells are written.
    pub(crate) fn render_table(&mut self, scene: &Scene, radiance: &mut Radiance) {
        radiance.resize(scene.view.width, scene.view.height);
        if !self.prepare(scene, radiance.source == Some(self.id)) {
            let frame = self.frame.context(self.simd, scene);
            render_tiles(&frame, radiance, TileRenderer::render_uncached);
            return self.invalidate();
        }
        self.update(scene, &mut radiance.bloom);
        compose_tiles(&self.frame.context(self.simd, scene), &self.history.bands, &[], radiance);
        radiance.source = Some(self.id.advance());
    }

    /// Renders the balls over a table that was rendered, and puts them into its means.
    pub(crate) fn render_balls(&mut self, scene: &Scene, bloom: &mut BloomPyramid) {
        render_balls(&self.frame.context(self.simd, scene), &mut self.sprites, bloom);
    }

    /// The balls of the last frame.
    pub(crate) fn sprites(&self) -> &[BallSprite] {
        &self.sprites
    }

    /// The last frame.
    pub(crate) fn frame_id(&self) -> FrameId {
        self.id
    }

    /// Whether any tile is another than in the frame before. A frame that was not cached has no tiles to tell.
    pub(crate) fn any_redrawn(&self) -> bool {
        self.history.bands.is_empty() || self.history.any_redrawn()
    }

    /// Whether the tile that a pixel is in is another than in the frame before, in a frame of this view.
    pub(crate) fn is_redrawn_at(&self, view: &View, x: usize, y: usize) -> bool {
        let (band, at) = tile_at(view, x, y);
        self.history.bands.get(band).and_then(|band| band.get(at)).is_none_or(|tile| tile.redrawn)
    }
}

/// The scene without what [`Scene::check`] refuses; `None` where its view shows nothing. `scratch` is room to work in.
pub(crate) fn drawable<'a, 'b>(scene: &'b Scene<'a>, scratch: &mut CheckScratch) -> Option<Cow<'b, Scene<'a>>> {
    let empty = scene.view.width == 0 || scene.view.height == 0;
    if empty || validation::wrong_with_view(&scene.view).is_some() {
        return None;
    }
    Some(if scene.check_in(scratch).is_ok() { Cow::Borrowed(scene) } else { Cow::Owned(scene.drawable()) })
}
