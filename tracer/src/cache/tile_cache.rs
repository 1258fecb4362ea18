//! The tile cache: what one tile keeps from frame to frame, since most of a table stands still.
//!
//! For every lamp a layer is kept: the tile in that lamp's light, of the colour white. A layer is valid until an occluder
//! moves between the tile and the lamp, or a top moves in the tile; then it is made anew, so a frame has the same bits
//! whatever came before it. Light is linear: a lamp that flashes is another weight in the sum of the layers, and nothing
//! more. What an event leaves valid is said by [`crate::cache::validity`] and by docs/tile_cache.md.

use crate::cache::cached_g_buffer::CachedGBuffer;
use crate::cache::cell_means::{CELLS_PER_TILE, CellMeans, TileMeans, add_cell_means, means_of};
use crate::cache::lamp_layer::{CachedLayer, FloorLight, LampState, LayerFormat, PlaneKind, PlanePools, WeightedSlot};
use crate::cache::lamp_set::LampSet;
use crate::cache::packed_planes::{PackedWeights, WeightedPlanes};
use crate::cache::validity::{CachedItem, Effect, Event, Validity, effect};
use crate::cache::weighted_sum::{Quantizer, WeightedSum, evaluate, quantization_step};
use crate::scene::GlowKey;
use crate::simd::dispatch::{SimdLevel, prefetch};
use crate::tile::planes::{ALL_ROWS, AlbedoTile, RgbTile, RowMask};
use crate::{Group, Rgb};

#[cfg(test)]
mod state_table_tests;

/// The light that a tile is put in.
pub(crate) struct Illumination<'a> {
    pub ambient: Rgb,
    /// Whether balls darken the ambient light.
    pub shaded: bool,
    /// The colours of lamps, by their slots.
    pub lamps: &'a [Rgb],
}

/// What one tile keeps.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileCache {
    /// Whether this frame's tile is another than the last frame's.
    pub redrawn: bool,
    /// The tile's pixels in the display buffer.
    display: Validity,
    /// Which surfaces are seen.
    pub g_buffer: CachedGBuffer,
    base: BaseLayer,
    /// What is known of each lamp, by its slot.
    lamps: Vec<LampState>,
    /// The lamps whose layers are valid.
    valid: LampSet,
    /// The lamps whose layers are valid and not dark.
    lit: LampSet,
    /// The layers of the lamps that have lit the tile.
    layers: Vec<CachedLayer>,
    glows: Vec<GlowLayer>,
    /// The planes of all layers.
    pools: PlanePools,
    sum: TileSum,
}

/// A tile in ambient light, with the emission of its tops; of a tile of bare floor only the means, in white light.
#[derive(Clone, Debug, Default)]
struct BaseLayer {
    validity: Validity,
    is_floor: bool,
    layer: CachedLayer,
}

/// A tile in the light of a glow.
#[derive(Clone, Debug)]
struct GlowLayer {
    key: GlowKey,
    validity: Validity,
    layer: CachedLayer,
}

/// The weights of a tile's sum in this frame's light.
#[derive(Clone, Debug, Default)]
struct TileSum {
    /// The weights of the irradiance planes, of the specular ones and of radiance.
    weights: [Vec<PackedWeights>; 3],
    /// The size of a step of the sums.
    step: Rgb,
    ambient: Rgb,
}

impl TileCache {
    /// Notes an event that meets all of the tile.
    pub fn apply(&mut self, event: Event) {
        self.display = self.display.after(CachedItem::Display, event);
        self.g_buffer.validity = self.g_buffer.validity.after(CachedItem::GBuffer, event);
        self.base.validity = self.base.validity.after(CachedItem::Base, event);
        if [CachedItem::LampLayer, CachedItem::GlowLayer].iter().all(|&item| effect(item, event) == Effect::Clear) {
            self.clear_layers();
        }
    }

    /// Notes an event that meets the tile in the light of one lamp.
    pub fn apply_to_lamp(&mut self, lamp: usize, event: Event) {
        self.display = self.display.after(CachedItem::Display, event);
        let state = self.lamp(lamp);
        state.validity = state.validity.after(CachedItem::LampLayer, event);
        if !state.validity.is_valid() {
            self.valid.remove(lamp);
        }
    }

