//! A renderer's picture as a layer of another one: [`crate::realtime::half_resolution::HalfRenderer`] puts pictures together from several.

use super::ExactRenderer;
use crate::realtime::schedule::BLOCK;
use crate::shading::chrome_ball::BallSprite;
use crate::tile::planes::TILE;
use crate::{Radiance, Scene, View};

impl ExactRenderer {
    /// Renders `scene` without the balls themselves, though with their shadows, and without bloom: of that, only the
    /// picture's means are taken.
    pub(crate) fn render_table(&mut self, scene: &Scene, radiance: &mut Radiance) {
        radiance.resize(scene.view.width, scene.view.height);
        if !self.prepare(scene, radiance.source == Some(self.picture)) {
            return self.render_afresh(scene, false, radiance);
        }
        self.look(scene, &mut radiance.bloom);
        self.compose(scene, &[], radiance);
        self.picture.1 += 1;
        radiance.source = Some(self.picture);
    }

    /// Its own number, and that of its last picture.
    pub(crate) fn picture(&self) -> (u64, u64) {
        self.picture
    }

    /// The balls of the last picture.
    pub(crate) fn ball_sprites(&self) -> &[BallSprite] {
        &self.ball_sprites
    }

    /// Whether any tile is another than in the picture before.
    pub(crate) fn is_fresh(&self) -> bool {
        // A picture that was made from nothing has no memory.
        self.past.bands.is_empty() || self.past.is_fresh()
    }

    /// Whether the tile that a pixel is in is another than in the picture before, in a picture of this view.
    pub(crate) fn is_fresh_at(&self, view: &View, x: usize, y: usize) -> bool {
        let (band, block) = (y / BLOCK, x / BLOCK);
        let tiles = |from: usize, end: usize| (end.min(from + BLOCK) - from).div_ceil(TILE);
        let (rows, columns) = (tiles(band * BLOCK, view.height), tiles(block * BLOCK, view.width));
        let at = block * (BLOCK / TILE) * rows + y % BLOCK / TILE * columns + x % BLOCK / TILE;
        self.past.bands.get(band).and_then(|band| band.get(at)).is_none_or(|tile| tile.fresh)
    }
}
