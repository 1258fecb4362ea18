//! Damage: what is different from the last frame, and where it can be seen. Tiles that nothing of it reaches are left as
//! they are.
//!
//! Every answer is on the safe side: a tile that is drawn again for nothing has the same bits as before. What moves
//! between a lamp and a tile is known to [`crate::cache::frame_history`].

use crate::cache::item_pairing::ItemPairing;
use crate::cache::tile_cache::TileCache;
use crate::cache::validity::Event;
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

/// How far from its middle a ball darkens the ambient light, mm.
pub(crate) fn contact_mm(ball: &Ball) -> f64 {
    ball.radius_mm * CONTACT_RADII + ball.lift_mm()
}

/// A glow as the last frame showed it.
#[derive(Clone, Debug, PartialEq)]
struct ShownGlow {
    id: ItemId,
    revision: Revision,
    color: Rgb,
    /// The pixels of its mask: left, top, right, bottom.
    pixels: [usize; 4],
}

impl Item for ShownGlow {
    fn id(&self) -> ItemId {
        self.id
    }
}

/// A lamp that shone in the last frame.
#[derive(Clone, Debug, PartialEq)]
struct LitLamp {
    lamp: Lamp,
    /// The slot by which the tile caches know it.
    slot: usize,
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

impl ShownGlow {
    fn new(glow: &Glow) -> ShownGlow {
        let &Mask { revision, x, y, width, .. } = glow.mask;
        let height = glow.mask.height();
        ShownGlow { id: glow.id, revision, color: glow.color, pixels: [x, y, x + width, y + height] }
    }
}

/// A lamp that does not shine as it did.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Flash {
    circle: (DVec2, f64),
    /// The slot by which the tile caches know it.
    slot: usize,
}

/// The events of a frame that meet every tile.
#[derive(Clone, Copy, Debug, Default)]
struct SceneEvents {
    art_changed: bool,
    ambient_changed: bool,
    buffer_replaced: bool,
}

impl SceneEvents {
    fn any(self) -> bool {
        self.art_changed || self.ambient_changed || self.buffer_replaced
    }
}

/// What the last frame showed beside shadows and tops, and what is new in this one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Damage {
    lamps: Vec<LitLamp>,
    shown_glows: Vec<ShownGlow>,
    balls: Vec<Ball>,
    overhangs: Vec<Overhang>,
    ambient: Rgb,
    view: Option<View>,
    art: ArtKey,
    /// The lamps and the glows of this frame, kept for the next.
    next_lamps: Vec<LitLamp>,
    next_glows: Vec<ShownGlow>,
    pairing: ItemPairing,
    events: SceneEvents,
    /// The lamps that do not shine as they did.
    flashes: Vec<Flash>,
    /// The pixels of glows that are not as they were: left, top, right, bottom.
    glows: Vec<[usize; 4]>,
    /// Where a ball is or was, and how far it darkens the floor: a ball mirrors all of the table, so whatever changes may
    /// show in it.
    contact_shadows: Vec<(DVec2, f64)>,
    balls_are_still: bool,
    /// Where tops are whose emission is not what it was.
    pub relit_tops: Vec<Bounds>,
}

impl Damage {
    /// Compares `scene` with the last one and keeps it; [`Damage::relit_tops`] is the caller's. `slot` gives the slot by
    /// which the tile caches know a lamp; `buffer_is_last` says that the buffer holds the last frame.
    pub fn advance(&mut self, scene: &Scene, buffer_is_last: bool, slot: impl FnMut(&Lamp) -> usize) {
        let art = ArtKey::of(scene.floor);
        self.events = SceneEvents {
            art_changed: self.art != art || self.view != Some(scene.view),
            ambient_changed: self.ambient != scene.ambient,
            buffer_replaced: !buffer_is_last,
        };
        (self.art, self.ambient, self.view) = (art, scene.ambient, Some(scene.view));
        self.compare_lamps(scene, slot);
        self.compare_glows(scene);
        self.contact_shadows.clear();
        for ball in self.balls.iter().chain(&scene.balls) {
            self.contact_shadows.push((ball.center_mm, contact_mm(ball)));
        }
        self.balls_are_still = self.balls == scene.balls && self.overhangs == scene.overhangs;
        self.balls.clone_from(&scene.balls);
        self.overhangs.clone_from(&scene.overhangs);
    }

    /// Whether the art is another, or the view.
    pub fn art_changed(&self) -> bool {
        self.events.art_changed
    }

    /// Leaves balls as they are that lie still where nothing is new; nor has anything moved before a lamp.
    pub fn leave_still_balls(&mut self) {
        let quiet = self.flashes.is_empty() && self.glows.is_empty() && self.relit_tops.is_empty();
        if quiet && self.balls_are_still && !self.events.any() {
            self.contact_shadows.clear();
        }
    }