    /// Forgets every lamp and every glow, and takes back the planes of all layers.
    fn clear_layers(&mut self) {
        (self.valid, self.lit) = (LampSet::default(), LampSet::default());
        self.lamps.clear();
        self.layers.clear();
        self.glows.clear();
        self.base.layer = CachedLayer::default();
        self.pools.clear();
    }

    /// What is known of a lamp.
    pub fn lamp(&mut self, lamp: usize) -> &mut LampState {
        if self.lamps.len() <= lamp {
            self.lamps.resize_with(lamp + 1, LampState::default);
        }
        &mut self.lamps[lamp]
    }

    /// Those of some lamps whose layers are not valid.
    pub fn out_of_date<'a>(&'a self, lamps: &'a LampSet) -> impl Iterator<Item = usize> + 'a {
        lamps.difference(&self.valid)
    }

    /// Whether the tile is known to see nothing of a lamp.
    pub fn is_dark(&self, lamp: usize) -> bool {
        self.valid.contains(lamp) && !self.lit.contains(lamp)
    }

    /// What of the base layer may be used.
    pub fn base(&self) -> Validity {
        self.base.validity
    }

    /// What of the tile's pixels in the display buffer may be used.
    pub fn display(&self) -> Validity {
        self.display
    }

    /// The tile's pixels are in the display buffer.
    pub fn presented(&mut self) {
        self.display = Validity::Valid;
    }

    /// What of the layer of a glow may be used.
    pub fn glow(&mut self, key: GlowKey) -> Validity {
        self.glow_layer(key).validity
    }

    fn glow_layer(&mut self, key: GlowKey) -> &mut GlowLayer {
        let at = self.glows.iter().position(|glow| glow.key == key).unwrap_or_else(|| {
            self.glows.push(GlowLayer { key, validity: Validity::Empty, layer: CachedLayer::default() });
            self.glows.len() - 1
        });
        &mut self.glows[at]
    }

    /// Keeps the tile in ambient light.
    pub fn keep_base(&mut self, simd: SimdLevel, radiance: &RgbTile) {
        self.base.is_floor = false;
        self.base.layer.set_step(quantization_step(simd, radiance));
        self.base.layer.keep_rgb(simd, radiance, ALL_ROWS, &mut self.pools);
        self.base.validity = Validity::Valid;
    }

    /// Keeps that all of the tile is floor of this albedo.
    pub fn keep_floor_base(&mut self, simd: SimdLevel, albedo: &RgbTile) {
        let mut means = [[0.0; CELLS_PER_TILE]; 3];
        means_of(simd, albedo, &mut means);
        self.base.layer.means = CellMeans::of(&means);
        (self.base.is_floor, self.base.layer.is_lit, self.base.validity) = (true, false, Validity::Valid);
    }

    /// The layer of a lamp: of darkness if there has been none.
    fn layer_of(&mut self, lamp: usize) -> &mut CachedLayer {
        self.lamp(lamp);
        let TileCache { lamps, layers, .. } = self;
        let at = lamps[lamp].layer.get_or_insert_with(|| {
            layers.push(CachedLayer::of(lamp));
            layers.len() as u16 - 1
        });
        &mut layers[usize::from(*at)]
    }

    /// Whether a lamp's layer would have to be kept in another format, if it is kept as radiance or not.
    pub fn changes_format(&mut self, lamp: usize, rgb: bool) -> bool {
        (self.layer_of(lamp).format == LayerFormat::Rgb) != rgb
    }

    /// Sets the quantization step of a lamp's layer, kept as radiance.
    pub fn set_step(&mut self, lamp: usize, step: f32) {
        self.layer_of(lamp).set_step(step);
        self.lamps[lamp].has_step = true;
    }

    /// Keeps rows of the tile in a lamp's light, whose step was set.
    pub fn keep_rgb(&mut self, lamp: usize, simd: SimdLevel, radiance: &RgbTile, rows: RowMask) {
        self.layer_of(lamp);
        let TileCache { lamps, layers, pools, .. } = self;
        let Some(at) = lamps[lamp].layer else { return };
        let layer = &mut layers[usize::from(at)];
        layer.keep_rgb(simd, radiance, rows, pools);
        let is_lit = layer.is_lit;
        self.made_anew(lamp, is_lit, None);
    }

