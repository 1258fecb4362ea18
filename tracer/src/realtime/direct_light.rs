//! Direct light: a tile in the light of one lamp. What stands between them, which fraction of the lamp each sample sees,
//! and what its surface makes of that.

use crate::cache::weighted_sum::quantization_step;
use crate::realtime::frame_context::{ActiveLamp, FrameContext};
use crate::realtime::g_buffer::GBuffer;
use crate::shading::falloff::Falloff;
use crate::shading::surface::{apply_visibility, floor_irradiance, shade_floor, shade_top};
use crate::shading::top_layer::TopLayer;
use crate::simd::dispatch::LANES;
use crate::tile::planes::{ALL_ROWS, BLACK, FULLY_VISIBLE, Plane, RgbTile, RowMask};
use crate::tile::rect::TileRect;
use crate::visibility::blockers::{Blockers, VisibilityClass};
use crate::visibility::fraction::IntervalScratch;
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::query::VisibilityQuery;
use crate::visibility::transmission::{self, MAX_TINTED, TintedGroup};
use crate::{Group, Rgb};

/// What a lamp lights of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LitResult {
    /// Nothing; which group hides the lamp, if it is one group alone.
    Nothing { hidden_by: Option<Group> },
    /// Bare floor in light that nothing tints, of this visibility: the floor's planes of [`LampLight`] hold it.
    Floor(VisibilityClass),
    /// Anything: [`LampLight::radiance`] holds it.
    Rgb,
}

/// A tile in the light of one lamp, of the colour white.
pub(crate) struct LampLight {
    /// Irradiance at the floor's samples, with nothing in the way.
    pub irradiance: Plane,
    /// What the floor's coat reflects in the lamp's own colour, with nothing in the way.
    pub specular: Plane,
    /// The fraction of the lamp that the last samples saw, where that is partial.
    pub visibility: Plane,
    /// What the tile sends to the eye.
    pub radiance: RgbTile,
}

impl LampLight {
    /// Darkness.
    pub fn new() -> LampLight {
        let [irradiance, specular, visibility] = BLACK;
        LampLight { irradiance, specular, visibility, radiance: BLACK }
    }
}

/// Scratch for one lamp's light: what it holds has no meaning between two calls.
pub(crate) struct LightScratch {
    blockers: Blockers,
    intervals: IntervalScratch,
    /// A layer's light at its samples.
    pub packed: RgbTile,
    /// The sum over the sets of tinted groups.
    sum: RgbTile,
}

impl LightScratch {
    /// Nothing yet.
    pub fn new() -> LightScratch {
        LightScratch { blockers: Blockers::default(), intervals: IntervalScratch::default(), packed: BLACK, sum: BLACK }
    }
}

/// One lamp and one tile.
#[derive(Clone, Copy)]
pub(crate) struct LampOnTile<'a> {
    pub frame: &'a FrameContext<'a>,
    pub lamp: &'a ActiveLamp,
    pub rect: &'a TileRect,
    pub g_buffer: &'a GBuffer,
    pub falloff: Falloff,
}

/// What may stand between a lamp and a tile: occluders that were classified for the tile, but for some groups.
#[derive(Clone, Copy)]
struct Occluders<'a> {
    potential: &'a PotentialOccluders,
    without: &'a [Group],
}

impl<'a> LampOnTile<'a> {
    /// The lamp as the tile's samples meet it.
    pub fn new(frame: &'a FrameContext, lamp: &'a ActiveLamp, rect: &'a TileRect, g_buffer: &'a GBuffer) -> Self {
        LampOnTile { frame, lamp, rect, g_buffer, falloff: Falloff::new(&lamp.lamp, rect.middle_mm) }
    }

