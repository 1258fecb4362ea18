//! Half resolution, for small machines: the lamps' light is found at half the resolution, everything else at the full one.
//!
//! Lamps, their shadows and the light from everywhere are a picture of a quarter of the pixels, brought to the full
//! resolution by [`crate::realtime::joint_upsampling`]. What shines by itself, the balls and the bloom are made at the full resolution, as
//! [`crate::Renderer::draw`] makes them. Its slow twin is that: the same scene, every pixel lit by itself.

use crate::cache::validity::{CachedItem, Event, Validity};
use crate::film::bloom::{BloomPyramid, CELL_PX, MipLevel};
use crate::film::tone_map;
use crate::realtime::exact_renderer::{ExactRenderer, drawable};
use crate::realtime::joint_upsampling::{Guides, UpsampleKernel};
use crate::realtime::schedule::write_planes;
use crate::scene::NO_FLOOR;
use crate::scene::validation::CheckScratch;
use crate::shading::chrome_ball::BallSprite;
use crate::simd::dispatch::{LANES, SimdLevel};
use crate::tile::planes::{BLACK, RgbTile, TILE};
use crate::{DisplayBuffer, Finish, Floor, ItemId, Radiance, RenderStage, Scene, View};
use rayon::prelude::*;

mod lists;

use lists::{Lists, add_lamps};

/// Draws scenes in light of half the resolution. Keep one from frame to frame: it allocates only when a scene has more
/// in it than before.
pub(crate) struct HalfRenderer {
    simd: SimdLevel,
    /// All light but what surfaces have of their own, at half the resolution, without the balls.
    lamps: CachedImage,
    /// Under a white sky: at half the resolution, and at the full one.
    guides: [CachedImage; 2],
    /// Which surface is seen, as a number: at half the resolution, and at the full one.
    surface_ids: [CachedImage; 2],
    /// Light that surfaces have of their own, and glows, at the full resolution.
    emission: CachedImage,
    /// The lists of the images' scenes.
    lists: Lists,
    tiles: Vec<UpsampledTile>,
    /// Room to check a scene in.
    scratch: CheckScratch,
}

/// A tile of the picture.
#[derive(Clone, Debug)]
struct UpsampledTile {
    kernel: UpsampleKernel,
    /// Whether a surface has light of its own.
    has_emission: bool,
    /// The tile in the buffer that it is composed into.
    shown: Validity,
}

/// An image of a part of the scene, cached from frame to frame: only tiles that have changed are rendered again.
struct CachedImage {
    renderer: ExactRenderer,
    radiance: Radiance,
    /// Whether any tile is another than in the frame before.
    redrawn: bool,
}

impl CachedImage {
    fn render(&mut self, scene: &Scene) {
        self.renderer.render_table(scene, &mut self.radiance);
        self.redrawn = self.renderer.any_redrawn();
    }

    /// Renders `scene` with this art, from this view.
    fn render_at<'a>(&mut self, (floor, view): (&'a Floor, View), scene: &mut Scene<'a>) {
        (scene.floor, scene.view) = (floor, view);
        self.render(scene);
    }
}

impl HalfRenderer {
    /// A renderer on a chosen instruction set: the same bits on each.
    pub fn on(simd: SimdLevel) -> HalfRenderer {
        let image = || CachedImage { renderer: ExactRenderer::on(simd), radiance: Radiance::default(), redrawn: true };
        HalfRenderer {
            simd,
            lamps: image(),
            guides: [image(), image()],
            surface_ids: [image(), image()],
            emission: image(),
            lists: Lists::default(),
            tiles: Vec::new(),
            scratch: CheckScratch::default(),
        }
    }

