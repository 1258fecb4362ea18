//! A prepared frame: what is found once for a frame, before its tiles. Which lamps shine, what may stand in their way, and
//! what is new since the last frame.

use crate::Scene;
use crate::cache::damage::Damage;
use crate::cache::frame_history::{FrameHistory, MAX_GLOWS, MAX_LAMPS};
use crate::cache::top_history::TopHistory;
use crate::realtime::frame_context::{ActiveLamp, ActiveLamps, FrameContext};
use crate::realtime::schedule::BLOCK;
use crate::shading::albedo_map::AlbedoMap;
use crate::simd::dispatch::SimdLevel;
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::TILE;
use crate::visibility::airborne_shadow::AirborneShadow;
use crate::visibility::disc_chain::DiscChains;
use crate::visibility::shadow_bounds::ShadowBounds;
use crate::visibility::sphere_shadow::occluding_balls;
use crate::visibility::transmission::{self, TintedGroup};
use geometry::Bounds;
use rayon::prelude::*;

/// What all tiles of a frame share. Kept from frame to frame, so that nothing is allocated once it is warm.
pub(crate) struct PreparedFrame {
    pub disc_chains: DiscChains,
    tinted: Vec<TintedGroup>,
    pub lamps: ActiveLamps,
    tops: TopHistory,
    moved_tops: Vec<Bounds>,
    pub damage: Damage,
    full_tile: PackedSamples,
    /// The pixel's size that `full_tile` is of.
    mm_per_px: f64,
    albedo: AlbedoMap,
}

impl Default for PreparedFrame {
    fn default() -> PreparedFrame {
        PreparedFrame {
            disc_chains: DiscChains::default(),
            tinted: Vec::new(),
            lamps: ActiveLamps::default(),
            tops: TopHistory::default(),
            moved_tops: Vec::new(),
            damage: Damage::default(),
            full_tile: PackedSamples::none(),
            mm_per_px: 0.0,
            albedo: AlbedoMap::default(),
        }
    }
}

impl PreparedFrame {
    /// The scene that was prepared, as tiles read it.
    pub fn context<'a>(&'a self, simd: SimdLevel, scene: &'a Scene<'a>) -> FrameContext<'a> {
        FrameContext {
            scene,
            simd,
            disc_chains: &self.disc_chains,
            tinted: &self.tinted,
            lamps: &self.lamps,
            tops: &self.tops,
            moved_tops: &self.moved_tops,
            damage: &self.damage,
            full_tile: &self.full_tile,
            albedo: &self.albedo,
        }
    }

    /// Finds what all tiles share, and what is new since the last frame of `history`; `buffer_is_last` says that the buffer
    /// holds that frame. Whether the tile caches can be used.
    pub fn prepare(
        &mut self,
        simd: SimdLevel,
        scene: &Scene,
        history: &mut FrameHistory,
        buffer_is_last: bool,
    ) -> bool {
        self.disc_chains.set(&scene.occluders);
        transmission::find_tinted(&scene.occluders, &mut self.tinted);
        let bands = scene.view.height.div_ceil(BLOCK);
        let tiles = scene.view.width.div_ceil(TILE) * (BLOCK / TILE);
        history.advance(scene, bands, tiles);
        self.lamps.find(scene, history);
        self.lamps.find_occluders(scene, history, &self.disc_chains);
        let is_cached = self.lamps.list.len() <= MAX_LAMPS && scene.glows.len() <= MAX_GLOWS;
        if is_cached {
            self.lamps.index(history.known.len());
        }
        self.tops.advance(&scene.tops, &mut self.moved_tops, &mut self.damage.relit_tops);
        self.damage.advance(scene, buffer_is_last, |lamp| history.slot(lamp));
        if self.mm_per_px != scene.view.mm_per_px {
            self.mm_per_px = scene.view.mm_per_px;
            self.full_tile = PackedSamples::full_tile(scene.view.mm_per_px);
        }
        if self.damage.art_changed() {
            self.albedo.set(simd, scene);
        }
        is_cached
    }

    /// Leaves balls as they are that lie still where nothing is new: no lamp is lost, and nothing has moved before one.
    pub fn leave_still_balls(&mut self) {
        if self.lamps.list.iter().all(|lamp| lamp.moved_shadows.is_empty() && !lamp.lost) {
            self.damage.leave_still_balls();
        }
    }
}

impl ActiveLamps {
    /// Becomes the lamps of a scene that shine.
    fn find(&mut self, scene: &Scene, history: &mut FrameHistory) {
        let mut count = 0;
        for lamp in scene.lamps.iter().filter(|lamp| lamp.shines()) {
            let slot = history.slot(lamp);
            match self.list.get_mut(count) {
                Some(old) => (old.lamp, old.circle, old.slot) = (*lamp, (lamp.center_mm, lamp.far_mm()), slot),
                None => self.list.push(ActiveLamp::new(lamp, slot)),
            }
            count += 1;
        }
        self.list.truncate(count);
    }

    /// Finds what may be in the way of each, and what has moved there.
    fn find_occluders(&mut self, scene: &Scene, history: &FrameHistory, disc_chains: &DiscChains) {
        self.list.par_iter_mut().for_each(|active| {
            let ActiveLamp { lamp, occluders, airborne, moved, moved_shadows, .. } = active;
            let known = &history.known[active.slot];
            active.lost = known.lost;
            occluders.set(lamp, disc_chains);
            moved.set(&known.moved);
            ShadowBounds::of_all(lamp, moved, moved_shadows);
            airborne.clear();
            airborne.extend(occluding_balls(&scene.balls, lamp, None).map(|ball| AirborneShadow::new(lamp, ball)));
            let moved_balls = occluding_balls(&known.moved_balls, lamp, None);
            moved_shadows.extend(moved_balls.map(|ball| ShadowBounds::of_airborne(lamp, ball)));
        });
    }

    /// Puts down by its slot what is known of each; `count` is how many slots there are.
    fn index(&mut self, count: usize) {
        self.colors.clear();
        self.colors.resize(count, [0.0; 3]);
        self.places.resize(count, 0);
        for (at, ActiveLamp { lamp, slot, .. }) in self.list.iter().enumerate() {
            self.colors[*slot] = lamp.color;
            self.places[*slot] = at;
        }
    }
}
