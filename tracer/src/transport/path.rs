//! The path tracer: light found backwards, from the pixels to the sources.
//!
//! The fluence at a point is the integral of the radiance over all directions. Directions are drawn evenly, each is followed as
//! a packet of light is ([`super::Photon`]: reflection, refraction and scattering look the same from both ends), and at the
//! point and at each matt surface the sources are asked directly for what they send there (next-event estimation; J. Kajiya,
//! "The rendering equation", 1986). Radiance over the index of refraction is kept on a way, so a path from a medium of index
//! n to a source in one of index m finds the source n/m times as bright.
//!
//! A point of light behind glass is found by no path: photons and beams find it.

use super::interaction::{Interaction, interact};
use super::photon::{HEROES, Photon, Step};
use super::scene::{Scene, TOLERANCE_MM};
use super::spectrum::{WavelengthSampler, Weights};
use super::{BodyId, Curve, Flight, LightSource, Material, Media, SourceForm, StartsOn, Surfaces};
use crate::View;
use geometry::rng::{SplitMix64, mix64, unit_from_bits};
use geometry::{Circle, DVec2, Ray, trig};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// A scene, ready for paths.
pub struct PathTracer<'a> {
    surfaces: Surfaces,
    sources: Vec<Prepared<'a>>,
    weights: Weights,
    seed: u64,
    most_surfaces: u32,
    /// Whether there is anything that absorbs light inside.
    absorbs: bool,
}

struct Prepared<'a> {
    source: &'a LightSource,
    wavelengths: WavelengthSampler,
    /// The dielectrics that it lies in.
    media: Vec<BodyId>,
}

/// The wavelengths of a path, and what each one weighs.
struct Spectral {
    nm: [f64; HEROES],
    weight: [f64; HEROES],
}

impl<'a> PathTracer<'a> {
    /// The tracer of a scene, for a screen whose white is that of `weights`.
    pub fn new(scene: &'a Scene, weights: Weights, seed: u64) -> PathTracer<'a> {
        let surfaces = Surfaces::new(&scene.bodies, TOLERANCE_MM);
        let prepared = |source: &'a LightSource| Prepared {
            source,
            wavelengths: WavelengthSampler::new(&source.emission),
            media: surfaces.media_at(source.form.middle()),
        };
        let sources = scene.sources.iter().filter(|source| source.power > 0.0).map(prepared).collect();
        let absorbs = (0..scene.bodies.len() as BodyId).any(|body| surfaces.absorbs(body));
        PathTracer { surfaces, sources, weights, seed, most_surfaces: super::MOST_SURFACES, absorbs }
    }

