//! The passes of a frame: each goes through all tiles, band by band, on every core.
//!
//! Cached: update the tiles' caches and the means of their cells; then, when balls and bloom are there, compose the tiles
//! into radiance, or compose and tone-map them in one go. Uncached: render every tile.

use crate::cache::cell_means::{CELLS_PER_TILE, means_of};
use crate::cache::tile_cache::{TileCache, to_compose, to_update};
use crate::cache::validity::Event;
use crate::film::bloom::BloomPyramid;
use crate::film::tone_map::{store_tile, tone_map_tile};
use crate::realtime::frame_context::FrameContext;
use crate::realtime::schedule::{BLOCK, each_tile, means_bands, write_means, write_planes};
use crate::realtime::tile_renderer::{TileRenderer, compose};
use crate::shading::chrome_ball::BallSprite;
use crate::simd::dispatch::LANES;
use crate::tile::planes::{BLACK, RgbTile, TILE};
use crate::tile::rect::TileRect;
use crate::{DisplayBuffer, Radiance};
use rayon::prelude::*;
use std::cell::RefCell;

thread_local! {
    static TILE_RENDERER: RefCell<TileRenderer> = RefCell::new(TileRenderer::new());
}

/// Calls `work` with this thread's tile renderer, which is in no block.
fn with_tile_renderer(work: impl FnOnce(&mut TileRenderer)) {
    TILE_RENDERER.with_borrow_mut(|renderer| {
        renderer.block.leave();
        work(renderer);
    });
}

/// Makes every tile's cache valid, and writes the means of those tiles that are redrawn.
pub(crate) fn update_tiles(frame: &FrameContext, bands: &mut [Vec<TileCache>], bloom: &mut BloomPyramid) {
    let Some((level, means)) = bloom.means_mut() else { return };
    let bands = bands.par_iter_mut().zip(means_bands(level, means));
    bands.enumerate().with_max_len(1).for_each(|(at, (caches, mut means))| {
        with_tile_renderer(|renderer| {
            each_tile(frame.scene, at, to_update(caches), |rect, cache| {
                renderer.block.enter(frame, rect);
                cache.redrawn = renderer.block.apply_damage(frame, rect, cache);
                if cache.redrawn {
                    let found = renderer.update(frame, rect, cache);
                    write_means(&found, rect.x, rect.y - at * BLOCK, &level, &mut means);
                }
            });
        });
    });
}

/// Composes the redrawn tiles of valid caches into `radiance`.
pub(crate) fn compose_tiles(
    frame: &FrameContext,
    bands: &[Vec<TileCache>],
    sprites: &[BallSprite],
    radiance: &mut Radiance,
) {
    let stride = radiance.stride();
    let [red, green, blue] = &mut radiance.planes;
    let band = stride * BLOCK;
    let rows = red.par_chunks_mut(band).zip(green.par_chunks_mut(band)).zip(blue.par_chunks_mut(band));
    rows.zip(bands).enumerate().with_max_len(1).for_each(|(at, (((red, green), blue), caches))| {
        let (mut planes, mut tile) = ([red, green, blue], BLACK);
        each_tile(frame.scene, at, caches.iter(), |rect, cache| {
            if cache.redrawn {
                compose(frame, rect, cache, sprites, &mut tile);
                write_planes(&tile, rect.x, rect.y - at * BLOCK, stride, &mut planes);
            }
        });
    });
}

/// Composes and tone-maps the tiles of valid caches that `display` does not show as they should be: no tile leaves the
/// processor's cache in between.
pub(crate) fn tone_map_tiles(
    frame: &FrameContext,
    bands: &mut [Vec<TileCache>],
    sprites: &[BallSprite],
    exposure: f32,
    display: &mut DisplayBuffer,
) {
    let (width, scissor, bloom) = (frame.scene.view.width, display.scissor, &display.bloom);
    let pixels = display.frame.pixels.par_chunks_mut(width * BLOCK);
    bands.par_iter_mut().zip(pixels).enumerate().with_max_len(1).for_each(|(at, (caches, pixels))| {
        let (mut tile, mut mapped) = (BLACK, [[0; LANES]; TILE]);
        each_tile(frame.scene, at, to_compose(caches), |&rect, cache| {
            let TileRect { x, y, .. } = rect;
            if cache.display().is_valid() && bloom.has_changed_at(x, y) {
                cache.apply(Event::BloomChanged);
            }
            if cache.display().is_valid() || !DisplayBuffer::in_scissor(scissor, x, y) {
                return;
            }
            cache.presented();
            compose(frame, &rect, cache, sprites, &mut tile);
            tone_map_tile(frame.simd, &tile, bloom, exposure, [x, y], &mut mapped);
            store_tile(&mapped, x, width, &mut pixels[(y - at * BLOCK) * width..]);
        });
    });
}

/// Renders every tile with `render`, without balls, and writes the means of its cells.
pub(crate) fn render_tiles(
    frame: &FrameContext,
    radiance: &mut Radiance,
    render: impl Fn(&mut TileRenderer, &FrameContext, &TileRect, &mut RgbTile) + Sync,
) {
    radiance.resize(frame.scene.view.width, frame.scene.view.height);
    radiance.source = None;
    let stride = radiance.stride();
    let [red, green, blue] = &mut radiance.planes;
    let band = stride * BLOCK;
    let rows = red.par_chunks_mut(band).zip(green.par_chunks_mut(band)).zip(blue.par_chunks_mut(band));
    let Some((level, means)) = radiance.bloom.means_mut() else { return };
    let bands = rows.zip(means_bands(level, means));
    bands.enumerate().with_max_len(1).for_each(|(at, (((red, green), blue), mut means))| {
        with_tile_renderer(|renderer| {
            let (mut planes, mut tile) = ([red, green, blue], BLACK);
            let mut found = [[0.0; CELLS_PER_TILE]; 3];
            each_tile(frame.scene, at, std::iter::repeat(()), |rect, ()| {
                renderer.block.enter(frame, rect);
                render(renderer, frame, rect, &mut tile);
                let y = rect.y - at * BLOCK;
                write_planes(&tile, rect.x, y, stride, &mut planes);
                means_of(frame.simd, &tile, &mut found);
                write_means(&found, rect.x, y, &level, &mut means);
            });
        });
    });
}
