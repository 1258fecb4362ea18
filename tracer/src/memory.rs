//! What was seen in earlier pictures and is still so: most of a table stands still.
//!
//! For every tile and lamp the picture of the tile in that lamp's light is kept. It holds until something that casts
//! shadows moves between the tile and the lamp, or a top moves in the tile; then it is made anew from nothing, so a
//! picture has the same bits whatever came before it. A lamp is known by where it is, not by its colour or its place in
//! a list: one that flashes is remembered while it is dark.

use crate::irradiance::Light;
use crate::response::{CELLS, Gist, Means, Part, Texels, add_gist};
use crate::surfaces::Surfaces;
use crate::{Group, Lamp, Occluder, Path, Rgb, View};
use geometry::Bounds;

/// How many lamps are remembered: in a scene of more, every picture is made from nothing.
pub(crate) const MOST_LAMPS: usize = 160;

/// How many moves a dark lamp may miss before everything that was seen of it is forgotten.
const MOST_MOVES: usize = 200;

/// What one tile shows in the light of one lamp: what the glare needs of it, and where the rest is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sight {
    /// Whether what follows still holds.
    pub holds: bool,
    /// What hides the lamp from all of the tile, if it is one group alone.
    pub hidden_by: Option<Group>,
    /// What squares of texels are multiplied by; 0 in darkness.
    scale: f32,
    gist: Gist,
    /// Which of the tile's pictures it is; none where it never was lit.
    picture: Option<u32>,
}

impl Sight {
    /// Whether it is known to be lit.
    fn is_lit(&self) -> bool {
        self.holds && self.scale > 0.0
    }

    /// The picture, in light of this colour.
    fn lit(&self, color: Rgb) -> Option<Lit> {
        let picture = self.picture.filter(|_| self.is_lit())?;
        Some(Lit { picture, gain: color.map(|channel| channel * self.scale) })
    }

    fn keep(&mut self, path: Path, light: &Light, pictures: &mut Vec<Texels>) {
        (self.holds, self.hidden_by) = (true, None);
        let at = *self.picture.get_or_insert_with(|| {
            pictures.push(Texels::dark());
            pictures.len() as u32 - 1
        });
        self.scale = pictures[at as usize].keep(path, light, &mut self.gist);
    }
}

/// A picture of a tile in its light.
#[derive(Clone, Copy, Debug)]
struct Lit {
    picture: u32,
    gain: Rgb,
}

/// What one tile shows under every known lamp.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileMemory {
    sights: Vec<Sight>,
    /// Of every sight, what its picture is multiplied by; 0 where there is none. Apart, since most lamps light few tiles.
    scales: Vec<f32>,
    /// In the light from everywhere, with the light of tops of their own.
    pub base: Sight,
    /// In the light of inserts, known by their masks' places in memory.
    glows: Vec<((usize, usize), Sight)>,
    /// The pictures of all of these: one after another, so that a tile is put together without a jump.
    pictures: Vec<Texels>,
    /// What it is made of in this picture: first the light from everywhere, if there is any.
    lit: Vec<Lit>,
    /// Whether the first of these is the light from everywhere.
    has_base: bool,
    /// Their sum's means.
    pub means: Means,
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
            self.scales.resize(lamp + 1, 0.0);
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

    /// Keeps the picture in the light from everywhere.
    pub fn keep_base(&mut self, path: Path, light: &Light) {
        self.base.keep(path, light, &mut self.pictures);
    }

    /// Keeps the picture in a lamp's light.
    pub fn keep(&mut self, lamp: usize, path: Path, light: &Light) {
        self.sights[lamp].keep(path, light, &mut self.pictures);
        self.scales[lamp] = self.sights[lamp].scale;
    }

    /// Keeps in mind that a lamp lights nothing, and what hides it if it is one group alone.
    pub fn keep_dark(&mut self, lamp: usize, hidden_by: Option<Group>) {
        let sight = &mut self.sights[lamp];
        (sight.holds, sight.hidden_by, sight.scale) = (true, hidden_by, 0.0);
        self.scales[lamp] = 0.0;
    }

    /// Keeps the picture in an insert's light.
    pub fn keep_glow(&mut self, mask: (usize, usize), path: Path, light: &Light) {
        if let Some((_, sight)) = self.glows.iter_mut().find(|glow| glow.0 == mask) {
            sight.keep(path, light, &mut self.pictures);
        }
    }

    /// Puts the tile in the light of lamps, given by their numbers, and of inserts, given by their masks.
    pub fn light(
        &mut self,
        path: Path,
        lamps: impl Iterator<Item = (usize, Rgb)>,
        glows: impl Iterator<Item = ((usize, usize), Rgb)>,
    ) {
        self.lit.clear();
        self.means = [[0.0; CELLS]; 3];
        let TileMemory { lit, means, sights, scales, glows: inserts, .. } = self;
        let mut add = |sight: &Sight, color: Rgb| {
            if let Some(part) = sight.lit(color) {
                add_gist(path, &sight.gist, part.gain, means);
                lit.push(part);
            }
        };
        add(&self.base, [1.0; 3]);
        for (number, color) in lamps {
            if scales.get(number).is_some_and(|&scale| scale > 0.0) {
                add(&sights[number], color);
            }
        }
        // Few tiles have inserts.
        for (mask, color) in glows.take_while(|_| !inserts.is_empty()) {
            if let Some((_, sight)) = inserts.iter().find(|glow| glow.0 == mask) {
                add(sight, color);
            }
        }
        self.has_base = self.base.is_lit();
    }

    /// What the tile shows of light from everywhere, and of the lamps and inserts that it is lit by.
    pub fn parts(&self) -> (impl Iterator<Item = Part<'_>>, impl Iterator<Item = Part<'_>>) {
        let (base, rest) = self.lit.split_at(usize::from(self.has_base));
        let part = |lit: &Lit| Part { texels: &self.pictures[lit.picture as usize], gain: lit.gain };
        (base.iter().map(part), rest.iter().map(part))
    }

    /// Nothing holds any more.
    pub fn forget(&mut self) {
        self.surfaces.holds = false;
        self.base.holds = false;
        self.developed = false;
        self.scales.fill(0.0);
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
