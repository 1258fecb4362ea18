//! What is different from the last picture, and where it can be seen: tiles that nothing of it reaches are left as they
//! are.
//!
//! Every answer is on the safe side: a tile that is drawn again for nothing has the same bits as before. What moves
//! between a lamp and a tile is not known here but to [`crate::cache::frame_history`].

use crate::cache::item_pairing::ItemPairing;
use crate::cache::tile_cache::TileMemory;
use crate::scene::id::Item;
use crate::tile::planes::TILE;
use crate::tile::rect::TileRect;
use crate::{Ball, Floor, Glow, ItemId, Lamp, Mask, Overhang, Revision, Rgb, Scene, View};
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

/// An insert as the last picture showed it.
#[derive(Clone, Debug, PartialEq)]
struct Inlay {
    id: ItemId,
    revision: Revision,
    color: Rgb,
    /// The pixels of its mask: left, top, right, bottom.
    pixels: [usize; 4],
}

impl Item for Inlay {
    fn id(&self) -> ItemId {
        self.id
    }
}

/// A lamp that shone in the last picture.
#[derive(Clone, Debug, PartialEq)]
struct LitLamp {
    lamp: Lamp,
    /// Its number in the tiles' memory.
    number: usize,
}

impl Item for LitLamp {
    fn id(&self) -> ItemId {
        self.lamp.id
    }
}

/// What tells the floor's art from other art.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct ArtKey {
    revision: Revision,
    size: [usize; 2],
    /// How many pixels there are of the floor, of tops and of normals.
    lengths: [usize; 3],
    gloss: u32,
}

impl ArtKey {
    fn of(floor: &Floor) -> ArtKey {
        ArtKey {
            revision: floor.revision,
            size: [floor.width, floor.height],
            lengths: [floor.floor.len(), floor.tops.len(), floor.normals.len()],
            gloss: floor.gloss.to_bits(),
        }
    }
}

impl Inlay {
    fn new(glow: &Glow) -> Inlay {
        let &Mask { revision, x, y, width, .. } = glow.mask;
        let height = glow.mask.height();
        Inlay { id: glow.id, revision, color: glow.color, pixels: [x, y, x + width, y + height] }
    }
}

/// A lamp that does not shine as it did.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Flash {
    circle: (DVec2, f64),
    /// Its number in the tiles' memory, if what is remembered of it counts.
    number: Option<usize>,
}

/// What the last picture showed beside shadows and tops, and what is new in this one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Changes {
    lamps: Vec<LitLamp>,
    inlays: Vec<Inlay>,
    balls: Vec<Ball>,
    overhangs: Vec<Overhang>,
    ambient: Rgb,
    view: Option<View>,
    art: ArtKey,
    /// The lamps and the glows of this picture, kept for the next.
    next_lamps: Vec<LitLamp>,
    next: Vec<Inlay>,
    pairing: ItemPairing,
    /// Whether all is different.
    pub everything: bool,
    /// Whether the art is another, or the view: nothing that was seen holds.
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
        let art = ArtKey::of(scene.floor);
        self.repainted = self.art != art || self.view != Some(scene.view);
        self.dawned = self.ambient != scene.ambient;
        self.everything = self.repainted || self.dawned;
        (self.art, self.ambient, self.view) = (art, scene.ambient, Some(scene.view));
        self.compare_lamps(scene, number);
        self.compare_glows(scene);
        self.contacts.clear();
        for ball in self.balls.iter().chain(&scene.balls) {
            self.contacts.push((ball.center_mm, contact_mm(ball)));
        }
        self.still = self.balls == scene.balls && self.overhangs == scene.overhangs;
        self.balls.clone_from(&scene.balls);
        self.overhangs.clone_from(&scene.overhangs);
    }

    /// Leaves balls as they are that lie still where nothing is new; nor has anything moved before a lamp.
    pub fn leave_still_balls(&mut self) {
        let quiet = self.flashes.is_empty() && self.glows.is_empty() && self.tops.is_empty();
        if quiet && self.still && !self.everything {
            self.contacts.clear();
        }
    }

    /// Balls add light up in the lamps' order, so a lamp that has changed places has changed.
    fn compare_lamps(&mut self, scene: &Scene, mut number: impl FnMut(&Lamp) -> usize) {
        let Changes { lamps, next_lamps, flashes, pairing, .. } = self;
        flashes.clear();
        next_lamps.clear();
        let lit = scene.lamps.iter().filter(|lamp| lamp.shines());
        next_lamps.extend(lit.map(|lamp| LitLamp { lamp: *lamp, number: number(lamp) }));
        pairing.each_change(lamps, next_lamps, |LitLamp { lamp, number }| {
            push_new(flashes, Flash { circle: (lamp.center_mm, lamp.far_mm()), number: Some(*number) });
        });
        std::mem::swap(lamps, next_lamps);
    }

    /// Notes that a lamp has to be looked at from everywhere.
    pub fn flash(&mut self, lamp: &Lamp) {
        self.flashes.push(Flash { circle: (lamp.center_mm, lamp.far_mm()), number: None });
    }

    fn compare_glows(&mut self, scene: &Scene) {
        let Changes { inlays, next, glows, pairing, .. } = self;
        glows.clear();
        next.clear();
        next.extend(scene.glows.iter().map(Inlay::new));
        pairing.each_change(inlays, next, |inlay| push_new(glows, inlay.pixels));
        std::mem::swap(inlays, next);
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

/// Puts something at the end of a list, unless it is there: what has only changed its colour is told of as it was and as it
/// is.
fn push_new<T: PartialEq>(list: &mut Vec<T>, item: T) {
    if list.last() != Some(&item) {
        list.push(item);
    }
}

/// Whether a circle comes within `room` of a point; what is not a number is near.
pub(crate) fn is_near(&(center, radius): &(DVec2, f64), point: DVec2, room: f64) -> bool {
    let reach = radius + room;
    center.distance_squared(point).partial_cmp(&(reach * reach)) != Some(Ordering::Greater)
}
