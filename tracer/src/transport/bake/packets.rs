//! Packets of light from one lamp, and what they leave: on matt walls, and as caustics in cells.

use super::cells::Cells;
use super::walls::Walls;
use super::way_basis::{NEAREST, WayBasis};
use crate::transport::PACKET_BITS;
use crate::transport::interaction::{Interaction, interact};
use crate::transport::photons::evenly;
use crate::transport::pixel_walk::{PixelSegment, PixelWalk};
use crate::transport::spectrum::{WavelengthSampler, Weights};
use crate::transport::{Contacts, HEROES, LightSource, MOST_SURFACES, Media, Photon, StartsOn, Step, Surfaces};
use geometry::DVec2;
use geometry::rng::{SplitMix64, mix64};
use std::ops::Range;

/// Where packets go.
pub(super) struct Place<'a> {
    pub(super) surfaces: &'a Surfaces,
    pub(super) walls: &'a Walls,
    pub(super) cells: &'a Cells,
    pub(super) weights: &'a Weights,
    /// Whether anything absorbs light inside.
    pub(super) absorbs: bool,
    /// Matt walls that light meets at most.
    pub(super) bounces: u32,
}

/// A lamp, ready to be drawn from.
pub(super) struct Lamp<'a> {
    pub(super) source: &'a LightSource,
    pub(super) ways: &'a WayBasis,
    pub(super) wavelengths: WavelengthSampler,
    pub(super) media: Media,
    pub(super) seed: u64,
}

/// What packets of one lamp have left: whole numbers, of which a packet's power is 2^24.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Traces {
    /// What each piece of the walls sends out, by pieces and then by ways.
    pub(super) walls: Vec<[i64; 3]>,
    /// Power times cells of way, by nodes.
    pub(super) caustics: Vec<[i64; 3]>,
}

impl Traces {
    pub(super) fn none(place: &Place, ways: &WayBasis) -> Traces {
        let walls = vec![[0; 3]; place.walls.pieces() * ways.count()];
        Traces { walls, caustics: vec![[0; 3]; place.cells.nodes().len()] }
    }

    pub(super) fn add(mut self, other: &Traces) -> Traces {
        let pairs = self.walls.iter_mut().zip(&other.walls).chain(self.caustics.iter_mut().zip(&other.caustics));
        pairs.for_each(|(sum, more)| (0..3).for_each(|channel| sum[channel] += more[channel]));
        self
    }
}

/// What is left by the packets of these numbers; `goes_on` is asked before each.
pub(super) fn trace(place: &Place, lamp: &Lamp, numbers: Range<u64>, goes_on: impl Fn() -> bool) -> Traces {
    let mut traces = Traces::none(place, lamp.ways);
    for number in numbers {
        if !goes_on() {
            break;
        }
        let (photon, random) = lamp.emit(number);
        Flight { place, lamp, photon, traces: &mut traces }.follow(random);
    }
    traces
}

impl Lamp<'_> {
    /// The packet of a number at the lamp.
    fn emit(&self, number: u64) -> (Photon, SplitMix64) {
        let [color, u, v] = evenly(number, self.seed);
        let samples: [_; HEROES] = std::array::from_fn(|hero| {
            let turned = color + hero as f64 / HEROES as f64;
            self.wavelengths.sample(turned - turned.floor())
        });
        let mut random = SplitMix64::new(mix64(self.seed ^ mix64(number)));
        let ray = self.source.form.emit([u, v]);
        let photon = Photon {
            ray,
            starts_on: StartsOn::NOTHING,
            wavelengths_nm: samples.map(|sample| sample.nm),
            power: samples.map(|sample| sample.weight / HEROES as f64),
            polarization: (random.next_u64() >> 63) as usize,
            way: self.source.form.head_start(&ray),
            media: self.media,
        };
        (photon, random)
    }
}

/// A packet on its way.
struct Flight<'a, 'b> {
    place: &'a Place<'b>,
    lamp: &'a Lamp<'b>,
    photon: Photon,
    traces: &'a mut Traces,
}

