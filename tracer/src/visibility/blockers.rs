//! The blockers of one lamp for one tile: what stands in the shaft between them, in the form that the visible fraction
//! is computed from, or the finding that the whole tile is lit or in umbra.
//!
//! - A *chain* whose every disc lies, for every point of the tile, between the point and the lamp's chord covers one
//!   interval, from its lowest tangent to its highest: the cheap case.
//! - A chain that also reaches from one side of the shaft to the other hides the lamp from the whole tile.
//! - A *piece* may come near the tile or the lamp: the hull of two discs, with every case of where it lies.
//!
//! Coordinates are mm from the tile's middle. For a tube the axes are turned, so that the first is the tube's normal:
//! then single precision tells what is near the tube's line from the line itself.

use crate::Group;
use crate::visibility::disc_chain::{Bulge, Disc, DiscChains, Link};
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::shaft::{BEFORE_LAMP, BETWEEN, MEETS_LEFT, MEETS_RIGHT};
use geometry::{Circle, DVec2, Taper};

/// A part of a chain, in mm from the tile's middle.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Element {
    /// A disc: middle and radius.
    Disc([f32; 3]),
    /// A piece of an arc's outer circle.
    Bulge(Cap),
}

/// The piece of a circle within an angle, in mm from the tile's middle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cap {
    /// The circle's middle and radius.
    pub circle: [f32; 3],
    /// The unit vector to the middle of the piece.
    pub middle: [f32; 2],
    /// The piece is where a radius dotted with `middle` is at least this, mm.
    pub least: f32,
    /// The radius of the arc's inner circle, below 0 where it has none, and the same bound for that.
    pub inner: [f32; 2],
}

/// The hull of two discs, in mm from the tile's middle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// One disc: middle and radius.
    pub a: [f32; 3],
    /// The other.
    pub b: [f32; 3],
    /// Both straight sides: x, y where each touches `a`, x, y where it touches `b`. Of a piece of an arc the outer one
    /// twice: its inner edge is hollow, so the straight side is no part of it.
    pub sides: [[f32; 4]; 2],
    /// What bulges out, if it is a piece of an arc.
    pub cap: Option<Cap>,
    /// Whether it is one disc alone.
    pub single: bool,
    /// Whether it may reach beyond the lamp's chord.
    pub clipped: bool,
}

/// What stands between one lamp and the samples of one tile.
#[derive(Clone, Debug, Default)]
pub(crate) struct Blockers {
    /// The elements of the chains, one chain after another.
    pub elements: Vec<Element>,
    /// Where in `elements` each chain ends.
    pub ends: Vec<usize>,
    /// The pieces.
    pub pieces: Vec<Piece>,
    /// The group whose chain hides the lamp, where one does.
    pub hidden_by: Option<Group>,
}

/// How much of a lamp the samples of a tile see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum VisibilityClass {
    /// All of it, every sample.
    Lit,
    /// Nothing of it, every sample.
    Umbra,
    /// Some samples may be in penumbra: computed sample by sample.
    Partial,
}

impl Blockers {
    /// Gathers what of `occluders`, which has been classified for the tile round `middle_mm`, casts shadows, but for
    /// some groups. The unit vector `axis` becomes the first axis.
    pub fn gather(
        &mut self,
        occluders: &PotentialOccluders,
        chains: &DiscChains,
        middle_mm: DVec2,
        axis: DVec2,
        without: &[Group],
    ) -> VisibilityClass {
        self.elements.clear();
        self.ends.clear();
        self.pieces.clear();
        self.hidden_by = None;
        let place = TileFrame { chains, middle_mm, axis };
        let mut chain = 0u16;
        for at in 0..occluders.len() {
            let counts = occluders.counts(at) && !without.contains(&occluders.group[at]);
            let alone = occluders.link[at] == Link::Start;
            let before = if alone { at } else { at - 1 };
            let codes = (occluders.code[before], occluders.code[at]);
            let is_between = counts && codes.0 & codes.1 & BETWEEN != 0;
            let open = self.ends.last().copied().unwrap_or(0) < self.elements.len();
            if open && (!is_between || alone) {
                if crosses_shaft(chain) {
                    self.hidden_by = Some(occluders.group[at - 1]);
                    return VisibilityClass::Umbra;
                }
                self.ends.push(self.elements.len());
            }
            if is_between {
                if self.ends.last().copied().unwrap_or(0) == self.elements.len() {
                    self.elements.push(Element::Disc(place.disc(occluders.index[before] as usize)));
                    chain = codes.0;
                }
                if !alone {
                    if let Link::Bulge(bulge) = occluders.link[at] {
                        self.elements.push(Element::Bulge(place.cap(&chains.bulges[bulge as usize])));
                    }
                    self.elements.push(Element::Disc(place.disc(occluders.index[at] as usize)));
                    chain |= codes.1;
                }
            } else if counts {
                let clipped = codes.0 & codes.1 & BEFORE_LAMP == 0;
                place.push_pieces(occluders, before, at, clipped, &mut self.pieces);
            }
        }
        if self.ends.last().copied().unwrap_or(0) < self.elements.len() {
            if crosses_shaft(chain) {
                self.hidden_by = occluders.group.last().copied();
                return VisibilityClass::Umbra;
            }
            self.ends.push(self.elements.len());
        }
        if self.ends.is_empty() && self.pieces.is_empty() { VisibilityClass::Lit } else { VisibilityClass::Partial }
    }

