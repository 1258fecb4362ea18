//! What one tile shows in the light of one lamp: whether that still holds, and the picture.

use crate::Group;
use crate::gist::Gist;
use crate::irradiance::Light;
use crate::lanes::Path;
use crate::lighting::ALL;
use crate::penumbra::{ALL_ROWS, Rows};
use crate::points::Plane;
use crate::response::{DARK, Texels, encode_rows, scale_of};
use std::ops::Range;

/// What is known of a tile in the light of one lamp.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sight {
    /// Whether anything that is known holds.
    pub holds: bool,
    /// Rows of which it does not.
    pub stale: Rows,
    /// Whether there is any light.
    is_lit: bool,
    /// Whether the picture's scales are those of the tile with nothing in the way: then rows can be kept one by one.
    pub gauged: bool,
    /// What hides the lamp from all of the tile, if it is one group alone.
    pub hidden_by: Option<Group>,
}

impl Sight {
    /// Whether it is known to be lit.
    pub fn is_lit(&self) -> bool {
        self.holds && self.is_lit
    }

    /// What has to be made anew.
    pub fn rows_to_make(&self) -> Rows {
        if self.holds && (self.stale == 0 || self.is_lit && self.gauged) { self.stale } else { ALL_ROWS }
    }

    /// Has been made anew.
    pub fn renew(&mut self, is_lit: bool, hidden_by: Option<Group>) {
        (self.holds, self.stale, self.is_lit, self.hidden_by) = (true, 0, is_lit, hidden_by);
    }

    /// Nothing of it holds any more.
    pub fn forget(&mut self) {
        (self.holds, self.gauged) = (false, false);
    }
}

/// How a picture is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Form {
    /// Red, green and blue: three planes.
    #[default]
    Colors,
    /// What arrives at bare floor: one plane.
    Floor,
    /// The same, and after it what shines on the floor.
    GlossyFloor,
}

/// A tile's picture: what the glare needs of it, and where the rest is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Kept {
    /// In which planes.
    pub form: Form,
    /// What squares of texels are multiplied by, and of those of the gloss; 0 if there is none.
    pub scales: [f32; 2],
    /// Its means.
    pub gist: Gist,
    /// Which of the tile's planes are its own.
    pub planes: Range<usize>,
}

impl Kept {
    /// Its planes, so many at least.
    fn take<'a>(&mut self, count: usize, planes: &'a mut Vec<Texels>) -> &'a mut [Texels] {
        if self.planes.len() < count {
            self.planes = planes.len()..planes.len() + count;
            planes.resize(self.planes.end, DARK.clone());
        }
        &mut planes[self.planes.start..][..count]
    }

    /// Says what squares of texels of colours are to be multiplied by.
    pub fn gauge(&mut self, scale: f32) {
        (self.form, self.scales) = (Form::Colors, [scale, 0.0]);
    }

    /// Says the same of a floor with nothing in the way.
    pub fn gauge_floor(&mut self, path: Path, floor: &Bare) {
        self.scales = [floor.arriving, floor.shine].map(|plane| scale_of(path, std::slice::from_ref(plane)));
        self.form = if self.scales[1] > 0.0 { Form::GlossyFloor } else { Form::Floor };
    }

    /// Keeps some rows in colours, which were gauged; says whether there is any light.
    pub fn keep_colors(&mut self, path: Path, light: &Light, rows: Rows, planes: &mut Vec<Texels>) -> bool {
        let scale = self.scales[0];
        let texels = self.take(3, planes);
        for (plane, texels) in light.iter().zip(&mut *texels) {
            encode_rows(path, plane, &ALL, rows, scale, texels);
        }
        self.gist.keep_colors(path, texels, scale, rows);
        !texels.iter().all(Texels::is_dark)
    }

    /// Keeps some rows of a floor, which was gauged; says whether there is any light.
    pub fn keep_floor(&mut self, path: Path, floor: &Bare, rows: Rows, planes: &mut Vec<Texels>) -> bool {
        let (scales, glossy) = (self.scales, self.form == Form::GlossyFloor);
        let texels = self.take(1 + usize::from(glossy), planes);
        encode_rows(path, floor.arriving, floor.seen, rows, scales[0], &mut texels[0]);
        if glossy {
            encode_rows(path, floor.shine, floor.seen, rows, scales[1], &mut texels[1]);
        }
        let gloss = if glossy { &texels[1] } else { &DARK };
        self.gist.keep_floor(path, floor.albedo, [&texels[0], gloss], scales, rows);
        !texels.iter().all(Texels::is_dark)
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
