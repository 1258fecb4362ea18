//! Photons, literally: the slow twin of [`crate::transport::PhotonTracer`].
//!
//! A packet has one wavelength. It meets the nearest of all edges, each of which is asked; what becomes of it is decided by one
//! random number; and its way leaves its light in pixel after pixel. No hierarchy, no packets of wavelengths or of curves, no
//! light that waits, one thread. Packets and their chance are those of the fast tracer, so where light of all wavelengths
//! fares alike, both go the same ways.

use crate::View;
use crate::transport::interaction::{Branch, Interaction, interact};
use crate::transport::spectrum::Weights;
use crate::transport::{
    Contacts, Counts, End, Falloff, Media, Photon, PhotonTracer, PixelSegment, Scene, StartsOn, Surfaces, TOLERANCE_MM,
    lambert,
};
use geometry::rng::SplitMix64;
use geometry::{DVec2, Ray};

/// A packet of one wavelength.
#[derive(Clone, Debug)]
pub struct LiteralPhoton {
    /// Where it is, and which way it goes.
    pub ray: Ray,
    /// Its wavelength, nm.
    pub wavelength_nm: f64,
    /// Its power, which never changes.
    pub power: f64,
    /// 0: s polarized; 1: p polarized.
    pub polarization: usize,
    /// How far it has come.
    pub way: f64,
    starts_on: StartsOn,
    media: Media,
}

/// A scene, ready for literal photons: nothing of it is rough.
pub struct LiteralTracer<'a> {
    packets: PhotonTracer<'a>,
    surfaces: Surfaces,
    weights: Weights,
    most_surfaces: u32,
}

