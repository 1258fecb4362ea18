//! What was seen in earlier pictures and is still so: most of a table stands still.
//!
//! For every tile and lamp the picture of the tile in that lamp's light is kept. It holds until something that casts
//! shadows moves between the tile and the lamp, or a top moves in the tile; then it is made anew from nothing, so a
//! picture has the same bits whatever came before it. A lamp is known by where it is, not by its colour or its place in
//! a list: one that flashes is remembered while it is dark.

use crate::cache::cell_means::{CELLS_PER_TILE, Gist, Means, add_gists, means_of};
use crate::cache::g_buffer::Surfaces;
use crate::cache::lamp_layer::{Bare, Kept, LayerFormat, Part, Planes, Sight};
use crate::cache::lamp_set::Numbers;
use crate::cache::packed_planes::{Gains, Terms};
use crate::cache::weighted_sum::{Steps, Sum, put_together, scale_of};
use crate::scene::GlowKey;
use crate::simd::dispatch::prefetch;
use crate::tile::planes::{ALL_ROWS, AlbedoTile, RgbTile, RowMask};
use crate::{Group, Rgb, SimdLevel};

/// The light that a tile is put in.
pub(crate) struct Illumination<'a> {
    /// The light from everywhere.
    pub ambient: Rgb,
    /// Whether that is shaded.
    pub shaded: bool,
    /// That of lamps, by their numbers.
    pub lamps: &'a [Rgb],
}

/// What one tile shows under every known lamp.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileMemory {
    /// Whether this picture's tile is another than the last one's.
    pub fresh: bool,
    /// Whether the film shows the tile as it is now, but for its bloom.
    pub developed: bool,
    /// Whether it is all bare floor.
    is_floor: bool,
    /// The lamps of which all is known, and those of them that light it.
    whole: Numbers,
    lit: Numbers,
    /// What is known of each lamp, by its number.
    sights: Vec<Sight>,
    /// The pictures of those that have lit it.
    kept: Vec<Kept>,
    /// The planes of all pictures.
    planes: Planes,
    /// What the halves of these are multiplied by in this picture.
    gains: [Vec<Gains>; 3],
    /// What a step of the sums is worth.
    worth: Rgb,
    /// The light from everywhere.
    ambient: Rgb,
    /// In the light from everywhere, with the light of tops of their own; of a tile of bare floor only what the bloom
    /// needs of it, in white light.
    pub base: Sight,
    kept_base: Kept,
    /// In the light of inserts, known by their ids and their masks' printings.
    glows: Vec<(GlowKey, Sight, Kept)>,
    /// What it shows.
    pub surfaces: Surfaces,
}

impl TileMemory {
    /// What was seen of a lamp.
    pub fn sight(&mut self, lamp: usize) -> &mut Sight {
        if self.sights.len() <= lamp {
            self.sights.resize_with(lamp + 1, Sight::default);
        }
        &mut self.sights[lamp]
    }

    /// Notes rows of the tile in which something has moved before a lamp.
    pub fn stir(&mut self, lamp: usize, rows: RowMask) {
        self.sights[lamp].stale |= rows;
        if rows != 0 {
            self.whole.remove(lamp);
        }
    }

