//! Weighted sums: a tile in the light of all lamps, from its layers, which are kept in whole numbers.
//!
//! Light is linear, so the tile under all lamps is the sum of the layers of each, times the lamps' colours. A
//! lamp that flashes is a factor here and nothing else. Of bare floor, what arrives is kept in one plane, since all
//! lamps meet the same paint; of anything else, three planes of colours. Numbers are kept in 32,767 steps up to the
//! plane's largest, and what they are multiplied by in 65,535 steps of all such factors together: an error of 1.5e-5 of
//! a lamp's largest value, and of at most 0.8e-5 of all lamps' for each of them. This module refuses to know what made
//! the light.

use crate::Rgb;
use crate::cache::packed_planes::{Baseline, MAX_TOTAL_WEIGHT, Madd, PLANE_MAX, ROWS_AT_ONCE, Sums, WeightedPlanes};
#[cfg(target_arch = "x86_64")]
use crate::cache::packed_planes::{Middle, Wide};
use crate::simd::dispatch::{InstructionSet, LANES, SimdLevel, max, multiversion};
use crate::tile::planes::{AlbedoTile, Plane, RgbTile, TILE};

/// Less light than this is none.
pub(crate) const MIN_LIGHT: f32 = 1e-20;

/// The step that planes, finite, 0 or more, are to be kept in; 0 if all is dark.
pub(crate) fn quantization_step(simd: SimdLevel, planes: &[Plane]) -> f32 {
    let mut largest = 0.0;
    find_largest(simd, planes, &mut largest);
    if largest < MIN_LIGHT { 0.0 } else { largest * (1.0 / PLANE_MAX) }
}

multiversion! {
    fn find_largest(planes: &[Plane], largest: &mut f32) = largest_lanes;
}

#[inline(always)]
fn largest_lanes(planes: &[Plane], largest: &mut f32) {
    let mut most = [0.0; LANES];
    for line in planes.as_flattened() {
        for i in 0..LANES {
            most[i] = max(line[i], most[i]);
        }
    }
    *largest = most.iter().fold(0.0, |a, &b| max(a, b));
}

/// Factors in whole numbers: how many steps each is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quantizer {
    per_unit: Rgb,
    /// The size of a step.
    pub step: Rgb,
}

impl Quantizer {
    /// Such that each of some factors, 0 or more, is at most [`PLANE_MAX`], and all together at most [`MAX_TOTAL_WEIGHT`]. They do
    /// not depend on the order.
    pub fn of(factors: impl Iterator<Item = Rgb> + Clone) -> Quantizer {
        let (mut most, mut count) = ([0.0; 3], 0);
        for factor in factors.clone() {
            most = [0, 1, 2].map(|channel: usize| max(factor[channel], most[channel]));
            count += 1;
        }
        let per_unit = most.map(|most| if most < MIN_LIGHT { 0.0 } else { PLANE_MAX / most });
        let mut steps = Quantizer { per_unit, step: [0.0; 3] };
        let mut total = [0; 3];
        for quantize in factors.map(|factor| steps.quantize(factor)) {
            total = [0, 1, 2].map(|channel: usize| total[channel] + quantize[channel]);
        }
        // Room for every one of them to be rounded up, twice.
        let room = MAX_TOTAL_WEIGHT.saturating_sub(count) as f32;
        for channel in 0..3 {
            let per_unit = &mut steps.per_unit[channel];
            *per_unit *= room / max(total[channel] as f32, room);
            steps.step[channel] = if *per_unit > 0.0 { 1.0 / *per_unit } else { 0.0 };
        }
        steps
    }

    /// A factor in steps.
    pub fn quantize(&self, factor: Rgb) -> [u32; 3] {
        [0, 1, 2].map(|channel: usize| (factor[channel] * self.per_unit[channel] + 0.5) as u32)
    }
}

/// What a tile is put together of, all in the same steps.
#[derive(Clone, Copy)]
pub(crate) struct WeightedSum<'a> {
    /// What arrives at the floor.
    pub irradiance: WeightedPlanes<'a, 1>,
    /// What shines there.
    pub specular: WeightedPlanes<'a, 1>,
    /// What is kept in colours.
    pub rgb: WeightedPlanes<'a, 3>,
    /// The size of a step of the sums.
    pub step: Rgb,
    /// Light that arrives everywhere at the floor.
    pub ambient: Rgb,
}

