//! What is found once for a picture, before its tiles: which lamps there are, what may stand in their way, and what is
//! new since the last picture.

use super::ExactRenderer;
use crate::Scene;
use crate::cache::frame_history::{MAX_GLOWS, MAX_LAMPS};
use crate::cache::lamp_set::Numbers;
use crate::realtime::schedule::BLOCK;
use crate::realtime::tile_renderer::Lit;
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::TILE;
use crate::visibility::airborne_shadow::AirborneShadow;
use crate::visibility::shadow_bounds::ShadowBounds;
use crate::visibility::sphere_shadow::occluding_balls;
use crate::visibility::transmission;
use rayon::prelude::*;

impl ExactRenderer {
    /// Finds what all tiles share, and what is new; `known` says that the last picture is there to go on from. Says
    /// whether the tiles' memory can be used.
    pub(crate) fn prepare(&mut self, scene: &Scene, known: bool) -> bool {
        self.disc_chains.set(&scene.occluders);
        transmission::find_tinted(&scene.occluders, &mut self.tinted);
        let bands = scene.view.height.div_ceil(BLOCK);
        let tiles = scene.view.width.div_ceil(TILE) * (BLOCK / TILE);
        self.past.turn_page(scene, bands, tiles);
        let count = self.prepare_lamps(scene);
        let remembered = count <= MAX_LAMPS && scene.glows.len() <= MAX_GLOWS;
        if remembered {
            self.number_lamps();
        }
        self.tops.turn_page(&scene.tops, &mut self.past.moved_tops, &mut self.changes.tops);
        self.changes.turn_page(scene, |lamp| self.past.number(lamp));
        self.lamps.iter().filter(|lit| lit.lost).for_each(|lit| self.changes.flash(&lit.lamp));
        if self.full_tile.0 != scene.view.mm_per_px {
            self.full_tile = (scene.view.mm_per_px, PackedSamples::full_tile(scene.view.mm_per_px));
        }
        if self.changes.repainted {
            self.art.set(self.simd, scene);
        }
        self.changes.everything |= !known;
        remembered
    }

    /// Puts down by its number what is known of each lamp.
    fn number_lamps(&mut self) {
        self.colors.clear();
        self.colors.resize(self.past.known.len(), [0.0; 3]);
        self.places.resize(self.past.known.len(), 0);
        self.lost = Numbers::default();
        for (at, lit) in self.lamps.iter().enumerate() {
            self.colors[lit.number] = lit.lamp.color;
            self.places[lit.number] = at;
            if lit.lost {
                self.lost.insert(lit.number);
            }
        }
    }

    /// Finds what may be in the way of the lamps that shine; says how many there are.
    fn prepare_lamps(&mut self, scene: &Scene) -> usize {
        let mut count = 0;
        for lamp in scene.lamps.iter().filter(|lamp| lamp.shines()) {
            let number = self.past.number(lamp);
            match self.lamps.get_mut(count) {
                Some(lit) => (lit.lamp, lit.circle, lit.number) = (*lamp, (lamp.center_mm, lamp.far_mm()), number),
                None => self.lamps.push(Lit::new(lamp, number)),
            }
            count += 1;
        }
        self.lamps.truncate(count);
        let (disc_chains, known) = (&self.disc_chains, &self.past.known);
        self.lamps.par_iter_mut().for_each(|lit| {
            let known = &known[lit.number];
            lit.lost = known.lost;
            lit.potential_occluders.set(&lit.lamp, disc_chains);
            lit.things.set(&known.moved);
            ShadowBounds::of_all(&lit.lamp, &lit.things, &mut lit.moved);
            lit.airborne.clear();
            lit.airborne.extend(
                occluding_balls(&scene.balls, &lit.lamp, None).map(|ball| AirborneShadow::new(&lit.lamp, ball)),
            );
            let moved_balls = occluding_balls(&known.moved_balls, &lit.lamp, None);
            lit.moved.extend(moved_balls.map(|ball| ShadowBounds::of_airborne(&lit.lamp, ball)));
        });
        count
    }

    pub(super) fn leave_still_balls(&mut self) {
        if self.lamps.iter().all(|lit| lit.moved.is_empty()) {
            self.changes.leave_still_balls();
        }
    }
}
