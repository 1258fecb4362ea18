//! A bake from its scene.

use super::Bake;
use super::bytes::fingerprint;
use super::cells::Cells;
use super::gather::WallLight;
use super::packets::{Lamp, Place, Traces, UNIT, trace};
use super::progress::Progress;
use super::walls::Walls;
use super::way_basis::WayBasis;
use crate::transport::spectrum::{WavelengthSampler, Weights};
use crate::transport::{BodyId, LightSource, Media, Scene, Surfaces, TOLERANCE_MM};
use geometry::Bounds;
use geometry::rng::{mix64, unit_from_bits};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// How fine a bake is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BakeOptions {
    /// What of the scene is baked, mm.
    pub region: Bounds,
    /// The side of a cell, and about that of a piece of a wall, mm; over 0.
    pub cell_mm: f64,
    /// Matt walls that light meets at most.
    pub bounces: u32,
    /// Packets of light from each lamp.
    pub packets: u64,
    /// Of chance.
    pub seed: u64,
}

impl BakeOptions {
    /// What is usual for a table, over this region: three walls, cells of four millimetres.
    pub fn over(region: Bounds) -> BakeOptions {
        BakeOptions { region, cell_mm: 4.0, bounces: 3, packets: 1 << 14, seed: 0 }
    }
}

/// Parts of a lamp's packets that are traced side by side.
const PARTS: u64 = 8;

/// Cells that are gathered one after the other.
const CHUNK: usize = 256;

/// Bakes a scene for a screen whose white is that of `weights`. `progress` is told what is done and all, in any unit, and says
/// whether to go on, from any thread; `None` where it said no.
pub fn bake(
    scene: &Scene,
    weights: &Weights,
    options: &BakeOptions,
    progress: &(dyn Fn(u64, u64) -> bool + Sync),
) -> Option<Bake> {
    let surfaces = Surfaces::new(&scene.bodies, TOLERANCE_MM);
    let cells = Cells::new(&surfaces, &options.region, options.cell_mm);
    let edges = scene.bodies.iter().zip(0..).flat_map(|(body, number)| body.edges.iter().map(move |_| number));
    let walls = Walls::new(&surfaces, &edges.collect::<Vec<BodyId>>(), options.cell_mm);
    let chunks = cells.nodes().len().div_ceil(CHUNK) as u64;
    let rounds = scene.sources.len() as u64 * PARTS;
    let progress = Progress::new(rounds + chunks, progress);
    if !progress.add(0) {
        return None;
    }
    let absorbs = (0..scene.bodies.len() as BodyId).any(|body| surfaces.absorbs(body));
    let place = Place { surfaces: &surfaces, walls: &walls, cells: &cells, weights, absorbs, bounces: options.bounces };
    let mut light = WallLight::new(&surfaces, &walls, &scene.sources);
    let lamps = light.lamps();
    let mut layers = vec![0.0; cells.nodes().len() * lamps * 3];
    for (number, source) in scene.sources.iter().enumerate() {
        let (traces, unit) = traces_of(&place, source, &light.ways[number], options, number, &progress)?;
        let stride = light.most_ways();
        fill_walls(&mut light.sent, &traces, light.ways[number].count(), [stride, lamps, number], &walls, unit);
        for (node, sums) in traces.caustics.iter().enumerate() {
            // Chords are cells long.
            let area = cells.nodes()[node].share * cells.cell_mm();
            let of = &mut layers[(node * lamps + number) * 3..][..3];
            of.iter_mut().zip(sums).for_each(|(light, sum)| *light = (*sum as f64 * unit / area) as f32);
        }
    }
    gather_all(&light, &cells, &mut layers, options.seed, &progress)?;
    let fingerprint = fingerprint(scene, weights);
    Some(Bake { options: *options, fingerprint, lamps, light: layers, surfaces, cells })
}

/// What all packets of a lamp leave, and the power of a unit of it.
fn traces_of(
    place: &Place,
    source: &LightSource,
    ways: &WayBasis,
    options: &BakeOptions,
    number: usize,
    progress: &Progress,
) -> Option<(Traces, f64)> {
    let absorbing =
        place.surfaces.media_at(source.form.middle()).into_iter().filter(|body| place.surfaces.absorbs(*body));
    let wavelengths = WavelengthSampler::new(&source.emission);
    let unit = source.power * wavelengths.mean() / (UNIT * options.packets.max(1) as f64);
    let seed = mix64(options.seed.wrapping_add(number as u64));
    let lamp = Lamp { source, ways, wavelengths, media: Media::of(absorbing), seed };
    let part = |part: u64| {
        let at = |part: u64| options.packets * part / PARTS;
        let traces = trace(place, &lamp, at(part)..at(part + 1), || !progress.is_cancelled());
        progress.add(1).then_some(traces)
    };
    let parts = if source.power > 0.0 { PARTS } else { 0 };
    let none = || Some(Traces::none(place, ways));
    let traces = (0..parts).into_par_iter().map(part).reduce(none, |a, b| Some(a?.add(&b?)))?;
    Some((traces, unit))
}

/// Puts a lamp's light on the walls beside that of the others: power for each millimetre.
fn fill_walls(
    sent: &mut [f32],
    traces: &Traces,
    ways: usize,
    [most_ways, lamps, lamp]: [usize; 3],
    walls: &Walls,
    unit: f64,
) {
    for (piece, length) in walls.lengths_mm().enumerate() {
        for way in 0..ways {
            for channel in 0..3 {
                let at = ((piece * most_ways + way) * 3 + channel) * lamps + lamp;
                sent[at] = (traces.walls[piece * ways + way][channel] as f64 * unit / length) as f32;
            }
        }
    }
}

/// Adds what all nodes get from the walls.
fn gather_all(light: &WallLight, cells: &Cells, layers: &mut [f32], seed: u64, progress: &Progress) -> Option<()> {
    let lamps = light.lamps();
    if lamps == 0 {
        return Some(());
    }
    layers.par_chunks_mut(CHUNK * lamps * 3).enumerate().try_for_each(|(chunk, layers)| {
        for (at, of) in layers.chunks_exact_mut(lamps * 3).enumerate() {
            let node = chunk * CHUNK + at;
            let turn = unit_from_bits(mix64(seed ^ mix64(node as u64)));
            let gathered = light.gather(cells.nodes()[node].at, turn);
            for lamp in 0..lamps {
                (0..3).for_each(|channel| of[lamp * 3 + channel] += gathered[channel * lamps + lamp]);
            }
        }
        progress.add(1).then_some(())
    })
}
