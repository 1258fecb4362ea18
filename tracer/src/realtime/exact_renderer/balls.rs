//! The balls of a picture: they mirror the table, so they come when it is lit.

use super::ExactRenderer;
use crate::film::bloom::BloomPyramid;
use crate::realtime::schedule::write_planes;
use crate::shading::chrome_ball::{BallSprite, TableImage};
use crate::tile::planes::BLACK;
use crate::{Radiance, Scene};
use rayon::prelude::*;

impl ExactRenderer {
    /// Renders the balls of a scene that was prepared, and puts them into the means.
    pub(crate) fn render_balls(&mut self, scene: &Scene, bloom: &mut BloomPyramid) {
        self.ball_sprites.resize_with(scene.balls.len(), BallSprite::default);
        self.ball_sprites.truncate(scene.balls.len());
        if let Some((level, planes)) = bloom.means() {
            let table =
                TableImage { view: &scene.view, level, planes, ambient: scene.ambient, overhangs: &scene.overhangs };
            let (simd, lamps, all, tinted) = (self.simd, &self.lamps, &self.disc_chains, &self.tinted);
            self.ball_sprites.par_iter_mut().zip(&scene.balls).for_each(|(sprite, ball)| {
                let lamps = lamps.iter().map(|lit| (&lit.lamp, &lit.potential_occluders));
                sprite.find_highlights(simd, ball, lamps, tinted, all);
                sprite.render(ball, table);
            });
        }
        if let Some((level, mut planes)) = bloom.means_mut() {
            for sprite in &self.ball_sprites {
                sprite.blend_means(&level, planes.each_mut().map(|plane| &mut **plane));
            }
        }
    }

    /// Renders the balls of a scene whose light is in `radiance`, and takes the bloom.
    pub(crate) fn put_balls_on(&mut self, scene: &Scene, radiance: &mut Radiance) {
        let stride = radiance.stride();
        self.render_balls(scene, &mut radiance.bloom);
        radiance.bloom.compute(self.simd);
        for sprite in &self.ball_sprites {
            for (x, y) in sprite.tiles() {
                let mut tile = BLACK;
                radiance.read_tile(x, y, &mut tile);
                sprite.blend(x, y, &mut tile);
                let [red, green, blue] = &mut radiance.planes;
                write_planes(&tile, x, y, stride, &mut [red, green, blue]);
            }
        }
    }
}
