//! What a tile shows in the light of one lamp alone: small pictures, kept in 16 bits a number.
//!
//! Light is linear, so the picture under all lamps is the sum of the pictures under each, times the lamps' colours. A
//! lamp that flashes is a factor here and nothing else. Of bare floor, what arrives is kept in one plane, since all
//! lamps meet the same paint; of anything else, three planes of colours. Numbers are kept as square roots, in 65,535
//! steps up to the plane's largest: an error of 1.6e-5 of a bright value, and less of a dark one. This module refuses
//! to know what made the light.

use crate::Rgb;
use crate::irradiance::Light;
use crate::lanes::{LANES, Lanes, Path, clones, max, ones, rounded};
use crate::penumbra::Rows;
use crate::points::{AREA, Plane, TILE};

/// What a tile's floor reflects: red, green, blue, in 65,535ths.
pub(crate) type Paint = [[u16; AREA]; 3];

/// Rows of a tile that are summed up in registers.
const ROWS: usize = 4;

/// The same where a plane gives all three channels.
const GRAY_ROWS: usize = 2;

/// Parts that are summed up together.
const BATCH: usize = 8;

/// The steps from dark to a plane's largest number.
pub(crate) const STEPS: f32 = 65_535.0;

/// Less light than this is none: squares of roots so small would lose their digits.
pub(crate) const FAINTEST: f32 = 1e-20;

/// A plane of a tile, row by row, as square roots.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Texels(pub [u16; AREA]);

/// Darkness.
pub(crate) static DARK: Texels = Texels([0; AREA]);

impl Texels {
    /// Whether all of it is dark.
    pub fn is_dark(&self) -> bool {
        self.0.iter().fold(0, |all, texel| all | texel) == 0
    }
}

/// Planes, with what their squares are to be multiplied by.
pub(crate) struct Part<'a, T: ?Sized> {
    /// One plane, or three.
    pub texels: &'a T,
    /// The light's colour, times the planes' own factor.
    pub gain: Rgb,
}

impl<T: ?Sized> Copy for Part<'_, T> {}

impl<T: ?Sized> Clone for Part<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

/// What squares of texels are to be multiplied by if these planes, finite, 0 or more, are kept; 0 if all is dark.
pub(crate) fn scale_of(path: Path, planes: &[Plane]) -> f32 {
    let mut largest = 0.0;
    find_largest(path, planes, &mut largest);
    let per_step = largest.sqrt() / STEPS;
    if largest < FAINTEST { 0.0 } else { per_step * per_step }
}

/// Adds colours onto what is in `out`.
pub(crate) fn add_colors<'a>(path: Path, parts: impl Iterator<Item = Part<'a, [Texels]>>, out: &mut Light) {
    in_batches(parts, |batch| sum_colors(path, batch, out));
}

/// Adds what is the same for all channels onto what is in `out`.
pub(crate) fn add_grays<'a>(path: Path, parts: impl Iterator<Item = Part<'a, Texels>>, out: &mut Light) {
    in_batches(parts, |batch| sum_grays(path, batch, out));
}

/// Adds what arrives at a floor, times its paint, onto what is in `out`.
pub(crate) fn add_floor<'a>(path: Path, paint: &Paint, parts: impl Iterator<Item = Part<'a, Texels>>, out: &mut Light) {
    in_batches(parts, |batch| sum_floor(path, paint, batch, [0.0; 3], true, out));
}

/// The floor in light that is `everywhere` the same, and in what arrives besides, into `out`.
pub(crate) fn put_floor<'a>(
    path: Path,
    paint: &Paint,
    everywhere: Rgb,
    parts: impl Iterator<Item = Part<'a, Texels>>,
    out: &mut Light,
) {
    let mut rest = false;
    in_batches(parts, |batch| {
        sum_floor(path, paint, batch, if rest { [0.0; 3] } else { everywhere }, rest, out);
        rest = true;
    });
    if !rest {
        sum_floor(path, paint, &[], everywhere, false, out);
    }
}

/// Calls `work` with some parts at a time, so that sums stay in registers and nothing is allocated.
#[inline(always)]
fn in_batches<'a, T: ?Sized + 'a>(mut parts: impl Iterator<Item = Part<'a, T>>, mut work: impl FnMut(&[Part<T>])) {
    while let Some(first) = parts.next() {
        let mut batch = [first; BATCH];
        let mut count = 1;
        while count < BATCH {
            let Some(part) = parts.next() else { break };
            batch[count] = part;
            count += 1;
        }
        work(&batch[..count]);
    }
}

