//! Which occluders may come between a lamp and a part of the floor, and how.
//!
//! Lists of discs are narrowed in steps: all that a lamp reaches, what matters to a block of tiles, what matters to one
//! tile. Every test is conservative: what it throws out casts no shadow there.

use crate::lanes::{Path, clones, max};
use crate::silhouette::{Link, Silhouettes};
use crate::{Group, Lamp};
use geometry::{DVec2, Segment};

/// Room for rounding in single precision, mm.
const MARGIN_MM: f32 = 2e-3;

/// The disc lies beyond one side of the space between tile and lamp.
const BEYOND_LEFT: u16 = 1;
/// The disc lies beyond the other side.
const BEYOND_RIGHT: u16 = 2;
/// The disc lies behind the lamp for every point of the tile.
const BEHIND_LAMP: u16 = 4;
/// The disc lies behind every point of the tile.
const BEHIND_TILE: u16 = 8;
/// For every point of the tile the disc lies before the lamp's chord.
pub(crate) const BEFORE_LAMP: u16 = 256;
/// The link up to this disc has the lamp and the tile, all of both, on one side.
const ASIDE: u16 = 16;
/// Both discs of a link have one of these in common: no shadow.
const OUTSIDE: u16 = BEYOND_LEFT | BEYOND_RIGHT | BEHIND_LAMP | BEHIND_TILE;
/// The disc reaches the left side.
pub(crate) const MEETS_LEFT: u16 = 32;
/// The disc reaches the right side.
pub(crate) const MEETS_RIGHT: u16 = 64;
/// For every point of the tile the disc lies between the point and the lamp's chord.
pub(crate) const BETWEEN: u16 = 128;
/// Discs of chains, relative to a lamp's middle.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
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
    /// Which disc of the [`Silhouettes`] it is.
    pub index: Vec<u32>,
    /// What the last [`Candidates::classify`] found.
    pub code: Vec<u16>,
    /// What the wider list's discs were found to be when this list was narrowed from it.
    wider_code: Vec<u16>,
}

/// Two discs: a lamp at the origin, and one around a part of the floor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cone {
    tile: [f32; 2],
    tile_radius: f32,
    tile_distance: f32,
    lamp_radius: f32,
    left: [f32; 2],
    right: [f32; 2],
    offset: f32,
}

impl Cone {
    /// The space between `lamp` and the disc around `middle_mm`.
    pub fn new(lamp: &Lamp, middle_mm: DVec2, radius_mm: f64) -> Cone {
        let tile = middle_mm - lamp.center_mm;
        let lamp_radius = lamp.radius_mm.max(0.0);
        let distance = tile.length();
        let widen = radius_mm - lamp_radius;
        let (mut left, mut right, mut offset) = (DVec2::ZERO, DVec2::ZERO, f64::from(f32::MAX));
        if distance > widen.abs() + f64::from(MARGIN_MM) {
            // The outward normals n of the sides, where the discs' tangents meet: n . 0 + lamp = n . tile + radius.
            let lean = tile * (-widen / (distance * distance));
            let across = tile.perp() * ((distance * distance - widen * widen).sqrt() / (distance * distance));
            (left, right, offset) = (lean + across, lean - across, lamp_radius);
        }
        let narrow = |v: DVec2| [v.x as f32, v.y as f32];
        Cone {
            tile: narrow(tile),
            tile_radius: radius_mm as f32,
            tile_distance: distance as f32,
            lamp_radius: lamp_radius as f32,
            left: narrow(left),
            right: narrow(right),
            offset: offset as f32,
        }
    }

    /// Whether nothing that a lamp of this reach lights is in the disc.
    pub fn beyond(&self, reach_mm: f64) -> bool {
        f64::from(self.tile_distance) > reach_mm + f64::from(self.tile_radius)
    }
}

impl Candidates {
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
    pub fn set(&mut self, lamp: &Lamp, all: &Silhouettes) {
        self.clear();
        let mut open = false;
        for (at, disc) in all.discs[..all.coarse].iter().enumerate() {
            let follows = disc.link != Link::Start;
            let alone = !follows && all.discs[..all.coarse].get(at + 1).is_none_or(|next| next.link == Link::Start);
            let before = if follows { at - 1 } else { at };
            let near = || {
                let core = Segment { a: all.discs[before].center, b: disc.center };
                let thick = outer_radius(all, before).max(outer_radius(all, at));
                let reach = lamp.reach_mm + thick + lamp.radius_mm + f64::from(MARGIN_MM);
                core.closest(lamp.center_mm).distance_squared(lamp.center_mm) <= reach * reach
            };
            let counts = (alone || follows) && Some(disc.group) != lamp.inside && near();
            if counts && follows && !open {
                self.push(lamp, all, before, Link::Start);
            }
            if counts {
                self.push(lamp, all, at, disc.link);
            }
            open = counts && follows;
        }
    }

    fn push(&mut self, lamp: &Lamp, all: &Silhouettes, at: usize, link: Link) {
        let disc = &all.discs[at];
        let from_lamp = disc.center - lamp.center_mm;
        self.x.push(from_lamp.x as f32);
        self.y.push(from_lamp.y as f32);
        self.outer.push(outer_radius(all, at) as f32 + MARGIN_MM);
        self.inner.push(disc.radius as f32 - MARGIN_MM);
        self.link.push(link);
        self.group.push(disc.group);
        self.index.push(at as u32);
    }

