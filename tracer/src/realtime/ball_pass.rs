//! The balls of a frame: they mirror the table, so they come when it is lit.

use crate::Radiance;
use crate::film::bloom::BloomPyramid;
use crate::realtime::frame_context::FrameContext;
use crate::realtime::schedule::write_planes;
use crate::shading::chrome_ball::{BallSprite, TableImage};
use crate::tile::planes::BLACK;
use rayon::prelude::*;

/// Renders the balls over the means of the table's cells, and puts them into these.
pub(crate) fn render_balls(frame: &FrameContext, sprites: &mut Vec<BallSprite>, bloom: &mut BloomPyramid) {
    let scene = frame.scene;
    sprites.resize_with(scene.balls.len(), BallSprite::default);
    if let Some((level, planes)) = bloom.means() {
        let (view, ambient, overhangs) = (&scene.view, scene.ambient, scene.overhangs.as_slice());
        let table = TableImage { view, level, planes, ambient, overhangs };
        sprites.par_iter_mut().zip(&scene.balls).for_each(|(sprite, ball)| {
            let lamps = frame.lamps.list.iter().map(|active| (&active.lamp, &active.occluders));
            sprite.find_highlights(frame.simd, ball, lamps, frame.tinted, frame.disc_chains);
            sprite.render(ball, table);
        });
    }
    if let Some((level, mut planes)) = bloom.means_mut() {
        for sprite in sprites.iter() {
            sprite.blend_means(&level, planes.each_mut().map(|plane| &mut **plane));
        }
    }
}

/// Blends balls over a picture of the table.
pub(crate) fn blend_balls(sprites: &[BallSprite], radiance: &mut Radiance) {
    let stride = radiance.stride();
    for sprite in sprites {
        for (x, y) in sprite.tiles() {
            let mut tile = BLACK;
            radiance.read_tile(x, y, &mut tile);
            sprite.blend(x, y, &mut tile);
            let [red, green, blue] = &mut radiance.planes;
            write_planes(&tile, x, y, stride, &mut [red, green, blue]);
        }
    }
}
