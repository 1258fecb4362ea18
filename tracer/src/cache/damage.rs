//! What is different from the last picture, and where it can be seen: tiles that nothing of it reaches are left as they
//! are.
//!
//! Every answer is on the safe side: a tile that is drawn again for nothing has the same bits as before. What moves
//! between a lamp and a tile is not known here but to [`crate::past`].

use crate::cache::tile_cache::TileMemory;
use crate::tile::planes::TILE;
use crate::tile::rect::TileRect;
use crate::{Ball, Filter, Glow, Lamp, Mask, Rgb, Scene, View};
use geometry::{Bounds, DVec2};
use std::cmp::Ordering;

/// Room for rounding, mm.
pub(crate) const DAMAGE_MARGIN_MM: f64 = 0.01;

/// Where the contact shadow ends of a ball that lies on the floor, in the ball's radii.
const CONTACT_RADII: f64 = 4.0;

/// How far from its middle a ball darkens the light from everywhere, mm.
pub(crate) fn contact_mm(ball: &Ball) -> f64 {
    ball.radius_mm * CONTACT_RADII + ball.lift_mm()
}

/// An insert as the last picture showed it: its mask by its place in memory.
#[derive(Clone, Debug, PartialEq)]
struct Inlay {
    mask: (usize, usize),
    color: Rgb,
    pixels: [usize; 4],
}

impl Inlay {
    fn new(glow: &Glow) -> Inlay {
        let &Mask { x, y, width, .. } = glow.mask;
        let height = glow.mask.height();
        let mask = glow.mask.place();
        Inlay { mask, color: glow.color, pixels: [x, y, x + width, y + height] }
    }
}

/// A lamp that does not shine as it did.
#[derive(Clone, Copy, Debug)]
struct Flash {
    circle: (DVec2, f64),
    /// Its number in the tiles' memory, if what is remembered of it counts.
    number: Option<usize>,
}

/// What the last picture showed beside shadows and tops, and what is new in this one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Changes {
    lamps: Vec<Lamp>,
    inlays: Vec<Inlay>,
    balls: Vec<Ball>,
    ambient: Rgb,
    filters: Vec<Filter>,
    view: Option<View>,
    art: [usize; 8],
    /// The glows of this picture, kept for the next.
    next: Vec<Inlay>,
    /// Whether all is different.
    pub everything: bool,
    /// Whether the art is another, or what passes through filters: nothing that was seen holds.
    pub repainted: bool,
    /// Whether the light from everywhere is another.
    dawned: bool,
    /// The lamps that do not shine as they did.
    flashes: Vec<Flash>,
    /// The pixels of inserts that do not glow as they did: left, top, right, bottom.
    glows: Vec<[usize; 4]>,
    /// Where a ball is or was, and how far it darkens the floor: a ball mirrors all of the table, so whatever changes may
    /// show in it.
    contacts: Vec<(DVec2, f64)>,
    /// Whether the balls are as they were.
    still: bool,
    /// Where tops are whose own light is not what it was.
    pub tops: Vec<Bounds>,
}

impl Changes {
    /// Compares `scene` with the last one and remembers it; [`Changes::tops`] is the caller's.
    ///
    /// `number` gives the number by which the tiles' memory knows a lamp.
    pub fn turn_page(&mut self, scene: &Scene, number: impl FnMut(&Lamp) -> usize) {
        let floor = scene.floor;
        let (below, above) = (floor.floor.as_ptr() as usize, floor.tops.as_ptr() as usize);
        let (has_normals, gloss) = (floor.normals.as_ptr() as usize, floor.gloss.to_bits() as usize);
        let art = [floor.width, floor.height, below, floor.floor.len(), above, floor.tops.len(), has_normals, gloss];
        self.repainted = self.art != art || self.view != Some(scene.view) || self.filters != scene.filters;
        self.filters.clone_from(&scene.filters);
        self.dawned = self.ambient != scene.ambient;
        self.everything = self.repainted || self.dawned;
        (self.art, self.ambient, self.view) = (art, scene.ambient, Some(scene.view));
        self.compare_lamps(scene, number);
        self.compare_glows(scene);
        self.contacts.clear();
        for ball in self.balls.iter().chain(&scene.balls) {
            self.contacts.push((ball.center_mm, contact_mm(ball)));
        }
        self.still = self.balls == scene.balls;
        self.balls.clone_from(&scene.balls);
    }

    /// Leaves balls as they are that lie still where nothing is new; nor has anything moved before a lamp.
    pub fn leave_still_balls(&mut self) {
        let quiet = self.flashes.is_empty() && self.glows.is_empty() && self.tops.is_empty();
        if quiet && self.still && !self.everything {
            self.contacts.clear();
        }
    }

