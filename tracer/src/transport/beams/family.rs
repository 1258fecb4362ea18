//! A source's rays as a family over u and v.

use crate::transport::spectrum::{WavelengthSample, WavelengthSampler, Weights};
use crate::transport::{LightSource, SourceForm};
use geometry::{Ray, trig};
use std::f64::consts::TAU;

/// What v is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Across {
    /// The place on the source, or the angle: the wavelength is that of the stratum's middle.
    Source,
    /// The wavelength within the stratum.
    Wavelength,
    /// Nothing: all of the stratum's rays are one.
    Nothing,
}

/// Part of a source's light: one stratum of its wavelengths and one of what makes it wide.
#[derive(Clone, Copy, Debug)]
pub struct Family<'a> {
    pub source: &'a LightSource,
    /// The wavelengths, nm, from and to.
    pub nm: [f64; 2],
    /// v, from and to.
    pub v: [f64; 2],
    pub across: Across,
    /// The colour of all of its light, if nothing is in the way: power times weight.
    pub color: [f64; 3],
    /// What of its light it lays.
    pub lays: Lays,
}

/// What of a family's light is laid. Before the first surface all wavelengths go the same way: where they part later, one family of
/// their sum has that light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lays {
    All,
    BeforeSurfaces,
    BehindSurfaces,
}

impl Family<'_> {
    /// The ray at u and v, 0 to 1 over the stratum, and its wavelength.
    pub fn ray(&self, u: f64, v: f64) -> (Ray, f64) {
        let middle_nm = 0.5 * (self.nm[0] + self.nm[1]);
        let within = |[from, to]: [f64; 2]| from + (to - from) * v;
        match self.across {
            Across::Source => (self.source.form.family(u, within(self.v)), middle_nm),
            Across::Wavelength => (self.source.form.family(u, 0.5), within(self.nm)),
            Across::Nothing => (self.source.form.family(u, 0.5), middle_nm),
        }
    }
}

/// The rim of a disc, seen along a beam that leaves it: its rays begin so far before the line between the two outer ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bulge {
    pub radius: f64,
    /// From where to where the beam lies across the disc: -1 to 1 is all of it.
    pub across: [f64; 2],
}

impl Bulge {
    /// How far before the disc's middle its rim is, where `part` of the beam is on one side.
    pub fn height(&self, part: f64) -> f64 {
        let across = self.across[0] + (self.across[1] - self.across[0]) * part;
        self.radius * (1.0 - across * across).max(0.0).sqrt()
    }

    /// The part at which that is farthest.
    pub fn foremost(&self) -> f64 {
        let [low, high] = self.across;
        if high > low { (-low / (high - low)).clamp(0.0, 1.0) } else { 0.0 }
    }
}

impl Family<'_> {
    /// The source's own form where beams of this v leave it, if their ends are not on a line.
    pub fn bulge(&self, v: [f64; 2]) -> Option<Bulge> {
        let SourceForm::Disc { radius, .. } = self.source.form else { return None };
        let across = v.map(|v| 2.0 * (self.v[0] + (self.v[1] - self.v[0]) * v) - 1.0);
        Some(Bulge { radius, across })
    }
}

impl SourceForm {
    /// The ray at u and v, 0 to 1: equal areas of u and v have equal power.
    fn family(&self, u: f64, v: f64) -> Ray {
        match *self {
            // A matt rim is as bright in each direction over its whole width: v is the place across.
            SourceForm::Disc { center, radius } => {
                let direction = trig::direction(TAU * u);
                let across = 2.0 * v - 1.0;
                let along = (1.0 - across * across).max(0.0).sqrt();
                Ray { origin: center + (direction * along + direction.perp() * across) * radius, direction }
            }
            _ => self.emit([u, v]),
        }
    }

    /// Whether v matters.
    fn is_wide(&self) -> bool {
        match *self {
            SourceForm::Disc { .. } | SourceForm::Tube(_) => true,
            SourceForm::Beam { half_angle, .. } => half_angle > 0.0,
            SourceForm::Point(_) | SourceForm::Cone { .. } => false,
        }
    }
}

/// The families of a source: strata of its wavelengths if they matter, and of its width. `parts_later`: all wavelengths go the same
/// way up to the first surface.
pub fn families<'a>(
    source: &'a LightSource,
    weights: &Weights,
    chromatic: bool,
    [wavelengths, widths]: [u32; 2],
    parts_later: bool,
) -> Vec<Family<'a>> {
    let wide = source.form.is_wide();
    let count = if wide { widths.max(1) } else { 1 };
    let strata = |(nm, color): ([f64; 2], [f64; 3]), lays: Lays| {
        let across = match (wide, nm[0] == nm[1]) {
            (true, _) => Across::Source,
            (false, false) => Across::Wavelength,
            (false, true) => Across::Nothing,
        };
        let color = color.map(|channel| channel / f64::from(count));
        (0..count).map(move |stratum| {
            let v = [stratum, stratum + 1].map(|edge| f64::from(edge) / f64::from(count));
            Family { source, nm, v, across, color, lays }
        })
    };
    let spectral = spectral(source, weights, wavelengths.max(if chromatic { 1 } else { 64 }));
    let sum = spectral.iter().fold([0.0; 3], |sum, (_, color)| [0, 1, 2].map(|channel| sum[channel] + color[channel]));
    let whole = ([550.0; 2], sum);
    if !chromatic {
        return strata(whole, Lays::All).collect();
    }
    let is_shared = parts_later && spectral.len() > 1;
    let behind = if is_shared { Lays::BehindSurfaces } else { Lays::All };
    let before = if is_shared { strata(whole, Lays::BeforeSurfaces).collect() } else { Vec::new() };
    before.into_iter().chain(spectral.into_iter().flat_map(|one| strata(one, behind))).collect()
}

/// Strata of a source's wavelengths, nm, each with the colour of its power.
fn spectral(source: &LightSource, weights: &Weights, wavelengths: u32) -> Vec<([f64; 2], [f64; 3])> {
    let sampler = WavelengthSampler::new(&source.emission);
    let power = source.power * sampler.mean();
    let color = |samples: &[WavelengthSample]| {
        samples.iter().fold([0.0; 3], |sum: [f64; 3], sample| {
            let weights = weights.at(sample.nm);
            [0, 1, 2].map(|channel| sum[channel] + f64::from(weights[channel]) * sample.weight * power)
        })
    };
    sampler.strata(wavelengths).iter().map(|one| (one.nm, color(&one.samples))).collect()
}