clones! {
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

clones! {
    /// Keeps some rows of a plane, times what is seen of it.
    pub(crate) fn encode_rows(
        plane: &Plane, seen: &Plane, rows: Rows, scale: f32, texels: &mut Texels,
    ) = encode_lanes;
}

#[inline(always)]
fn encode_lanes(plane: &Plane, seen: &Plane, rows: Rows, scale: f32, texels: &mut Texels) {
    let steps = if scale > 0.0 { 1.0 / scale.sqrt() } else { 0.0 };
    for row in ones(rows) {
        let (line, seen, out) = (&plane[row], &seen[row], &mut texels.0[row * LANES..][..LANES]);
        for i in 0..LANES {
            out[i] = rounded((max(line[i], 0.0) * seen[i]).sqrt() * steps);
        }
    }
}

clones! {
    fn sum_colors(parts: &[Part<[Texels]>], out: &mut Light) = sum_colors_lanes;
}

#[inline(always)]
fn sum_colors_lanes(parts: &[Part<[Texels]>], out: &mut Light) {
    for channel in 0..3 {
        for rows in (0..TILE).step_by(ROWS) {
            let mut sums = [[0.0; LANES]; ROWS];
            sums.copy_from_slice(&out[channel][rows..rows + ROWS]);
            for part in parts {
                let gain = part.gain[channel];
                let texels = &part.texels[channel].0[rows * LANES..][..ROWS * LANES];
                for row in 0..ROWS {
                    for i in 0..LANES {
                        let root = f32::from(texels[row * LANES + i]);
                        sums[row][i] += root * root * gain;
                    }
                }
            }
            out[channel][rows..rows + ROWS].copy_from_slice(&sums);
        }
    }
}

/// The sums of two rows of planes that are the same for all channels, onto `sums`.
#[inline(always)]
fn add_rows(parts: &[Part<Texels>], rows: usize, sums: &mut [[Lanes; GRAY_ROWS]; 3]) {
    let [red, green, blue] = sums;
    for part in parts {
        let [r, g, b] = part.gain;
        let texels = &part.texels.0[rows * LANES..][..GRAY_ROWS * LANES];
        for row in 0..GRAY_ROWS {
            for i in 0..LANES {
                let root = f32::from(texels[row * LANES + i]);
                let square = root * root;
                red[row][i] += square * r;
                green[row][i] += square * g;
                blue[row][i] += square * b;
            }
        }
    }
}

clones! {
    fn sum_grays(parts: &[Part<Texels>], out: &mut Light) = sum_grays_lanes;
}

#[inline(always)]
fn sum_grays_lanes(parts: &[Part<Texels>], out: &mut Light) {
    for rows in (0..TILE).step_by(GRAY_ROWS) {
        let mut sums = [[[0.0; LANES]; GRAY_ROWS]; 3];
        add_rows(parts, rows, &mut sums);
        for (sums, out) in sums.iter().zip(&mut *out) {
            for row in 0..GRAY_ROWS {
                for i in 0..LANES {
                    out[rows + row][i] += sums[row][i];
                }
            }
        }
    }
}

clones! {
    fn sum_floor(
        paint: &Paint, parts: &[Part<Texels>], everywhere: Rgb, kept: bool, out: &mut Light,
    ) = sum_floor_lanes;
}

#[inline(always)]
fn sum_floor_lanes(paint: &Paint, parts: &[Part<Texels>], everywhere: Rgb, kept: bool, out: &mut Light) {
    for rows in (0..TILE).step_by(GRAY_ROWS) {
        let mut sums = everywhere.map(|everywhere| [[everywhere; LANES]; GRAY_ROWS]);
        add_rows(parts, rows, &mut sums);
        for ((sums, paint), out) in sums.iter().zip(paint).zip(&mut *out) {
            for row in 0..GRAY_ROWS {
                let (paint, out) = (&paint[(rows + row) * LANES..][..LANES], &mut out[rows + row]);
                for i in 0..LANES {
                    let light = f32::from(paint[i]) * (1.0 / 65_535.0) * sums[row][i];
                    out[i] = if kept { out[i] + light } else { light };
                }
            }
        }
    }
}
