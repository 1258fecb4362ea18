//! The shadow rays from one point to one lamp.

use crate::reference::culling_triangle::CullingTriangle;
use crate::reference::monte_carlo::Sampling;
use crate::scene::validation;
use crate::{Group, Lamp, Occluder, Rgb, Scene};
use geometry::rng::Key;
use geometry::{DVec2, Ray, Segment, Shape};
use std::ops::Range;

/// Neighbouring samples that are cast against the same shapes.
const TOGETHER: u32 = 128;

/// The mean over a lamp of `1 / (d^2 + height^2)`, 1/mm^2.
pub(super) struct Arriving {
    /// What arrives of each channel: hidden samples count 0, and tinted ones what passes.
    pub seen: [f64; 3],
    /// What would arrive with nothing in the way.
    pub all: f64,
}

/// What may be in the way of a point's rays to a lamp.
#[derive(Default)]
pub(super) struct Near<'a> {
    /// What is opaque.
    walls: Vec<&'a Shape>,
    /// What tints light, and its transmittance.
    pub panes: Vec<(&'a Occluder, Rgb)>,
}

impl<'a> Near<'a> {
    /// Gathers what may meet the triangle of the point and the chord.
    fn gather(&mut self, scene: &'a Scene, lamp: &Lamp, without: Option<Group>, triangle: &CullingTriangle) {
        self.walls.clear();
        self.panes.clear();
        for occluder in &scene.occluders {
            let Occluder { shape, group, material, .. } = occluder;
            let counts = Some(*group) != without && Some(*group) != lamp.inside;
            if !counts || validation::wrong_with_shape(shape).is_some() || !triangle.may_meet(shape) {
                continue;
            }
            match material.transmittance() {
                Some(transmittance) => self.panes.push((occluder, transmittance)),
                None => self.walls.push(shape),
            }
        }
    }
}

/// The rays from one point to one lamp.
pub(super) struct Rays {
    pub sampling: Sampling,
    pub key: Key,
    pub point: DVec2,
}

impl Rays {
    /// What arrives past everything that is not of the group `without`; `near` is room to work in.
    pub fn arriving<'a>(&self, scene: &'a Scene, lamp: &Lamp, without: Option<Group>, near: &mut Near<'a>) -> Arriving {
        let chord = self.chord(lamp);
        near.gather(scene, lamp, without, &CullingTriangle::new(self.point, chord.a, chord.b));
        let Near { walls, panes } = near;
        let inside = walls.iter().any(|shape| shape.distance(self.point).0 < 0.0);
        let height_square = lamp.height_mm() * lamp.height_mm();
        // A disc's light is that of its middle, whichever part of it is seen.
        let from_middle = 1.0 / (self.point.distance_squared(lamp.center_mm) + height_square);
        if lamp.tube().is_none() && (inside || walls.is_empty() && panes.is_empty()) {
            return Arriving { seen: [if inside { 0.0 } else { from_middle }; 3], all: from_middle };
        }
        let count = self.sampling.samples.max(1);
        let (mut seen, mut all) = ([0.0; 3], 0.0);
        let mut there = Vec::with_capacity(walls.len());
        for first in (0..count).step_by(TOGETHER as usize) {
            let samples = first..count.min(first + TOGETHER);
            self.narrow(walls, chord, &samples, &mut there);
            let mut last = 0;
            for sample in samples {
                let target = chord.a + chord.along() * self.place(sample);
                let arrives = if lamp.tube().is_some() {
                    1.0 / (self.point.distance_squared(target) + height_square)
                } else {
                    from_middle
                };
                all += arrives;
                if inside || !there.is_empty() && self.is_hidden(target, &there, &mut last) {
                    continue;
                }
                let passes = self.passes(target, panes);
                for channel in 0..3 {
                    seen[channel] += arrives * passes[channel];
                }
            }
        }
        Arriving { seen: seen.map(|sum| sum / f64::from(count)), all: all / f64::from(count) }
    }

    /// What is left of a ray: the product of the transmittances of the groups that it meets, each once.
    fn passes(&self, target: DVec2, panes: &[(&Occluder, Rgb)]) -> [f64; 3] {
        let mut passes = [1.0; 3];
        let mut met: Vec<Group> = Vec::new();
        for (Occluder { shape, group, .. }, transmittance) in panes {
            let meets = || shape.distance(self.point).0 < 0.0 || self.meets(target, shape);
            if !met.contains(group) && meets() {
                met.push(*group);
                for channel in 0..3 {
                    passes[channel] *= f64::from(transmittance[channel]);
                }
            }
        }
        passes
    }

    /// Whether the ray to a target meets a shape.
    fn meets(&self, target: DVec2, shape: &Shape) -> bool {
        let far = self.point.distance(target);
        let hit = Ray::towards(self.point, target).and_then(|ray| shape.cast(&ray));
        hit.is_some_and(|hit| hit.distance <= far)
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

    /// What is sampled: a tube is its own chord, a disc's is the diameter that faces the point.
    fn chord(&self, lamp: &Lamp) -> Segment {
        let half = lamp.tube().unwrap_or_else(|| {
            let way = lamp.center_mm - self.point;
            way.try_normalize().unwrap_or(DVec2::X).perp() * lamp.radius_mm()
        });
        Segment { a: lamp.center_mm - half, b: lamp.center_mm + half }
    }

    /// Where on the chord a sample is, 0 to 1.
    pub fn place(&self, sample: u32) -> f64 {
        let random = self.key.with(u64::from(sample)).unit();
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
