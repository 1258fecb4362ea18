//! A bake: the layers of all lamps, and the light at a point under lamps of any colours.

use super::BakeOptions;
use super::cells::Cells;
use crate::transport::Surfaces;
use geometry::DVec2;

/// The indirect light and the caustics of a scene that stands still, a layer for each lamp.
#[derive(Clone, Debug)]
pub struct Bake {
    pub(super) options: BakeOptions,
    /// Says which scene it is of.
    pub(super) fingerprint: u64,
    pub(super) lamps: usize,
    /// By nodes, lamps, channels.
    pub(super) light: Vec<f32>,
    pub(super) surfaces: Surfaces,
    pub(super) cells: Cells,
}

/// Of the same scene, with the same options, to the last bit of light.
impl PartialEq for Bake {
    fn eq(&self, other: &Bake) -> bool {
        let key = |bake: &Bake| (bake.fingerprint, bake.lamps, bake.options);
        let bits = |bake: &Bake| bake.light.iter().map(|light| light.to_bits()).collect::<Vec<_>>();
        key(self) == key(other) && bits(self) == bits(other)
    }
}

/// A bake under lamps of certain colours.
pub struct MixedBake<'a> {
    bake: &'a Bake,
    nodes: Vec<[f32; 3]>,
}

impl Bake {
    /// How many layers there are: one for each source of the scene, in its order.
    pub fn layers(&self) -> usize {
        self.lamps
    }

    /// What it was made with.
    pub fn options(&self) -> &BakeOptions {
        &self.options
    }

    /// The fluence at a point, signed, where each lamp's light is multiplied by its colour; a lamp without one is dark. What the
    /// lamps send there straight is not in it.
    pub fn fluence(&self, point: DVec2, colors: &[[f64; 3]]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let mut total = 0.0;
        self.cells.around(&self.surfaces, point, |node, weight| {
            let mixed = self.mixed_node(node, colors);
            (0..3).for_each(|channel| sum[channel] += weight * f64::from(mixed[channel]));
            total += weight;
        });
        if total > 0.0 { sum.map(|channel| channel / total) } else { sum }
    }

    /// The weighted sum of all layers, for many points.
    pub fn mixed(&self, colors: &[[f64; 3]]) -> MixedBake<'_> {
        let nodes = (0..self.cells.nodes().len()).map(|node| self.mixed_node(node, colors)).collect();
        MixedBake { bake: self, nodes }
    }

    fn mixed_node(&self, node: usize, colors: &[[f64; 3]]) -> [f32; 3] {
        let lamps = self.light[node * self.lamps * 3..(node + 1) * self.lamps * 3].chunks_exact(3);
        let mut sum = [0.0; 3];
        for (light, color) in lamps.zip(colors) {
            (0..3).for_each(|channel| sum[channel] += f64::from(light[channel]) * color[channel]);
        }
        sum.map(|channel| channel as f32)
    }
}

impl MixedBake<'_> {
    /// [`Bake::fluence`].
    pub fn fluence(&self, point: DVec2) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let mut total = 0.0;
        self.bake.cells.around(&self.bake.surfaces, point, |node, weight| {
            (0..3).for_each(|channel| sum[channel] += weight * f64::from(self.nodes[node][channel]));
            total += weight;
        });
        if total > 0.0 { sum.map(|channel| channel / total) } else { sum }
    }
}
