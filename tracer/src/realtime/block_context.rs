//! The block context: what a block of 2 x 2 tiles finds out once about its neighbourhood, for all of its tiles.
//!
//! Occluders are narrowed from a lamp's to a block's to a tile's; a block's lists make a tile's short.

use crate::cache::damage::{BlockDamage, DAMAGE_MARGIN_MM, is_near};
use crate::cache::lamp_set::LampSet;
use crate::cache::tile_cache::TileCache;
use crate::cache::validity::Event;
use crate::realtime::frame_context::{ActiveLamp, FrameContext};
use crate::realtime::schedule::BLOCK;
use crate::tile::rect::TileRect;
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::shadow_bounds::ShadowBounds;
use crate::visibility::shaft::Shaft;
use geometry::{Bounds, DVec2};
use std::f64::consts::SQRT_2;

/// The lists of one block. Kept from block to block, so that nothing is allocated once they are warm.
#[derive(Default)]
pub(crate) struct BlockContext {
    /// The upper left pixel of the block that the lists are of.
    corner: Option<(usize, usize)>,
    middle_mm: DVec2,
    /// From its middle to its corners, mm.
    radius_mm: f64,
    damage: BlockDamage,
    /// By the active lamps' places: where the shadows of what moved may fall in the block.
    moved_shadows: Vec<Vec<ShadowBounds>>,
    /// The places of the active lamps for which there are any, and of those that are lost.
    moved_lamps: Vec<usize>,
    lost_lamps: Vec<usize>,
    lists: Lists,
}

/// What only tiles that are made anew need.
#[derive(Default)]
struct Lists {
    /// Whether they are of this block.
    gathered: bool,
    /// The slots of the tops in the block, from the lowest to the highest.
    tops: Vec<usize>,
    /// The lamps that reach the block: their places among the active ones, and their slots.
    lamps: Vec<usize>,
    reaching: LampSet,
    /// By the active lamps' places: what may stand between the lamp and the block, where that was asked.
    occluders: Vec<PotentialOccluders>,
    narrowed: Vec<bool>,
}

impl BlockContext {
    /// Forgets which block the lists are of: the next tile may be of another frame.
    pub fn leave(&mut self) {
        self.corner = None;
    }

    /// Finds the damage of the block that the tile is in, unless the last tile was in the same one.
    pub fn enter(&mut self, frame: &FrameContext, rect: &TileRect) {
        let corner = (rect.x / BLOCK * BLOCK, rect.y / BLOCK * BLOCK);
        if self.corner == Some(corner) {
            return;
        }
        self.corner = Some(corner);
        self.lists.gathered = false;
        let view = &frame.scene.view;
        let half = BLOCK as f64 * 0.5 * view.mm_per_px;
        let corner_mm = view.origin_mm + DVec2::new(corner.0 as f64, corner.1 as f64) * view.mm_per_px;
        self.middle_mm = corner_mm + DVec2::splat(half);
        self.radius_mm = half * SQRT_2;
        frame.damage.within(self.middle_mm, self.radius_mm, frame.moved_tops, &mut self.damage);
        self.find_lamps(frame, half);
    }

    fn find_lamps(&mut self, frame: &FrameContext, half_mm: f64) {
        grow(&mut self.moved_shadows, frame.lamps.list.len());
        self.moved_lamps.clear();
        self.lost_lamps.clear();
        for (at, ActiveLamp { circle, moved_shadows, lost, .. }) in frame.lamps.list.iter().enumerate() {
            if *lost && is_near(circle, self.middle_mm, self.radius_mm + DAMAGE_MARGIN_MM) {
                self.lost_lamps.push(at);
            }
            if moved_shadows.is_empty() || !is_near(circle, self.middle_mm, self.radius_mm) {
                continue;
            }
            let reaching = moved_shadows.iter().filter(|bounds| bounds.may_reach(self.middle_mm, half_mm));
            self.moved_shadows[at].clear();
            self.moved_shadows[at].extend(reaching);
            if !self.moved_shadows[at].is_empty() {
                self.moved_lamps.push(at);
            }
        }
    }