    /// Keeps rows of a tile of bare floor in a lamp's light; the first time, all of them.
    pub fn keep_floor(&mut self, lamp: usize, simd: SimdLevel, floor: &FloorLight, rows: RowMask) {
        self.layer_of(lamp);
        let TileCache { lamps, layers, pools, .. } = self;
        let Some(at) = lamps[lamp].layer else { return };
        let layer = &mut layers[usize::from(at)];
        if !lamps[lamp].has_step || layer.format == LayerFormat::Rgb {
            layer.set_floor_steps(simd, floor);
            lamps[lamp].has_step = true;
        }
        layer.keep_floor(simd, floor, rows, pools);
        let is_lit = layer.is_lit;
        self.made_anew(lamp, is_lit, None);
    }

    /// Keeps that a lamp lights nothing, and what hides it if it is one group alone.
    pub fn keep_dark(&mut self, lamp: usize, hidden_by: Option<Group>) {
        if let Some(layer) = self.lamp(lamp).layer {
            self.layers[usize::from(layer)].is_lit = false;
        }
        self.made_anew(lamp, false, hidden_by);
    }

    fn made_anew(&mut self, lamp: usize, is_lit: bool, hidden_by: Option<Group>) {
        self.lamp(lamp).made_anew(is_lit, hidden_by);
        self.valid.insert(lamp);
        if is_lit {
            self.lit.insert(lamp);
        } else {
            self.lit.remove(lamp);
        }
    }

    /// Keeps the tile in a glow's light.
    pub fn keep_glow(&mut self, key: GlowKey, simd: SimdLevel, radiance: &RgbTile) {
        self.glow_layer(key);
        let TileCache { glows, pools, .. } = self;
        if let Some(glow) = glows.iter_mut().find(|glow| glow.key == key) {
            glow.layer.set_step(quantization_step(simd, radiance));
            glow.layer.keep_rgb(simd, radiance, ALL_ROWS, pools);
            glow.validity = Validity::Valid;
        }
    }

    /// The layers that the tile is a sum of, with the colours of their light.
    fn summands<'a>(
        &'a self,
        light: &'a Illumination,
        glows: impl Iterator<Item = (GlowKey, Rgb)>,
    ) -> impl Iterator<Item = (&'a CachedLayer, Rgb)> {
        let base = Some((&self.base.layer, [1.0; 3])).filter(|_| !light.shaded);
        let lamps = self.layers.iter().map(|layer| (layer, light.lamps[usize::from(layer.lamp)]));
        // Few tiles have glows.
        let glows = glows
            .take_while(|_| !self.glows.is_empty())
            .filter_map(|(key, color)| self.glows.iter().find(|glow| glow.key == key).map(|glow| (&glow.layer, color)));
        base.into_iter().chain(lamps).chain(glows).filter(|(layer, color)| layer.is_lit && *color != [0.0; 3])
    }

    /// Weighs the layers by the colours of their light and returns the means of the sum's cells, unless the ambient light is
    /// shaded. `parts` is scratch.
    pub fn weigh(
        &mut self,
        simd: SimdLevel,
        light: &Illumination,
        glows: impl Iterator<Item = (GlowKey, Rgb)> + Clone,
        parts: &mut Vec<WeightedSlot>,
    ) -> TileMeans {
        parts.clear();
        self.summands(light, glows.clone()).for_each(|(layer, color)| layer.push_weighted(color, parts));
        let quantizer = Quantizer::of(parts.iter().map(|part| part.weight));
        let mut sums = [[0; CELLS_PER_TILE]; 3];
        let cell_means = self.summands(light, glows).map(|(layer, color)| {
            let means = &layer.means;
            (means, quantizer.quantize(color.map(|channel| channel * means.step)))
        });
        add_cell_means(simd, cell_means, &mut sums);
        let mut means = [[0.0; CELLS_PER_TILE]; 3];
        for channel in 0..3 {
            for (mean, sum) in means[channel].iter_mut().zip(sums[channel]) {
                *mean = sum as f32 * quantizer.step[channel];
            }
        }
        if self.base.is_floor {
            self.base.layer.means.add_light(light.ambient, &mut means);
        }
        self.sum.set(&self.pools, &quantizer, parts);
        self.sum.ambient = light.ambient;
        means
    }

    /// Asks the memory for what [`TileCache::compose`] will read.
    fn prefetch_planes(&self) {
        self.sum.weights.iter().for_each(|weights| prefetch(weights));
        prefetch(self.pools.irradiance.planes());
        prefetch(self.pools.specular.planes());
        prefetch(self.pools.rgb.planes());
    }

    /// Asks the memory for what [`TileCache::weigh`] will read.
    fn prefetch_layers(&self) {
        prefetch(&self.layers);
    }

    /// Puts together what the tile shows, on floor of this albedo. Where [`TileCache::weigh`] was told so, `shade` darkens
    /// the ambient light.
    pub fn compose(
        &self,
        simd: SimdLevel,
        albedo: &AlbedoTile,
        shade: Option<impl FnOnce(&mut RgbTile)>,
        out: &mut RgbTile,
    ) {
        let ambient = if self.base.is_floor { self.sum.ambient } else { [0.0; 3] };
        let lamps = self.sum.of(&self.pools);
        let Some(shade) = shade else {
            return evaluate(simd, &WeightedSum { ambient, ..lamps }, albedo, false, out);
        };
        if self.base.is_floor {
            evaluate(simd, &WeightedSum { ambient, ..WeightedSum::NOTHING }, albedo, false, out);
        } else {
            self.base.layer.decode(&self.pools, out);
        }
        shade(out);
        evaluate(simd, &lamps, albedo, true, out);
    }
}