    /// Finds for every disc how it lies to the cone.
    pub fn classify(&mut self, path: Path, cone: &Cone) {
        let n = self.len();
        self.code.resize(n, 0);
        classify(path, &self.x, &self.y, &self.outer, &self.inner, cone, &mut self.code);
    }

    /// Classifies, and says whether anything may cast a shadow.
    pub fn classified_any(&mut self, path: Path, cone: &Cone) -> bool {
        if self.len() == 0 {
            return false;
        }
        self.classify(path, cone);
        (0..self.len()).any(|at| self.counts(at))
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
            _ => code[at - 1] & code[at] & OUTSIDE == 0 && code[at] & ASIDE == 0,
        }
    }

    /// Puts into `narrower` what may cast a shadow within `cone`.
    ///
    /// With the lamp and the silhouettes that the list was made from, the pieces of arcs that are near the tile or the
    /// lamp are cut finer.
    pub fn narrow(&self, path: Path, cone: &Cone, narrower: &mut Candidates, finer: Option<(&Lamp, &Silhouettes)>) {
        narrower.clear();
        narrower.wider_code.resize(self.len(), 0);
        classify(path, &self.x, &self.y, &self.outer, &self.inner, cone, &mut narrower.wider_code);
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
                    (Link::Bulge(bulge), Some((lamp, all))) if !between => {
                        let fine = all.bulges[bulge as usize].fine.clone();
                        for at in fine.skip(1) {
                            narrower.push(lamp, all, at, all.discs[at].link);
                        }
                    }
                    (link, _) => narrower.copy(self, at, link),
                }
            }
            open = counts && follows;
        }
    }

    fn copy(&mut self, from: &Candidates, at: usize, link: Link) {
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
fn outer_radius(all: &Silhouettes, at: usize) -> f64 {
    let bulge = |at: usize| match all.discs.get(at).map(|disc| disc.link) {
        Some(Link::Bulge(bulge)) => all.bulges[bulge as usize].sagitta_mm,
        _ => 0.0,
    };
    all.discs[at].radius + bulge(at).max(bulge(at + 1))
}

clones! {
    /// Writes for each disc the bits that say how it lies to the cone.
    fn classify(x: &[f32], y: &[f32], outer: &[f32], inner: &[f32], cone: &Cone, code: &mut [u16]) = classify_lanes;
}

#[inline(always)]
fn classify_lanes(x: &[f32], y: &[f32], outer: &[f32], inner: &[f32], cone: &Cone, code: &mut [u16]) {
    let n = code.len();
    let (x, y, outer, inner) = (&x[..n], &y[..n], &outer[..n], &inner[..n]);
    let [tx, ty] = cone.tile;
    let farthest = cone.tile_distance + cone.tile_radius;
    for i in 0..n {
        let left = cone.left[0] * x[i] + cone.left[1] * y[i] - cone.offset;
        let right = cone.right[0] * x[i] + cone.right[1] * y[i] - cone.offset;
        // With P a point of the tile, Q the disc and L = 0 the lamp: how far (Q - P) . (L - P) and (L - Q) . (L - P) can
        // be from their values at the tile's middle.
        let (cx, cy) = (x[i] - tx, y[i] - ty);
        let (sx, sy) = (cx - tx, cy - ty);
        let from_tile = -(cx * tx + cy * ty);
        let from_tile_swing = cone.tile_radius * (sx * sx + sy * sy).sqrt();
        let to_lamp = x[i] * tx + y[i] * ty;
        let to_lamp_swing = cone.tile_radius * (x[i] * x[i] + y[i] * y[i]).sqrt();
        let thick = outer[i] * farthest;
        let square = cone.tile_radius * cone.tile_radius;
        let behind_lamp = to_lamp + to_lamp_swing + thick < 0.0;
        let behind_tile = from_tile + from_tile_swing + square + thick < 0.0;
        let before_lamp = to_lamp - to_lamp_swing - thick > 0.0;
        let after_tile = from_tile - from_tile_swing - thick > 0.0;
        let bit = |is: bool, bit: u16| if is { bit } else { 0 };
        code[i] = bit(left - outer[i] > 0.0, BEYOND_LEFT)
            | bit(right - outer[i] > 0.0, BEYOND_RIGHT)
            | bit(behind_lamp, BEHIND_LAMP)
            | bit(behind_tile, BEHIND_TILE)
            | bit(left + inner[i] >= 0.0, MEETS_LEFT)
            | bit(right + inner[i] >= 0.0, MEETS_RIGHT)
            | bit(before_lamp & after_tile, BETWEEN)
            | bit(before_lamp, BEFORE_LAMP);
    }
    for i in 1..n {
        // The distances of the lamp's and of the tile's middle from the line through both discs.
        let (ex, ey) = (x[i] - x[i - 1], y[i] - y[i - 1]);
        let scale = 1.0 / max(ex * ex + ey * ey, 1e-12).sqrt();
        let lamp = (ey * x[i] - ex * y[i]) * scale;
        let tile = lamp - (ey * tx - ex * ty) * scale;
        let thick = max(outer[i - 1], outer[i]);
        let (lamp_room, tile_room) = (cone.lamp_radius + thick, cone.tile_radius + thick);
        let above = (lamp > lamp_room) & (tile > tile_room);
        let below = (lamp < -lamp_room) & (tile < -tile_room);
        code[i] |= if above | below { ASIDE } else { 0 };
    }
}
