//! A lamp layer: one tile in the light of one lamp, white, in packed planes. What is known of it, and its planes.
//!
//! Of bare floor the irradiance is kept, before the albedo: one plane for all three channels.

use crate::Group;
use crate::Rgb;
use crate::cache::cell_means::CellMeans;
use crate::cache::packed_planes::{PackedPlanes, PlaneSlot, encode_rows};
use crate::cache::validity::Validity;
use crate::cache::weighted_sum::quantization_step;
use crate::simd::dispatch::SimdLevel;
use crate::tile::planes::{ALL_ROWS, BLACK, FULLY_VISIBLE, Plane, RgbTile, RowMask};

/// What is known of a tile in the light of one lamp.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LampState {
    pub validity: Validity,
    /// Whether there is any light, as far as it is valid.
    pub is_lit: bool,
    /// Whether the layer's quantization steps are those of the tile with nothing in the way: then rows can be kept one by
    /// one.
    pub has_step: bool,
    /// What hides the lamp from all of the tile, if it is one group alone.
    pub hidden_by: Option<Group>,
    /// Which of the tile's layers it is, if there has been one.
    pub layer: Option<u16>,
}

impl LampState {
    /// The rows that have to be made anew.
    pub fn rows_to_make(&self) -> RowMask {
        match self.validity {
            Validity::Valid => 0,
            Validity::Stale(rows) if self.is_lit && self.has_step => rows,
            Validity::Stale(_) | Validity::Empty => ALL_ROWS,
        }
    }

    /// The lamp's light has been made anew.
    pub fn made_anew(&mut self, is_lit: bool, hidden_by: Option<Group>) {
        (self.validity, self.is_lit, self.hidden_by) = (Validity::Valid, is_lit, hidden_by);
    }
}

/// How a layer is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LayerFormat {
    /// Radiance: red, green and blue.
    #[default]
    Rgb,
    /// Irradiance at bare floor.
    Irradiance,
    /// The same, and what the floor's coat reflects.
    IrradianceSpecular,
}

/// The three kinds of planes that a tile keeps, each in a pool of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlaneKind {
    /// Irradiance at the floor.
    Irradiance,
    /// What the floor's coat reflects.
    Specular,
    /// Red, green, blue.
    Rgb,
}

/// Slots of packed planes, given away one by one.
#[derive(Clone, Debug)]
pub(crate) struct PlanePool<const CHANNELS: usize> {
    /// The planes; those that were given away before [`PlanePools::clear`] are still there.
    planes: Vec<[PackedPlanes; CHANNELS]>,
    given: u16,
}

impl<const CHANNELS: usize> Default for PlanePool<CHANNELS> {
    fn default() -> Self {
        PlanePool { planes: Vec::new(), given: 0 }
    }
}

impl<const CHANNELS: usize> PlanePool<CHANNELS> {
    /// The packed planes of which any slot is given away.
    pub fn planes(&self) -> &[[PackedPlanes; CHANNELS]] {
        &self.planes[..usize::from(self.given).div_ceil(2)]
    }

    /// The planes of the slot that is in `place`; one is given away if none is.
    fn take(&mut self, place: &mut Option<PlaneSlot>) -> (&mut [PackedPlanes; CHANNELS], PlaneSlot) {
        let slot = *place.get_or_insert_with(|| {
            self.given += 1;
            PlaneSlot::after(self.given - 1)
        });
        if slot.index() == self.planes.len() {
            self.planes.push([PackedPlanes::ZERO; CHANNELS]);
        }
        (&mut self.planes[slot.index()], slot)
    }
}

/// The planes of a tile's layers.
#[derive(Clone, Debug, Default)]
pub(crate) struct PlanePools {
    pub irradiance: PlanePool<1>,
    pub specular: PlanePool<1>,
    pub rgb: PlanePool<3>,
}

impl PlanePools {
    /// Takes every slot back.
    pub fn clear(&mut self) {
        self.irradiance.given = 0;
        self.specular.given = 0;
        self.rgb.given = 0;
    }
}

/// A tile in one light: the means of its cells, and where its planes are.
#[derive(Clone, Debug, Default)]
#[repr(align(64))]
pub(crate) struct CachedLayer {
    /// The lamp, by its slot.
    pub lamp: u16,
    /// Whether there is any light.
    pub is_lit: bool,
    pub format: LayerFormat,
    /// The quantization steps of its planes, and of its specular ones; 0 if there is no light.
    steps: [f32; 2],
    pub means: CellMeans,
    /// The slots of its irradiance, its specular planes and its radiance.
    slots: [Option<PlaneSlot>; 3],
}

