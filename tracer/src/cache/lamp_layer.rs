//! What one tile shows in the light of one lamp: whether that still holds, and the picture.

use crate::cache::cell_means::Gist;
use crate::cache::packed_planes::{Half, Pair, encode_rows};
use crate::cache::weighted_sum::scale_of;
use crate::simd::dispatch::SimdLevel;
use crate::tile::planes::{ALL_ROWS, BLACK, FULLY_VISIBLE, Plane, RgbTile, RowMask};
use crate::{Group, Rgb};

/// What is known of a tile in the light of one lamp.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sight {
    /// Whether anything that is known holds.
    pub holds: bool,
    /// Whether there is any light.
    is_lit: bool,
    /// Whether the picture's scales are those of the tile with nothing in the way: then rows can be kept one by one.
    pub gauged: bool,
    /// Rows of which it does not hold.
    pub stale: RowMask,
    /// What hides the lamp from all of the tile, if it is one group alone.
    pub hidden_by: Option<Group>,
    /// Which of the tile's pictures it is, if there has been one.
    pub kept: Option<u16>,
}

impl Sight {
    /// Whether it is known to be lit.
    pub fn is_lit(&self) -> bool {
        self.holds && self.is_lit
    }

    /// Whether all that can be seen is known.
    pub fn is_whole(&self) -> bool {
        self.holds && self.stale == 0
    }

    /// What has to be made anew.
    pub fn rows_to_make(&self) -> RowMask {
        if self.holds && (self.stale == 0 || self.is_lit && self.gauged) { self.stale } else { ALL_ROWS }
    }

    /// Has been made anew.
    pub fn renew(&mut self, is_lit: bool, hidden_by: Option<Group>) {
        (self.holds, self.stale, self.is_lit, self.hidden_by) = (true, 0, is_lit, hidden_by);
    }
}

/// How a picture is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LayerFormat {
    /// Red, green and blue.
    #[default]
    Colors,
    /// What arrives at bare floor.
    Floor,
    /// The same, and what shines on the floor.
    GlossyFloor,
}

/// Half pairs of planes, given away one by one.
#[derive(Clone, Debug)]
pub(crate) struct Pool<const CHANNELS: usize> {
    /// The pairs; those that were given away before [`Planes::clear`] are still there.
    pairs: Vec<[Pair; CHANNELS]>,
    given: u16,
}

impl<const CHANNELS: usize> Default for Pool<CHANNELS> {
    fn default() -> Self {
        Pool { pairs: Vec::new(), given: 0 }
    }
}

impl<const CHANNELS: usize> Pool<CHANNELS> {
    /// The pairs of which any half is given away.
    pub fn pairs(&self) -> &[[Pair; CHANNELS]] {
        &self.pairs[..usize::from(self.given).div_ceil(2)]
    }

    /// The half that is in `place`; one is given away if none is.
    fn take(&mut self, place: &mut Option<Half>) -> (&mut [Pair; CHANNELS], Half) {
        let half = *place.get_or_insert_with(|| {
            self.given += 1;
            Half::after(self.given - 1)
        });
        if half.pair() == self.pairs.len() {
            self.pairs.push([Pair::NOTHING; CHANNELS]);
        }
        (&mut self.pairs[half.pair()], half)
    }
}

/// The planes of a tile's pictures.
#[derive(Clone, Debug, Default)]
pub(crate) struct Planes {
    /// Of what arrives at the floor.
    pub irradiance: Pool<1>,
    /// Of what shines there.
    pub specular: Pool<1>,
    /// Red, green, blue.
    pub colors: Pool<3>,
}

impl Planes {
    /// Nothing is given away any more.
    pub fn clear(&mut self) {
        self.irradiance.given = 0;
        self.specular.given = 0;
        self.colors.given = 0;
    }
}

/// A tile's picture: what the bloom needs of it, and where the rest is.
#[derive(Clone, Debug, Default)]
#[repr(align(64))]
pub(crate) struct Kept {
    /// The lamp, by its number.
    pub lamp: u16,
    /// Whether there is any light.
    pub is_lit: bool,
    /// In which planes.
    pub form: LayerFormat,
    /// What the planes' steps are worth, and those of the gloss; 0 if there is none.
    pub scales: [f32; 2],
    /// Its means.
    pub gist: Gist,
    /// Its places among those that arrive, that shine and that are coloured.
    halves: [Option<Half>; 3],
}