impl Flight<'_, '_> {
    fn follow(mut self, mut random: SplitMix64) {
        let surfaces = self.place.surfaces;
        let mut scattered = 0;
        // A lamp's straight light is no part of the bake, and that of a wall is gathered.
        let mut is_counted = true;
        for _ in 0..MOST_SURFACES {
            let contacts = surfaces.meet(&self.photon.ray, &self.photon.starts_on);
            let distance = contacts.as_ref().map_or(f64::INFINITY, |contacts| contacts.first().distance);
            let absorption = self.absorption();
            if !is_counted {
                self.cross_cells(distance, absorption.as_ref());
            }
            let Some(contacts) = contacts else { return };
            if let Some(absorption) = absorption {
                (0..HEROES).for_each(|of| self.photon.power[of] *= libm::exp(-absorption[of] * distance));
            }
            self.photon.way += distance;
            self.photon.ray.origin = contacts.first().place;
            if !self.lamp.ways.reaches(self.photon.way) || self.photon.total_power() <= 0.0 {
                return;
            }
            if let Some(sent) = self.scattered(&contacts) {
                if scattered == self.place.bounces {
                    return;
                }
                scattered += 1;
                if self.is_in_the_open() {
                    self.count_on_wall(&contacts, sent);
                }
            }
            match self.photon.meet(surfaces, &contacts, &mut random) {
                Step::Scatters(_) => is_counted = self.is_in_the_open(),
                Step::Passes | Step::Turns => is_counted = false,
                Step::Ends(_) => return,
            }
        }
    }

    /// How much of each wavelength is absorbed, 1/mm, if any is.
    fn absorption(&self) -> Option<[f64; HEROES]> {
        let Photon { media, wavelengths_nm, .. } = &self.photon;
        let found =
            self.place.absorbs.then(|| wavelengths_nm.map(|nm| media.absorption_per_mm(self.place.surfaces, nm)));
        found.filter(|absorption| *absorption != [0.0; HEROES])
    }

    /// Whether the packet is in no absorbing medium: what a wall sends out is gathered over clear ways only.
    fn is_in_the_open(&self) -> bool {
        self.absorption().is_none()
    }

    /// The colour of what a matt wall at these contacts sends out; the mean over what chance will make of it.
    fn scattered(&self, contacts: &Contacts) -> Option<[f64; 3]> {
        let (surfaces, photon) = (self.place.surfaces, &self.photon);
        let mut smooth = |normal, _| normal;
        let (mut color, mut is_matt) = ([0.0; 3], false);
        for of in 0..HEROES {
            if photon.power[of] == 0.0 {
                continue;
            }
            let nm = photon.wavelengths_nm[of];
            let met = interact(surfaces, contacts, photon.ray.direction, nm, &mut smooth);
            let Interaction::Scattered { reflectance, .. } = met else { continue };
            is_matt = true;
            let weights = self.place.weights.at(nm);
            (0..3).for_each(|channel| color[channel] += photon.power[of] * reflectance * f64::from(weights[channel]));
        }
        is_matt.then_some(color)
    }

    fn count_on_wall(&mut self, contacts: &Contacts, sent: [f64; 3]) {
        let Some(point) = self.place.walls.met(self.place.surfaces, contacts) else { return };
        let (first, parts) = self.lamp.ways.parts(self.photon.way);
        let base = self.place.walls.piece(&point) * self.lamp.ways.count() + first;
        let count = NEAREST.min(self.lamp.ways.count());
        for (sums, part) in self.traces.walls[base..base + count].iter_mut().zip(parts) {
            (0..3).for_each(|channel| sums[channel] += (sent[channel] * part * UNIT) as i64);
        }
    }

    /// Leaves light in the cells that the packet crosses before the next surface.
    fn cross_cells(&mut self, distance: f64, absorption: Option<&[f64; HEROES]>) {
        let Place { surfaces, cells, weights, .. } = *self.place;
        let ray = self.photon.ray;
        let diagonal = DVec2::new(cells.width() as f64, cells.height() as f64).length() * cells.cell_mm();
        let from = cells.place_of(ray.origin);
        let middle = DVec2::new(cells.width() as f64, cells.height() as f64) * 0.5;
        let to = cells.place_of(ray.at(distance.min(diagonal + (from - middle).length() * cells.cell_mm())));
        let photon = &self.photon;
        let colors = photon.wavelengths_nm.map(|nm| weights.at(nm));
        let sums = &mut self.traces.caustics;
        let size = [cells.width(), cells.height()];
        let Some(walk) = PixelWalk::new(&PixelSegment { from, to }, size[0], size[1]) else { return };
        walk.visit(size, |[x, y], chord, at| {
            let cell = y * size[0] + x;
            let gone = at * cells.cell_mm();
            let Some(node) = cells.node_seen(surfaces, cell, ray.at(gone)) else { return };
            let weight = self.lamp.source.falloff.weight(photon.way + gone) * chord * UNIT;
            for of in (0..HEROES).filter(|of| photon.power[*of] > 0.0) {
                let left = absorption.map_or(1.0, |absorption| libm::exp(-absorption[of] * gone));
                let power = photon.power[of] * left * weight;
                (0..3).for_each(|channel| sums[node][channel] += (power * f64::from(colors[of][channel])) as i64);
            }
        });
    }
}

/// A packet's power in the sums.
pub(super) const UNIT: f64 = (1_u64 << PACKET_BITS) as f64;
