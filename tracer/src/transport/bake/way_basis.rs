//! The ways that light has come, in a few numbers.
//!
//! On a table light fades with its whole way: `w(W + d)` for light that has come the way W to a wall and goes d further. W is
//! another for every packet; interpolated between a few ways T, `w(W + d) = sum c_k(W) w(T_k + d)`, a wall's light is one
//! number for each T. The ways are evenly spaced in `ln(1 + W / softness)`, where falloffs are smooth, and the interpolation is
//! Lagrange's through the nearest four.

use crate::transport::Falloff;

/// How many ways there are.
pub(super) const WAYS: usize = 12;

/// Ways between which one lies.
pub(super) const NEAREST: usize = 4;

/// The ways of one lamp's light.
#[derive(Clone, Debug)]
pub(super) struct WayBasis {
    falloff: Falloff,
    /// T, mm; in the plane, where ways do not matter, one.
    ways: Vec<f64>,
    /// mm.
    softness: f64,
    /// From one way to the next, in the logarithm.
    step: f64,
}

/// The softness over the lamp's height: the falloff's own scale is the height, and its top, where light has hardly come any way,
/// is round.
const SOFTNESS: f64 = 0.5;

/// The softness over the reach at least.
const LEAST_SOFTNESS: f64 = 0.02;

impl WayBasis {
    pub(super) fn new(falloff: Falloff) -> WayBasis {
        let Falloff::Table { height_mm, reach_mm } = falloff else {
            return WayBasis { falloff, ways: vec![0.0], softness: 1.0, step: 1.0 };
        };
        let softness = (SOFTNESS * height_mm.abs()).max(LEAST_SOFTNESS * reach_mm);
        let step = libm::log1p(reach_mm / softness) / (WAYS - 1) as f64;
        let ways = (0..WAYS).map(|number| softness * libm::expm1(step * number as f64)).collect();
        WayBasis { falloff, ways, softness, step }
    }

    /// How many ways it has.
    pub(super) fn count(&self) -> usize {
        self.ways.len()
    }

    /// Whether light that has come so far is still there.
    pub(super) fn reaches(&self, way: f64) -> bool {
        match self.falloff {
            Falloff::Plane => true,
            Falloff::Table { reach_mm, .. } => way < reach_mm,
        }
    }

    /// The part of a way in the nearest of the ways: the first one's number, and the parts.
    pub(super) fn parts(&self, way: f64) -> (usize, [f64; NEAREST]) {
        if self.count() == 1 {
            return (0, [1.0, 0.0, 0.0, 0.0]);
        }
        let place = libm::log1p(way.max(0.0) / self.softness) / self.step;
        let first = (place as usize).saturating_sub(1).min(WAYS - NEAREST);
        let x = place - first as f64;
        let parts = std::array::from_fn(|own| {
            let others = (0..NEAREST).filter(|other| *other != own);
            others.map(|other| (x - other as f64) / (own as f64 - other as f64)).product()
        });
        (first, parts)
    }

    /// What light of each way weighs after it has gone `distance` further.
    fn weight(&self, number: usize, distance: f64) -> f64 {
        self.falloff.weight(self.ways[number] + distance)
    }
}

/// The weights of all ways by distance, ready to be looked up; between two distances they are interpolated.
#[derive(Clone, Debug)]
pub(super) struct WayWeights {
    /// For each millimetre of distance.
    rows_per_mm: f64,
    rows: Vec<[f32; WAYS]>,
}

/// Distances at which weights are known, for each reach.
const ROWS: usize = 2048;

impl WayWeights {
    pub(super) fn new(basis: &WayBasis) -> WayWeights {
        let row = |distance: f64| {
            std::array::from_fn(|way| if way < basis.count() { basis.weight(way, distance) as f32 } else { 0.0 })
        };
        match basis.falloff {
            Falloff::Plane => WayWeights { rows_per_mm: 0.0, rows: vec![row(0.0); 2] },
            Falloff::Table { reach_mm, .. } => {
                let rows_per_mm = ROWS as f64 / reach_mm;
                // The last two rows are beyond the reach: nothing.
                let rows = (0..ROWS + 2).map(|number| row(number as f64 / rows_per_mm)).collect();
                WayWeights { rows_per_mm, rows }
            }
        }
    }

    /// The weight of each way after `distance` more.
    pub(super) fn at(&self, distance: f64) -> [f32; WAYS] {
        let place = (distance * self.rows_per_mm).min((self.rows.len() - 2) as f64);
        let number = place as usize;
        let part = (place - number as f64) as f32;
        let (a, b) = (&self.rows[number], &self.rows[number + 1]);
        std::array::from_fn(|way| a[way] + (b[way] - a[way]) * part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For the tables' lamps, over all ways: within a hundredth of the weight where the lamp is brightest, and of all light within
    /// seven thousandths.
    #[test]
    fn weights_of_all_ways_are_found_between_a_few() {
        for (height_mm, reach_mm) in [(30.0, 1000.0), (30.0, 280.0), (24.0, 380.0), (60.0, 500.0)] {
            let falloff = Falloff::Table { height_mm, reach_mm };
            let basis = WayBasis::new(falloff);
            let weights = WayWeights::new(&basis);
            let brightest = falloff.weight(height_mm);
            let (mut most, mut sum, mut all) = (0.0_f64, 0.0, 0.0);
            for way in (0..1000).map(|step| (f64::from(step) + 0.5) * 1e-3 * reach_mm) {
                let (first, parts) = basis.parts(way);
                for distance in (0..100).map(|step| f64::from(step) * 0.01 * reach_mm) {
                    let weights = weights.at(distance);
                    let found: f64 = (0..NEAREST).map(|at| parts[at] * f64::from(weights[first + at])).sum();
                    let weight = falloff.weight(way + distance);
                    let off = (found - weight).abs();
                    (most, sum, all) = (most.max(off / brightest), sum + off, all + weight);
                }
            }
            assert!(most < 0.01 && sum / all < 0.007, "{height_mm} {reach_mm}: {most} {}", sum / all);
        }
    }
}