impl WeightedSum<'_> {
    /// Darkness.
    pub const NOTHING: WeightedSum<'static> = WeightedSum {
        irradiance: WeightedPlanes { planes: &[], weights: &[] },
        specular: WeightedPlanes { planes: &[], weights: &[] },
        rgb: WeightedPlanes { planes: &[], weights: &[] },
        step: [0.0; 3],
        ambient: [0.0; 3],
    };
}

/// Puts a tile together on floor of this paint, in `out`; `onto` what is there already, or in its place.
pub(crate) fn evaluate(simd: SimdLevel, sum: &WeightedSum, albedo: &AlbedoTile, onto: bool, out: &mut RgbTile) {
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn avx2(sum: &WeightedSum, albedo: &AlbedoTile, onto: bool, out: &mut RgbTile) {
        sum_lanes::<Middle>(sum, albedo, onto, out);
    }
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
    fn avx512(sum: &WeightedSum, albedo: &AlbedoTile, onto: bool, out: &mut RgbTile) {
        sum_lanes::<Wide>(sum, albedo, onto, out);
    }
    match simd.set() {
        InstructionSet::Baseline => sum_lanes::<Baseline>(sum, albedo, onto, out),
        // SAFETY: a `SimdLevel` of this set exists only where the machine was found to have it.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx2 => unsafe { avx2(sum, albedo, onto, out) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx512 => unsafe { avx512(sum, albedo, onto, out) },
    }
}

#[inline(always)]
fn sum_lanes<M: Madd>(sum: &WeightedSum, albedo: &AlbedoTile, onto: bool, out: &mut RgbTile) {
    let on_floor = !sum.irradiance.planes.is_empty() || sum.ambient != [0.0; 3];
    for row in (0..TILE).step_by(ROWS_AT_ONCE) {
        let mut sums: Sums = [[[0; LANES]; ROWS_AT_ONCE]; 3];
        sum.specular.add::<M>(row, &mut sums);
        sum.rgb.add::<M>(row, &mut sums);
        for channel in 0..3 {
            for (line, sums) in out[channel][row..row + ROWS_AT_ONCE].iter_mut().zip(&sums[channel]) {
                for i in 0..LANES {
                    let light = sums[i] as f32 * sum.step[channel];
                    line[i] = if onto { line[i] + light } else { light };
                }
            }
        }
        if !on_floor {
            continue;
        }
        let mut sums: Sums = [[[0; LANES]; ROWS_AT_ONCE]; 3];
        sum.irradiance.add::<M>(row, &mut sums);
        for channel in 0..3 {
            let (step, ambient) = (sum.step[channel], sum.ambient[channel]);
            let albedo = &albedo[channel].as_chunks::<LANES>().0[row..row + ROWS_AT_ONCE];
            for ((line, albedo), sums) in
                out[channel][row..row + ROWS_AT_ONCE].iter_mut().zip(albedo).zip(&sums[channel])
            {
                for i in 0..LANES {
                    let light = ambient + sums[i] as f32 * step;
                    line[i] += f32::from(albedo[i]) * (1.0 / 65_535.0) * light;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::rng::SplitMix64;

    /// However many factors there are and however different, none is too large, nor are all together, and each is
    /// within a step; in another order they are the same.
    #[test]
    fn factors_fit_into_their_steps() {
        let mut random = SplitMix64::new(3);
        for count in (1..40).chain([400, 1_500]) {
            let most = if count % 2 == 0 { 10.0 } else { -29.5 };
            let mut factor = || [(); 3].map(|()| libm::exp2(random.uniform(-30.0, most)) as f32);
            let mut factors: Vec<Rgb> = (0..count).map(|_| factor()).collect();
            let steps = Quantizer::of(factors.iter().copied());
            let mut total = [0; 3];
            for factor in &factors {
                let quantize = steps.quantize(*factor);
                for channel in 0..3 {
                    let off = quantize[channel] as f32 * steps.step[channel] - factor[channel];
                    assert!(off.abs() <= 0.501 * steps.step[channel], "{off} off, {count} factors");
                    assert!(quantize[channel] <= PLANE_MAX as u32, "{quantize:?}");
                    total[channel] += quantize[channel];
                }
            }
            assert!(total.iter().all(|&total| total <= MAX_TOTAL_WEIGHT), "{total:?} of {count}");
            factors.reverse();
            let again = Quantizer::of(factors.iter().copied());
            assert!(again.per_unit == steps.per_unit && again.step == steps.step);
        }
    }
}
