//! The balls of a picture: they mirror the table, so they come when it is lit.

use super::Renderer;
use crate::film::bloom::BloomPyramid;
use crate::realtime::schedule::write_planes;
use crate::shading::chrome_ball::{BallSprite, TableImage};
use crate::shading::surface::BLACK;
use crate::{Radiance, Scene};
use rayon::prelude::*;

impl Renderer {
    /// Renders the balls of a scene that was prepared, and puts them into the means.
    pub(crate) fn render_balls(&mut self, scene: &Scene, bloom: &mut BloomPyramid) {
        self.patches.resize_with(scene.balls.len(), BallSprite::default);
        self.patches.truncate(scene.balls.len());
        if let Some((level, planes)) = bloom.means() {
            let table =
                TableImage { view: &scene.view, level, planes, ambient: scene.ambient, overhangs: &scene.overhangs };
            let (simd, lamps, all) = (self.simd, &self.lamps, &self.disc_chains);
            self.patches.par_iter_mut().zip(&scene.balls).for_each(|(patch, ball)| {
                let lamps = lamps.iter().map(|lit| (&lit.lamp, &lit.potential_occluders));
                patch.look(simd, ball, lamps, &scene.filters, all);
                patch.render(ball, table);
            });
        }
        if let Some((level, mut planes)) = bloom.means_mut() {
            for patch in &self.patches {
                patch.blend_means(&level, planes.each_mut().map(|plane| &mut **plane));
            }
        }
    }

    /// Renders the balls of a scene whose light is in `radiance`, and takes the bloom.
    pub(super) fn put_balls_on(&mut self, scene: &Scene, radiance: &mut Radiance) {
        let stride = radiance.stride();
        self.render_balls(scene, &mut radiance.bloom);
        radiance.bloom.gather(self.simd);
        for patch in &self.patches {
            for (x, y) in patch.tiles() {
                let mut tile = BLACK;
                radiance.read_tile(x, y, &mut tile);
                patch.blend(x, y, &mut tile);
                let [red, green, blue] = &mut radiance.planes;
                write_planes(&tile, x, y, stride, &mut [red, green, blue]);
            }
        }
    }
}
