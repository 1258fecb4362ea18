//! The slow, honest twin: shadow rays to random points of a lamp's chord, in double precision, against the same shapes.
//!
//! Random numbers are named by lamp, pixel and sample: the same picture on any number of threads. A ray is cast against
//! every shape that may meet the triangle of the point and the chord, and no shape is thought of as anything but what
//! [`Shape::cast`] says it is.

use crate::reference::culling_triangle::CullingTriangle;
use crate::scene::validation;
use crate::simd::dispatch::LANES;
use crate::tile::packed_samples::{PackedSamples, Plane, TILE};
use crate::{Filter, Group, Lamp, Occluder, Rgb, Scene};
use geometry::{DVec2, Ray, Segment, Shape};
use std::ops::Range;

mod balls;

/// Neighbouring samples that are cast against the same shapes.
const TOGETHER: u32 = 128;

/// How a lamp is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Shadow rays a lamp.
    pub samples: u32,
    /// Other seeds give other noise.
    pub seed: u64,
    /// One sample in each of `samples` equal parts of the chord, instead of anywhere: less noise.
    pub stratified: bool,
}

/// Where the points of a tile are.
pub(crate) struct TilePixels {
    /// The tile's middle, mm.
    pub middle_mm: DVec2,
    /// Its upper left pixel.
    pub corner: (usize, usize),
    /// Width and height of the picture: nobody sees what a tile has beyond it.
    pub size: (usize, usize),
}

/// What arrives at a point of the floor from all lamps, by `sampling`; what is of the group `exclude` casts no
/// shadow.
pub fn irradiance(scene: &Scene, point_mm: DVec2, exclude: Option<Group>, sampling: Sampling) -> Rgb {
    let mut sum = [0.0; 3];
    let mut near = Vec::new();
    for (index, lamp) in scene.lamps.iter().enumerate().filter(|(_, lamp)| lamp.shines()) {
        let rest = lamp.rest(point_mm);
        if rest > 0.0 {
            let name = Name::new(sampling.seed, index as u64).at(point_mm);
            let rays = Rays { sampling, name, point: point_mm };
            let seen = if scene.filters.is_empty() {
                [rays.arriving(&scene.occluders, lamp, exclude.as_slice(), &mut near).seen; 3]
            } else {
                rays.arriving_through(scene, lamp, exclude)
            };
            let open = rays.unoccluded_fraction(&scene.balls, lamp, exclude);
            let strength = open * Lamp::REFERENCE_MM * Lamp::REFERENCE_MM * rest * rest;
            for channel in 0..3 {
                sum[channel] += f64::from(lamp.color[channel]) * strength * seen[channel];
            }
        }
    }
    sum.map(|light| light as f32)
}

impl Sampling {
    /// The visible fraction of `lamp` at some points of a tile.
    pub(crate) fn visible_fraction(
        &self,
        occluders: &[Occluder],
        lamp: &Lamp,
        points: &PackedSamples,
        at: TilePixels,
        without: &[Group],
        fraction: &mut Plane,
    ) {
        let mut near = Vec::new();
        self.each_point(lamp, points, &at, |rays, block, lane| {
            fraction[block][lane] = rays.map_or(0.0, |rays| {
                let ChordIrradiance { seen, all } = rays.arriving(occluders, lamp, without, &mut near);
                (seen / all) as f32
            });
        });
    }

    /// Calls `work` with the rays of each point and its place; there are none from what nobody sees.
    fn each_point(
        &self,
        lamp: &Lamp,
        points: &PackedSamples,
        at: &TilePixels,
        mut work: impl FnMut(Option<Rays>, usize, usize),
    ) {
        let of_lamp = Name::new(self.seed, 0).at(lamp.center_mm);
        for point in 0..points.count {
            let (block, lane) = (point / LANES, point % LANES);
            let offset = DVec2::new(f64::from(points.x[block][lane]), f64::from(points.y[block][lane]));
            let pixel = usize::from(points.pixel[point]);
            let (x, y) = (at.corner.0 + pixel % TILE, at.corner.1 + pixel / TILE);
            let name = of_lamp.next((y as u64) << 32 | x as u64);
            let there = x < at.size.0 && y < at.size.1;
            work(there.then(|| Rays { sampling: *self, name, point: at.middle_mm + offset }), block, lane);
        }
    }
}