    /// Puts some rows of the tile in the lamp's light, past what `potential` holds.
    pub fn light(
        &self,
        potential: &PotentialOccluders,
        rows: RowMask,
        scratch: &mut LightScratch,
        out: &mut LampLight,
    ) -> LitResult {
        let on_path = transmission::on_path(self.frame.tinted, |group| potential.casts(group));
        let occluders = Occluders { potential, without: &[] };
        if !on_path.as_slice().is_empty() {
            return self.light_through(on_path.as_slice(), potential, rows, scratch, out);
        }
        if self.g_buffer.tops().is_empty() {
            return match self.light_floor_past(occluders, rows, scratch, out) {
                VisibilityClass::Umbra => LitResult::Nothing { hidden_by: scratch.blockers.hidden_by },
                class => LitResult::Floor(class),
            };
        }
        if self.light_past(occluders, rows, scratch, out) {
            LitResult::Rgb
        } else {
            LitResult::Nothing { hidden_by: None }
        }
    }

    /// [`LampOnTile::light`] through tinted groups: the sum over the sets of them that may be taken away.
    fn light_through(
        &self,
        tinted: &[TintedGroup],
        potential: &PotentialOccluders,
        rows: RowMask,
        scratch: &mut LightScratch,
        out: &mut LampLight,
    ) -> LitResult {
        let mut lit = false;
        scratch.sum = BLACK;
        transmission::each_subset(tinted, |without, part| {
            let occluders = Occluders { potential, without };
            if part != [0.0; 3] && self.light_past(occluders, rows, scratch, out) {
                lit = true;
                add(&out.radiance, part, &mut scratch.sum);
            }
        });
        out.radiance = scratch.sum;
        // What hides the lamp with every tinted group away is more than one group can be blamed for.
        if lit { LitResult::Rgb } else { LitResult::Nothing { hidden_by: None } }
    }

    /// The quantization step of the tile's layer: that of all the light that it would show were nothing in the way.
    pub fn unoccluded_step(&self, scratch: &mut LightScratch, out: &mut LampLight) -> f32 {
        let LightScratch { packed, sum, .. } = scratch;
        *sum = BLACK;
        if self.g_buffer.has_floor() {
            self.light_floor(ALL_ROWS, out);
            self.shade_floor(ALL_ROWS, [&out.irradiance, &out.specular], packed, sum);
        }
        for top in self.g_buffer.tops() {
            self.light_top(top, ALL_ROWS, &FULLY_VISIBLE, packed, sum);
        }
        quantization_step(self.frame.simd, sum)
    }

    /// Puts the floor in light past occluders, into the floor's planes; how much of the lamp it sees.
    fn light_floor_past(
        &self,
        occluders: Occluders,
        rows: RowMask,
        scratch: &mut LightScratch,
        out: &mut LampLight,
    ) -> VisibilityClass {
        let class = self.visibility(occluders, None, rows, scratch, &mut out.visibility);
        if class != VisibilityClass::Umbra {
            self.light_floor(rows, out);
        }
        class
    }

    /// Puts the floor in light with nothing in the way, into the floor's planes.
    pub fn light_floor(&self, rows: RowMask, out: &mut LampLight) {
        let (samples, blocks) = (self.g_buffer.floor_samples(self.frame), self.g_buffer.floor_blocks(rows));
        let (floor, gloss) = (&self.g_buffer.floor, self.frame.scene.floor.gloss);
        let LampLight { irradiance, specular, .. } = out;
        floor_irradiance(self.frame.simd, samples, blocks, floor, self.falloff, gloss, irradiance, specular);
    }

    /// Takes what is hidden of the lamp from the floor's planes.
    pub fn apply_floor_visibility(&self, rows: RowMask, out: &mut LampLight) {
        let LampLight { irradiance, specular, visibility, .. } = out;
        apply_visibility(self.frame.simd, self.g_buffer.floor_blocks(rows), visibility, irradiance, specular);
    }

