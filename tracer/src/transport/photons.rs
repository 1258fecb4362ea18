//! The photon tracer: packets of light from the sources, as many as are asked for, and what they leave on a film.
//!
//! A packet is named by its number: where it starts is the number's place in a sequence that fills the unit cube evenly, and
//! its later decisions come from a stream of the number's own. So a picture is the same in any order and on any number of
//! threads, and the first half of its packets is a picture too.

use super::film::{PACKET_BITS, SplatFilm};
use super::photon::{End, Flight, HEROES, Media, Photon};
use super::pixel_walk::PixelSegment;
use super::scene::{Scene, TOLERANCE_MM};
use super::spectrum::{WavelengthSampler, Weights};
use super::splat_queue::SplatQueue;
use super::{Falloff, LightSource, StartsOn, Surfaces};
use crate::View;
use geometry::DVec2;
use geometry::rng::{SplitMix64, mix64};
use rayon::prelude::*;
use std::ops::{AddAssign, Range};
use std::sync::Mutex;

/// Packets that one task traces.
const TASK: u64 = 1 << 8;

/// Surfaces that a packet meets at most, if nothing else is said: with half of the power lost at each, 2^-1000 is left.
pub const MOST_SURFACES: u32 = 1_000;

/// How packets ended: whole numbers, and `sent` is the sum of the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Packets that left their sources.
    pub sent: u64,
    /// Of those, absorbed ones.
    pub absorbed: u64,
    /// Ones that left the scene.
    pub gone: u64,
    /// Ones that were given up.
    pub given_up: u64,
    /// Straight pieces of all their ways.
    pub segments: u64,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, more: Counts) {
        self.sent += more.sent;
        self.absorbed += more.absorbed;
        self.gone += more.gone;
        self.given_up += more.given_up;
        self.segments += more.segments;
    }
}

/// A source, ready to be drawn from.
struct Prepared<'a> {
    source: &'a LightSource,
    wavelengths: WavelengthSampler,
    /// The absorbing dielectrics that it lies in.
    media: Media,
    /// The part of all power that comes before it.
    begins: f64,
    /// Its own part.
    part: f64,
}

/// A scene, ready for photons.
pub struct PhotonTracer<'a> {
    surfaces: Surfaces,
    sources: Vec<Prepared<'a>>,
    /// The power of all sources.
    power: f64,
    weights: Weights,
    seed: u64,
    most_surfaces: u32,
}

impl<'a> PhotonTracer<'a> {
    /// The tracer of a scene, for a screen whose white is that of `weights`.
    pub fn new(scene: &'a Scene, weights: Weights, seed: u64) -> PhotonTracer<'a> {
        let surfaces = Surfaces::new(&scene.bodies, TOLERANCE_MM);
        let samplers: Vec<_> = scene.sources.iter().map(|source| WavelengthSampler::new(&source.emission)).collect();
        let powers = scene.sources.iter().zip(&samplers).map(|(source, sampler)| source.power * sampler.mean());
        let powers: Vec<f64> = powers.collect();
        let power: f64 = powers.iter().sum();
        let mut begins = 0.0;
        let sources = scene.sources.iter().zip(samplers).zip(powers).map(|((source, wavelengths), own)| {
            let media = surfaces.media_at(source.form.middle()).into_iter().filter(|body| surfaces.absorbs(*body));
            let part = if power > 0.0 { own / power } else { 0.0 };
            let prepared = Prepared { source, wavelengths, media: Media::of(media), begins, part };
            begins += part;
            prepared
        });
        let sources = sources.collect();
        PhotonTracer { surfaces, sources, power, weights, seed, most_surfaces: MOST_SURFACES }
    }

    /// The same with another limit of surfaces that a packet meets.
    pub fn with_most_surfaces(self, most_surfaces: u32) -> PhotonTracer<'a> {
        PhotonTracer { most_surfaces, ..self }
    }