    /// Those of some lamps of which not all is known, or that are lost.
    pub fn to_make<'a>(&'a self, lamps: &'a Numbers, lost: &'a Numbers) -> impl Iterator<Item = usize> + 'a {
        lamps.without_or_with(&self.whole, lost)
    }

    /// What an insert's light does in the tile.
    pub fn glow(&mut self, glow: GlowKey) -> &mut Sight {
        let at = self.glows.iter().position(|known| known.0 == glow).unwrap_or_else(|| {
            self.glows.push((glow, Sight::default(), Kept::default()));
            self.glows.len() - 1
        });
        &mut self.glows[at].1
    }

    /// Whether the tile is known to see nothing of a lamp.
    pub fn is_dark(&self, lamp: usize) -> bool {
        self.whole.contains(lamp) && !self.lit.contains(lamp)
    }

    /// Keeps the picture in the light from everywhere.
    pub fn keep_base(&mut self, simd: SimdLevel, light: &RgbTile) {
        self.is_floor = false;
        self.kept_base.gauge(scale_of(simd, light));
        self.kept_base.keep_colors(simd, light, ALL_ROWS, &mut self.planes);
        self.base.renew(self.kept_base.is_lit, None);
    }

    /// Keeps in mind that all of the tile is floor of this reflectance.
    pub fn keep_floor_base(&mut self, simd: SimdLevel, albedo: &RgbTile) {
        self.is_floor = true;
        let mut means = [[0.0; CELLS_PER_TILE]; 3];
        means_of(simd, albedo, &mut means);
        self.kept_base.gist = Gist::of(&means);
        self.base.renew(false, None);
    }

    /// The place of the picture in a lamp's light: of darkness if there has been none.
    fn place_of(&mut self, lamp: usize) -> usize {
        let kept = &mut self.kept;
        let place = self.sights[lamp].kept.get_or_insert_with(|| {
            kept.push(Kept::of(lamp));
            kept.len() as u16 - 1
        });
        usize::from(*place)
    }

    /// Whether a lamp's picture would have to be kept in another way, if it is kept in colours or not.
    pub fn is_another(&mut self, lamp: usize, colors: bool) -> bool {
        let place = self.place_of(lamp);
        (self.kept[place].form == LayerFormat::Colors) != colors
    }

    /// Says what the steps of a lamp's light, kept in colours, are worth.
    pub fn gauge(&mut self, lamp: usize, scale: f32) {
        let place = self.place_of(lamp);
        self.kept[place].gauge(scale);
        self.sights[lamp].gauged = true;
    }

    /// Keeps rows of the picture in a lamp's light, which was gauged.
    pub fn keep(&mut self, lamp: usize, simd: SimdLevel, light: &RgbTile, rows: RowMask) {
        let place = self.place_of(lamp);
        let kept = &mut self.kept[place];
        kept.keep_colors(simd, light, rows, &mut self.planes);
        let is_lit = kept.is_lit;
        self.renew(lamp, is_lit, None);
    }

    /// Keeps rows of the picture in a lamp's light of a tile that is all floor; the first time, all of them.
    pub fn keep_floor(&mut self, lamp: usize, simd: SimdLevel, floor: &Bare, rows: RowMask) {
        let place = self.place_of(lamp);
        let kept = &mut self.kept[place];
        if !self.sights[lamp].gauged || kept.form == LayerFormat::Colors {
            kept.gauge_floor(simd, floor);
            self.sights[lamp].gauged = true;
        }
        kept.keep_floor(simd, floor, rows, &mut self.planes);
        let is_lit = kept.is_lit;
        self.renew(lamp, is_lit, None);
    }

    /// Keeps in mind that a lamp lights nothing, and what hides it if it is one group alone.
    pub fn keep_dark(&mut self, lamp: usize, hidden_by: Option<Group>) {
        if let Some(kept) = self.sight(lamp).kept {
            self.kept[usize::from(kept)].is_lit = false;
        }
        self.renew(lamp, false, hidden_by);
    }

    /// A lamp has been looked at.
    fn renew(&mut self, lamp: usize, is_lit: bool, hidden_by: Option<Group>) {
        self.sights[lamp].renew(is_lit, hidden_by);
        self.whole.insert(lamp);
        if is_lit {
            self.lit.insert(lamp);
        } else {
            self.lit.remove(lamp);
        }
    }

    /// Keeps the picture in an insert's light.
    pub fn keep_glow(&mut self, glow: GlowKey, simd: SimdLevel, light: &RgbTile) {
        if let Some((_, sight, kept)) = self.glows.iter_mut().find(|known| known.0 == glow) {
            kept.gauge(scale_of(simd, light));
            kept.keep_colors(simd, light, ALL_ROWS, &mut self.planes);
            sight.renew(kept.is_lit, None);
        }
    }

    /// The pictures that it is put together of, with the colours of their light.
    fn pictures<'a>(
        &'a self,
        light: &'a Illumination,
        glows: impl Iterator<Item = (GlowKey, Rgb)>,
    ) -> impl Iterator<Item = (&'a Kept, Rgb)> {
        let base = Some((&self.kept_base, [1.0; 3])).filter(|_| self.base.is_lit() && !light.shaded);
        let lamps = self.kept.iter().map(|kept| (kept, light.lamps[usize::from(kept.lamp)]));
        // Few tiles have inserts.
        let glows = glows
            .take_while(|_| !self.glows.is_empty())
            .filter_map(|(key, color)| self.glows.iter().find(|glow| glow.0 == key).map(|(_, _, kept)| (kept, color)));
        base.into_iter().chain(lamps).chain(glows).filter(|(kept, color)| kept.is_lit && *color != [0.0; 3])
    }

    /// Puts the tile in light, and in that of inserts, given by their keys; `means` becomes what the bloom needs of it,
    /// unless the light from everywhere is shaded. `parts` is room.
    pub fn light(
        &mut self,
        simd: SimdLevel,
        light: &Illumination,
        glows: impl Iterator<Item = (GlowKey, Rgb)> + Clone,
        parts: &mut Vec<Part>,
        means: &mut Means,
    ) {
        self.ambient = light.ambient;
        parts.clear();
        self.pictures(light, glows.clone()).for_each(|(kept, color)| kept.push_parts(color, parts));
        let steps = Steps::of(parts.iter().map(|part| part.gain));
        let mut sums = [[0; CELLS_PER_TILE]; 3];
        let gists = self
            .pictures(light, glows)
            .map(|(kept, color)| (&kept.gist, steps.whole(color.map(|channel| channel * kept.gist.scale))));
        add_gists(simd, gists, &mut sums);
        for channel in 0..3 {
            for (mean, sum) in means[channel].iter_mut().zip(sums[channel]) {
                *mean = sum as f32 * steps.worth[channel];
            }
        }
        if self.is_floor {
            self.kept_base.gist.add_light(light.ambient, means);
        }
        let Planes { irradiance, specular, colors } = &self.planes;
        let lengths = [irradiance.pairs().len(), specular.pairs().len(), colors.pairs().len()];
        for (gains, length) in self.gains.iter_mut().zip(lengths) {
            gains.clear();
            gains.resize(length, [0; 3]);
        }
        for Part { list, half, gain } in parts {
            let gains = &mut self.gains[*list][half.pair()];
            let whole = steps.whole(*gain);
            *gains = [0, 1, 2].map(|channel: usize| gains[channel] | whole[channel] << half.shift());
        }
        self.worth = steps.worth;
    }

    /// Asks for what [`TileMemory::compose`] will read.
    fn fetch_planes(&self) {
        self.gains.iter().for_each(|gains| prefetch(gains));
        prefetch(self.planes.irradiance.pairs());
        prefetch(self.planes.specular.pairs());
        prefetch(self.planes.colors.pairs());
    }

    /// Asks for what [`TileMemory::light`] will read.
    fn fetch_kept(&self) {
        prefetch(&self.kept);
    }

    /// Puts together what the tile shows, on floor of this paint. Where [`TileMemory::light`] was told so, `shade` darkens
    /// the light from everywhere.
    pub fn compose(
        &self,
        simd: SimdLevel,
        paint: &AlbedoTile,
        shade: Option<impl FnOnce(&mut RgbTile)>,
        out: &mut RgbTile,
    ) {
        let [irradiance, specular, colors] = &self.gains;
        let everywhere = if self.is_floor { self.ambient } else { [0.0; 3] };
        let lamps = Sum {
            irradiance: Terms { pairs: self.planes.irradiance.pairs(), gains: irradiance },
            specular: Terms { pairs: self.planes.specular.pairs(), gains: specular },
            colors: Terms { pairs: self.planes.colors.pairs(), gains: colors },
            worth: self.worth,
            everywhere: [0.0; 3],
        };
        let Some(shade) = shade else {
            return put_together(simd, &Sum { everywhere, ..lamps }, paint, false, out);
        };
        if self.is_floor {
            put_together(simd, &Sum { everywhere, ..Sum::NOTHING }, paint, false, out);
        } else {
            self.kept_base.decode(&self.planes, out);
        }
        shade(out);
        put_together(simd, &lamps, paint, true, out);
    }

    /// Nothing holds any more.
    pub fn forget(&mut self) {
        self.surfaces.holds = false;
        self.base = Sight::default();
        self.developed = false;
        (self.whole, self.lit) = (Numbers::default(), Numbers::default());
        self.sights.clear();
        self.kept.clear();
        self.glows.clear();
        self.kept_base = Kept::default();
        self.planes.clear();
    }
}

/// Tiles one after another; while one is looked at, what `prefetch` asks for of the next is on its way.
fn ahead(mut tiles: &mut [TileMemory], prefetch: impl Fn(&TileMemory)) -> impl Iterator<Item = &mut TileMemory> {
    std::iter::from_fn(move || {
        let (tile, others) = std::mem::take(&mut tiles).split_first_mut()?;
        others.first().into_iter().for_each(&prefetch);
        tiles = others;
        Some(tile)
    })
}

/// Tiles that are to be made true.
pub(crate) fn to_be_lit(tiles: &mut [TileMemory]) -> impl Iterator<Item = &mut TileMemory> {
    ahead(tiles, TileMemory::fetch_kept)
}

/// Tiles that are to be put together.
pub(crate) fn to_be_composed(tiles: &mut [TileMemory]) -> impl Iterator<Item = &mut TileMemory> {
    ahead(tiles, TileMemory::fetch_planes)
}
