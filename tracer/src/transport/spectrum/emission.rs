//! What lamps emit: their power by wavelength, and wavelengths drawn in proportion to what is seen of it.

use super::{LONGEST_NM, SHORTEST_NM, emission_of_rgb, xyz};
use libm::expm1;

/// The spectrum of a lamp.
#[derive(Clone, Debug, PartialEq)]
pub enum Emission {
    /// Equal power at every wavelength.
    EqualEnergy,
    /// A black body: M. Planck, 1900.
    Blackbody {
        /// Its temperature, K.
        kelvin: f64,
    },
    /// A smooth spectrum of this linear sRGB colour.
    Color([f64; 3]),
    /// A gas's lines.
    Gas(Gas),
    /// One wavelength, nm: a laser.
    Line(f64),
}

/// A gas whose lines are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gas {
    /// Hydrogen: the Balmer lines.
    Hydrogen,
    /// Helium.
    Helium,
    /// Neon: red and orange.
    Neon,
    /// Sodium: the yellow pair.
    Sodium,
    /// Mercury at low pressure.
    Mercury,
}

/// A line: its wavelength, nm, and its part of the lamp's power, before they are brought to 1 in all.
pub type GasLine = (f64, f64);

impl Gas {
    /// All gases, by name.
    pub const NAMED: [(&'static str, Gas); 5] = [
        ("hydrogen", Gas::Hydrogen),
        ("helium", Gas::Helium),
        ("neon", Gas::Neon),
        ("sodium", Gas::Sodium),
        ("mercury", Gas::Mercury),
    ];

    /// Its lines. Wavelengths are those of the NIST Atomic Spectra Database; powers are rounded ones of discharge tubes.
    pub fn lines(self) -> &'static [GasLine] {
        match self {
            Gas::Hydrogen => &[(410.17, 0.06), (434.05, 0.12), (486.13, 0.32), (656.28, 1.0)],
            Gas::Helium => &[
                (388.86, 0.3),
                (447.15, 0.25),
                (471.31, 0.05),
                (492.19, 0.08),
                (501.57, 0.2),
                (587.56, 1.0),
                (667.82, 0.4),
                (706.52, 0.25),
            ],
            Gas::Neon => &[
                (540.06, 0.06),
                (585.25, 0.7),
                (588.19, 0.3),
                (594.48, 0.4),
                (607.43, 0.4),
                (609.62, 0.5),
                (614.31, 0.8),
                (616.36, 0.3),
                (621.73, 0.25),
                (626.65, 0.5),
                (633.44, 0.6),
                (638.30, 0.7),
                (640.22, 1.0),
                (650.65, 0.7),
                (659.90, 0.4),
                (667.83, 0.4),
                (692.95, 0.4),
                (703.24, 0.7),
            ],
            Gas::Sodium => &[(588.995, 1.0), (589.592, 0.5)],
            Gas::Mercury => &[(404.66, 0.45), (435.83, 1.0), (546.07, 0.95), (576.96, 0.12), (579.07, 0.12)],
        }
    }
}

/// The second radiation constant hc/k, nm K.
const PLANCK_NM_K: f64 = 1.438_776_877e7;

impl Emission {
    /// The power at a wavelength in any unit; lines have none between them.
    pub fn power(&self, wavelength_nm: f64) -> f64 {
        match self {
            Emission::EqualEnergy => 1.0,
            Emission::Blackbody { kelvin } => {
                let of = |nm: f64| (560.0 / nm).powi(5) / expm1(PLANCK_NM_K / (nm * kelvin));
                of(wavelength_nm) / of(560.0)
            }
            Emission::Color(color) => emission_of_rgb(*color, wavelength_nm),
            Emission::Gas(_) | Emission::Line(_) => 0.0,
        }
    }

    fn lines(&self) -> Option<Vec<GasLine>> {
        match self {
            Emission::Gas(gas) => Some(gas.lines().to_vec()),
            Emission::Line(nm) => Some(vec![(*nm, 1.0)]),
            _ => None,
        }
    }
}

/// How much a wavelength matters to an eye: nothing that has power is left out.
fn importance(wavelength_nm: f64) -> f64 {
    let [x, y, z] = xyz(wavelength_nm);
    0.08 + 0.3 * x.max(0.0) + 0.6 * y + 0.3 * z
}

/// A wavelength that was drawn, and how much more power lies there than draws fall there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WavelengthSample {
    /// The wavelength, nm.
    pub nm: f64,
    /// The part of the lamp's power that one draw stands for, times the number of draws: its mean over all draws is 1.
    pub weight: f64,
}

/// Draws of a stratum.
const STRATUM_DRAWS: u32 = 16;

