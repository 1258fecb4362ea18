//! A tile in the light of one lamp: what stands between them, how much of the lamp each point sees, and what its surfaces
//! make of that.

use crate::cache::weighted_sum::scale_of;
use crate::realtime::tile_renderer::{Lit, Stage, Workspace};
use crate::shading::falloff::Falloff;
use crate::shading::surface::{apply_visibility, floor_irradiance, shade_floor, shade_top};
use crate::shading::top_layer::TopLayer;
use crate::simd::dispatch::{LANES, SimdLevel, set_bits};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{ALL_ROWS, BLACK, FULLY_VISIBLE, RgbTile, RowMask};
use crate::tile::rect::TileRect;
use crate::visibility::blockers::VisibilityClass;
use crate::visibility::query::VisibilityQuery;
use crate::visibility::shaft::Shaft;
use crate::visibility::transmission;
use crate::{Group, Rgb};

/// What a lamp lights of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lighted {
    /// Nothing.
    Dark,
    /// Bare floor, and nothing of its light is tinted; how much of the lamp it sees.
    Floor(VisibilityClass),
    /// Anything.
    Colors,
}

impl Workspace {
    /// Puts some rows of the tile in the light of one lamp, of the colour white, into [`Workspace::picture`], or if it is
    /// all floor, into [`Workspace::irradiance`] and [`Workspace::specular`], before what is in the way, which is in
    /// [`Workspace::fraction`].
    pub(crate) fn light(&mut self, stage: &Stage, at: usize, rect: &TileRect, layers: usize, rows: RowMask) -> Lighted {
        self.look_at(stage, at, rect);
        let near = &self.near[at];
        let met = transmission::on_path(stage.tinted, |group| near.casts(group));
        if met.as_slice().is_empty() {
            if layers == 0 {
                let verdict = self.light_floor_past(stage, at, rect, &[], rows);
                return if verdict == VisibilityClass::Umbra { Lighted::Dark } else { Lighted::Floor(verdict) };
            }
            let lit = self.light_past(stage, at, rect, layers, &[], rows);
            return if lit { Lighted::Colors } else { Lighted::Dark };
        }
        let mut lit = false;
        self.sum = BLACK;
        transmission::each_subset(met.as_slice(), |away, part| {
            if part != [0.0; 3] && self.light_past(stage, at, rect, layers, away, rows) {
                lit = true;
                add(&self.picture, part, &mut self.sum);
            }
        });
        self.picture = self.sum;
        // What hides the lamp with every filter away is more than one group can be blamed for.
        self.blockers.hidden_by = None;
        if lit { Lighted::Colors } else { Lighted::Dark }
    }

    /// What a step is worth where the tile is kept in the light of one lamp: that of all the light that it would show were
    /// nothing in the way.
    pub(crate) fn gauge(&mut self, stage: &Stage, at: usize, rect: &TileRect, layers: usize) -> f32 {
        std::mem::swap(&mut self.picture, &mut self.sum);
        let falloff = Falloff::new(&stage.lamps[at].lamp, rect.middle_mm);
        self.picture = BLACK;
        if self.whole || self.floor.count > 0 {
            self.light_floor(stage, falloff, ALL_ROWS);
            self.paint(stage.simd, ALL_ROWS);
        }
        for layer in 0..layers {
            self.light_top(stage, falloff, layer, ALL_ROWS, VisibilityClass::Lit);
        }
        let scale = scale_of(stage.simd, &self.picture);
        std::mem::swap(&mut self.picture, &mut self.sum);
        scale
    }

    /// Finds how much of a lamp the floor sees, past everything but some groups, and puts its light into
    /// [`Workspace::irradiance`] and [`Workspace::specular`].
    fn light_floor_past(
        &mut self,
        stage: &Stage,
        at: usize,
        rect: &TileRect,
        away: &[Group],
        rows: RowMask,
    ) -> VisibilityClass {
        let verdict = self.sees(stage, at, rect, None, away, rows);
        if verdict != VisibilityClass::Umbra {
            self.light_floor(stage, Falloff::new(&stage.lamps[at].lamp, rect.middle_mm), rows);
        }
        verdict
    }

    /// Puts the floor in a lamp's light with nothing in the way, into [`Workspace::irradiance`] and [`Workspace::specular`].
    pub(crate) fn light_floor(&mut self, stage: &Stage, falloff: Falloff, rows: RowMask) {
        let blocks = self.floor_blocks(rows);
        let points = if self.whole { stage.full_tile } else { &self.floor };
        let (irradiance, specular) = (&mut self.irradiance, &mut self.specular);
        floor_irradiance(
            stage.simd,
            points,
            blocks,
            &self.ground,
            falloff,
            stage.scene.floor.gloss,
            irradiance,
            specular,
        );
    }

    /// The blocks of the floor's points that are in some rows.
    fn floor_blocks(&self, rows: RowMask) -> u16 {
        if self.whole { rows } else { self.floor.blocks_in(rows) }
    }

    /// Takes from [`Workspace::irradiance`] and [`Workspace::specular`] what is in the way.
    pub(crate) fn veil(&mut self, simd: SimdLevel, verdict: VisibilityClass, rows: RowMask) {
        if verdict == VisibilityClass::Partial {
            apply_visibility(simd, self.floor_blocks(rows), &self.fraction, &mut self.irradiance, &mut self.specular);
        }
    }