    /// The power of all sources: a packet of `n` is this over `n`.
    pub fn power(&self) -> f64 {
        self.power
    }

    /// Traces the packets of these numbers; `fly` sees each straight piece of their ways, with its source.
    pub fn trace(&self, numbers: Range<u64>, mut fly: impl FnMut(&Flight, &LightSource)) -> Counts {
        let mut counts = Counts::default();
        if self.power <= 0.0 {
            return counts;
        }
        for number in numbers {
            let (photon, source, mut random) = self.emit(number);
            counts.sent += 1;
            let end = photon.follow(&self.surfaces, &mut random, self.most_surfaces, |flight| {
                counts.segments += 1;
                fly(flight, source);
            });
            match end {
                End::Absorbed => counts.absorbed += 1,
                End::Gone => counts.gone += 1,
                End::GivenUp => counts.given_up += 1,
            }
        }
        counts
    }

    /// The packet of a number at its source, and its stream of chance.
    pub fn emit(&self, number: u64) -> (Photon, &LightSource, SplitMix64) {
        let [which, u, v] = evenly(number, self.seed);
        let after = self.sources.partition_point(|source| source.begins <= which);
        let Prepared { source, wavelengths, media, begins, part } = &self.sources[after.saturating_sub(1)];
        // Which source and which wavelength are one number: what is left of the choice is uniform again.
        let unit = ((which - begins) / part).clamp(0.0, 1.0);
        let samples: [_; HEROES] = std::array::from_fn(|hero| {
            let turned = unit + hero as f64 / HEROES as f64;
            wavelengths.sample(if turned < 1.0 { turned } else { turned - 1.0 })
        });
        let power = match wavelengths.is_one_line() {
            // Of wavelengths that are one the first carries all.
            true => std::array::from_fn(|hero| if hero == 0 { samples[0].weight } else { 0.0 }),
            false => samples.map(|sample| sample.weight / HEROES as f64),
        };
        let mut random = SplitMix64::new(mix64(self.seed ^ mix64(number)));
        let ray = source.form.emit([u, v]);
        let photon = Photon {
            ray,
            starts_on: StartsOn::NOTHING,
            wavelengths_nm: samples.map(|sample| sample.nm),
            power,
            polarization: (random.next_u64() >> 63) as usize,
            way: source.form.head_start(&ray),
            media: *media,
        };
        (photon, source, random)
    }

    /// Adds the light of the packets of these numbers to a film.
    fn expose_on(&self, numbers: Range<u64>, view: &View, Exposed { film, queue }: &mut Exposed) -> Counts {
        let far = Far::of(view);
        self.trace(numbers, |flight, source| {
            let Flight { photon, distance, absorption_per_mm } = flight;
            let distance = distance.min(far.from(photon.ray.origin));
            let from = view.screen_from_table(photon.ray.origin);
            let segment = PixelSegment { from, to: view.screen_from_table(photon.ray.at(distance)) };
            match (absorption_per_mm, source.falloff) {
                (None, Falloff::Plane) => queue.splat(&segment, self.color(photon, |_| 1.0), film),
                (absorption, falloff) => film.splat_varying(&segment, |pixels| {
                    let gone = pixels * view.mm_per_px;
                    let weight = falloff.weight(photon.way + gone);
                    self.color(photon, |of| {
                        weight * absorption.map_or(1.0, |absorption| libm::exp(-absorption[of] * gone))
                    })
                }),
            }
        })
    }

    /// The colour of a packet, of whose wavelengths these parts are left.
    fn color(&self, photon: &Photon, part: impl Fn(usize) -> f64) -> [f32; 3] {
        let mut color = [0.0; 3];
        for of in 0..HEROES {
            if photon.power[of] > 0.0 {
                let weights = self.weights.at(photon.wavelengths_nm[of]);
                let power = (photon.power[of] * part(of)) as f32;
                (0..3).for_each(|channel| color[channel] += power * weights[channel]);
            }
        }
        color
    }
}