/// A range of wavelengths.
#[derive(Clone, Debug, PartialEq)]
pub struct WavelengthStratum {
    /// From and to, nm.
    pub nm: [f64; 2],
    /// Wavelengths within it; their weights are parts of the lamp's power.
    pub samples: Vec<WavelengthSample>,
}

/// Parts of the way from 0 to 1 whose cells are known.
const GUIDES: u32 = 512;

/// Draws wavelengths of a lamp in proportion to power times importance.
#[derive(Clone, Debug, PartialEq)]
pub struct WavelengthSampler {
    /// Where cell i begins on the way from 0 to 1.
    begins: Vec<f64>,
    /// For each cell: the wavelength at which it begins and ends, nm, and the weight of its draws.
    cells: Vec<([f64; 2], f64)>,
    /// The cell in which each of [`GUIDES`] equal parts of that way begins (H.-C. Chen and Y. Asau, 1974).
    guide: Vec<u32>,
    /// The mean power over all wavelengths, relative to equal energy; 1 for lines.
    mean: f64,
}

impl WavelengthSampler {
    /// The sampler of a spectrum.
    pub fn new(emission: &Emission) -> WavelengthSampler {
        let cells: Vec<([f64; 2], f64)> = match emission.lines() {
            Some(lines) => lines.into_iter().map(|(nm, power)| ([nm; 2], power)).collect(),
            None => {
                let steps = (LONGEST_NM - SHORTEST_NM) as usize;
                let cell = |step: usize| {
                    let nm = SHORTEST_NM + step as f64;
                    ([nm, nm + 1.0], emission.power(nm + 0.5))
                };
                (0..steps).map(cell).collect()
            }
        };
        let power: f64 = cells.iter().map(|(_, power)| power).sum();
        let mean = if emission.lines().is_some() { 1.0 } else { power / cells.len() as f64 };
        let middle = |ends: &[f64; 2]| 0.5 * (ends[0] + ends[1]);
        let drawn = |(ends, power): &([f64; 2], f64)| power * importance(middle(ends));
        let all: f64 = cells.iter().map(drawn).sum();
        let mut begins = Vec::with_capacity(cells.len());
        let mut sum = 0.0;
        for cell in &cells {
            begins.push(sum / all);
            sum += drawn(cell);
        }
        let weight = |ends: &[f64; 2]| all / (power * importance(middle(ends)));
        let cells = cells.iter().map(|(ends, _)| (*ends, weight(ends))).collect();
        let cell_at = |unit: f64| begins.partition_point(|begin| *begin <= unit).saturating_sub(1) as u32;
        let guide = (0..GUIDES).map(|part| cell_at(f64::from(part) / f64::from(GUIDES))).collect();
        WavelengthSampler { begins, cells, guide, mean }
    }

    /// The wavelength at `unit`, from 0 to 1.
    pub fn sample(&self, unit: f64) -> WavelengthSample {
        let end_of = |cell: usize| self.begins.get(cell + 1).copied().unwrap_or(1.0);
        let mut cell = self.guide[((unit * f64::from(GUIDES)) as usize).min(self.guide.len() - 1)] as usize;
        while cell + 1 < self.begins.len() && end_of(cell) <= unit {
            cell += 1;
        }
        let (begin, end) = (self.begins[cell], end_of(cell));
        let part = if end > begin { (unit - begin) / (end - begin) } else { 0.0 };
        let ([from, to], weight) = self.cells[cell];
        WavelengthSample { nm: from + (to - from) * part, weight }
    }

    /// All wavelengths in `count` strata that are equally likely to be drawn; of lines one stratum each.
    pub fn strata(&self, count: u32) -> Vec<WavelengthStratum> {
        let is_lines = self.cells.iter().all(|([from, to], _)| from == to);
        if is_lines {
            let end = |cell: usize| self.begins.get(cell + 1).copied().unwrap_or(1.0);
            let line = |(cell, (nm, weight)): (usize, &([f64; 2], f64))| {
                let part = weight * (end(cell) - self.begins[cell]);
                WavelengthStratum { nm: *nm, samples: vec![WavelengthSample { nm: nm[0], weight: part }] }
            };
            return self.cells.iter().enumerate().map(line).collect();
        }
        let stratum = |number: u32| {
            let edge = |number: u32| f64::from(number) / f64::from(count);
            let samples = (0..STRATUM_DRAWS).map(|draw| {
                let place = (f64::from(draw) + 0.5) / f64::from(STRATUM_DRAWS);
                let WavelengthSample { nm, weight } = self.sample(edge(number) + place / f64::from(count));
                WavelengthSample { nm, weight: weight / f64::from(STRATUM_DRAWS * count) }
            });
            // The last edge is the end of the last cell, where a draw would be the next one's.
            let nm = [edge(number), edge(number + 1) - 1e-12].map(|unit| self.sample(unit).nm);
            WavelengthStratum { nm, samples: samples.collect() }
        };
        (0..count.max(1)).map(stratum).collect()
    }