/// A plane, or three, as a part of a sum.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part {
    /// Whether it arrives, shines or is coloured: 0, 1, 2.
    pub list: usize,
    /// Where it is.
    pub half: Half,
    /// What it is multiplied by.
    pub gain: Rgb,
}

impl Kept {
    /// Darkness, in the light of a lamp.
    pub fn of(lamp: usize) -> Kept {
        Kept { lamp: lamp as u16, ..Kept::default() }
    }

    /// Says what steps of colours are worth.
    pub fn gauge(&mut self, scale: f32) {
        (self.form, self.scales) = (LayerFormat::Colors, [scale, 0.0]);
    }

    /// Says the same of a floor with nothing in the way.
    pub fn gauge_floor(&mut self, simd: SimdLevel, floor: &Bare) {
        self.scales = [floor.irradiance, floor.specular].map(|plane| scale_of(simd, std::slice::from_ref(plane)));
        self.form = if self.scales[1] > 0.0 { LayerFormat::GlossyFloor } else { LayerFormat::Floor };
    }

    /// Keeps some rows in colours, which were gauged.
    pub fn keep_colors(&mut self, simd: SimdLevel, light: &RgbTile, rows: RowMask, planes: &mut Planes) {
        let scale = self.scales[0];
        let (pairs, half) = planes.colors.take(&mut self.halves[2]);
        for (plane, pair) in light.iter().zip(&mut *pairs) {
            encode_rows(simd, plane, &FULLY_VISIBLE, rows, scale, half, pair);
        }
        self.gist.keep_colors(simd, pairs, half, scale, rows);
        self.is_lit = !pairs.iter().all(|pair| pair.is_dark(half));
    }

    /// Keeps some rows of a floor, which was gauged.
    pub fn keep_floor(&mut self, simd: SimdLevel, floor: &Bare, rows: RowMask, planes: &mut Planes) {
        let scales = self.scales;
        let ([matt], matt_half) = planes.irradiance.take(&mut self.halves[0]);
        encode_rows(simd, floor.irradiance, floor.seen, rows, scales[0], matt_half, matt);
        self.is_lit = !matt.is_dark(matt_half);
        let matt = (&*matt, matt_half);
        let gloss = if self.form == LayerFormat::GlossyFloor {
            let ([gloss], half) = planes.specular.take(&mut self.halves[1]);
            encode_rows(simd, floor.specular, floor.seen, rows, scales[1], half, gloss);
            self.is_lit |= !gloss.is_dark(half);
            (&*gloss, half)
        } else {
            matt
        };
        self.gist.keep_floor(simd, floor.albedo, [matt, gloss], scales, rows);
    }

    /// Adds what it is in light of a colour.
    pub fn push_parts(&self, color: Rgb, parts: &mut Vec<Part>) {
        let mut push = |list: usize, scale: f32| {
            let part = |half| Part { list, half, gain: color.map(|channel| channel * scale) };
            parts.extend(self.halves[list].map(part));
        };
        match self.form {
            LayerFormat::Colors => push(2, self.scales[0]),
            LayerFormat::Floor => push(0, self.scales[0]),
            LayerFormat::GlossyFloor => {
                push(0, self.scales[0]);
                push(1, self.scales[1]);
            }
        }
    }

    /// The picture itself, kept in colours; black if there is none.
    pub fn decode(&self, planes: &Planes, out: &mut RgbTile) {
        *out = BLACK;
        let Some(half) = self.halves[2].filter(|_| self.is_lit) else { return };
        for (plane, pair) in out.iter_mut().zip(&planes.colors.pairs[half.pair()]) {
            for (row, line) in plane.iter_mut().enumerate() {
                *line = pair.row(half, row).map(|number| number * self.scales[0]);
            }
        }
    }
}

/// A tile of bare floor in the light of one lamp.
#[derive(Clone, Copy)]
pub(crate) struct Bare<'a> {
    /// Its reflectance.
    pub albedo: &'a RgbTile,
    /// What arrives, and is reflected in the floor's colours.
    pub irradiance: &'a Plane,
    /// What is reflected in the lamp's own colour.
    pub specular: &'a Plane,
    /// How much of both is not in shadow.
    pub seen: &'a Plane,
}
