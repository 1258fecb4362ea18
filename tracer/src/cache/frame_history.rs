//! Frame history: what the last frame was made of, what has moved before each lamp since the lamp was lit last, and the
//! tiles' caches.

use crate::cache::item_pairing::ItemPairing;
use crate::cache::tile_cache::TileCache;
use crate::cache::validity::Event;
use crate::{Ball, ItemId, Lamp, Occluder, Scene, View};

/// The most lamps that are cached: in a scene of more, every frame is made from nothing.
pub(crate) const MAX_LAMPS: usize = 160;

/// The most glows that are cached.
pub(crate) const MAX_GLOWS: usize = 1_000;

/// How many moves a dark lamp may miss before it is lost.
const MAX_MOVES: usize = 200;

/// A lamp that the tiles' caches know.
#[derive(Clone, Debug)]
pub(crate) struct KnownLamp {
    /// The lamp, black.
    lamp: Lamp,
    /// What has moved since it shone last: where it was, and where it went.
    pub moved: Vec<Occluder>,
    /// The same of balls in the air.
    pub moved_balls: Vec<Ball>,
    /// Whether too much has moved to be told.
    pub lost: bool,
}

/// What the last frame was made of, and what has moved since.
#[derive(Clone, Debug, Default)]
pub(crate) struct FrameHistory {
    view: Option<View>,
    occluders: Vec<Occluder>,
    /// The balls in the air, not turned.
    airborne: Vec<Ball>,
    /// Scratch: the airborne balls of this frame.
    next: Vec<Ball>,
    /// The lamps by their slots, which [`TileCache`] knows them by. A lamp that moves gets another slot; its old slot stays.
    pub known: Vec<KnownLamp>,
    /// The lamps' slots, in the order of their ids.
    slots: Vec<(ItemId, usize)>,
    pairing: ItemPairing,
    /// The tiles, band by band.
    pub bands: Vec<Vec<TileCache>>,
}

impl FrameHistory {
    /// Notes what is new in a frame of `bands` bands of `tiles` tiles.
    pub fn advance(&mut self, scene: &Scene, bands: usize, tiles: usize) {
        let Scene { view, occluders, .. } = scene;
        if self.view.as_ref() != Some(view) || self.known.len() > MAX_LAMPS {
            self.view = Some(*view);
            self.known.clear();
            self.slots.clear();
            self.bands.resize_with(bands, Vec::new);
            for band in &mut self.bands {
                band.resize_with(tiles, TileCache::default);
                band.iter_mut().for_each(|tile| tile.apply(Event::ViewChanged));
            }
        }
        let FrameHistory { occluders: old, airborne, next, known, pairing, .. } = self;
        pairing.each_change(old, occluders, |moved| {
            // How a tile is lit past tinted groups depends on which of them may be in the way at all, which reaches farther
            // than their shadows.
            let everywhere = moved.material.transmittance().is_some();
            for known in known.iter_mut() {
                known.lost |= everywhere;
                known.moved.push(*moved);
            }
        });
        next.clear();
        let is_airborne = |ball: &&Ball| ball.is_airborne();
        next.extend(scene.balls.iter().filter(is_airborne).map(|ball| Ball { rotation: [0.0; 4], ..*ball }));
        pairing.each_change(airborne, next, |ball| known.iter_mut().for_each(|known| known.moved_balls.push(*ball)));
        std::mem::swap(airborne, next);
        for known in &mut self.known {
            if known.moved.len() + known.moved_balls.len() > MAX_MOVES {
                known.lost = true;
                known.moved.clear();
                known.moved_balls.clear();
            }
        }
        self.occluders.clear();
        self.occluders.extend_from_slice(occluders);
    }

    /// Whether any tile is another than in the last frame.
    pub fn any_redrawn(&self) -> bool {
        self.bands.iter().flatten().any(|tile| tile.redrawn)
    }

    /// The slot of a lamp: it is given one if it is new, and another if it is not where it was or shines in another form.
    pub fn slot(&mut self, lamp: &Lamp) -> usize {
        let black = Lamp { color: [0.0; 3], ..*lamp };
        let at = self.slots.binary_search_by_key(&lamp.id, |&(id, _)| id);
        if let Ok(at) = at
            && self.known[self.slots[at].1].lamp == black
        {
            return self.slots[at].1;
        }
        let slot = self.known.len();
        self.known.push(KnownLamp { lamp: black, moved: Vec::new(), moved_balls: Vec::new(), lost: true });
        match at {
            Ok(at) => self.slots[at].1 = slot,
            Err(at) => self.slots.insert(at, (lamp.id, slot)),
        }
        slot
    }

    /// Every tile's layer of the lamp of this slot is valid.
    pub fn lamp_updated(&mut self, slot: usize) {
        self.known[slot].moved.clear();
        self.known[slot].moved_balls.clear();
        self.known[slot].lost = false;
    }
}