    /// Tells a tile's cache of every event that reaches the tile; says whether the tile may look different from the last
    /// frame's.
    pub fn apply_damage(&self, frame: &FrameContext, rect: &TileRect, cache: &mut TileCache) -> bool {
        let mut redraw = self.damage.apply(rect, cache);
        for ActiveLamp { lamp, slot, .. } in self.lost_lamps.iter().map(|&at| &frame.lamps.list[at]) {
            if rect.is_reached_by(lamp) {
                cache.apply_to_lamp(*slot, Event::LampLost);
                redraw = true;
            }
        }
        for &at in &self.moved_lamps {
            let ActiveLamp { lamp, slot, .. } = &frame.lamps.list[at];
            let (layer, shadows) = (*cache.lamp(*slot), &self.moved_shadows[at]);
            // What one group hides stays hidden while that group stands still.
            let hidden = layer.hidden_by.is_some_and(|group| shadows.iter().all(|bounds| bounds.group != group));
            if layer.validity.is_empty() || hidden || !rect.is_reached_by(lamp) {
                continue;
            }
            let reaching = shadows.iter().filter(|bounds| bounds.may_reach(rect.middle_mm, rect.half_mm));
            let rows = reaching.fold(0, |rows, bounds| rows | bounds.rows(rect, frame.scene.view.mm_per_px));
            if rows != 0 || !layer.validity.is_valid() {
                cache.apply_to_lamp(*slot, Event::OccluderMoved(rows));
                redraw = true;
            }
        }
        redraw
    }

    /// Finds what all tiles of the block that are made anew have in common, once.
    pub fn gather(&mut self, frame: &FrameContext) {
        let BlockContext { middle_mm, radius_mm, lists, .. } = self;
        if lists.gathered {
            return;
        }
        lists.gathered = true;
        let half = *radius_mm / SQRT_2;
        let bounds = Bounds::of(*middle_mm, *middle_mm).grown(half + 2.0 * frame.scene.view.mm_per_px);
        lists.tops.clear();
        let overlaps = |&slot: &usize| frame.tops.outline(slot).is_some_and(|outline| outline.bounds.overlaps(&bounds));
        lists.tops.extend(frame.tops.order().iter().copied().filter(overlaps));
        let lamps = &frame.lamps.list;
        grow(&mut lists.occluders, lamps.len());
        lists.narrowed.clear();
        lists.narrowed.resize(lamps.len(), false);
        lists.lamps.clear();
        let reaches = |lamp: &ActiveLamp| is_near(&lamp.circle, *middle_mm, *radius_mm + DAMAGE_MARGIN_MM);
        lists.lamps.extend((0..lamps.len()).filter(|&at| reaches(&lamps[at])));
        lists.reaching = LampSet::default();
        lists.lamps.iter().for_each(|&at| lists.reaching.insert(lamps[at].slot));
    }

    /// The slots of the tops in the block, from the lowest to the highest.
    pub fn tops(&self) -> &[usize] {
        &self.lists.tops
    }

    /// The places among the active lamps of those that reach the block.
    pub fn lamps(&self) -> &[usize] {
        &self.lists.lamps
    }

    /// The slots of the lamps that reach the block.
    pub fn reaching(&self) -> &LampSet {
        &self.lists.reaching
    }

    /// What may stand between an active lamp and a tile, classified for the tile.
    pub fn occluders(&mut self, frame: &FrameContext, at: usize, rect: &TileRect) -> &PotentialOccluders {
        let ActiveLamp { lamp, occluders, .. } = &frame.lamps.list[at];
        let near = &mut self.lists.occluders[at];
        if !self.lists.narrowed[at] {
            let shaft = Shaft::new(lamp, self.middle_mm, self.radius_mm);
            occluders.narrow(frame.simd, &shaft, near, Some((lamp, frame.disc_chains)));
            self.lists.narrowed[at] = true;
        }
        near.classify(frame.simd, &Shaft::new(lamp, rect.middle_mm, rect.radius_mm));
        near
    }
}

/// Makes a list at least so long. It is never cut: renderers of scenes with other numbers of lamps may share a thread.
fn grow<T: Default>(list: &mut Vec<T>, length: usize) {
    if list.len() < length {
        list.resize_with(length, T::default);
    }
}