    /// Light is added up in the lamps' order, so a lamp that has changed places has changed.
    fn compare_lamps(&mut self, scene: &Scene, mut number: impl FnMut(&Lamp) -> usize) {
        self.flashes.clear();
        let mut flash = |lamp: &Lamp| Flash { circle: (lamp.center_mm, lamp.far_mm()), number: Some(number(lamp)) };
        let black = |lamp: &Lamp| Lamp { color: [0.0; 3], ..*lamp };
        let mut old = self.lamps.as_slice();
        for lamp in scene.lamps.iter().filter(|lamp| lamp.shines()) {
            match old.iter().position(|old| black(old) == black(lamp)) {
                Some(at) => {
                    self.flashes.extend(old[..at].iter().map(&mut flash));
                    if old[at].color != lamp.color {
                        self.flashes.push(flash(lamp));
                    }
                    old = &old[at + 1..];
                }
                None => self.flashes.push(flash(lamp)),
            }
        }
        self.flashes.extend(old.iter().map(&mut flash));
        self.lamps.clear();
        self.lamps.extend(scene.lamps.iter().filter(|lamp| lamp.shines()));
    }

    /// Notes that a lamp has to be looked at from everywhere.
    pub fn flash(&mut self, lamp: &Lamp) {
        self.flashes.push(Flash { circle: (lamp.center_mm, lamp.far_mm()), number: None });
    }

    fn compare_glows(&mut self, scene: &Scene) {
        self.glows.clear();
        self.next.clear();
        self.next.extend(scene.glows.iter().map(Inlay::new));
        let mut old = self.inlays.as_slice();
        for new in &self.next {
            match old.iter().position(|old| old.mask == new.mask && old.pixels == new.pixels) {
                Some(at) => {
                    self.glows.extend(old[..at].iter().map(|inlay| inlay.pixels));
                    if old[at].color != new.color {
                        self.glows.push(new.pixels);
                    }
                    old = &old[at + 1..];
                }
                None => self.glows.push(new.pixels),
            }
        }
        self.glows.extend(old.iter().map(|inlay| inlay.pixels));
        std::mem::swap(&mut self.inlays, &mut self.next);
    }

    /// What may be seen in the block of tiles round `middle_mm`, `radius_mm` to its corners.
    pub fn near(&self, middle_mm: DVec2, radius_mm: f64, moved_tops: &[Bounds], nearby: &mut Nearby) {
        (nearby.repainted, nearby.dawned) = (self.repainted, self.dawned);
        let room = radius_mm + DAMAGE_MARGIN_MM;
        let bounds = Bounds::of(middle_mm, middle_mm).grown(room);
        let overlapping = |list: &[Bounds], near: &mut Vec<Bounds>| {
            near.clear();
            near.extend(list.iter().filter(|top| top.overlaps(&bounds)));
        };
        overlapping(moved_tops, &mut nearby.moved_tops);
        overlapping(&self.tops, &mut nearby.tops);
        nearby.flashes.clear();
        nearby.flashes.extend(self.flashes.iter().filter(|flash| is_near(&flash.circle, middle_mm, room)));
        nearby.contacts.clear();
        nearby.contacts.extend(self.contacts.iter().filter(|circle| is_near(circle, middle_mm, room)));
        nearby.glows.clear();
        nearby.glows.extend_from_slice(&self.glows);
    }
}

/// The changes that may be seen in one block of tiles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Nearby {
    repainted: bool,
    dawned: bool,
    moved_tops: Vec<Bounds>,
    tops: Vec<Bounds>,
    flashes: Vec<Flash>,
    contacts: Vec<(DVec2, f64)>,
    glows: Vec<[usize; 4]>,
}

impl Nearby {
    /// Whether the tile at `rect` may look different; `memory`, what it saw in the last picture, forgets what is not so
    /// any more.
    pub fn reach(&self, rect: &TileRect, memory: &mut TileMemory) -> bool {
        let &TileRect { x, y, middle_mm, radius_mm, ref bounds, .. } = rect;
        let room = radius_mm + DAMAGE_MARGIN_MM;
        if self.repainted || self.moved_tops.iter().any(|moved| moved.overlaps(bounds)) {
            memory.forget();
        }
        let shines = self.tops.iter().any(|top| top.overlaps(bounds));
        memory.base.holds &= !shines && !self.dawned;
        let seen = |flash: &Flash| !flash.number.is_some_and(|number| memory.is_dark(number));
        !memory.base.holds
            || self.contacts.iter().any(|circle| is_near(circle, middle_mm, room))
            || self.flashes.iter().any(|flash| is_near(&flash.circle, middle_mm, room) && seen(flash))
            || self
                .glows
                .iter()
                .any(|&[left, top, right, bottom]| left < x + TILE && right > x && top < y + TILE && bottom > y)
    }
}

/// Whether a circle comes within `room` of a point; what is not a number is near.
pub(crate) fn is_near(&(center, radius): &(DVec2, f64), point: DVec2, room: f64) -> bool {
    let reach = radius + room;
    center.distance_squared(point).partial_cmp(&(reach * reach)) != Some(Ordering::Greater)
}