    /// Renders `scene`, whose art at [`View::halved`] is [`Scene::half_floor`], on the threads of the current rayon pool: the same bits on
    /// any number. What [`Scene::check`] refuses is not drawn; of a view that it refuses there is no picture.
    pub fn render(&mut self, scene: &Scene, radiance: &mut Radiance) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return radiance.resize(0, 0) };
        radiance.resize(scene.view.width, scene.view.height);
        let known = radiance.source == Some(self.lamps.renderer.frame_id());
        self.find_light(scene, known, &mut radiance.bloom, &mut |_| {});
        self.compose(radiance);
        radiance.source = Some(self.lamps.renderer.frame_id());
    }

    /// Renders `scene` as [`HalfRenderer::render`] does, and tone-maps it in one go. Calls `done` after each step.
    pub fn draw_timed(
        &mut self,
        scene: &Scene,
        exposure: f32,
        display: &mut DisplayBuffer,
        done: &mut (dyn FnMut(RenderStage) + Send),
    ) {
        let Some(scene) = &drawable(scene, &mut self.scratch) else { return display.resize(0, 0) };
        display.resize(scene.view.width, scene.view.height);
        let known = display.source == Some((self.lamps.renderer.frame_id(), exposure));
        self.find_light(scene, known, &mut display.bloom, done);
        self.tone_map(exposure, display);
        done(RenderStage::ToneMapped);
        display.source = Some((self.lamps.renderer.frame_id(), exposure));
    }

    /// Makes every tile anew in the next frame, as [`crate::Renderer::invalidate`] does.
    pub fn invalidate(&mut self) {
        let HalfRenderer { lamps, guides, surface_ids, emission, .. } = self;
        for image in [lamps, emission].into_iter().chain(guides).chain(surface_ids) {
            image.renderer.invalidate();
        }
    }

    /// Makes every image valid, the balls and the bloom; `known` says that the buffer holds the last frame.
    fn find_light(
        &mut self,
        scene: &Scene,
        known: bool,
        bloom: &mut BloomPyramid,
        done: &mut (dyn FnMut(RenderStage) + Send),
    ) {
        self.render_images(scene, done);
        let changed = self.find_stale(&scene.view, known);
        if changed {
            self.write_means(bloom);
        }
        done(RenderStage::Shaded);
        self.lamps.renderer.render_balls(scene, bloom);
        done(RenderStage::BallsRendered);
        if changed {
            bloom.compute(self.simd);
        }
        done(RenderStage::Bloomed);
    }

    /// Makes every image valid: each is of a scene of its own, with a part of what is in `scene`.
    fn render_images(&mut self, scene: &Scene, done: &mut (dyn FnMut(RenderStage) + Send)) {
        let half_floor = scene.half_floor.unwrap_or(&NO_FLOOR);
        let (full, half) = ((scene.floor, scene.view), (half_floor, scene.view.halved()));
        let mut part = self.lists.surfaces_of(scene);
        self.emission.render(&part);
        part.glows.clear();
        for (top, original) in part.tops.iter_mut().zip(&scene.tops) {
            top.finish = Finish { emission: [surface_id(top.id), 0.0, 0.0], art: false, ..original.finish };
        }
        let [half_surface_ids, full_surface_ids] = &mut self.surface_ids;
        full_surface_ids.render_at(full, &mut part);
        half_surface_ids.render_at(half, &mut part);
        for (top, original) in part.tops.iter_mut().zip(&scene.tops) {
            top.finish = Finish { emission: [0.0; 3], ..original.finish };
        }
        part.ambient = [1.0; 3];
        let [half_guide, full_guide] = &mut self.guides;
        half_guide.render_at(half, &mut part);
        full_guide.render_at(full, &mut part);
        done(RenderStage::Prepared);
        add_lamps(scene, &mut part);
        self.lamps.render_at(half, &mut part);
        self.lists = Lists::of(part);
    }

    /// Finds which tiles have to be composed again; says whether there is any.
    fn find_stale(&mut self, view: &View, known: bool) -> bool {
        let HalfRenderer {
            simd,
            lamps,
            guides: [half_guide, guide],
            surface_ids: [half_surface_ids, surface_ids],
            emission,
            tiles,
            ..
        } = self;
        let (across, down) = (view.width.div_ceil(TILE), view.height.div_ceil(TILE));
        let another = tiles.len() != across * down;
        tiles.resize(
            across * down,
            UpsampledTile { kernel: UpsampleKernel::none(), has_emission: false, shown: Validity::Empty },
        );
        let guides = Guides {
            half_guide: &half_guide.radiance,
            half_surface_ids: &half_surface_ids.radiance,
            guide: &guide.radiance,
            surface_ids: &surface_ids.radiance,
        };
        let half = view.halved();
        let look = |(at, tile): (usize, &mut UpsampledTile)| {
            let (x, y) = (at % across * TILE, at / across * TILE);
            let (left, top) = ((x / 2).saturating_sub(1), (y / 2).saturating_sub(1));
            let (right, bottom) = ((x / 2 + TILE / 2).min(half.width - 1), (y / 2 + TILE / 2).min(half.height - 1));
            let corners = [(left, top), (right, top), (left, bottom), (right, bottom)];
            let is_redrawn = |image: &CachedImage| another || image.redrawn && image.renderer.is_redrawn_at(view, x, y);
            let is_redrawn_around = |image: &CachedImage| {
                image.redrawn && corners.iter().any(|&(x, y)| image.renderer.is_redrawn_at(&half, x, y))
            };
            let surfaces_changed = is_redrawn(guide)
                || is_redrawn(surface_ids)
                || is_redrawn_around(half_guide)
                || is_redrawn_around(half_surface_ids);
            if surfaces_changed {
                tile.kernel.take(*simd, guides, x, y);
            }
            let emission_changed = is_redrawn(emission);
            if emission_changed {
                let mut light = BLACK;
                emission.radiance.read_tile(x, y, &mut light);
                tile.has_emission = light.as_flattened().as_flattened().iter().any(|light| *light > 0.0);
            }
            let redrawn = !known || surfaces_changed || emission_changed || is_redrawn_around(lamps);
            if redrawn {
                tile.shown = Validity::Empty;
            }
            redrawn
        };
        tiles.par_iter_mut().enumerate().with_min_len(across).map(look).reduce(|| false, |a, b| a | b)
    }

    /// The means of the picture's cells: a cell is two half-resolution pixels wide and high.
    fn write_means(&self, bloom: &mut BloomPyramid) {
        let lamps = &self.lamps.radiance;
        let emission = self.emission.radiance.bloom.means();
        let (Some((level, means)), Some((_, emission))) = (bloom.means_mut(), emission) else { return };
        means.into_par_iter().zip(emission).enumerate().for_each(|(channel, (means, emission))| {
            mean_of_four(
                &lamps.planes[channel],
                [lamps.stride(), lamps.height()],
                &level,
                &emission[level.stride..],
                means,
            );
        });
    }

    /// Puts together the tiles that are not in `radiance` as they should be.
    fn compose(&mut self, radiance: &mut Radiance) {
        let (width, stride) = (radiance.width(), radiance.stride());
        let (surfaces, tiles) = (Surfaces::of(self.simd, &self.lamps, &self.emission), &mut self.tiles);
        let [red, green, blue] = &mut radiance.planes;
        let rows = red.par_chunks_mut(stride * TILE).zip(green.par_chunks_mut(stride * TILE));
        let bands = rows.zip(blue.par_chunks_mut(stride * TILE)).zip(tiles.par_chunks_mut(width.div_ceil(TILE)));
        bands.enumerate().for_each(|(band, (((red, green), blue), tiles))| {
            let (mut planes, mut out) = ([red, green, blue], BLACK);
            for (x, tile) in (0..width).step_by(TILE).zip(tiles).filter(|(_, tile)| !tile.shown.is_valid()) {
                tile.shown = Validity::Valid;
                surfaces.compose(tile, x, band * TILE, &mut out);
                write_planes(&out, x, 0, stride, &mut planes);
            }
        });
    }

    /// Tone-maps the tiles that are not on display as they should be.
    fn tone_map(&mut self, exposure: f32, display: &mut DisplayBuffer) {
        let (simd, width, scissor, bloom) = (self.simd, display.frame.width, display.scissor, &display.bloom);
        let (surfaces, tiles) = (Surfaces::of(simd, &self.lamps, &self.emission), &mut self.tiles);
        let bands = display.frame.pixels.par_chunks_mut(width * TILE).zip(tiles.par_chunks_mut(width.div_ceil(TILE)));
        bands.enumerate().for_each(|(band, (pixels, tiles))| {
            let (mut out, mut mapped) = (BLACK, [[0; LANES]; TILE]);
            let y = band * TILE;
            for (x, tile) in (0..width).step_by(TILE).zip(tiles) {
                if tile.shown.is_valid() && bloom.has_changed_at(x, y) {
                    tile.shown = tile.shown.after(CachedItem::Display, Event::BloomChanged);
                }
                if tile.shown.is_valid() || !DisplayBuffer::in_scissor(scissor, x, y) {
                    continue;
                }
                tile.shown = Validity::Valid;
                surfaces.compose(tile, x, y, &mut out);
                tone_map::tone_map_tile(simd, &out, bloom, exposure, [x, y], &mut mapped);
                tone_map::store_tile(&mapped, x, width, pixels);
            }
        });
    }
}

