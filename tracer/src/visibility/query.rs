//! How much of one lamp the points of one tile see.

use crate::Group;
use crate::realtime::tile_renderer::{Lit, Stage};
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
    pub occluders: &'b PotentialOccluders,
    pub lit: &'a Lit,
    pub rect: &'b TileRect,
    pub blockers: &'b mut Blockers,
    pub scratch: &'b mut IntervalScratch,
    pub fraction: &'b mut Plane,
}

impl VisibilityQuery<'_, '_> {
    /// Finds how much of the lamp each point of some blocks sees, past everything but some occluders' groups, and past
    /// airborne balls that are not of the points' own group.
    pub fn evaluate(
        &mut self,
        points: &PackedSamples,
        blocks: u16,
        without: &[Group],
        own: Option<Group>,
    ) -> VisibilityClass {
        let verdict = self.behind_occluders(points, blocks, without);
        if verdict == VisibilityClass::Umbra || self.lit.airborne.is_empty() {
            return verdict;
        }
        self.behind_balls(points, blocks, own, verdict)
    }

    fn behind_occluders(&mut self, points: &PackedSamples, blocks: u16, without: &[Group]) -> VisibilityClass {
        let (lamp, middle) = (&self.lit.lamp, self.rect.middle_mm);
        let (emitter, axis) = ProjectedEmitter::new(lamp, middle);
        let verdict = self.blockers.gather(self.occluders, self.stage.disc_chains, middle, axis, without);
        if verdict == VisibilityClass::Partial {
            self.scratch.reserve(self.blockers.intervals());
            let VisibilityQuery { stage, blockers, scratch, fraction, .. } = self;
            visible_fraction(stage.simd, blocks, &points.x, &points.y, emitter, blockers, scratch, fraction);
        }
        verdict
    }

    /// Takes what airborne balls hide from what is seen past all else.
    fn behind_balls(
        &mut self,
        points: &PackedSamples,
        blocks: u16,
        own: Option<Group>,
        mut verdict: VisibilityClass,
    ) -> VisibilityClass {
        let &TileRect { middle_mm, half_mm, .. } = self.rect;
        let reaches = |ball: &&AirborneShadow| Some(ball.group) != own && ball.bounds.may_reach(middle_mm, half_mm);
        for ball in self.lit.airborne.iter().filter(reaches) {
            if verdict == VisibilityClass::Lit {
                verdict = VisibilityClass::Partial;
                set_bits(blocks).for_each(|block| self.fraction[block] = [1.0; LANES]);
            }
            ball.attenuate(self.stage.simd, self.rect, points, blocks, self.fraction);
        }
        verdict
    }
}