    /// Whether all draws are one wavelength.
    pub fn is_one_line(&self) -> bool {
        matches!(self.cells[..], [([from, to], _)] if from == to)
    }

    /// The lamp's mean power over all wavelengths, relative to equal energy: a dark colour has less. 1 for lines.
    pub fn mean(&self) -> f64 {
        self.mean
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transport::spectrum::Weights;

    fn color_of(emission: &Emission) -> [f64; 3] {
        let (sampler, weights) = (WavelengthSampler::new(emission), Weights::equal_energy());
        let mut sum = [0.0; 3];
        for draw in 0..20_000 {
            let sample = sampler.sample((f64::from(draw) + 0.5) / 20_000.0);
            let at = weights.at(sample.nm);
            (0..3).for_each(|channel| sum[channel] += sample.weight * f64::from(at[channel]) / 20_000.0);
        }
        sum
    }

    #[test]
    fn draws_give_back_the_colour_of_the_lamp() {
        for (emission, expected) in
            [(Emission::EqualEnergy, [1.0, 1.0, 1.0]), (Emission::Color([1.0, 0.5, 0.25]), [1.0, 0.5, 0.25])]
        {
            let sampler = WavelengthSampler::new(&emission);
            let color = color_of(&emission).map(|channel| channel * sampler.mean());
            assert!(color.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-3), "{color:?}");
        }
    }

    /// The guide's way to a cell is that of a search through all of them.
    #[test]
    fn a_draw_is_in_the_last_cell_that_begins_before_it() {
        for emission in
            [Emission::EqualEnergy, Emission::Gas(Gas::Neon), Emission::Line(550.0), Emission::Color([1.0, 0.0, 0.0])]
        {
            let sampler = WavelengthSampler::new(&emission);
            let exact = sampler.begins.iter().copied();
            for unit in (0..20_000).map(|draw| f64::from(draw) / 20_000.0).chain(exact.filter(|begin| *begin < 1.0)) {
                let cell = sampler.begins.iter().rposition(|begin| *begin <= unit).expect("the first begins at 0");
                let ([from, to], weight) = sampler.cells[cell];
                let sample = sampler.sample(unit);
                assert!((from..=to).contains(&sample.nm) && sample.weight == weight, "{emission:?} {unit}");
            }
        }
    }

    /// Wien: b / T = 2.8978e6 nm K / T; and a warm body is redder than a hot one.
    #[test]
    fn a_black_body_shines_brightest_where_wien_says() {
        let body = Emission::Blackbody { kelvin: 5000.0 };
        let top =
            (3800..7800).max_by(|a, b| body.power(f64::from(*a) * 0.1).total_cmp(&body.power(f64::from(*b) * 0.1)));
        assert!((f64::from(top.unwrap()) * 0.1 - 579.55).abs() < 0.1);
        let [red, _, blue] = color_of(&Emission::Blackbody { kelvin: 2700.0 });
        let [hot_red, _, hot_blue] = color_of(&Emission::Blackbody { kelvin: 9000.0 });
        assert!(red > 2.5 * blue && hot_red < hot_blue);
    }

    #[test]
    fn neon_is_red_sodium_yellow_and_mercury_blue_green() {
        let neon = color_of(&Emission::Gas(Gas::Neon));
        assert!(neon[0] > 3.0 * neon[1].abs() && neon[2].abs() < 0.1 * neon[0], "{neon:?}");
        let sodium = color_of(&Emission::Gas(Gas::Sodium));
        assert!(sodium[0] > sodium[1] && sodium[1] > 0.2 * sodium[0] && sodium[2] < 0.0, "{sodium:?}");
        let mercury = color_of(&Emission::Gas(Gas::Mercury));
        assert!(mercury[2] > mercury[0] && mercury[1] > mercury[0], "{mercury:?}");
        for (_, gas) in Gas::NAMED {
            assert!(gas.lines().iter().all(|(nm, _)| (SHORTEST_NM..LONGEST_NM).contains(nm)));
        }
    }

    /// Each draw's weight is power over density: their mean is 1, so no power is lost or made.
    #[test]
    fn the_mean_weight_is_one() {
        for emission in [Emission::EqualEnergy, Emission::Blackbody { kelvin: 3000.0 }, Emission::Gas(Gas::Helium)] {
            let sampler = WavelengthSampler::new(&emission);
            let weights = (0..10_000).map(|draw| sampler.sample((f64::from(draw) + 0.5) / 10_000.0).weight);
            let mean = weights.sum::<f64>() / 10_000.0;
            assert!((mean - 1.0).abs() < 1e-3, "{mean}");
        }
    }
}
