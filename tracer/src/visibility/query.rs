//! How much of one lamp the points of one tile see.

use crate::Group;
use crate::realtime::tile_renderer::{Lit, Stage};
use crate::simd::dispatch::{LANES, ones};
use crate::tile::packed_samples::{Plane, Points};
use crate::tile::rect::Place;
use crate::visibility::airborne_shadow::Floating;
use crate::visibility::blockers::{Obstruction, Verdict};
use crate::visibility::fraction::{Intervals, visible_fraction};
use crate::visibility::potential_occluders::Candidates;
use crate::visibility::projected_emitter::Source;

/// One lamp, looked at from one tile.
pub(crate) struct Gaze<'a, 'b> {
    pub stage: &'a Stage<'a>,
    pub near: &'b Candidates,
    pub lit: &'a Lit,
    pub place: &'b Place,
    pub between: &'b mut Obstruction,
    pub room: &'b mut Intervals,
    pub fraction: &'b mut Plane,
}

impl Gaze<'_, '_> {
    /// Finds how much of the lamp each point of some blocks sees, past everything but some occluders' groups, and past
    /// floating balls that are not of the points' own group.
    pub fn sees(&mut self, points: &Points, blocks: u16, without: &[Group], own: Option<Group>) -> Verdict {
        let verdict = self.past_occluders(points, blocks, without);
        if verdict == Verdict::Dark || self.lit.floating.is_empty() {
            return verdict;
        }
        self.past_balls(points, blocks, own, verdict)
    }

    fn past_occluders(&mut self, points: &Points, blocks: u16, without: &[Group]) -> Verdict {
        let (lamp, middle) = (&self.lit.lamp, self.place.middle_mm);
        let (source, axis) = Source::new(lamp, middle);
        let verdict = self.between.gather(self.near, self.stage.silhouettes, middle, axis, without);
        if verdict == Verdict::Mixed {
            self.room.reserve(self.between.intervals());
            let Gaze { stage, between, room, fraction, .. } = self;
            visible_fraction(stage.path, blocks, &points.x, &points.y, source, between, room, fraction);
        }
        verdict
    }

    /// Takes what floating balls hide from what is seen past all else.
    fn past_balls(&mut self, points: &Points, blocks: u16, own: Option<Group>, mut verdict: Verdict) -> Verdict {
        let &Place { middle_mm, half_mm, .. } = self.place;
        let reaches = |ball: &&Floating| Some(ball.group) != own && ball.penumbra.may_reach(middle_mm, half_mm);
        for ball in self.lit.floating.iter().filter(reaches) {
            if verdict == Verdict::Lit {
                verdict = Verdict::Mixed;
                ones(blocks).for_each(|block| self.fraction[block] = [1.0; LANES]);
            }
            ball.veil(self.stage.path, self.place, points, blocks, self.fraction);
        }
        verdict
    }
}
