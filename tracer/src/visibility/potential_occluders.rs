//! Potential occluders: the discs that may come between a lamp and a part of the floor.
//!
//! The lists are hierarchical: all that a lamp reaches, of that what lies in the shaft to a block of tiles, of that
//! what lies in the shaft to one tile. Every test is conservative: what it throws out casts no shadow there.

use crate::simd::dispatch::SimdLevel;
use crate::visibility::disc_chain::{DiscChains, Link};
use crate::visibility::shaft::{BETWEEN, Discs, OUTSIDE, OUTSIDE_LINK, SHAFT_MARGIN_MM, Shaft};
use crate::{Group, Lamp};
use geometry::Segment;

/// Discs of chains, relative to a lamp's middle.
#[derive(Clone, Debug, Default)]
pub(crate) struct PotentialOccluders {
    x: Vec<f32>,
    y: Vec<f32>,
    /// Radius with everything that may bulge out of the disc's links.
    outer: Vec<f32>,
    /// Radius that is surely solid.
    inner: Vec<f32>,
    /// How the disc hangs on the one before it in this list.
    pub link: Vec<Link>,
    /// The groups.
    pub group: Vec<Group>,
    /// Which disc of the [`DiscChains`] it is.
    pub index: Vec<u32>,
    /// What the last [`PotentialOccluders::classify`] found.
    pub code: Vec<u16>,
    /// What the wider list's discs were found to be when this list was narrowed from it.
    wider_code: Vec<u16>,
}

impl PotentialOccluders {
    /// Forgets all.
    pub fn clear(&mut self) {
        self.x.clear();
        self.y.clear();
        self.outer.clear();
        self.inner.clear();
        self.link.clear();
        self.group.clear();
        self.index.clear();
        self.code.clear();
    }

    /// How many discs there are.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Everything that can come between `lamp` and what it reaches.
    pub fn set(&mut self, lamp: &Lamp, chains: &DiscChains) {
        self.clear();
        let mut open = false;
        for (at, disc) in chains.discs[..chains.coarse].iter().enumerate() {
            let follows = disc.link != Link::Start;
            let alone =
                !follows && chains.discs[..chains.coarse].get(at + 1).is_none_or(|next| next.link == Link::Start);
            let before = if follows { at - 1 } else { at };
            let near = || {
                let core = Segment { a: chains.discs[before].center, b: disc.center };
                let max_radius = outer_radius(chains, before).max(outer_radius(chains, at));
                let reach = lamp.reach_mm + max_radius + lamp.radius_mm() + f64::from(SHAFT_MARGIN_MM);
                core.closest(lamp.center_mm).distance_squared(lamp.center_mm) <= reach * reach
            };
            let counts = (alone || follows) && Some(disc.group) != lamp.inside && near();
            if counts && follows && !open {
                self.push(lamp, chains, before, Link::Start);
            }
            if counts {
                self.push(lamp, chains, at, disc.link);
            }
            open = counts && follows;
        }
    }

    fn push(&mut self, lamp: &Lamp, chains: &DiscChains, at: usize, link: Link) {
        let disc = &chains.discs[at];
        let from_lamp = disc.center - lamp.center_mm;
        self.x.push(from_lamp.x as f32);
        self.y.push(from_lamp.y as f32);
        self.outer.push(outer_radius(chains, at) as f32 + SHAFT_MARGIN_MM);
        self.inner.push(disc.radius as f32 - SHAFT_MARGIN_MM);
        self.link.push(link);
        self.group.push(disc.group);
        self.index.push(at as u32);
    }

    /// Finds for every disc how it lies to the shaft.
    pub fn classify(&mut self, simd: SimdLevel, shaft: &Shaft) {
        let n = self.len();
        self.code.resize(n, 0);
        let PotentialOccluders { x, y, outer, inner, code, .. } = self;
        shaft.classify(simd, Discs { x, y, outer, inner }, code);
    }

    /// Whether anything of a group may cast a shadow, as the last [`PotentialOccluders::classify`] found.
    pub fn casts(&self, group: Group) -> bool {
        (0..self.len()).any(|at| self.group[at] == group && self.counts(at))
    }

    /// Whether the link from the disc before `at` (the disc alone, where a chain of one starts) may cast a shadow.
    pub fn counts(&self, at: usize) -> bool {
        self.link_counts(&self.code, at)
    }

    fn link_counts(&self, code: &[u16], at: usize) -> bool {
        match self.link[at] {
            Link::Start => {
                let alone = self.link.get(at + 1).is_none_or(|&next| next == Link::Start);
                alone && code[at] & OUTSIDE == 0
            }
            _ => code[at - 1] & code[at] & OUTSIDE == 0 && code[at] & OUTSIDE_LINK == 0,
        }
    }

    /// Puts into `narrower` what may cast a shadow within `shaft`.
    ///
    /// With the lamp and the disc chains that the list was made from, the pieces of arcs that are near the tile or the
    /// lamp are cut finer.
    pub fn narrow(
        &self,
        simd: SimdLevel,
        shaft: &Shaft,
        narrower: &mut PotentialOccluders,
        finer: Option<(&Lamp, &DiscChains)>,
    ) {
        narrower.clear();
        narrower.wider_code.resize(self.len(), 0);
        let PotentialOccluders { x, y, outer, inner, .. } = self;
        shaft.classify(simd, Discs { x, y, outer, inner }, &mut narrower.wider_code);
        let mut open = false;
        for at in 0..self.len() {
            let follows = self.link[at] != Link::Start;
            let counts = self.link_counts(&narrower.wider_code, at);
            if counts && follows && !open {
                narrower.copy(self, at - 1, Link::Start);
            }
            if counts {
                let between = follows && narrower.wider_code[at - 1] & narrower.wider_code[at] & BETWEEN != 0;
                match (self.link[at], finer) {
                    (Link::Bulge(bulge), Some((lamp, chains))) if !between => {
                        let fine = chains.bulges[bulge as usize].fine.clone();
                        for at in fine.skip(1) {
                            narrower.push(lamp, chains, at, chains.discs[at].link);
                        }
                    }
                    (link, _) => narrower.copy(self, at, link),
                }
            }
            open = counts && follows;
        }
    }

    fn copy(&mut self, from: &PotentialOccluders, at: usize, link: Link) {
        self.x.push(from.x[at]);
        self.y.push(from.y[at]);
        self.outer.push(from.outer[at]);
        self.inner.push(from.inner[at]);
        self.link.push(link);
        self.group.push(from.group[at]);
        self.index.push(from.index[at]);
    }
}

/// The radius of a disc, with the bulges of both of its links.
fn outer_radius(chains: &DiscChains, at: usize) -> f64 {
    let bulge = |at: usize| match chains.discs.get(at).map(|disc| disc.link) {
        Some(Link::Bulge(bulge)) => chains.bulges[bulge as usize].sagitta_mm,
        _ => 0.0,
    };
    chains.discs[at].radius + bulge(at).max(bulge(at + 1))
}