    /// The same with another limit of surfaces that a path meets.
    pub fn with_most_surfaces(self, most_surfaces: u32) -> PathTracer<'a> {
        PathTracer { most_surfaces, ..self }
    }

    /// The fluence at a point by sample number `sample` of `directions` directions.
    fn fluence(&self, point: DVec2, name: u64, sample: u64, directions: u32) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let media = self.surfaces.media_at(point);
        let absorbing = Media::of(media.iter().copied().filter(|body| self.surfaces.absorbs(*body)));
        for (number, prepared) in self.sources.iter().enumerate() {
            let mut random = SplitMix64::new(mix64(mix64(self.seed ^ name) ^ mix64(sample << 20 | number as u64)));
            for direction in 0..directions {
                let spectral = prepared.spectral(&mut random, self.index_ratio(&media, &prepared.media));
                // Strata of directions, turned by the sample.
                let unit = (f64::from(direction) + random.unit()) / f64::from(directions);
                let photon = Photon {
                    ray: Ray { origin: point, direction: trig::direction(TAU * unit) },
                    starts_on: StartsOn::NOTHING,
                    wavelengths_nm: spectral.nm,
                    power: [1.0 / HEROES as f64; HEROES],
                    polarization: (random.next_u64() >> 63) as usize,
                    way: 0.0,
                    media: absorbing,
                };
                let light = self.path(prepared, photon, &spectral, &mut random);
                (0..3).for_each(|channel| sum[channel] += light[channel] / f64::from(directions));
            }
        }
        sum
    }

    /// What a path finds: the fluence at its start, if all directions were as this one.
    fn path(&self, prepared: &Prepared, mut photon: Photon, spectral: &Spectral, random: &mut SplitMix64) -> [f64; 3] {
        let mut light = self.next_event(prepared, &photon, None, spectral, random);
        // What the last question to the sources has found already is not found again.
        let mut asked = true;
        for _ in 0..self.most_surfaces {
            let mut met = [0.0; 3];
            let step = photon.step(&self.surfaces, random, |flight| {
                if !asked {
                    met = self.sources_on(prepared, flight, spectral);
                }
            });
            (0..3).for_each(|channel| light[channel] += met[channel]);
            match step {
                Step::Passes => {}
                Step::Turns => asked = false,
                Step::Scatters(normal) => {
                    let more = self.next_event(prepared, &photon, Some(normal), spectral, random);
                    (0..3).for_each(|channel| light[channel] += more[channel]);
                    asked = true;
                }
                Step::Ends(_) => break,
            }
        }
        light
    }

    /// What a source sends straight to where the path is: to a point (times all directions), or to a matt surface with this normal.
    fn next_event(
        &self,
        prepared: &Prepared,
        photon: &Photon,
        normal: Option<DVec2>,
        spectral: &Spectral,
        random: &mut SplitMix64,
    ) -> [f64; 3] {
        let point = photon.ray.origin;
        let Some((to, fluence)) = prepared.source.form.towards(point, random.unit()) else { return [0.0; 3] };
        let Some(ray) = Ray::towards(point, to) else { return [0.0; 3] };
        // Of the fluence of a narrow bundle a matt surface takes the cosine, and each direction has half of that times 2 pi.
        let part = normal.map_or(1.0, |normal| PI * normal.dot(ray.direction).max(0.0));
        let distance = point.distance(to);
        if part <= 0.0 {
            return [0.0; 3];
        }
        let passed = self.passed(&ray, photon, distance);
        let Some(passed) = passed else { return [0.0; 3] };
        let arriving = Ray { origin: to, direction: -ray.direction };
        let way = photon.way + distance + prepared.source.form.head_start(&arriving);
        let weight = prepared.source.falloff.weight(way);
        self.color(photon, spectral, |of| passed[of] * part * fluence * weight * prepared.source.power)
    }

    /// The part of each wavelength that goes straight over a distance; `None` where something turns or stops light.
    fn passed(&self, ray: &Ray, photon: &Photon, distance: f64) -> Option<[f64; HEROES]> {
        let mut passed = [1.0; HEROES];
        if !self.absorbs && !self.surfaces.is_blocked(ray, &photon.starts_on, distance) {
            return Some(passed);
        }
        let (mut ray, mut starts_on, mut media, mut left) = (*ray, photon.starts_on, photon.media, distance);
        loop {
            let contacts = self.surfaces.meet(&ray, &starts_on);
            let next = contacts.as_ref().map_or(f64::INFINITY, |contacts| contacts.first().distance);
            let way = next.min(left);
            for of in 0..HEROES {
                passed[of] *= libm::exp(-media.absorption_per_mm(&self.surfaces, photon.wavelengths_nm[of]) * way);
            }
            let Some(contacts) = contacts.filter(|_| next < left) else { return Some(passed) };
            for of in 0..HEROES {
                let mut smooth = |normal, _| normal;
                let nm = photon.wavelengths_nm[of];
                let Interaction::Split { transmitted: Some(through), .. } =
                    interact(&self.surfaces, &contacts, ray.direction, nm, &mut smooth)
                else {
                    return None;
                };
                if through.direction != ray.direction {
                    return None;
                }
                passed[of] *= through.power[photon.polarization];
            }
            media.cross(&self.surfaces, &contacts, photon.wavelengths_nm[0]);
            left -= next;
            starts_on = contacts.starts_on();
            ray.origin = contacts.first().place;
        }
    }

    /// What a source of some size adds to a path that crosses it.
    fn sources_on(&self, prepared: &Prepared, flight: &Flight, spectral: &Spectral) -> [f64; 3] {
        let Some((distance, radiance)) = prepared.source.form.crossed(&flight.photon.ray) else { return [0.0; 3] };
        if distance >= flight.distance {
            return [0.0; 3];
        }
        let ray = &flight.photon.ray;
        let arriving = Ray { origin: ray.at(distance), direction: -ray.direction };
        let way = flight.photon.way + distance + prepared.source.form.head_start(&arriving);
        let weight = prepared.source.falloff.weight(way);
        let passed =
            |of: usize| flight.absorption_per_mm.map_or(1.0, |absorption| libm::exp(-absorption[of] * distance));
        self.color(flight.photon, spectral, |of| passed(of) * TAU * radiance * weight * prepared.source.power)
    }

    /// The colour of a path's light; `light` is that of each wavelength.
    fn color(&self, photon: &Photon, spectral: &Spectral, light: impl Fn(usize) -> f64) -> [f64; 3] {
        let mut color = [0.0; 3];
        for of in 0..HEROES {
            // A packet that has chosen a wavelength carries it in the first place.
            let Some(own) = spectral.nm.iter().position(|nm| *nm == photon.wavelengths_nm[of]) else { continue };
            let part = photon.power[of] * spectral.weight[own] * light(of);
            if part > 0.0 {
                let weights = self.weights.at(photon.wavelengths_nm[of]);
                (0..3).for_each(|channel| color[channel] += part * f64::from(weights[channel]));
            }
        }
        color
    }

    /// The index of refraction at a point over that at a source, by wavelength.
    fn index_ratio(&self, media: &[BodyId], of_source: &[BodyId]) -> impl Fn(f64) -> f64 + use<'_, 'a> {
        let index = |bodies: &[BodyId]| {
            let glasses = bodies.iter().filter_map(|body| match self.surfaces.material(*body) {
                Material::Dielectric(glass) => Some(glass.dispersion),
                _ => None,
            });
            glasses.collect::<Vec<_>>()
        };
        let (here, there) = (index(media), index(of_source));
        move |nm| {
            let product =
                |glasses: &[super::spectrum::Dispersion]| glasses.iter().map(|glass| glass.index(nm)).product::<f64>();
            product(&here) / product(&there)
        }
    }
}