/// How far a ray has to go to be out of the picture.
struct Far {
    middle: DVec2,
    diagonal: f64,
}

impl Far {
    fn of(view: &View) -> Far {
        let size = DVec2::new(view.width as f64, view.height as f64) * view.mm_per_px;
        Far { middle: view.origin_mm + size * 0.5, diagonal: size.length() }
    }

    fn from(&self, origin: DVec2) -> f64 {
        origin.distance(self.middle) + self.diagonal
    }
}

/// A film, and the light that waits for it.
struct Exposed {
    film: SplatFilm,
    queue: SplatQueue,
}

impl Exposed {
    fn new(view: &View) -> Exposed {
        let film = SplatFilm::new(view, PACKET_BITS);
        Exposed { queue: SplatQueue::new(&film), film }
    }
}

/// A photon picture in the making.
pub struct PhotonPicture<'a> {
    tracer: PhotonTracer<'a>,
    view: View,
    /// One for each thread.
    films: Vec<Mutex<Exposed>>,
    counts: Counts,
}

impl<'a> PhotonPicture<'a> {
    /// An empty picture; `threads` films are kept.
    pub fn new(tracer: PhotonTracer<'a>, view: View) -> PhotonPicture<'a> {
        let films = (0..rayon::current_num_threads().max(1)).map(|_| Mutex::new(Exposed::new(&view))).collect();
        PhotonPicture { tracer, view, films, counts: Counts::default() }
    }

    /// Traces so many packets more.
    pub fn expose(&mut self, packets: u64) {
        let first = self.counts.sent;
        let tasks = packets.div_ceil(TASK);
        let counts = (0..tasks).into_par_iter().map(|task| {
            let from = first + task * TASK;
            let to = (from + TASK).min(first + packets);
            let own = rayon::current_thread_index().unwrap_or(0) % self.films.len();
            // A poisoned film would be that of a panic, which ends all.
            let mut film = self.films[own].lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            self.tracer.expose_on(from..to, &self.view, &mut film)
        });
        let counts = counts.reduce(Counts::default, |mut sum, more| {
            sum += more;
            sum
        });
        self.films.par_iter_mut().for_each(|exposed| {
            let Exposed { film, queue } = exposed.get_mut().unwrap_or_else(std::sync::PoisonError::into_inner);
            queue.flush(film);
        });
        self.counts += counts;
        // A scene without power sends none, and yet they are done.
        self.counts.sent = first + packets;
    }

    /// How the packets have ended so far.
    pub fn counts(&self) -> &Counts {
        &self.counts
    }

    /// The fluence in each pixel, row by row, signed.
    pub fn fluence(&self) -> Vec<[f64; 3]> {
        let mut sum = SplatFilm::new(&self.view, PACKET_BITS);
        for film in &self.films {
            sum.add(&film.lock().unwrap_or_else(std::sync::PoisonError::into_inner).film);
        }
        let scale = self.tracer.power / (self.counts.sent.max(1) as f64 * self.view.mm_per_px);
        let (width, height) = (sum.width(), sum.height());
        (0..width * height).map(|at| sum.pixel(at % width, at / width, scale)).collect()
    }
}

/// The place of a number in a sequence that fills the unit cube evenly: an additive recurrence with the generalized golden ratio
/// (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), turned by the seed.
pub(super) fn evenly(number: u64, seed: u64) -> [f64; 3] {
    // 2^64 over g, g^2, g^3 with g^4 = g + 1.
    const STEPS: [u64; 3] = [0xd1b5_4a32_d192_ed03, 0xabc9_8388_fb8f_ac03, 0x8cb9_2ba7_2f3d_8dd7];
    std::array::from_fn(|axis| {
        let shift = mix64(seed.wrapping_mul(3).wrapping_add(axis as u64 + 1));
        geometry::rng::unit_from_bits(number.wrapping_mul(STEPS[axis]).wrapping_add(shift))
    })
}
