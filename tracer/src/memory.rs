//! What was seen in earlier pictures and is still so: most of a table stands still.
//!
//! For every tile and lamp the picture of the tile in that lamp's light is kept. It holds until something that casts
//! shadows moves between the tile and the lamp, or a top moves in the tile; then it is made anew from nothing, so a
//! picture has the same bits whatever came before it. A lamp is known by where it is, not by its colour or its place in
//! a list: one that flashes is remembered while it is dark.

use crate::irradiance::Light;
use crate::lanes::{LANES, fetch};
use crate::lighting::ALL;
use crate::penumbra::{ALL_ROWS, Rows};
use crate::points::Plane;
use crate::response::{
    CELLS, Gist, Means, Paint, Part, Texels, add_colors, add_floor, add_grays, encode_rows, means_of, put_floor,
    scale_of,
};
use crate::surfaces::Surfaces;
use crate::{Group, Path, Rgb};

/// How a picture is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Form {
    /// Red, green and blue: three planes.
    #[default]
    Colors,
    /// What arrives at bare floor: one plane.
    Floor,
    /// The same, and after it what shines on the floor.
    GlossyFloor,
}

/// What one tile shows in the light of one lamp: what the glare needs of it, and where the rest is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sight {
    /// Whether what follows still holds.
    pub holds: bool,
    /// What hides the lamp from all of the tile, if it is one group alone.
    pub hidden_by: Option<Group>,
    form: Form,
    /// Rows that do not hold any more.
    pub stale: Rows,
    /// Whether there is any light.
    is_lit: bool,
    /// What squares of texels are multiplied by, and of those of the gloss; 0 if there is none.
    scales: [f32; 2],
    /// Whether these are those of the floor with nothing in the way: then rows can be kept one by one.
    pub gauged: bool,
    gist: Gist,
    /// Which of the tile's planes are its own.
    planes: std::ops::Range<usize>,
}

impl Sight {
    /// Whether it is known to be lit.
    fn is_lit(&self) -> bool {
        self.holds && self.is_lit
    }

    /// What has to be made anew.
    pub fn rows_to_make(&self) -> Rows {
        if self.holds && (self.stale == 0 || self.is_lit && self.gauged) { self.stale } else { ALL_ROWS }
    }

    /// Nothing of it holds any more.
    fn forget(&mut self) {
        (self.holds, self.gauged) = (false, false);
    }

    /// Its planes, so many at least.
    fn take<'a>(&mut self, count: usize, planes: &'a mut Vec<Texels>) -> &'a mut [Texels] {
        if self.planes.len() < count {
            self.planes = planes.len()..planes.len() + count;
            planes.resize(self.planes.end, Texels::dark());
        }
        &mut planes[self.planes.start..][..count]
    }

    /// Whether three planes are kept of it.
    pub fn is_colors(&self) -> bool {
        self.form == Form::Colors
    }

    /// Says what squares of texels of colours are to be multiplied by.
    pub fn gauge(&mut self, scale: f32) {
        (self.form, self.gauged, self.scales) = (Form::Colors, true, [scale, 0.0]);
    }

    /// Keeps some rows in colours; the first time, all.
    fn keep_colors(&mut self, path: Path, light: &Light, rows: Rows, planes: &mut Vec<Texels>) {
        (self.holds, self.hidden_by, self.stale) = (true, None, 0);
        let scale = self.scales[0];
        let texels = self.take(3, planes);
        for (plane, texels) in light.iter().zip(&mut *texels) {
            encode_rows(path, plane, &ALL, rows, scale, texels);
        }
        self.is_lit = !texels.iter().all(Texels::is_dark);
        self.gist.keep_colors(path, texels, scale, rows);
    }

    /// Keeps some rows of a floor; the first time, all.
    fn keep_floor(&mut self, path: Path, floor: Bare, rows: Rows, planes: &mut Vec<Texels>) {
        (self.holds, self.hidden_by, self.stale) = (true, None, 0);
        if !self.gauged || self.form == Form::Colors {
            let gauge = |plane: &Plane| scale_of(path, std::slice::from_ref(plane));
            self.scales = [gauge(floor.arriving), gauge(floor.shine)];
            self.gauged = true;
        }
        self.form = if self.scales[1] > 0.0 { Form::GlossyFloor } else { Form::Floor };
        let scales = self.scales;
        let (matt, gloss) = self.take(2, planes).split_at_mut(1);
        encode_rows(path, floor.arriving, floor.seen, rows, scales[0], &mut matt[0]);
        if scales[1] > 0.0 {
            encode_rows(path, floor.shine, floor.seen, rows, scales[1], &mut gloss[0]);
        }
        self.is_lit = !(matt[0].is_dark() && (scales[1] == 0.0 || gloss[0].is_dark()));
        self.gist.keep_floor(path, floor.albedo, [&matt[0], &gloss[0]], scales, rows);
    }
}