    /// Balls add light up in the lamps' order, so a lamp that has changed places has changed.
    fn compare_lamps(&mut self, scene: &Scene, mut slot: impl FnMut(&Lamp) -> usize) {
        let Damage { lamps, next_lamps, flashes, pairing, .. } = self;
        flashes.clear();
        next_lamps.clear();
        let lit = scene.lamps.iter().filter(|lamp| lamp.shines());
        next_lamps.extend(lit.map(|lamp| LitLamp { lamp: *lamp, slot: slot(lamp) }));
        pairing.each_change(lamps, next_lamps, |LitLamp { lamp, slot }| {
            push_new(flashes, Flash { circle: (lamp.center_mm, lamp.far_mm()), slot: *slot });
        });
        std::mem::swap(lamps, next_lamps);
    }

    fn compare_glows(&mut self, scene: &Scene) {
        let Damage { shown_glows, next_glows, glows, pairing, .. } = self;
        glows.clear();
        next_glows.clear();
        next_glows.extend(scene.glows.iter().map(ShownGlow::new));
        pairing.each_change(shown_glows, next_glows, |glow| push_new(glows, glow.pixels));
        std::mem::swap(shown_glows, next_glows);
    }

    /// The damage that may be seen in the block of tiles round `middle_mm`, `radius_mm` to its corners.
    pub fn within(&self, middle_mm: DVec2, radius_mm: f64, moved_tops: &[Bounds], block: &mut BlockDamage) {
        block.events = self.events;
        let room = radius_mm + DAMAGE_MARGIN_MM;
        let bounds = Bounds::of(middle_mm, middle_mm).grown(room);
        let overlapping = |list: &[Bounds], near: &mut Vec<Bounds>| {
            near.clear();
            near.extend(list.iter().filter(|top| top.overlaps(&bounds)));
        };
        overlapping(moved_tops, &mut block.moved_tops);
        overlapping(&self.relit_tops, &mut block.relit_tops);
        block.flashes.clear();
        block.flashes.extend(self.flashes.iter().filter(|flash| is_near(&flash.circle, middle_mm, room)));
        block.contact_shadows.clear();
        block.contact_shadows.extend(self.contact_shadows.iter().filter(|circle| is_near(circle, middle_mm, room)));
        block.glows.clear();
        block.glows.extend_from_slice(&self.glows);
    }
}

/// The damage that may be seen in one block of tiles.
#[derive(Clone, Debug, Default)]
pub(crate) struct BlockDamage {
    events: SceneEvents,
    moved_tops: Vec<Bounds>,
    relit_tops: Vec<Bounds>,
    flashes: Vec<Flash>,
    contact_shadows: Vec<(DVec2, f64)>,
    glows: Vec<[usize; 4]>,
}

impl BlockDamage {
    /// Tells a tile's cache of every event that reaches the tile; says whether the tile may look different from the last
    /// frame's.
    pub fn apply(&self, rect: &TileRect, cache: &mut TileCache) -> bool {
        let overlaps = |list: &[Bounds]| list.iter().any(|top| top.overlaps(&rect.bounds));
        if self.events.art_changed {
            cache.apply(Event::ArtChanged);
        } else if overlaps(&self.moved_tops) {
            cache.apply(Event::TopMoved);
        }
        if overlaps(&self.relit_tops) {
            cache.apply(Event::EmissionChanged);
        }
        if self.events.ambient_changed {
            cache.apply(Event::AmbientChanged);
        }
        let event = self.redraw_event(rect, cache);
        if let Some(event) = event {
            cache.apply(event);
        }
        event.is_some() || !cache.base().is_valid()
    }

    /// An event, if there is any, that leaves all layers valid, but gives them other weights or is drawn over them.
    fn redraw_event(&self, rect: &TileRect, cache: &TileCache) -> Option<Event> {
        let &TileRect { x, y, middle_mm, radius_mm, .. } = rect;
        let room = radius_mm + DAMAGE_MARGIN_MM;
        let flashes = |flash: &Flash| is_near(&flash.circle, middle_mm, room) && !cache.is_dark(flash.slot);
        let shows =
            |&[left, top, right, bottom]: &[usize; 4]| left < x + TILE && right > x && top < y + TILE && bottom > y;
        match () {
            () if self.events.buffer_replaced => Some(Event::BufferReplaced),
            () if self.contact_shadows.iter().any(|circle| is_near(circle, middle_mm, room)) => {
                Some(Event::ReflectionChanged)
            }
            () if self.flashes.iter().any(flashes) => Some(Event::LampColorChanged),
            () if self.glows.iter().any(shows) => Some(Event::GlowChanged),
            () => None,
        }
    }
}

/// Puts something at the end of a list, unless it is there: what has only changed its colour is told of as it was and as it
/// is.
fn push_new<T: PartialEq>(list: &mut Vec<T>, item: T) {
    if list.last() != Some(&item) {
        list.push(item);
    }
}

/// Whether a circle comes within `room` of a point; what is NaN is near.
pub(crate) fn is_near(&(center, radius): &(DVec2, f64), point: DVec2, room: f64) -> bool {
    let reach = radius + room;
    center.distance_squared(point).partial_cmp(&(reach * reach)) != Some(Ordering::Greater)
}
