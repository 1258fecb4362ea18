//! What was seen in earlier pictures and is still so: most of a table stands still.
//!
//! For every tile, lamp and layer the visible fractions are kept. They hold until something that casts shadows moves
//! between the tile and the lamp, or a top moves in the tile; then they are found anew from nothing, so a picture with
//! memory has the same bits as one without. A lamp is known by where it is, not by its colour or its place in a list:
//! one that flashes is remembered while it is dark.

use crate::lanes::Lanes;
use crate::obstruction::Verdict;
use crate::surfaces::Surfaces;
use crate::{Lamp, Occluder, View};
use geometry::Bounds;

/// How many lamps are remembered.
const MOST_LAMPS: usize = 160;

/// How many moves a dark lamp may miss before everything that was seen of it is forgotten.
const MOST_MOVES: usize = 200;

/// What one tile saw of one lamp.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sight {
    /// Whether what follows still holds.
    pub holds: bool,
    /// For the floor and then each top: the verdict, and where its fractions begin.
    pub layers: Vec<(Verdict, usize)>,
    /// The visible fractions of mixed layers.
    pub fractions: Vec<Lanes>,
}

/// What one tile saw of every known lamp.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileMemory {
    sights: Vec<Sight>,
    /// What it shows.
    pub surfaces: Surfaces,
    /// Whether this picture's tile was drawn, and not left as it was.
    pub fresh: bool,
}

impl TileMemory {
    /// What was seen of a lamp.
    pub fn sight(&mut self, lamp: usize) -> &mut Sight {
        if self.sights.len() <= lamp {
            self.sights.resize_with(lamp + 1, Sight::default);
        }
        &mut self.sights[lamp]
    }

    /// Whether the tile is known to see nothing of a lamp.
    pub fn is_dark(&self, lamp: usize) -> bool {
        let dark = |sight: &Sight| sight.holds && sight.layers.iter().all(|layer| layer.0 == Verdict::Dark);
        self.sights.get(lamp).is_some_and(dark)
    }

    /// Nothing holds any more.
    pub fn forget(&mut self) {
        self.surfaces.holds = false;
        for sight in &mut self.sights {
            sight.holds = false;
        }
    }
}

/// A lamp that has been seen.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    /// The lamp, black.
    lamp: Lamp,
    /// What has moved since it shone last: where it was, and where it went.
    pub moved: Vec<Occluder>,
    /// Whether too much has moved to be told.
    pub lost: bool,
}

/// What the last picture was made of, and what has moved since.
#[derive(Clone, Debug, Default)]
pub(crate) struct Past {
    view: Option<View>,
    occluders: Vec<Occluder>,
    /// The lamps, by the numbers that [`TileMemory`] knows them by.
    pub known: Vec<Known>,
    /// The tiles, band by band.
    pub bands: Vec<Vec<TileMemory>>,
    /// Where tops have moved.
    pub moved_tops: Vec<Bounds>,
}

impl Past {
    /// Notes what is new in a picture of `bands` bands of `tiles` tiles.
    pub fn turn_page(&mut self, view: &View, occluders: &[Occluder], bands: usize, tiles: usize) {
        if self.view.as_ref() != Some(view) || self.known.len() > MOST_LAMPS {
            self.view = Some(*view);
            self.known.clear();
            self.bands.resize_with(bands, Vec::new);
            for band in &mut self.bands {
                band.resize_with(tiles, TileMemory::default);
                band.iter_mut().for_each(TileMemory::forget);
            }
        }
        for at in 0..self.occluders.len().max(occluders.len()) {
            let (old, new) = (self.occluders.get(at), occluders.get(at));
            if old != new {
                for known in &mut self.known {
                    known.moved.extend(old);
                    known.moved.extend(new);
                }
            }
        }
        for known in &mut self.known {
            if known.moved.len() > MOST_MOVES {
                known.lost = true;
                known.moved.clear();
            }
        }
        self.occluders.clear();
        self.occluders.extend_from_slice(occluders);
    }

    /// The number of a lamp, which is given one if it is new.
    pub fn number(&mut self, lamp: &Lamp) -> usize {
        let black = Lamp { color: [0.0; 3], ..*lamp };
        self.known.iter().position(|known| known.lamp == black).unwrap_or_else(|| {
            self.known.push(Known { lamp: black, moved: Vec::new(), lost: true });
            self.known.len() - 1
        })
    }

    /// The lamp of this number has been looked at from everywhere.
    pub fn looked_at(&mut self, number: usize) {
        self.known[number].moved.clear();
        self.known[number].lost = false;
    }
}