    /// Puts the floor's picture, of what arrives and of what shines, into some rows of [`Workspace::picture`], which
    /// was dark.
    pub(crate) fn paint(&mut self, simd: SimdLevel, rows: RowMask) {
        let (blocks, albedo) = (self.floor_blocks(rows), &self.ground.albedo);
        if self.whole {
            shade_floor(simd, blocks, albedo, &self.irradiance, &self.specular, &mut self.picture);
        } else {
            shade_floor(simd, blocks, albedo, &self.irradiance, &self.specular, &mut self.packed);
            scatter(&self.floor, blocks, &self.packed, &mut self.picture);
        }
    }

    /// [`Workspace::light`], past everything but some groups.
    fn light_past(
        &mut self,
        stage: &Stage,
        at: usize,
        rect: &TileRect,
        layers: usize,
        away: &[Group],
        rows: RowMask,
    ) -> bool {
        self.picture = BLACK;
        let bare = self.whole || self.floor.count > 0;
        let floor = if bare { self.light_floor_past(stage, at, rect, away, rows) } else { VisibilityClass::Umbra };
        let mut lit = floor != VisibilityClass::Umbra;
        if lit {
            self.veil(stage.simd, floor, rows);
            self.paint(stage.simd, rows);
        }
        let falloff = Falloff::new(&stage.lamps[at].lamp, rect.middle_mm);
        for layer in 0..layers {
            let verdict = self.sees(stage, at, rect, Some(layer), away, rows);
            if verdict != VisibilityClass::Umbra {
                lit = true;
                self.light_top(stage, falloff, layer, rows, verdict);
            }
        }
        lit
    }

    /// Adds some rows of a top's picture to [`Workspace::picture`].
    pub(crate) fn light_top(
        &mut self,
        stage: &Stage,
        falloff: Falloff,
        layer: usize,
        rows: RowMask,
        verdict: VisibilityClass,
    ) {
        let TopLayer { form, points, surface, .. } = &self.tops[layer];
        let (finish, blocks) = (&stage.tops.top(*form).finish, points.blocks_in(rows));
        let fraction = if verdict == VisibilityClass::Lit { &FULLY_VISIBLE } else { &self.fraction };
        shade_top(stage.simd, points, blocks, surface, finish, falloff, fraction, &mut self.packed);
        scatter(points, blocks, &self.packed, &mut self.picture);
    }

    /// Finds what may stand between a lamp and the tile.
    fn look_at(&mut self, stage: &Stage, at: usize, rect: &TileRect) {
        let Lit { lamp, potential_occluders, .. } = &stage.lamps[at];
        let near = &mut self.near[at];
        if !self.is_near[at] {
            let around = Shaft::new(lamp, self.block.0, self.block.1);
            potential_occluders.narrow(stage.simd, &around, near, Some((lamp, stage.disc_chains)));
            self.is_near[at] = true;
        }
        near.classify(stage.simd, &Shaft::new(lamp, rect.middle_mm, rect.radius_mm));
    }

    /// Finds how much of a lamp that was looked at each point of the floor or of a top sees, past everything but some
    /// groups and the top's own.
    fn sees(
        &mut self,
        stage: &Stage,
        at: usize,
        rect: &TileRect,
        layer: Option<usize>,
        away: &[Group],
        rows: RowMask,
    ) -> VisibilityClass {
        let mut without = [Group(0); transmission::MAX_TINTED + 1];
        without[..away.len()].copy_from_slice(away);
        let mut own = None;
        let (points, blocks) = if let Some(layer) = layer {
            let TopLayer { form, points, .. } = &self.tops[layer];
            own = Some(stage.tops.top(*form).group);
            (points, points.blocks_in(rows))
        } else {
            (if self.whole { stage.full_tile } else { &self.floor }, self.floor_blocks(rows))
        };
        let count = away.len() + own.iter().len();
        without[away.len()..count].copy_from_slice(own.as_slice());
        let mut query = VisibilityQuery {
            simd: stage.simd,
            disc_chains: stage.disc_chains,
            lamp: &stage.lamps[at].lamp,
            airborne: &stage.lamps[at].airborne,
            occluders: &self.near[at],
            rect,
            blockers: &mut self.blockers,
            scratch: &mut self.intervals,
            fraction: &mut self.fraction,
        };
        query.evaluate(points, blocks, &without[..count], own)
    }
}

/// Adds a picture in light of a colour.
pub(crate) fn add(picture: &RgbTile, color: Rgb, sum: &mut RgbTile) {
    for ((sum, picture), color) in sum.iter_mut().zip(picture).zip(color) {
        for (sum, line) in sum.iter_mut().zip(picture) {
            for i in 0..LANES {
                sum[i] += line[i] * color;
            }
        }
    }
}

/// Adds the light of some blocks of packed points to the pixels that they are.
pub(crate) fn scatter(points: &PackedSamples, blocks: u16, packed: &RgbTile, picture: &mut RgbTile) {
    let [red, green, blue] = picture.each_mut().map(|plane| plane.as_flattened_mut());
    for block in set_bits(blocks).take_while(|&block| block < points.blocks()) {
        let pixels = &points.pixel[block * LANES..(block * LANES + LANES).min(points.count)];
        for (at, &pixel) in pixels.iter().enumerate() {
            red[usize::from(pixel)] += packed[0][block][at];
            green[usize::from(pixel)] += packed[1][block][at];
            blue[usize::from(pixel)] += packed[2][block][at];
        }
    }
}
