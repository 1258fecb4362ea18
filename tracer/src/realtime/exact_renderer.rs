//! From a scene to the light that leaves it: prepares what all tiles share, makes the tiles' memories true on every core,
//! then the balls that mirror them, then the bloom, then the tiles themselves.

use crate::cache::cell_means::{CELLS_PER_TILE, means_of};
use crate::cache::damage::Changes;
use crate::cache::frame_history::Past;
use crate::cache::lamp_set::Numbers;
use crate::cache::tile_cache::{to_be_composed, to_be_lit};
use crate::cache::top_history::TopHistory;
use crate::film::bloom::BloomPyramid;
use crate::film::tone_map;
use crate::realtime::schedule::{BLOCK, each_tile, means_bands, write_means, write_planes};
use crate::realtime::tile_renderer::{Lit, Stage, Workspace};
use crate::scene::validation::{self, CheckScratch};
use crate::shading::albedo_map::AlbedoMap;
use crate::shading::chrome_ball::BallSprite;
use crate::simd::dispatch::{LANES, SimdLevel};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::TILE;
use crate::tile::rect::TileRect;
use crate::visibility::disc_chain::DiscChains;
use crate::visibility::transmission::TintedGroup;
use crate::{DisplayBuffer, Radiance, RenderStage, Rgb, Scene};
use rayon::prelude::*;
use std::borrow::Cow;
use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};

mod balls;
mod layer;
mod prepare;

/// Renders scenes in exact direct light. Keep one from frame to frame: it allocates only when a scene has more in it than
/// before.
pub(crate) struct ExactRenderer {
    simd: SimdLevel,
    disc_chains: DiscChains,
    past: Past,
    changes: Changes,
    /// Its own number, and that of its last picture.
    picture: (u64, u64),
    lamps: Vec<Lit>,
    /// By the lamps' numbers: their light, black for those that do not shine, and their places among those that do.
    colors: Vec<Rgb>,
    places: Vec<usize>,
    /// The lamps of which nothing is remembered.
    lost: Numbers,
    tinted: Vec<TintedGroup>,
    tops: TopHistory,
    full_tile: (f64, PackedSamples),
    ball_sprites: Vec<BallSprite>,
    art: AlbedoMap,
    /// The light of pictures that are made from nothing.
    radiance: Radiance,
    /// Room to check a scene in.
    scratch: CheckScratch,
}

/// What the tiles of a picture have in common.
macro_rules! stage {
    ($renderer:expr, $scene:expr) => {
        Stage {
            simd: $renderer.simd,
            scene: $scene,
            disc_chains: &$renderer.disc_chains,
            lamps: &$renderer.lamps,
            colors: &$renderer.colors,
            places: &$renderer.places,
            lost: &$renderer.lost,
            moved_tops: &$renderer.past.moved_tops,
            changes: &$renderer.changes,
            tinted: &$renderer.tinted,
            tops: &$renderer.tops,
            full_tile: &$renderer.full_tile.1,
            art: &$renderer.art,
        }
    };
}

/// How many renderers there have been: a picture knows by it who drew it.
static RENDERERS: AtomicU64 = AtomicU64::new(0);

thread_local! {
    static WORKSPACE: RefCell<Workspace> = RefCell::new(Workspace::new());
}

impl ExactRenderer {
    /// A renderer on a chosen instruction set: the same bits on each.
    pub fn on(simd: SimdLevel) -> ExactRenderer {
        ExactRenderer {
            simd,
            disc_chains: DiscChains::default(),
            past: Past::default(),
            changes: Changes::default(),
            picture: (RENDERERS.fetch_add(1, Ordering::Relaxed), 0),
            lamps: Vec::new(),
            colors: Vec::new(),
            places: Vec::new(),
            lost: Numbers::default(),
            tinted: Vec::new(),
            tops: TopHistory::default(),
            full_tile: (0.0, PackedSamples::none()),
            ball_sprites: Vec::new(),
            art: AlbedoMap::default(),
            radiance: Radiance::default(),
            scratch: CheckScratch::default(),
        }
    }

