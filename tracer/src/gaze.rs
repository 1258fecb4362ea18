//! How much of one lamp the points of one tile see.

use crate::candidates::Candidates;
use crate::obstruction::{Obstruction, Verdict};
use crate::points::{Plane, Points};
use crate::source::Source;
use crate::tile::Stage;
use crate::visibility::{Intervals, visible_fraction};
use crate::{Group, Lamp, monte_carlo};
use geometry::DVec2;

/// One lamp, looked at from one tile.
pub(crate) struct Gaze<'a, 'b> {
    pub stage: &'a Stage<'a>,
    pub near: &'b Candidates,
    pub lamp: &'a Lamp,
    pub middle: DVec2,
    pub corner: (usize, usize),
    pub between: &'b mut Obstruction,
    pub room: &'b mut Intervals,
    pub fraction: &'b mut Plane,
}

impl Gaze<'_, '_> {
    /// Finds how much of the lamp each point of some blocks sees, past everything but some groups.
    pub fn sees(&mut self, points: &Points, blocks: u16, without: &[Group]) -> Verdict {
        if let Some(sampling) = &self.stage.sampling {
            let view = &self.stage.scene.view;
            let size = (view.width, view.height);
            let at = monte_carlo::Place { middle_mm: self.middle, corner: self.corner, size };
            let occluders = &self.stage.scene.occluders;
            sampling.visible_fraction(occluders, self.lamp, points, at, without, self.fraction);
            return Verdict::Mixed;
        }
        let (source, axis) = Source::new(self.lamp, self.middle);
        let verdict = self.between.gather(self.near, self.stage.silhouettes, self.middle, axis, without);
        if verdict == Verdict::Mixed {
            self.room.reserve(self.between.intervals());
            let Gaze { stage, between, room, fraction, .. } = self;
            visible_fraction(stage.path, blocks, &points.x, &points.y, source, between, room, fraction);
        }
        verdict
    }
}