/// A tile of bare floor in the light of one lamp.
#[derive(Clone, Copy)]
pub(crate) struct Bare<'a> {
    /// Its reflectance.
    pub albedo: &'a Light,
    /// What arrives, and is reflected in the floor's colours.
    pub arriving: &'a Plane,
    /// What is reflected in the lamp's own colour.
    pub shine: &'a Plane,
    /// How much of both is not in shadow.
    pub seen: &'a Plane,
}

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
    /// Whether it sees any of a lamp, for every sight. Apart, since most lamps light few tiles.
    shown: Vec<bool>,
    /// In the light from everywhere, with the light of tops of their own; of a tile of bare floor only what the glare
    /// needs of it, in white light.
    pub base: Sight,
    /// Whether it is all bare floor.
    is_floor: bool,
    /// In the light of inserts, known by their masks' places in memory.
    glows: Vec<((usize, usize), Sight)>,
    /// The pictures of all of these: one after another, so that a tile is put together without a jump.
    planes: Vec<Texels>,
    /// What it is made of in this picture: in colours, of what arrives at the floor, of what shines there.
    colors: Vec<Lit>,
    arriving: Vec<Lit>,
    shine: Vec<Lit>,
    /// The light from everywhere.
    ambient: Rgb,
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
            self.shown.resize(lamp + 1, false);
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
        self.is_floor = false;
        self.base.gauge(scale_of(path, light));
        self.base.keep_colors(path, light, ALL_ROWS, &mut self.planes);
    }

    /// Keeps in mind that all of the tile is floor of this reflectance.
    pub fn keep_floor_base(&mut self, path: Path, albedo: &Light) {
        self.is_floor = true;
        self.base.holds = true;
        let mut means = [[0.0; CELLS]; 3];
        means_of(path, albedo, &mut means);
        self.base.gist = Gist::of(&means);
    }

    /// Keeps rows of the picture in a lamp's light.
    pub fn keep(&mut self, lamp: usize, path: Path, light: &Light, rows: Rows) {
        self.sights[lamp].keep_colors(path, light, rows, &mut self.planes);
        self.shown[lamp] = self.sights[lamp].is_lit();
    }

    /// Keeps rows of the picture in a lamp's light of a tile that is all floor.
    pub fn keep_floor(&mut self, lamp: usize, path: Path, floor: Bare, rows: Rows) {
        self.sights[lamp].keep_floor(path, floor, rows, &mut self.planes);
        self.shown[lamp] = self.sights[lamp].is_lit();
    }

    /// Keeps in mind that a lamp lights nothing, and what hides it if it is one group alone.
    pub fn keep_dark(&mut self, lamp: usize, hidden_by: Option<Group>) {
        let sight = &mut self.sights[lamp];
        (sight.holds, sight.hidden_by, sight.stale, sight.is_lit) = (true, hidden_by, 0, false);
        self.shown[lamp] = false;
    }

    /// Keeps the picture in an insert's light.
    pub fn keep_glow(&mut self, mask: (usize, usize), path: Path, light: &Light) {
        if let Some((_, sight)) = self.glows.iter_mut().find(|glow| glow.0 == mask) {
            sight.gauge(scale_of(path, light));
            sight.keep_colors(path, light, ALL_ROWS, &mut self.planes);
        }
    }

    /// Puts the tile in the light from everywhere, of lamps, given by their numbers, and of inserts, given by their masks.
    pub fn light(
        &mut self,
        path: Path,
        ambient: Rgb,
        lamps: impl Iterator<Item = (usize, Rgb)>,
        glows: impl Iterator<Item = ((usize, usize), Rgb)>,
    ) {
        self.ambient = ambient;
        self.means = [[0.0; CELLS]; 3];
        if self.is_floor {
            self.base.gist.add(path, ambient, &mut self.means);
        }
        let TileMemory { colors, arriving, shine, means, sights, shown, glows: inserts, .. } = self;
        [&mut *colors, arriving, shine].into_iter().for_each(Vec::clear);
        let mut add = |sight: &Sight, color: Rgb| {
            sight.gist.add(path, color, means);
            let lit = |scale: f32, plane: usize| Lit { plane, gain: color.map(|channel| channel * scale) };
            let first = lit(sight.scales[0], sight.planes.start);
            match sight.form {
                Form::Colors => colors.push(first),
                Form::Floor | Form::GlossyFloor => arriving.push(first),
            }
            if sight.form == Form::GlossyFloor {
                shine.push(lit(sight.scales[1], sight.planes.start + 1));
            }
        };
        if !self.is_floor && self.base.is_lit() {
            add(&self.base, [1.0; 3]);
        }
        for (number, color) in lamps {
            if shown.get(number).is_some_and(|&shown| shown) {
                add(&sights[number], color);
            }
        }
        // Few tiles have inserts.
        for (mask, color) in glows.take_while(|_| !inserts.is_empty()) {
            if let Some((_, sight)) = inserts.iter().find(|glow| glow.0 == mask && glow.1.is_lit()) {
                add(sight, color);
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
        fetch(&self.shown);
        for (sight, _) in self.sights.iter().zip(&self.shown).filter(|(_, shown)| **shown) {
            fetch(std::slice::from_ref(sight));
        }
    }

    /// Puts together what the tile shows, on floor of this paint; `shade` darkens the light from everywhere.
    pub fn compose(&self, path: Path, paint: &Paint, shade: Option<impl FnOnce(&mut Light)>, out: &mut Light) {
        let gray = |lit: &Lit| Part { texels: &self.planes[lit.plane], gain: lit.gain };
        let colored = |lit: &Lit| Part { texels: &self.planes[lit.plane..lit.plane + 3], gain: lit.gain };
        let (base, rest) = self.colors.split_at(usize::from(!self.is_floor && self.base.is_lit()));
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
        self.shown.fill(false);
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