    /// Renders `scene` with exact shadows, on the threads of the current rayon pool: the same bits on any number.
    /// What [`Scene::check`] refuses is not drawn; of a view that it refuses there is no picture.
    pub fn render(&mut self, scene: &Scene, radiance: &mut Radiance) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return radiance.resize(0, 0) };
        radiance.resize(scene.view.width, scene.view.height);
        if !self.prepare(scene, radiance.source == Some(self.picture)) {
            return self.render_afresh(scene, true, radiance);
        }
        self.leave_still_balls();
        self.look(scene, &mut radiance.bloom);
        if self.past.is_fresh() {
            self.render_balls(scene, &mut radiance.bloom);
            radiance.bloom.compute(self.simd);
        }
        self.compose(scene, &self.ball_sprites, radiance);
        self.picture.1 += 1;
        radiance.source = Some(self.picture);
    }

    /// Puts together the tiles that are not in `radiance` as they should be.
    fn compose(&self, scene: &Scene, ball_sprites: &[BallSprite], radiance: &mut Radiance) {
        let stride = radiance.stride();
        let [red, green, blue] = &mut radiance.planes;
        let band = stride * BLOCK;
        let bands = red.par_chunks_mut(band).zip(green.par_chunks_mut(band)).zip(blue.par_chunks_mut(band));
        let stage = stage!(self, scene);
        bands.zip(&self.past.bands).enumerate().with_max_len(1).for_each(|(at, (((red, green), blue), memory))| {
            WORKSPACE.with_borrow_mut(|workspace| {
                let mut planes = [red, green, blue];
                each_tile(scene, at, memory.iter(), |rect, memory| {
                    if memory.fresh {
                        workspace.compose(&stage, rect, memory, ball_sprites);
                        write_planes(&workspace.out, rect.x, rect.y - at * BLOCK, stride, &mut planes);
                    }
                });
            });
        });
    }

    /// Renders `scene` and tone-maps it in one go: the same pixels, several times as fast, since no tile leaves the cache in
    /// between. Tiles that still show what they should are left as they are. Calls `done` after each step.
    pub fn draw_watched(
        &mut self,
        scene: &Scene,
        exposure: f32,
        display: &mut DisplayBuffer,
        done: &mut (dyn FnMut(RenderStage) + Send),
    ) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return display.resize(0, 0) };
        display.resize(scene.view.width, scene.view.height);
        let known = display.source == Some((self.picture, exposure));
        if !self.prepare(scene, known) {
            return self.draw_afresh(scene, exposure, display);
        }
        self.leave_still_balls();
        done(RenderStage::Prepared);
        self.look(scene, &mut display.bloom);
        done(RenderStage::Shaded);
        let fresh = self.past.is_fresh();
        if fresh {
            self.render_balls(scene, &mut display.bloom);
        }
        done(RenderStage::Mirrored);
        if fresh {
            display.bloom.compute(self.simd);
        }
        done(RenderStage::Glared);
        if fresh || display.scissor.is_some() {
            self.develop(scene, exposure, display);
        }
        done(RenderStage::Developed);
        self.picture.1 += 1;
        display.source = Some((self.picture, exposure));
    }

    /// Renders `scene` with nothing remembered and nothing rounded to be kept: the slow twin of [`ExactRenderer::render`].
    pub fn render_anew(&mut self, scene: &Scene, radiance: &mut Radiance) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return radiance.resize(0, 0) };
        self.prepare(scene, false);
        self.render_afresh(scene, true, radiance);
    }

    /// Forgets what earlier pictures showed: the next one is found anew from nothing, with the same bits.
    pub fn forget(&mut self) {
        self.past = Past::default();
        self.changes = Changes::default();
        self.picture.1 += 1;
    }

    /// Renders a scene that was prepared, with its balls and its bloom or without them, and forgets it.
    fn render_afresh(&mut self, scene: &Scene, whole: bool, radiance: &mut Radiance) {
        self.render_tiles(scene, radiance, Workspace::render);
        if whole {
            self.put_balls_on(scene, radiance);
        }
        self.forget();
    }

    /// Renders the tiles of a scene that was prepared, without its balls, and their means; `render` makes each tile in
    /// [`Workspace::out`].
    pub(crate) fn render_tiles(
        &self,
        scene: &Scene,
        radiance: &mut Radiance,
        render: impl Fn(&mut Workspace, &Stage, &TileRect) + Sync,
    ) {
        radiance.resize(scene.view.width, scene.view.height);
        radiance.source = None;
        let stride = radiance.stride();
        let [red, green, blue] = &mut radiance.planes;
        let band = stride * BLOCK;
        let bands = red.par_chunks_mut(band).zip(green.par_chunks_mut(band)).zip(blue.par_chunks_mut(band));
        let stage = stage!(self, scene);
        let Some((level, means)) = radiance.bloom.means_mut() else { return };
        bands.zip(means_bands(level, means)).enumerate().with_max_len(1).for_each(
            |(at, (((red, green), blue), mut means))| {
                WORKSPACE.with_borrow_mut(|workspace| {
                    let mut planes = [red, green, blue];
                    let mut found = [[0.0; CELLS_PER_TILE]; 3];
                    let mut block = None;
                    each_tile(scene, at, std::iter::repeat(()), |rect, ()| {
                        workspace.enter_block_at(&stage, rect, &mut block);
                        render(workspace, &stage, rect);
                        let y = rect.y - at * BLOCK;
                        write_planes(&workspace.out, rect.x, y, stride, &mut planes);
                        means_of(stage.simd, &workspace.out, &mut found);
                        write_means(&found, rect.x, y, &level, &mut means);
                    });
                });
            },
        );
    }

    /// Draws a scene that was prepared, and forgets it.
    fn draw_afresh(&mut self, scene: &Scene, exposure: f32, display: &mut DisplayBuffer) {
        let mut radiance = std::mem::take(&mut self.radiance);
        self.render_afresh(scene, true, &mut radiance);
        tone_map::map_on(self.simd, &radiance, exposure, &mut display.frame);
        self.radiance = radiance;
        display.source = None;
    }

    /// Makes every tile's memory true, and takes the means of those that have changed.
    fn look(&mut self, scene: &Scene, bloom: &mut BloomPyramid) {
        let mut bands = std::mem::take(&mut self.past.bands);
        let stage = stage!(self, scene);
        if let Some((level, means)) = bloom.means_mut() {
            bands.par_iter_mut().zip(means_bands(level, means)).enumerate().with_max_len(1).for_each(
                |(at, (memory, mut means))| {
                    WORKSPACE.with_borrow_mut(|workspace| {
                        let mut block = None;
                        each_tile(scene, at, to_be_lit(memory), |rect, memory| {
                            workspace.enter_block_at(&stage, rect, &mut block);
                            memory.fresh = workspace.differs(&stage, rect, memory);
                            if memory.fresh {
                                memory.developed = false;
                                workspace.remember(&stage, rect, memory);
                                write_means(&workspace.means, rect.x, rect.y - at * BLOCK, &level, &mut means);
                            }
                        });
                    });
                },
            );
        }
        self.past.bands = bands;
        self.lamps.iter().for_each(|lit| self.past.looked_at(lit.number));
    }

    /// Puts the tiles on film that are not there as they should be.
    fn develop(&mut self, scene: &Scene, exposure: f32, display: &mut DisplayBuffer) {
        let mut bands = std::mem::take(&mut self.past.bands);
        let stage = stage!(self, scene);
        let (width, simd, ball_sprites, bloom) = (scene.view.width, self.simd, &self.ball_sprites, &display.bloom);
        let scissor = display.scissor;
        let wants = |x, y| DisplayBuffer::in_scissor(scissor, x, y);
        let pixels = display.frame.pixels.par_chunks_mut(width * BLOCK);
        bands.par_iter_mut().zip(pixels).enumerate().with_max_len(1).for_each(|(at, (memory, pixels))| {
            WORKSPACE.with_borrow_mut(|workspace| {
                let mut tile = [[0; LANES]; TILE];
                each_tile(scene, at, to_be_composed(memory), |rect, memory| {
                    memory.developed = memory.developed && !bloom.has_changed_at(rect.x, rect.y);
                    if memory.developed || !wants(rect.x, rect.y) {
                        return;
                    }
                    memory.developed = true;
                    workspace.compose(&stage, rect, memory, ball_sprites);
                    tone_map::tone_map_tile(simd, &workspace.out, bloom, exposure, [rect.x, rect.y], &mut tile);
                    tone_map::store_tile(&tile, rect.x, width, &mut pixels[(rect.y - at * BLOCK) * width..]);
                });
            });
        });
        self.past.bands = bands;
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