/// A plane, or three, as a part of a weighted sum.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WeightedSlot {
    pub kind: PlaneKind,
    pub slot: PlaneSlot,
    pub weight: Rgb,
}

impl CachedLayer {
    /// Darkness, in the light of a lamp.
    pub fn of(lamp: usize) -> CachedLayer {
        CachedLayer { lamp: lamp as u16, ..CachedLayer::default() }
    }

    /// Becomes radiance in steps of this size.
    pub fn set_step(&mut self, step: f32) {
        (self.format, self.steps) = (LayerFormat::Rgb, [step, 0.0]);
    }

    /// Becomes bare floor, in steps that hold it with nothing in the way.
    pub fn set_floor_steps(&mut self, simd: SimdLevel, floor: &FloorLight) {
        let step = |plane: &Plane| quantization_step(simd, std::slice::from_ref(plane));
        self.steps = [step(floor.irradiance), step(floor.specular)];
        self.format = if self.steps[1] > 0.0 { LayerFormat::IrradianceSpecular } else { LayerFormat::Irradiance };
    }

    /// Keeps some rows of radiance, whose step was set.
    pub fn keep_rgb(&mut self, simd: SimdLevel, radiance: &RgbTile, rows: RowMask, pools: &mut PlanePools) {
        let step = self.steps[0];
        let (planes, slot) = pools.rgb.take(&mut self.slots[PlaneKind::Rgb as usize]);
        for (plane, packed) in radiance.iter().zip(&mut *planes) {
            encode_rows(simd, plane, &FULLY_VISIBLE, rows, step, slot, packed);
        }
        self.means.keep_rgb(simd, planes, slot, step, rows);
        self.is_lit = !planes.iter().all(|packed| packed.is_dark(slot));
    }

    /// Keeps some rows of bare floor, whose steps were set.
    pub fn keep_floor(&mut self, simd: SimdLevel, floor: &FloorLight, rows: RowMask, pools: &mut PlanePools) {
        let (steps, seen) = (self.steps, floor.visibility);
        let ([irradiance], slot) = pools.irradiance.take(&mut self.slots[PlaneKind::Irradiance as usize]);
        encode_rows(simd, floor.irradiance, seen, rows, steps[0], slot, irradiance);
        self.is_lit = !irradiance.is_dark(slot);
        let irradiance = (&*irradiance, slot);
        let specular = if self.format == LayerFormat::IrradianceSpecular {
            let ([specular], slot) = pools.specular.take(&mut self.slots[PlaneKind::Specular as usize]);
            encode_rows(simd, floor.specular, seen, rows, steps[1], slot, specular);
            self.is_lit |= !specular.is_dark(slot);
            (&*specular, slot)
        } else {
            irradiance
        };
        self.means.keep_floor(simd, floor.albedo, [irradiance, specular], steps, rows);
    }

    /// Adds its planes, in light of a colour, to the parts of a sum.
    pub fn push_weighted(&self, color: Rgb, parts: &mut Vec<WeightedSlot>) {
        let mut push = |kind: PlaneKind, step: f32| {
            let part = |slot| WeightedSlot { kind, slot, weight: color.map(|channel| channel * step) };
            parts.extend(self.slots[kind as usize].map(part));
        };
        match self.format {
            LayerFormat::Rgb => push(PlaneKind::Rgb, self.steps[0]),
            LayerFormat::Irradiance => push(PlaneKind::Irradiance, self.steps[0]),
            LayerFormat::IrradianceSpecular => {
                push(PlaneKind::Irradiance, self.steps[0]);
                push(PlaneKind::Specular, self.steps[1]);
            }
        }
    }

    /// The layer itself, kept as radiance; black if there is none.
    pub fn decode(&self, pools: &PlanePools, out: &mut RgbTile) {
        *out = BLACK;
        let Some(slot) = self.slots[PlaneKind::Rgb as usize].filter(|_| self.is_lit) else { return };
        for (plane, packed) in out.iter_mut().zip(&pools.rgb.planes[slot.index()]) {
            for (row, line) in plane.iter_mut().enumerate() {
                *line = packed.row(slot, row).map(|number| number * self.steps[0]);
            }
        }
    }
}

/// A tile of bare floor in the light of one lamp.
#[derive(Clone, Copy)]
pub(crate) struct FloorLight<'a> {
    pub albedo: &'a RgbTile,
    /// What arrives, and is reflected in the floor's colours.
    pub irradiance: &'a Plane,
    /// What the coat reflects in the lamp's own colour.
    pub specular: &'a Plane,
    /// The fraction of both that is not in shadow.
    pub visibility: &'a Plane,
}
