//! Visibility query: how much of one lamp the samples of one tile see.

use crate::simd::dispatch::SimdLevel;
use crate::simd::dispatch::{LANES, set_bits};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::Plane;
use crate::tile::rect::TileRect;
use crate::visibility::airborne_shadow::AirborneShadow;
use crate::visibility::blockers::{Blockers, VisibilityClass};
use crate::visibility::disc_chain::DiscChains;
use crate::visibility::fraction::{IntervalScratch, visible_fraction};
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::projected_emitter::ProjectedEmitter;
use crate::{Group, Lamp};

/// One lamp, looked at from one tile.
pub(crate) struct VisibilityQuery<'a> {
    pub simd: SimdLevel,
    pub disc_chains: &'a DiscChains,
    pub lamp: &'a Lamp,
    /// The balls in the air that may hide the lamp.
    pub airborne: &'a [AirborneShadow],
    /// The occluders that may come between the lamp and the tile, classified for the tile.
    pub occluders: &'a PotentialOccluders,
    pub rect: &'a TileRect,
    pub blockers: &'a mut Blockers,
    pub scratch: &'a mut IntervalScratch,
    pub fraction: &'a mut Plane,
}

impl VisibilityQuery<'_> {
    /// Finds how much of the lamp each sample of some blocks sees, past everything but some occluders' groups, and past
    /// airborne balls that are not of the samples' own group.
    pub fn evaluate(
        &mut self,
        samples: &PackedSamples,
        blocks: u16,
        without: &[Group],
        own: Option<Group>,
    ) -> VisibilityClass {
        let class = self.behind_occluders(samples, blocks, without);
        if class == VisibilityClass::Umbra || self.airborne.is_empty() {
            return class;
        }
        self.behind_balls(samples, blocks, own, class)
    }

    fn behind_occluders(&mut self, samples: &PackedSamples, blocks: u16, without: &[Group]) -> VisibilityClass {
        let (lamp, middle) = (self.lamp, self.rect.middle_mm);
        let (emitter, axis) = ProjectedEmitter::new(lamp, middle);
        let class = self.blockers.gather(self.occluders, self.disc_chains, middle, axis, without);
        if class == VisibilityClass::Partial {
            self.scratch.reserve(self.blockers.intervals());
            let &mut VisibilityQuery { simd, ref blockers, ref mut scratch, ref mut fraction, .. } = self;
            visible_fraction(simd, blocks, &samples.x, &samples.y, emitter, blockers, scratch, fraction);
        }
        class
    }

    /// Takes what airborne balls hide from what is seen past all else.
    fn behind_balls(
        &mut self,
        samples: &PackedSamples,
        blocks: u16,
        own: Option<Group>,
        mut class: VisibilityClass,
    ) -> VisibilityClass {
        let &TileRect { middle_mm, half_mm, .. } = self.rect;
        let reaches = |ball: &&AirborneShadow| Some(ball.group) != own && ball.bounds.may_reach(middle_mm, half_mm);
        for ball in self.airborne.iter().filter(reaches) {
            if class == VisibilityClass::Lit {
                class = VisibilityClass::Partial;
                set_bits(blocks).for_each(|block| self.fraction[block] = [1.0; LANES]);
            }
            ball.attenuate(self.simd, self.rect, samples, blocks, self.fraction);
        }
        class
    }
}