    /// How many intervals the chains and pieces cover.
    pub fn intervals(&self) -> usize {
        self.ends.len() + self.pieces.len()
    }
}

/// Whether a connected chain, all of it between tile and lamp, reaches from one side of their shaft to the other.
fn crosses_shaft(chain: u16) -> bool {
    chain & MEETS_LEFT != 0 && chain & MEETS_RIGHT != 0
}

/// Brings things from the table into a tile's coordinates.
struct TileFrame<'a> {
    chains: &'a DiscChains,
    middle_mm: DVec2,
    axis: DVec2,
}

impl TileFrame<'_> {
    fn turned(&self, way: DVec2) -> [f32; 2] {
        [way.dot(self.axis) as f32, way.dot(self.axis.perp()) as f32]
    }

    fn circle(&self, circle: Circle) -> [f32; 3] {
        let [x, y] = self.turned(circle.center - self.middle_mm);
        [x, y, circle.radius as f32]
    }

    fn disc(&self, index: usize) -> [f32; 3] {
        let disc = &self.chains.discs[index];
        self.circle(Circle { center: disc.center, radius: disc.radius })
    }

    fn cap(&self, bulge: &Bulge) -> Cap {
        Cap {
            circle: self.circle(bulge.outer),
            middle: self.turned(bulge.middle),
            least: (bulge.cos_half * bulge.outer.radius) as f32,
            inner: [bulge.inner_mm as f32, (bulge.cos_half * bulge.inner_mm) as f32],
        }
    }

    fn push_pieces(
        &self,
        occluders: &PotentialOccluders,
        before: usize,
        at: usize,
        clipped: bool,
        pieces: &mut Vec<Piece>,
    ) {
        let circle = |at: usize| {
            let disc = &self.chains.discs[occluders.index[at] as usize];
            Circle { center: disc.center, radius: disc.radius }
        };
        let Link::Bulge(bulge) = occluders.link[at] else {
            return pieces.push(self.piece(circle(before), circle(at), None, clipped));
        };
        let bulge = &self.chains.bulges[bulge as usize];
        if bulge.fine.is_empty() {
            return pieces.push(self.piece(circle(before), circle(at), Some(bulge), clipped));
        }
        for ends in self.chains.discs[bulge.fine.clone()].windows(2) {
            let Link::Bulge(part) = ends[1].link else { continue };
            let part = &self.chains.bulges[part as usize];
            let circle = |disc: &Disc| Circle { center: disc.center, radius: disc.radius };
            pieces.push(self.piece(circle(&ends[0]), circle(&ends[1]), Some(part), clipped));
        }
    }

    fn piece(&self, a: Circle, b: Circle, bulge: Option<&Bulge>, clipped: bool) -> Piece {
        let cap = bulge.map(|bulge| (self.cap(bulge), bulge.outer.center));
        let taper = Taper { a, b };
        let hollow = |normal: DVec2| cap.is_some_and(|(_, center)| normal.dot(center - a.center) > 0.0);
        let sides = taper.side_normals().map(|normals| {
            let [one, other] = normals;
            let kept = [if hollow(one) { other } else { one }, if hollow(other) { one } else { other }];
            kept.map(|normal| {
                let side = taper.side(normal);
                let [from, to] = [side.a, side.b].map(|end| self.turned(end - self.middle_mm));
                [from[0], from[1], to[0], to[1]]
            })
        });
        let nowhere = [[0.0; 4]; 2];
        Piece {
            a: self.circle(a),
            b: self.circle(b),
            sides: sides.unwrap_or(nowhere),
            cap: cap.map(|(cap, _)| cap),
            single: sides.is_none(),
            clipped,
        }
    }
}