impl TileSum {
    /// Sets the weights of the planes.
    fn set(&mut self, pools: &PlanePools, quantizer: &Quantizer, parts: &[WeightedSlot]) {
        let lengths = [pools.irradiance.planes().len(), pools.specular.planes().len(), pools.rgb.planes().len()];
        for (weights, length) in self.weights.iter_mut().zip(lengths) {
            weights.clear();
            weights.resize(length, [0; 3]);
        }
        for WeightedSlot { kind, slot, weight } in parts {
            let weights = &mut self.weights[*kind as usize][slot.index()];
            let whole = quantizer.quantize(*weight);
            *weights = [0, 1, 2].map(|channel: usize| weights[channel] | whole[channel] << slot.shift());
        }
        self.step = quantizer.step;
    }

    /// The weighted planes, without ambient light.
    fn of<'a>(&'a self, pools: &'a PlanePools) -> WeightedSum<'a> {
        let weights = |kind: PlaneKind| self.weights[kind as usize].as_slice();
        WeightedSum {
            irradiance: WeightedPlanes { planes: pools.irradiance.planes(), weights: weights(PlaneKind::Irradiance) },
            specular: WeightedPlanes { planes: pools.specular.planes(), weights: weights(PlaneKind::Specular) },
            rgb: WeightedPlanes { planes: pools.rgb.planes(), weights: weights(PlaneKind::Rgb) },
            step: self.step,
            ambient: [0.0; 3],
        }
    }
}

/// Tiles one after another; while one is worked on, what `prefetch` asks for of the next is on its way.
fn ahead(mut tiles: &mut [TileCache], prefetch: impl Fn(&TileCache)) -> impl Iterator<Item = &mut TileCache> {
    std::iter::from_fn(move || {
        let (tile, others) = std::mem::take(&mut tiles).split_first_mut()?;
        others.first().into_iter().for_each(&prefetch);
        tiles = others;
        Some(tile)
    })
}

/// Tiles that are to be updated.
pub(crate) fn to_update(tiles: &mut [TileCache]) -> impl Iterator<Item = &mut TileCache> {
    ahead(tiles, TileCache::prefetch_layers)
}

/// Tiles that are to be composed.
pub(crate) fn to_compose(tiles: &mut [TileCache]) -> impl Iterator<Item = &mut TileCache> {
    ahead(tiles, TileCache::prefetch_planes)
}