/// What tiles of the full resolution are put together of.
struct Surfaces<'a> {
    simd: SimdLevel,
    light: &'a Radiance,
    emission: &'a Radiance,
    balls: &'a [BallSprite],
}

impl<'a> Surfaces<'a> {
    fn of(simd: SimdLevel, lamps: &'a CachedImage, emission: &'a CachedImage) -> Surfaces<'a> {
        Surfaces { simd, light: &lamps.radiance, emission: &emission.radiance, balls: lamps.renderer.sprites() }
    }

    /// Puts together the tile whose upper left pixel is (`x`, `y`).
    fn compose(&self, tile: &UpsampledTile, x: usize, y: usize, out: &mut RgbTile) {
        tile.kernel.apply(self.simd, self.light, x, y, out);
        if tile.has_emission {
            let mut own = BLACK;
            self.emission.read_tile(x, y, &mut own);
            add(&own, out);
        }
        self.balls.iter().for_each(|ball| ball.blend(x, y, out));
    }
}

fn add(more: &RgbTile, light: &mut RgbTile) {
    for (light, more) in light.as_flattened_mut().iter_mut().zip(more.as_flattened()) {
        for i in 0..LANES {
            light[i] += more[i];
        }
    }
}

/// The surface ids that are told apart; single precision has no finer turns for more.
const SURFACE_IDS: u32 = 4096;