impl Prepared<'_> {
    /// Wavelengths of this source, and what each one weighs; `ratio` is how much brighter it looks from where the path starts.
    fn spectral(&self, random: &mut SplitMix64, ratio: impl Fn(f64) -> f64) -> Spectral {
        let unit = random.unit();
        let samples: [_; HEROES] = std::array::from_fn(|hero| {
            let turned = unit + hero as f64 / HEROES as f64;
            self.wavelengths.sample(turned - turned.floor())
        });
        let mean = self.wavelengths.mean();
        Spectral {
            nm: samples.map(|sample| sample.nm),
            weight: samples.map(|sample| sample.weight * mean * ratio(sample.nm)),
        }
    }
}

impl SourceForm {
    /// A point of the source, drawn by `unit`, and the fluence at `point` of unit power if all that shines there is as visible as
    /// that point. `None` for light that comes in one direction only, and inside a disc.
    fn towards(&self, point: DVec2, unit: f64) -> Option<(DVec2, f64)> {
        match *self {
            SourceForm::Point(center) | SourceForm::Cone { center, .. } => Some((center, self.fluence(point)?)),
            SourceForm::Disc { center, radius } => {
                let away = center - point;
                let distance = away.length();
                if distance <= radius {
                    // Its light goes outwards: what is seen inside is its face.
                    return None;
                }
                let half = libm::asin(radius / distance);
                let direction = trig::rotate(away / distance, (2.0 * unit - 1.0) * half);
                let hit = Circle { center, radius }.cast(&Ray { origin: point, direction });
                let reach =
                    hit.map_or_else(|| (distance * distance - radius * radius).max(0.0).sqrt(), |hit| hit.distance);
                Some((point + direction * reach, self.fluence(point)?))
            }
            SourceForm::Tube(line) => {
                let place = line.a + line.along() * unit;
                Some((place, 1.0 / (TAU * point.distance(place))))
            }
            SourceForm::Beam { .. } => None,
        }
    }

    /// How far along a ray the source is crossed, and its radiance there at unit power.
    fn crossed(&self, ray: &Ray) -> Option<(f64, f64)> {
        match *self {
            SourceForm::Disc { center, radius } => {
                let hit = Circle { center, radius }.cast(ray)?;
                Some((hit.distance, 1.0 / (4.0 * PI * radius)))
            }
            SourceForm::Tube(line) => {
                let crossing = Curve::Line(line).cross(ray, false)?;
                // Each millimetre sends 1 / (2 pi length) in all directions; slantwise more of them lie on the ray.
                let across = crossing.normal.dot(ray.direction).abs();
                Some((crossing.distance, 1.0 / (TAU * line.length() * across)))
            }
            SourceForm::Point(_) | SourceForm::Cone { .. } | SourceForm::Beam { .. } => None,
        }
    }
}

/// A path-traced picture in the making.
pub struct PathPicture<'a> {
    tracer: PathTracer<'a>,
    view: View,
    directions: u32,
    sums: Vec<[f64; 3]>,
    passes: u64,
}

impl<'a> PathPicture<'a> {
    /// An empty picture; each pass follows so many directions from a point of each pixel.
    pub fn new(tracer: PathTracer<'a>, view: View, directions: u32) -> PathPicture<'a> {
        PathPicture {
            tracer,
            view,
            directions: directions.max(1),
            sums: vec![[0.0; 3]; view.width * view.height],
            passes: 0,
        }
    }

    /// One pass more over all pixels.
    pub fn expose(&mut self) {
        let (view, pass) = (self.view, self.passes);
        self.sums.par_chunks_mut(view.width).enumerate().for_each(|(y, row)| {
            for (x, sum) in row.iter_mut().enumerate() {
                let name = (y as u64) << 32 | x as u64;
                let bits = mix64(self.tracer.seed ^ mix64(name) ^ mix64(pass).rotate_left(17));
                let offset = DVec2::new(unit_from_bits(bits), unit_from_bits(mix64(bits)));
                let point = view.origin_mm + (DVec2::new(x as f64, y as f64) + offset) * view.mm_per_px;
                let light = self.tracer.fluence(point, name, pass, self.directions);
                (0..3).for_each(|channel| sum[channel] += light[channel]);
            }
        });
        self.passes += 1;
    }

    /// Directions that a pass follows from a pixel.
    pub fn directions(&self) -> u32 {
        self.directions
    }

    /// Passes so far.
    pub fn passes(&self) -> u64 {
        self.passes
    }

    /// The fluence in each pixel, row by row, signed.
    pub fn fluence(&self) -> Vec<[f64; 3]> {
        let passes = self.passes.max(1) as f64;
        self.sums.iter().map(|sum| sum.map(|channel| channel / passes)).collect()
    }
}
