//! What the last picture was made of, what has moved since, and the tiles that remember it.

use crate::cache::tile_cache::TileMemory;
use crate::{Ball, Group, Lamp, Occluder, Scene, View};
use geometry::Bounds;

/// How many lamps are remembered: in a scene of more, every picture is made from nothing.
pub(crate) const MAX_LAMPS: usize = 160;

/// And of inserts.
pub(crate) const MAX_GLOWS: usize = 1_000;

/// How many moves a dark lamp may miss before everything that was seen of it is forgotten.
const MAX_MOVES: usize = 200;

/// A lamp that has been seen.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    /// The lamp, black.
    lamp: Lamp,
    /// What has moved since it shone last: where it was, and where it went.
    pub moved: Vec<Occluder>,
    /// The same of balls that float.
    pub moved_balls: Vec<Ball>,
    /// Whether too much has moved to be told.
    pub lost: bool,
}

/// What the last picture was made of, and what has moved since.
#[derive(Clone, Debug, Default)]
pub(crate) struct Past {
    view: Option<View>,
    occluders: Vec<Occluder>,
    /// The balls that float, not turned.
    airborne: Vec<Ball>,
    /// Those of the picture that is to come.
    next: Vec<Ball>,
    /// The lamps, by the numbers that [`TileMemory`] knows them by.
    pub known: Vec<Known>,
    /// The tiles, band by band.
    pub bands: Vec<Vec<TileMemory>>,
    /// Where tops have moved.
    pub moved_tops: Vec<Bounds>,
}

impl Past {
    /// Notes what is new in a picture of `bands` bands of `tiles` tiles.
    pub fn turn_page(&mut self, scene: &Scene, bands: usize, tiles: usize) {
        let Scene { view, occluders, .. } = scene;
        if self.view.as_ref() != Some(view) || self.known.len() > MAX_LAMPS {
            self.view = Some(*view);
            self.known.clear();
            self.bands.resize_with(bands, Vec::new);
            for band in &mut self.bands {
                band.resize_with(tiles, TileMemory::default);
                band.iter_mut().for_each(TileMemory::forget);
            }
        }
        let Past { occluders: old, airborne, next, known, .. } = self;
        let group = |occluder: &Occluder| occluder.group;
        each_move(old, occluders, group, |moved| known.iter_mut().for_each(|known| known.moved.push(*moved)));
        next.clear();
        next.extend(
            scene.balls.iter().filter(|ball| ball.is_airborne()).map(|ball| Ball { rotation: [0.0; 4], ..*ball }),
        );
        let group = |ball: &Ball| ball.group;
        each_move(airborne, next, group, |ball| known.iter_mut().for_each(|known| known.moved_balls.push(*ball)));
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

    /// Whether any tile is another than in the last picture.
    pub fn is_fresh(&self) -> bool {
        self.bands.iter().flatten().any(|tile| tile.fresh)
    }

    /// The number of a lamp, which is given one if it is new.
    pub fn number(&mut self, lamp: &Lamp) -> usize {
        let black = Lamp { color: [0.0; 3], ..*lamp };
        self.known.iter().position(|known| known.lamp == black).unwrap_or_else(|| {
            self.known.push(Known { lamp: black, moved: Vec::new(), moved_balls: Vec::new(), lost: true });
            self.known.len() - 1
        })
    }

    /// The lamp of this number has been looked at from everywhere.
    pub fn looked_at(&mut self, number: usize) {
        self.known[number].moved.clear();
        self.known[number].moved_balls.clear();
        self.known[number].lost = false;
    }
}

/// Calls `moved` for what was in the old list and is not in the new one, and the other way round. What comes and goes
/// leaves the others where they were, as long as they keep their order.
fn each_move<T: PartialEq>(mut old: &[T], mut new: &[T], group: impl Fn(&T) -> Group, mut moved: impl FnMut(&T)) {
    while let (Some((before, older)), Some((now, newer))) = (old.split_first(), new.split_first()) {
        let changed = before != now;
        let another = changed && group(before) != group(now);
        let came = another && newer.iter().any(|other| group(other) == group(before));
        let gone = another && !came;
        if changed && !came {
            moved(before);
        }
        if changed && !gone {
            moved(now);
        }
        old = if came { old } else { older };
        new = if gone { new } else { newer };
    }
    old.iter().chain(new).for_each(moved);
}