/// The mean over a lamp of `1 / (d^2 + height^2)`, 1/mm^2.
struct ChordIrradiance {
    /// Where hidden places count 0.
    seen: f64,
    /// Where every place counts.
    all: f64,
}

/// The rays from one point to one lamp.
struct Rays {
    sampling: Sampling,
    name: Name,
    point: DVec2,
}

impl Rays {
    fn arriving<'a>(
        &self,
        occluders: &'a [Occluder],
        lamp: &Lamp,
        without: &[Group],
        near: &mut Vec<&'a Shape>,
    ) -> ChordIrradiance {
        let chord = self.chord(lamp);
        let triangle = CullingTriangle::new(self.point, chord.a, chord.b);
        let counts = |occluder: &&Occluder| !without.contains(&occluder.group) && Some(occluder.group) != lamp.inside;
        near.clear();
        near.extend(
            occluders
                .iter()
                .filter(counts)
                .map(|occluder| &occluder.shape)
                .filter(|shape| validation::wrong_with_shape(shape).is_none() && triangle.may_meet(shape)),
        );
        let inside = near.iter().any(|shape| shape.distance(self.point).0 < 0.0);
        let height_square = lamp.height_mm() * lamp.height_mm();
        // A disc's light is that of its middle, whichever part of it is seen.
        let from_middle = 1.0 / (self.point.distance_squared(lamp.center_mm) + height_square);
        if lamp.tube().is_none() && (inside || near.is_empty()) {
            return ChordIrradiance { seen: if inside { 0.0 } else { from_middle }, all: from_middle };
        }
        let count = self.sampling.samples.max(1);
        let (mut seen, mut all) = (0.0, 0.0);
        let mut there = Vec::with_capacity(near.len());
        for first in (0..count).step_by(TOGETHER as usize) {
            let samples = first..count.min(first + TOGETHER);
            self.narrow(near, chord, &samples, &mut there);
            let mut last = 0;
            for sample in samples {
                let hidden = inside || !there.is_empty();
                if !hidden && lamp.tube().is_none() {
                    seen += from_middle;
                    all += from_middle;
                    continue;
                }
                let target = chord.a + chord.along() * self.place(sample);
                let arrives = if lamp.tube().is_some() {
                    1.0 / (self.point.distance_squared(target) + height_square)
                } else {
                    from_middle
                };
                all += arrives;
                if !(hidden && (inside || self.is_hidden(target, &there, &mut last))) {
                    seen += arrives;
                }
            }
        }
        ChordIrradiance { seen: seen / f64::from(count), all: all / f64::from(count) }
    }

    /// The mean over a lamp of `1 / (d^2 + height^2)`, 1/mm^2, where each ray is tinted by every filter that it meets.
    fn arriving_through(&self, scene: &Scene, lamp: &Lamp, without: Option<Group>) -> [f64; 3] {
        let chord = self.chord(lamp);
        let counts = |occluder: &&Occluder| Some(occluder.group) != without && Some(occluder.group) != lamp.inside;
        let drawn = |occluder: &&Occluder| validation::wrong_with_shape(&occluder.shape).is_none();
        let near: Vec<&Occluder> = scene.occluders.iter().filter(counts).filter(drawn).collect();
        let height_square = lamp.height_mm() * lamp.height_mm();
        let mut seen = [0.0; 3];
        for sample in 0..self.sampling.samples.max(1) {
            let target = chord.a + chord.along() * self.place(sample);
            let place = if lamp.tube().is_some() { target } else { lamp.center_mm };
            let arrives = 1.0 / (self.point.distance_squared(place) + height_square);
            let tint = self.tint(target, &near, &scene.filters);
            for channel in 0..3 {
                seen[channel] += arrives * tint[channel];
            }
        }
        seen.map(|sum| sum / f64::from(self.sampling.samples.max(1)))
    }

    /// What is left of a ray: nothing where a wall is in the way, else the product of the tints of the filters.
    fn tint(&self, target: DVec2, near: &[&Occluder], filters: &[Filter]) -> [f64; 3] {
        let far = self.point.distance(target);
        let ray = Ray::towards(self.point, target);
        let met = |occluder: &Occluder| {
            let shape = &occluder.shape;
            let inside = shape.distance(self.point).0 < 0.0;
            inside || ray.is_some_and(|ray| shape.cast(&ray).is_some_and(|hit| hit.distance <= far))
        };
        let mut tint = [1.0; 3];
        let mut passed: Vec<Group> = Vec::new();
        for occluder in near.iter().filter(|occluder| met(occluder)) {
            let Some(filter) = filters.iter().find(|filter| filter.group == occluder.group) else { return [0.0; 3] };
            if !passed.contains(&filter.group) {
                passed.push(filter.group);
                for channel in 0..3 {
                    tint[channel] *= f64::from(filter.tint[channel]);
                }
            }
        }
        tint
    }

    /// Leaves out what meets no ray of some neighbouring samples.
    fn narrow<'a>(&self, near: &[&'a Shape], chord: Segment, samples: &Range<u32>, there: &mut Vec<&'a Shape>) {
        there.clear();
        if !self.sampling.stratified {
            return there.extend_from_slice(near);
        }
        let end = |sample: u32| chord.a + chord.along() * (f64::from(sample) / f64::from(self.sampling.samples.max(1)));
        let triangle = CullingTriangle::new(self.point, end(samples.start), end(samples.end));
        there.extend(near.iter().copied().filter(|shape| triangle.may_meet(shape)));
    }

    /// What is sampled: a segment is its own chord, a disc's is the diameter that faces the point.
    fn chord(&self, lamp: &Lamp) -> Segment {
        let half = lamp.tube().unwrap_or_else(|| {
            let way = lamp.center_mm - self.point;
            way.try_normalize().unwrap_or(DVec2::X).perp() * lamp.radius_mm()
        });
        Segment { a: lamp.center_mm - half, b: lamp.center_mm + half }
    }

    /// Where on the chord a sample is, 0 to 1.
    fn place(&self, sample: u32) -> f64 {
        let random = self.name.next(u64::from(sample)).unit();
        if self.sampling.stratified {
            (f64::from(sample) + random) / f64::from(self.sampling.samples.max(1))
        } else {
            random
        }
    }

    /// Whether anything is on the way; what was in the way of the `last` ray is asked first.
    fn is_hidden(&self, target: DVec2, near: &[&Shape], last: &mut usize) -> bool {
        let Some(ray) = Ray::towards(self.point, target) else { return false };
        let far = self.point.distance(target);
        let hides = |shape: &Shape| shape.cast(&ray).is_some_and(|hit| hit.distance <= far);
        if hides(near[*last]) {
            return true;
        }
        let found = near.iter().position(|shape| hides(shape));
        *last = found.unwrap_or(*last);
        found.is_some()
    }
}

/// A chain of numbers that names a random number. The mixing is that of SplitMix64 (G. Steele, D. Lea, C. Flood, 2014).
#[derive(Clone, Copy)]
struct Name(u64);

impl Name {
    fn new(seed: u64, number: u64) -> Name {
        Name(seed).next(number)
    }

    fn at(self, place: DVec2) -> Name {
        self.next(place.x.to_bits()).next(place.y.to_bits())
    }

    fn next(self, number: u64) -> Name {
        let mut bits = (self.0 ^ number.wrapping_mul(0xff51_afd7_ed55_8ccd)).wrapping_add(0x9e37_79b9_7f4a_7c15);
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Name(bits ^ (bits >> 31))
    }

    /// In [0, 1).
    fn unit(self) -> f64 {
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}
