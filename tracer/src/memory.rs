//! What was seen in earlier pictures and is still so: most of a table stands still.
//!
//! For every tile and lamp the picture of the tile in that lamp's light is kept. It holds until something that casts
//! shadows moves between the tile and the lamp, or a top moves in the tile; then it is made anew from nothing, so a
//! picture has the same bits whatever came before it. A lamp is known by where it is, not by its colour or its place in
//! a list: one that flashes is remembered while it is dark.

use crate::gist::{CELLS, Gist, Means, means_of};
use crate::irradiance::Light;
use crate::lanes::{LANES, fetch};
use crate::penumbra::{ALL_ROWS, Rows};
use crate::response::{Paint, Part, Texels, add_colors, add_floor, add_grays, put_floor, scale_of};
use crate::sight::{Bare, Form, Kept, Sight};
use crate::surfaces::Surfaces;
use crate::{Group, Path, Rgb};

/// A plane, or the first of three, in its light.
#[derive(Clone, Copy, Debug)]
struct Lit {
    plane: usize,
    gain: Rgb,
}

/// What one tile shows under every known lamp.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileMemory {
    sights: Vec<Sight>,
    /// The pictures of these. Apart, since most lamps light few tiles.
    kept: Vec<Kept>,
    /// In the light from everywhere, with the light of tops of their own; of a tile of bare floor only what the glare
    /// needs of it, in white light.
    pub base: Sight,
    kept_base: Kept,
    /// Whether it is all bare floor.
    is_floor: bool,
    /// In the light of inserts, known by their masks' places in memory.
    glows: Vec<((usize, usize), Sight, Kept)>,
    /// The pictures of all of these: one after another, so that a tile is put together without a jump.
    planes: Vec<Texels>,
    /// What it is made of in this picture: in colours, of what arrives at the floor, of what shines there.
    colors: Vec<Lit>,
    arriving: Vec<Lit>,
    shine: Vec<Lit>,
    /// The light from everywhere.
    ambient: Rgb,
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
            self.kept.resize_with(lamp + 1, Kept::default);
        }
        &mut self.sights[lamp]
    }

    /// What an insert's light does in the tile.
    pub fn glow(&mut self, mask: (usize, usize)) -> &mut Sight {
        let at = self.glows.iter().position(|glow| glow.0 == mask).unwrap_or_else(|| {
            self.glows.push((mask, Sight::default(), Kept::default()));
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
        self.is_floor = false;
        self.kept_base.gauge(scale_of(path, light));
        self.base.renew(self.kept_base.keep_colors(path, light, ALL_ROWS, &mut self.planes), None);
    }

    /// Keeps in mind that all of the tile is floor of this reflectance.
    pub fn keep_floor_base(&mut self, path: Path, albedo: &Light) {
        self.is_floor = true;
        let mut means = [[0.0; CELLS]; 3];
        means_of(path, albedo, &mut means);
        self.kept_base.gist = Gist::of(&means);
        self.base.renew(false, None);
    }

    /// Whether a lamp's picture would have to be kept in another way, if it is kept in colours or not.
    pub fn is_another(&self, lamp: usize, colors: bool) -> bool {
        (self.kept[lamp].form == Form::Colors) != colors
    }

    /// Says what squares of texels are multiplied by in a lamp's light, kept in colours.
    pub fn gauge(&mut self, lamp: usize, scale: f32) {
        self.sights[lamp].gauged = true;
        self.kept[lamp].gauge(scale);
    }

    /// Keeps rows of the picture in a lamp's light, which was gauged.
    pub fn keep(&mut self, lamp: usize, path: Path, light: &Light, rows: Rows) {
        let is_lit = self.kept[lamp].keep_colors(path, light, rows, &mut self.planes);
        self.sights[lamp].renew(is_lit, None);
    }

    /// Keeps rows of the picture in a lamp's light of a tile that is all floor; the first time, all of them.
    pub fn keep_floor(&mut self, lamp: usize, path: Path, floor: &Bare, rows: Rows) {
        let (sight, kept) = (&mut self.sights[lamp], &mut self.kept[lamp]);
        if !sight.gauged || kept.form == Form::Colors {
            kept.gauge_floor(path, floor);
            sight.gauged = true;
        }
        sight.renew(kept.keep_floor(path, floor, rows, &mut self.planes), None);
    }

    /// Keeps in mind that a lamp lights nothing, and what hides it if it is one group alone.
    pub fn keep_dark(&mut self, lamp: usize, hidden_by: Option<Group>) {
        self.sights[lamp].renew(false, hidden_by);
    }

    /// Keeps the picture in an insert's light.
    pub fn keep_glow(&mut self, mask: (usize, usize), path: Path, light: &Light) {
        if let Some((_, sight, kept)) = self.glows.iter_mut().find(|glow| glow.0 == mask) {
            kept.gauge(scale_of(path, light));
            sight.renew(kept.keep_colors(path, light, ALL_ROWS, &mut self.planes), None);
        }
    }

    /// Puts the tile in the light from everywhere, of lamps, given by their numbers, and of inserts, given by their masks;
    /// `means` becomes what the glare needs of it.
    pub fn light(
        &mut self,
        path: Path,
        ambient: Rgb,
        lamps: impl Iterator<Item = (usize, Rgb)>,
        glows: impl Iterator<Item = ((usize, usize), Rgb)>,
        means: &mut Means,
    ) {
        self.ambient = ambient;
        *means = [[0.0; CELLS]; 3];
        if self.is_floor {
            self.kept_base.gist.add(path, ambient, means);
        }
        let TileMemory { colors, arriving, shine, sights, kept, glows: inserts, .. } = self;
        [&mut *colors, arriving, shine].into_iter().for_each(Vec::clear);
        let mut add = |kept: &Kept, color: Rgb| {
            kept.gist.add(path, color, means);
            let lit = |scale: f32, plane: usize| Lit { plane, gain: color.map(|channel| channel * scale) };
            let first = lit(kept.scales[0], kept.planes.start);
            match kept.form {
                Form::Colors => colors.push(first),
                Form::Floor | Form::GlossyFloor => arriving.push(first),
            }
            if kept.form == Form::GlossyFloor {
                shine.push(lit(kept.scales[1], kept.planes.start + 1));
            }
        };
        if self.base.is_lit() {
            add(&self.kept_base, [1.0; 3]);
        }
        for (number, color) in lamps {
            if sights.get(number).is_some_and(Sight::is_lit) {
                add(&kept[number], color);
            }
        }
        // Few tiles have inserts.
        for (mask, color) in glows.take_while(|_| !inserts.is_empty()) {
            if let Some((_, _, kept)) = inserts.iter().find(|glow| glow.0 == mask && glow.1.is_lit()) {
                add(kept, color);
            }
        }
    }

    /// Asks for what [`TileMemory::compose`] will read.
    fn fetch_planes(&self) {
        for lit in &self.colors {
            fetch(&self.planes[lit.plane..lit.plane + 3]);
        }
        for lit in self.arriving.iter().chain(&self.shine) {
            fetch(&self.planes[lit.plane..lit.plane + 1]);
        }
    }

    /// Asks for what [`TileMemory::light`] will read.
    fn fetch_sights(&self) {
        for (_, kept) in self.sights.iter().zip(&self.kept).filter(|(sight, _)| sight.is_lit()) {
            fetch(std::slice::from_ref(kept));
        }
    }

    /// Puts together what the tile shows, on floor of this paint; `shade` darkens the light from everywhere.
    pub fn compose(&self, path: Path, paint: &Paint, shade: Option<impl FnOnce(&mut Light)>, out: &mut Light) {
        let gray = |lit: &Lit| Part { texels: &self.planes[lit.plane], gain: lit.gain };
        let colored = |lit: &Lit| Part { texels: &self.planes[lit.plane..lit.plane + 3], gain: lit.gain };
        let (base, rest) = self.colors.split_at(usize::from(self.base.is_lit()));
        let arriving = self.arriving.iter().map(gray);
        if !self.is_floor {
            out.as_flattened_mut().fill([0.0; LANES]);
            add_colors(path, base.iter().map(colored), out);
        }
        match shade {
            Some(shade) => {
                if self.is_floor {
                    put_floor(path, paint, self.ambient, std::iter::empty(), out);
                }
                shade(out);
                add_floor(path, paint, arriving, out);
            }
            None if self.is_floor => put_floor(path, paint, self.ambient, arriving, out),
            None => add_floor(path, paint, arriving, out),
        }
        add_grays(path, self.shine.iter().map(gray), out);
        add_colors(path, rest.iter().map(colored), out);
    }

    /// Nothing holds any more.
    pub fn forget(&mut self) {
        self.surfaces.holds = false;
        self.base.forget();
        self.developed = false;
        for sight in self.sights.iter_mut().chain(self.glows.iter_mut().map(|glow| &mut glow.1)) {
            sight.forget();
        }
    }
}

/// Tiles one after another; while one is looked at, what `fetch` asks for of the next is on its way.
fn ahead(mut tiles: &mut [TileMemory], fetch: impl Fn(&TileMemory)) -> impl Iterator<Item = &mut TileMemory> {
    std::iter::from_fn(move || {
        let (tile, others) = std::mem::take(&mut tiles).split_first_mut()?;
        others.first().into_iter().for_each(&fetch);
        tiles = others;
        Some(tile)
    })
}

/// Tiles that are to be made true.
pub(crate) fn to_be_lit(tiles: &mut [TileMemory]) -> impl Iterator<Item = &mut TileMemory> {
    ahead(tiles, TileMemory::fetch_sights)
}

/// Tiles that are to be put together.
pub(crate) fn to_be_composed(tiles: &mut [TileMemory]) -> impl Iterator<Item = &mut TileMemory> {
    ahead(tiles, TileMemory::fetch_planes)
}