impl<'a> LiteralTracer<'a> {
    /// The tracer of a scene, for a screen whose white is that of `weights`; `None` where something is rough: facets are drawn
    /// by the fast tracer alone.
    pub fn new(scene: &'a Scene, weights: Weights, seed: u64) -> Option<LiteralTracer<'a>> {
        let is_smooth = scene.bodies.iter().all(|body| body.material.roughness() == 0.0);
        is_smooth.then(|| LiteralTracer {
            packets: PhotonTracer::new(scene, weights.clone(), seed),
            surfaces: Surfaces::new(&scene.bodies, TOLERANCE_MM),
            weights,
            most_surfaces: crate::transport::MOST_SURFACES,
        })
    }

    /// Traces the first `packets`; `fly` sees each straight piece of their ways: the packet at its start, how far it goes, how its
    /// light fades, and what is absorbed of it, 1/mm.
    pub fn trace(&self, packets: u64, mut fly: impl FnMut(&LiteralPhoton, f64, Falloff, f64)) -> Counts {
        let mut counts = Counts::default();
        for number in 0..packets {
            let (packet, source, mut random) = self.packets.emit(number);
            let mut photon = LiteralPhoton::of(&packet);
            counts.sent += 1;
            let mut end = End::GivenUp;
            for _ in 0..self.most_surfaces {
                counts.segments += 1;
                let contacts = self.surfaces.meet_literally(&photon.ray, &photon.starts_on);
                let distance = contacts.as_ref().map_or(f64::INFINITY, |contacts| contacts.first().distance);
                let absorption = photon.media.absorption_per_mm(&self.surfaces, photon.wavelength_nm);
                fly(&photon, distance, source.falloff, absorption);
                if let Some(found) = self.next(&mut photon, contacts, absorption, &mut random) {
                    end = found;
                    break;
                }
            }
            match end {
                End::Absorbed => counts.absorbed += 1,
                End::Gone => counts.gone += 1,
                End::GivenUp => counts.given_up += 1,
            }
        }
        counts
    }

    /// Brings a packet to what it meets and on from there; how it ended, if it did.
    fn next(
        &self,
        photon: &mut LiteralPhoton,
        contacts: Option<Contacts>,
        absorption_per_mm: f64,
        random: &mut SplitMix64,
    ) -> Option<End> {
        let Some(contacts) = contacts else {
            return Some(if photon.media.is_empty() { End::Gone } else { End::Absorbed });
        };
        let distance = contacts.first().distance;
        if !photon.media.is_empty() && random.unit() >= libm::exp(-absorption_per_mm * distance) {
            return Some(End::Absorbed);
        }
        photon.way += distance;
        photon.ray.origin = contacts.first().place;
        photon.starts_on = contacts.starts_on();
        let mut smooth = |normal, _| normal;
        let incoming = photon.ray.direction;
        match interact(&self.surfaces, &contacts, incoming, photon.wavelength_nm, &mut smooth) {
            Interaction::Absorbed => Some(End::Absorbed),
            Interaction::Scattered { normal, reflectance } => {
                if random.unit() >= reflectance {
                    return Some(End::Absorbed);
                }
                photon.ray.direction = lambert(normal, random.unit());
                photon.polarization = (random.next_u64() >> 63) as usize;
                None
            }
            Interaction::Split { reflected, transmitted } => {
                let part = |branch: Option<Branch>| branch.map_or(0.0, |branch| branch.power[photon.polarization]);
                let place = random.unit();
                if place < part(reflected) {
                    photon.ray.direction = reflected?.direction;
                } else if place < part(reflected) + part(transmitted) {
                    photon.ray.direction = transmitted?.direction;
                    photon.media.cross(&self.surfaces, &contacts, photon.wavelength_nm);
                } else {
                    return Some(End::Absorbed);
                }
                None
            }
        }
    }

    /// The fluence in each pixel of a view, row by row, signed, by so many packets; and how they ended.
    pub fn picture(&self, view: &View, packets: u64) -> (Vec<[f64; 3]>, Counts) {
        let mut sums = vec![[0.0; 3]; view.width * view.height];
        let counts = self.expose(view, packets, &mut sums);
        let scale = self.packets.power() / (packets.max(1) as f64 * view.mm_per_px);
        (sums.into_iter().map(|sum| sum.map(|channel| channel * scale)).collect(), counts)
    }

    /// Adds the first `packets` to the sums of a view's pixels, a packet's power being 1.
    pub fn expose(&self, view: &View, packets: u64, sums: &mut [[f64; 3]]) -> Counts {
        let size = DVec2::new(view.width as f64, view.height as f64) * view.mm_per_px;
        self.trace(packets, |photon, distance, falloff, absorption| {
            // No way within the picture is longer than its diagonal.
            let distance = distance.min(photon.ray.origin.distance(view.origin_mm + size * 0.5) + size.length());
            let ends = [photon.ray.origin, photon.ray.at(distance)].map(|end| view.screen_from_table(end));
            let color = self.weights.at(photon.wavelength_nm);
            each_pixel(&PixelSegment { from: ends[0], to: ends[1] }, view, |pixel, chord, middle| {
                let gone = middle * view.mm_per_px;
                let power = photon.power * falloff.weight(photon.way + gone) * libm::exp(-absorption * gone);
                (0..3).for_each(|of| sums[pixel][of] += power * chord * f64::from(color[of]));
            });
        })
    }
}

impl LiteralPhoton {
    /// The first wavelength of a packet, with all of its power.
    fn of(packet: &Photon) -> LiteralPhoton {
        let others = packet.power[1..].iter().any(|power| *power > 0.0);
        LiteralPhoton {
            ray: packet.ray,
            wavelength_nm: packet.wavelengths_nm[0],
            // Each of several wavelengths stands for one packet of as many.
            power: packet.power[0] * if others { packet.power.len() as f64 } else { 1.0 },
            polarization: packet.polarization,
            way: packet.way,
            starts_on: StartsOn::NOTHING,
            media: packet.media,
        }
    }
}

/// Shows `visit` each pixel that the way crosses, the length of its chord and how far from the start its middle is, in pixels:
/// J. Amanatides and A. Woo, "A fast voxel traversal algorithm for ray tracing", Eurographics 1987. From one line of pixels to
/// the next, outside of the picture too.
fn each_pixel(segment: &PixelSegment, view: &View, mut visit: impl FnMut(usize, f64, f64)) {
    let (from, way) = (segment.from, segment.to - segment.from);
    let length = way.length();
    if !(length > 0.0 && length.is_finite()) {
        return;
    }
    let direction = way / length;
    let mut cell = [0, 1].map(|axis| from[axis].floor() as i64);
    let step = [0, 1].map(|axis| if direction[axis] < 0.0 { -1 } else { 1 });
    // The distance at which the next line of an axis is crossed; a way along the lines never crosses one.
    let next_line = |cell: [i64; 2], axis: usize| {
        let line = if step[axis] > 0 { cell[axis] + 1 } else { cell[axis] } as f64;
        if direction[axis] == 0.0 { f64::INFINITY } else { (line - from[axis]) / direction[axis] }
    };
    let mut at = 0.0;
    while at < length {
        let next = [next_line(cell, 0), next_line(cell, 1)];
        let axis = usize::from(next[1] < next[0]);
        let leaves = next[axis].min(length);
        let is_inside = (0..view.width as i64).contains(&cell[0]) && (0..view.height as i64).contains(&cell[1]);
        if is_inside && leaves > at {
            visit(cell[1] as usize * view.width + cell[0] as usize, leaves - at, 0.5 * (leaves + at));
        }
        at = leaves;
        cell[axis] += step[axis];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::optical_jumble;
    use crate::transport::PhotonPicture;
    use crate::transport::spectrum::Emission;

    /// With one wavelength the packets of both meet the same places in the same order, bit for bit, and end alike.
    #[test]
    fn both_tracers_hit_exactly_the_same() {
        for seed in 0..3 {
            let mut scene = optical_jumble(60, seed);
            scene.sources.iter_mut().for_each(|source| source.emission = Emission::Line(550.0));
            let weights = Weights::equal_energy();
            let literal = LiteralTracer::new(&scene, weights.clone(), 7).expect("nothing is rough");
            let mut ways = Vec::new();
            let slow = literal.trace(2_000, |photon, distance, _, _| ways.push((photon.ray, distance)));
            let mut at = 0;
            let fast = PhotonTracer::new(&scene, weights, 7).trace(0..2_000, |flight, _| {
                assert_eq!(ways.get(at), Some(&(flight.photon.ray, flight.distance)), "{at}");
                at += 1;
            });
            assert_eq!((slow, at), (fast, ways.len()));
            assert!(at > 8_000, "{at}");
        }
    }

    /// Of all wavelengths the pictures are the same but for the noise, which two halves of each tell.
    #[test]
    fn both_tracers_find_the_same_light() {
        let view = View { width: 9, height: 18, origin_mm: DVec2::ZERO, mm_per_px: 60.0 };
        let scene = optical_jumble(60, 4);
        let slow = |seed| {
            let tracer = LiteralTracer::new(&scene, Weights::equal_energy(), seed).expect("nothing is rough");
            tracer.picture(&view, 20_000).0
        };
        let fast = |seed| {
            let mut picture = PhotonPicture::new(PhotonTracer::new(&scene, Weights::equal_energy(), seed), view);
            picture.expose(40_000);
            picture.fluence()
        };
        let (one, other) = ([slow(1), slow(2)], [fast(3), fast(4)]);
        let (mut apart, mut noise, mut bias, mut sum) = (0.0, 0.0, 0.0, 0.0);
        for (pixel, channel) in (0..view.width * view.height).flat_map(|pixel| (0..3).map(move |of| (pixel, of))) {
            let mean = |of: &[Vec<[f64; 3]>; 2]| 0.5 * (of[0][pixel][channel] + of[1][pixel][channel]);
            let half = |of: &[Vec<[f64; 3]>; 2]| 0.5 * (of[0][pixel][channel] - of[1][pixel][channel]);
            apart += (mean(&one) - mean(&other)).powi(2);
            noise += half(&one).powi(2) + half(&other).powi(2);
            bias += mean(&one) - mean(&other);
            sum += mean(&one);
        }
        assert!(apart < 2.0 * noise, "{apart} against {noise} of noise");
        assert!((bias / sum).abs() < 0.01, "{}", bias / sum);
    }
}
