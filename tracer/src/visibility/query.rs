//! How much of one lamp the points of one tile see.

use crate::Group;
use crate::realtime::tile_renderer::{Lit, Stage};
use crate::reference::monte_carlo;
use crate::simd::dispatch::{LANES, set_bits};
use crate::tile::packed_samples::{PackedSamples, Plane};
use crate::tile::rect::TileRect;
use crate::visibility::airborne_shadow::AirborneShadow;
use crate::visibility::blockers::{Blockers, VisibilityClass};
use crate::visibility::fraction::{IntervalScratch, visible_fraction};
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::projected_emitter::ProjectedEmitter;

/// One lamp, looked at from one tile.
pub(crate) struct VisibilityQuery<'a, 'b> {
    pub stage: &'a Stage<'a>,
    pub near: &'b PotentialOccluders,
    pub lit: &'a Lit,
    pub place: &'b TileRect,
    pub between: &'b mut Blockers,
    pub room: &'b mut IntervalScratch,
    pub fraction: &'b mut Plane,
}

impl VisibilityQuery<'_, '_> {
    /// Finds how much of the lamp each point of some blocks sees, past everything but some occluders' groups, and past
    /// floating balls that are not of the points' own group.
    pub fn sees(
        &mut self,
        points: &PackedSamples,
        blocks: u16,
        without: &[Group],
        own: Option<Group>,
    ) -> VisibilityClass {
        let verdict = self.past_occluders(points, blocks, without);
        if verdict == VisibilityClass::Umbra || self.lit.floating.is_empty() {
            return verdict;
        }
        self.past_balls(points, blocks, own, verdict)
    }

    fn past_occluders(&mut self, points: &PackedSamples, blocks: u16, without: &[Group]) -> VisibilityClass {
        let (lamp, middle) = (&self.lit.lamp, self.place.middle_mm);
        if let Some(sampling) = &self.stage.sampling {
            let occluders = &self.stage.scene.occluders;
            sampling.visible_fraction(occluders, lamp, points, self.sampled(), without, self.fraction);
            return VisibilityClass::Partial;
        }
        let (source, axis) = ProjectedEmitter::new(lamp, middle);
        let verdict = self.between.gather(self.near, self.stage.disc_chains, middle, axis, without);
        if verdict == VisibilityClass::Partial {
            self.room.reserve(self.between.intervals());
            let VisibilityQuery { stage, between, room, fraction, .. } = self;
            visible_fraction(stage.simd, blocks, &points.x, &points.y, source, between, room, fraction);
        }
        verdict
    }

    /// Takes what floating balls hide from what is seen past all else.
    fn past_balls(
        &mut self,
        points: &PackedSamples,
        blocks: u16,
        own: Option<Group>,
        mut verdict: VisibilityClass,
    ) -> VisibilityClass {
        if let Some(sampling) = &self.stage.sampling {
            let balls = &self.stage.scene.balls;
            sampling.attenuate(balls, &self.lit.lamp, points, self.sampled(), own, self.fraction);
            return verdict;
        }
        let &TileRect { middle_mm, half_mm, .. } = self.place;
        let reaches = |ball: &&AirborneShadow| Some(ball.group) != own && ball.bounds.may_reach(middle_mm, half_mm);
        for ball in self.lit.floating.iter().filter(reaches) {
            if verdict == VisibilityClass::Lit {
                verdict = VisibilityClass::Partial;
                set_bits(blocks).for_each(|block| self.fraction[block] = [1.0; LANES]);
            }
            ball.attenuate(self.stage.simd, self.place, points, blocks, self.fraction);
        }
        verdict
    }

    fn sampled(&self) -> monte_carlo::TilePixels {
        let TileRect { x, y, middle_mm, .. } = *self.place;
        let view = &self.stage.scene.view;
        monte_carlo::TilePixels { middle_mm, corner: (x, y), size: (view.width, view.height) }
    }
}