    /// Adds the floor of an irradiance and a specular plane to some rows of `out`, which were black.
    pub fn shade_floor(
        &self,
        rows: RowMask,
        [irradiance, specular]: [&Plane; 2],
        packed: &mut RgbTile,
        out: &mut RgbTile,
    ) {
        let (blocks, albedo) = (self.g_buffer.floor_blocks(rows), &self.g_buffer.floor.albedo);
        match self.g_buffer.packed_floor() {
            None => shade_floor(self.frame.simd, blocks, albedo, irradiance, specular, out),
            Some(samples) => {
                shade_floor(self.frame.simd, blocks, albedo, irradiance, specular, packed);
                samples.scatter(blocks, packed, out);
            }
        }
    }

    /// Puts all surfaces in light past occluders, into [`LampLight::radiance`]; whether any is lit.
    fn light_past(&self, occluders: Occluders, rows: RowMask, scratch: &mut LightScratch, out: &mut LampLight) -> bool {
        out.radiance = BLACK;
        let mut lit = false;
        if self.g_buffer.has_floor() {
            let class = self.light_floor_past(occluders, rows, scratch, out);
            if class != VisibilityClass::Umbra {
                lit = true;
                if class == VisibilityClass::Partial {
                    self.apply_floor_visibility(rows, out);
                }
                let LampLight { irradiance, specular, radiance, .. } = out;
                self.shade_floor(rows, [irradiance, specular], &mut scratch.packed, radiance);
            }
        }
        for top in self.g_buffer.tops() {
            let class = self.visibility(occluders, Some(top), rows, scratch, &mut out.visibility);
            if class != VisibilityClass::Umbra {
                lit = true;
                let visibility = if class == VisibilityClass::Lit { &FULLY_VISIBLE } else { &out.visibility };
                self.light_top(top, rows, visibility, &mut scratch.packed, &mut out.radiance);
            }
        }
        lit
    }

    /// Adds some rows of a top, of which each sample sees a fraction of the lamp, to `out`.
    pub fn light_top(
        &self,
        top: &TopLayer,
        rows: RowMask,
        visibility: &Plane,
        packed: &mut RgbTile,
        out: &mut RgbTile,
    ) {
        let TopLayer { slot, samples, surface, .. } = top;
        let (finish, blocks) = (&self.frame.tops.top(*slot).finish, samples.blocks_in(rows));
        shade_top(self.frame.simd, samples, blocks, surface, finish, self.falloff, visibility, packed);
        samples.scatter(blocks, packed, out);
    }

    /// The fraction of the lamp that the samples of the floor or of a top see, past occluders but the top's own group.
    fn visibility(
        &self,
        occluders: Occluders,
        top: Option<&TopLayer>,
        rows: RowMask,
        scratch: &mut LightScratch,
        fraction: &mut Plane,
    ) -> VisibilityClass {
        let own = top.map(|top| self.frame.tops.top(top.slot).group);
        let (samples, blocks) = match top {
            Some(top) => (&top.samples, top.samples.blocks_in(rows)),
            None => (self.g_buffer.floor_samples(self.frame), self.g_buffer.floor_blocks(rows)),
        };
        let mut without = [Group(0); MAX_TINTED + 1];
        let away = occluders.without.len();
        let count = away + own.iter().len();
        without[..away].copy_from_slice(occluders.without);
        without[away..count].copy_from_slice(own.as_slice());
        let mut query = VisibilityQuery {
            simd: self.frame.simd,
            disc_chains: self.frame.disc_chains,
            lamp: &self.lamp.lamp,
            airborne: &self.lamp.airborne,
            occluders: occluders.potential,
            rect: self.rect,
            blockers: &mut scratch.blockers,
            scratch: &mut scratch.intervals,
            fraction,
        };
        query.evaluate(samples, blocks, &without[..count], own)
    }
}

/// Adds a tile in light of a colour.
pub(crate) fn add(tile: &RgbTile, color: Rgb, sum: &mut RgbTile) {
    for ((sum, plane), color) in sum.iter_mut().zip(tile).zip(color) {
        for (sum, line) in sum.iter_mut().zip(plane) {
            for i in 0..LANES {
                sum[i] += line[i] * color;
            }
        }
    }
}
