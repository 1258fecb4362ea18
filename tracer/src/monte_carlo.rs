//! The slow, honest twin: shadow rays to random points of a lamp's chord, in double precision, against the same shapes.
//!
//! Random numbers are named by lamp, pixel and sample: the same picture on any number of threads.

use crate::lanes::LANES;
use crate::points::{Plane, Points, TILE};
use crate::{Group, Lamp, Occluder, Rgb, Scene};
use geometry::{DVec2, Ray};

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
pub(crate) struct Place {
    /// The tile's middle, mm.
    pub middle_mm: DVec2,
    /// Its upper left pixel.
    pub corner: (usize, usize),
}

/// What arrives at a point of the floor from all lamps, by `sampling`; occluders of the group `exclude` cast no shadow.
pub fn irradiance(scene: &Scene, point_mm: DVec2, exclude: Option<Group>, sampling: Sampling) -> Rgb {
    let mut sum = [0.0; 3];
    for (index, lamp) in scene.lamps.iter().enumerate() {
        let falloff = lamp.falloff(point_mm);
        if falloff > 0.0 {
            let name = Name::new(sampling.seed, index as u64);
            let seen = sampling.seen(&scene.occluders, lamp, point_mm, exclude, name);
            for channel in 0..3 {
                sum[channel] += f64::from(lamp.color[channel]) * falloff * seen;
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
        points: &Points,
        at: Place,
        without: Option<Group>,
        fraction: &mut Plane,
    ) {
        let of_lamp = Name::new(self.seed, lamp.center_mm.x.to_bits()).next(lamp.center_mm.y.to_bits());
        for point in 0..points.count {
            let (block, lane) = (point / LANES, point % LANES);
            let offset = DVec2::new(f64::from(points.x[block][lane]), f64::from(points.y[block][lane]));
            let pixel = usize::from(points.pixel[point]);
            let (x, y) = (at.corner.0 + pixel % TILE, at.corner.1 + pixel / TILE);
            let name = of_lamp.next((y as u64) << 32 | x as u64);
            fraction[block][lane] = self.seen(occluders, lamp, at.middle_mm + offset, without, name) as f32;
        }
    }

    fn seen(&self, occluders: &[Occluder], lamp: &Lamp, point: DVec2, without: Option<Group>, name: Name) -> f64 {
        let counts = |occluder: &&Occluder| Some(occluder.group) != without && Some(occluder.group) != lamp.inside;
        let way = lamp.center_mm - point;
        let across = way.try_normalize().unwrap_or(DVec2::X).perp() * lamp.radius_mm.max(0.0);
        let swept = way.length() + across.length();
        let near: Vec<&Occluder> =
            occluders.iter().filter(counts).filter(|occluder| occluder.shape.distance(point).0 <= swept).collect();
        if near.iter().any(|occluder| occluder.shape.distance(point).0 < 0.0) {
            return 0.0;
        }
        let visible = (0..self.samples).filter(|&sample| {
            let random = name.next(u64::from(sample)).unit();
            let place = if self.stratified { (f64::from(sample) + random) / f64::from(self.samples) } else { random };
            let target = lamp.center_mm + across * (2.0 * place - 1.0);
            let Some(ray) = Ray::towards(point, target) else { return true };
            let far = point.distance(target);
            !near.iter().any(|occluder| occluder.shape.cast(&ray).is_some_and(|hit| hit.distance <= far))
        });
        visible.count() as f64 / f64::from(self.samples.max(1))
    }
}

/// A chain of numbers that names a random number. The mixing is that of SplitMix64 (G. Steele, D. Lea, C. Flood, 2014).
#[derive(Clone, Copy)]
struct Name(u64);

impl Name {
    fn new(seed: u64, number: u64) -> Name {
        Name(seed).next(number)
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