/// What tells a top from the floor, which is 0, and from other tops: from a quarter to 1, far from those of tops of
/// neighbouring ids (multiples of the golden ratio are as far from each other as they can be). Tops whose ids are
/// [`SURFACE_IDS`] apart have the same one: where they meet, light bleeds from one to the other.
fn surface_id(id: ItemId) -> f32 {
    let turns = (id.0 % SURFACE_IDS) as f32 * 0.618_034;
    0.25 + 0.75 * (turns - turns.floor())
}

/// Writes the means of two by two pixels of a plane, and adds what is in `more`.
fn mean_of_four(plane: &[f32], [stride, height]: [usize; 2], level: &MipLevel, more: &[f32], means: &mut [f32]) {
    const { assert!(CELL_PX == 4, "a cell is two half-resolution pixels wide") };
    for row in 0..level.height {
        let line = |row: usize| &plane[row.min(height - 1) * stride..][..stride];
        let (above, below) = (line(2 * row), line(2 * row + 1));
        let start = row * level.stride + 1;
        let (means, more) = (&mut means[start..][..level.width], &more[start..][..level.width]);
        let pairs = above.as_chunks::<2>().0.iter().zip(below.as_chunks::<2>().0);
        for ((mean, more), (above, below)) in means.iter_mut().zip(more).zip(pairs) {
            *mean = ((above[0] + above[1]) + (below[0] + below[1])) * 0.25 + more;
        }
    }
}
