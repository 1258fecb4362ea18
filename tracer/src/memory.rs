//! What was seen in earlier pictures and is still so: most of a table stands still.
//!
//! For every tile and lamp the picture of the tile in that lamp's light is kept. It holds until something that casts
//! shadows moves between the tile and the lamp, or a top moves in the tile; then it is made anew from nothing, so a
//! picture has the same bits whatever came before it. A lamp is known by where it is, not by its colour or its place in
//! a list: one that flashes is remembered while it is dark.

use crate::irradiance::Light;
use crate::response::{Gist, Part, Texels};
use crate::surfaces::Surfaces;
use crate::{Group, Lamp, Occluder, Path, Rgb, View};
use geometry::Bounds;

/// How many lamps are remembered: in a scene of more, every picture is made from nothing.
pub(crate) const MOST_LAMPS: usize = 160;

/// How many moves a dark lamp may miss before everything that was seen of it is forgotten.
const MOST_MOVES: usize = 200;

/// What one tile shows in the light of one lamp. What the glare needs is kept here, the rest where it need not be
/// touched for that.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sight {
    /// Whether what follows still holds.
    pub holds: bool,
    /// What hides the lamp from all of the tile, if it is one group alone.
    pub hidden_by: Option<Group>,
    /// What squares of texels are multiplied by; 0 in darkness.
    scale: f32,
    gist: Gist,
    /// The tile in that light; nothing where it never was lit.
    texels: Option<Box<Texels>>,
}

impl Sight {
    /// What is known to be lit, in light of this colour.
    fn lit(&self, color: Rgb) -> Option<Part<'_>> {
        let texels = self.texels.as_deref().filter(|_| self.is_lit())?;
        Some(Part { texels, gist: &self.gist, gain: color.map(|channel| channel * self.scale) })
    }

    /// Whether it is known to be lit.
    fn is_lit(&self) -> bool {
        self.holds && self.scale > 0.0
    }

    /// Keeps a picture.
    pub fn keep(&mut self, path: Path, light: &Light) {
        (self.holds, self.hidden_by) = (true, None);
        let texels = self.texels.get_or_insert_with(|| Box::new(Texels::dark()));
        self.scale = texels.keep(path, light, &mut self.gist);
    }

    /// Keeps in mind that nothing is lit, and what hides the lamp if it is one group alone.
    pub fn keep_dark(&mut self, hidden_by: Option<Group>) {
        (self.holds, self.hidden_by, self.scale) = (true, hidden_by, 0.0);
    }
}

/// What one tile shows under every known lamp.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileMemory {
    sights: Vec<Sight>,
    /// In the light from everywhere, with the light of tops of their own.
    pub base: Sight,
    /// In the light of inserts, known by their masks' places in memory.
    glows: Vec<((usize, usize), Sight)>,
    /// What it shows.
    pub surfaces: Surfaces,
    /// Whether this picture's tile is another than the last one's.
    pub fresh: bool,
    /// Whether the film shows the tile as it is now, but for its glare.
    pub developed: bool,
}

impl TileMemory {
    /// What was seen of a lamp.
    pub fn sight(&mut self, lamp: usize) -> &mut Sight {
        if self.sights.len() <= lamp {
            self.sights.resize_with(lamp + 1, Sight::default);
        }
        &mut self.sights[lamp]
    }

    /// What an insert's light does in the tile.
    pub fn glow(&mut self, mask: (usize, usize)) -> &mut Sight {
        let at = self.glows.iter().position(|glow| glow.0 == mask).unwrap_or_else(|| {
            self.glows.push((mask, Sight::default()));
            self.glows.len() - 1
        });
        &mut self.glows[at].1
    }

    /// Whether the tile is known to see nothing of a lamp.
    pub fn is_dark(&self, lamp: usize) -> bool {
        self.sights.get(lamp).is_some_and(|sight| sight.holds && !sight.is_lit())
    }

    /// What the tile shows of light from everywhere.
    pub fn base(&self) -> impl Iterator<Item = Part<'_>> {
        self.base.lit([1.0; 3]).into_iter()
    }

    /// What it shows of lamps, given by their numbers, and of inserts, given by their masks, in their colours.
    pub fn lit<'a>(
        &'a self,
        lamps: impl Iterator<Item = (usize, Rgb)> + 'a,
        glows: impl Iterator<Item = ((usize, usize), Rgb)> + 'a,
    ) -> impl Iterator<Item = Part<'a>> {
        let lamp = |(number, color): (usize, Rgb)| self.sights.get(number)?.lit(color);
        let glow = |(mask, color): ((usize, usize), Rgb)| {
            self.glows.iter().find(|glow| glow.0 == mask)?.1.lit(color)
        };
        // Few tiles have inserts.
        let glows = glows.take_while(|_| !self.glows.is_empty());
        lamps.filter_map(lamp).chain(glows.filter_map(glow))
    }

    /// Nothing holds any more.
    pub fn forget(&mut self) {
        self.surfaces.holds = false;
        self.base.holds = false;
        self.developed = false;
        for sight in self.sights.iter_mut().chain(self.glows.iter_mut().map(|glow| &mut glow.1)) {
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

    /// Whether any tile is another than in the last picture.
    pub fn is_fresh(&self) -> bool {
        self.bands.iter().flatten().any(|tile| tile.fresh)
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
