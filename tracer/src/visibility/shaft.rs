//! The shaft: the convex hull of a lamp and a part of the floor, and how discs lie to the shaft. (E. Haines, J. Wallace,
//! "Shaft culling for efficient ray-traced radiosity", 1991, in two dimensions.)
//!
//! Every ray from the part of the floor to the lamp lies in the shaft. A disc outside casts no shadow there; a chain of
//! discs that crosses it from side to side leaves the whole part in umbra. Every test is conservative.

use crate::Lamp;
use crate::simd::dispatch::{SimdLevel, max, multiversion};
use geometry::DVec2;

/// A margin for rounding in single precision, mm: some units in the last place of a coordinate of 5 m.
pub(crate) const SHAFT_MARGIN_MM: f32 = 2e-3;

/// The disc lies beyond one side of the space between tile and lamp.
const BEYOND_LEFT: u16 = 1;
/// The disc lies beyond the other side.
const BEYOND_RIGHT: u16 = 2;
/// The disc lies behind the lamp for every point of the tile.
const BEHIND_LAMP: u16 = 4;
/// The disc lies behind every point of the tile.
const BEHIND_TILE: u16 = 8;
/// For every point of the tile the disc lies before the lamp's chord.
pub(crate) const BEFORE_LAMP: u16 = 256;
/// The link up to this disc has the lamp and the tile, all of both, on one side.
pub(crate) const OUTSIDE_LINK: u16 = 16;
/// Both discs of a link have one of these in common: no shadow.
pub(crate) const OUTSIDE: u16 = BEYOND_LEFT | BEYOND_RIGHT | BEHIND_LAMP | BEHIND_TILE;
/// The disc reaches the left side.
pub(crate) const MEETS_LEFT: u16 = 32;
/// The disc reaches the right side.
pub(crate) const MEETS_RIGHT: u16 = 64;
/// For every point of the tile the disc lies between the point and the lamp's chord.
pub(crate) const BETWEEN: u16 = 128;

/// The hull of a disc around a part of the floor and of a lamp, whose middle is the origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shaft {
    tile: [f32; 2],
    tile_radius: f32,
    tile_distance: f32,
    /// The radius of a disc; half of a tube's length.
    lamp_radius: f32,
    /// The outward normals of the hull's sides, and how far out the sides are.
    left: [f32; 2],
    right: [f32; 2],
    offset: [f32; 2],
    tube: Option<Tube>,
}

/// A tube that shines, its middle at the origin.
#[derive(Clone, Copy, Debug)]
struct Tube {
    /// From the middle to one end.
    half: [f32; 2],
    /// The unit normal on the tile's side.
    normal: [f32; 2],
    /// How far the part of the floor that is nearest to the tube's line is from it; negative where the line crosses.
    gap: f32,
}

/// Discs to be classified: their middles, the radius that may be solid, and the radius that surely is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Discs<'a> {
    pub x: &'a [f32],
    pub y: &'a [f32],
    pub outer: &'a [f32],
    pub inner: &'a [f32],
}

/// A side of a hull: its outward unit normal, and how far out it is.
type Side = (DVec2, f64);

/// No side: nothing is beyond it, and nothing reaches it.
const NOWHERE: Side = (DVec2::ZERO, f32::MAX as f64);

impl Shaft {
    /// The space between `lamp` and the disc around `middle_mm`.
    pub fn new(lamp: &Lamp, middle_mm: DVec2, radius_mm: f64) -> Shaft {
        let tile = middle_mm - lamp.center_mm;
        let sides = match lamp.tube() {
            None => sides(DVec2::ZERO, lamp.radius_mm(), tile, radius_mm),
            Some(half) => tube_sides(half, tile, radius_mm),
        };
        let narrow = |v: DVec2| [v.x as f32, v.y as f32];
        let tube = lamp.tube().map(|half| {
            let across = half.perp() / half.length();
            let normal = if across.dot(tile) < 0.0 { -across } else { across };
            let gap = (normal.dot(tile) - radius_mm) as f32 - SHAFT_MARGIN_MM;
            Tube { half: narrow(half), normal: narrow(normal), gap }
        });
        Shaft {
            tile: narrow(tile),
            tile_radius: radius_mm as f32,
            tile_distance: tile.length() as f32,
            lamp_radius: lamp.radius_mm() as f32,
            left: narrow(sides[0].0),
            right: narrow(sides[1].0),
            offset: sides.map(|(_, offset)| offset as f32),
            tube,
        }
    }

    /// Writes for each disc the bits that say how it lies to the shaft.
    pub fn classify(&self, simd: SimdLevel, discs: Discs, code: &mut [u16]) {
        match &self.tube {
            None => classify_round(simd, discs, self, code),
            Some(tube) => classify_tube(simd, discs, self, tube, code),
        }
    }
}

/// Where the common tangents of a lamp's disc and of a tile's have both on the inner side: n . lamp + lamp radius =
/// n . tile + radius.
fn sides(lamp: DVec2, lamp_radius: f64, tile: DVec2, radius: f64) -> [Side; 2] {
    let from_lamp = tile - lamp;
    let distance = from_lamp.length();
    let widen = radius - lamp_radius;
    if distance > widen.abs() + f64::from(SHAFT_MARGIN_MM) {
        let lean = from_lamp * (-widen / (distance * distance));
        let across = from_lamp.perp() * ((distance * distance - widen * widen).sqrt() / (distance * distance));
        [lean + across, lean - across].map(|normal| (normal, normal.dot(lamp) + lamp_radius))
    } else {
        [NOWHERE; 2]
    }
}

/// The same for a tube: of the sides through its two ends, those that have the other end on the inner side.
fn tube_sides(half: DVec2, tile: DVec2, radius: f64) -> [Side; 2] {
    let (from_end, from_other) = (sides(half, 0.0, tile, radius), sides(-half, 0.0, tile, radius));
    [0, 1].map(|side| {
        let holds = |(normal, offset): Side, other: DVec2| normal.dot(other) <= offset;
        if holds(from_end[side], -half) {
            from_end[side]
        } else if holds(from_other[side], half) {
            from_other[side]
        } else {
            NOWHERE
        }
    })
}

multiversion! {
    fn classify_round(discs: Discs, shaft: &Shaft, code: &mut [u16]) = classify_round_lanes;
}

multiversion! {
    fn classify_tube(discs: Discs, shaft: &Shaft, tube: &Tube, code: &mut [u16]) = classify_tube_lanes;
}

#[inline(always)]
fn bit(is: bool, bit: u16) -> u16 {
    if is { bit } else { 0 }
}

#[inline(always)]
fn classify_round_lanes(discs: Discs, shaft: &Shaft, code: &mut [u16]) {
    let n = code.len();
    let (x, y, outer, inner) = (&discs.x[..n], &discs.y[..n], &discs.outer[..n], &discs.inner[..n]);
    let [tx, ty] = shaft.tile;
    let farthest = shaft.tile_distance + shaft.tile_radius;
    for i in 0..n {
        let left = shaft.left[0] * x[i] + shaft.left[1] * y[i] - shaft.offset[0];
        let right = shaft.right[0] * x[i] + shaft.right[1] * y[i] - shaft.offset[1];
        // With P a point of the tile, Q the disc and L = 0 the lamp: how far (Q - P) . (L - P) and (L - Q) . (L - P)
        // can be from their values at the tile's middle.
        let (cx, cy) = (x[i] - tx, y[i] - ty);
        let (sx, sy) = (cx - tx, cy - ty);
        let from_tile = -(cx * tx + cy * ty);
        let from_tile_variation = shaft.tile_radius * (sx * sx + sy * sy).sqrt();
        let to_lamp = x[i] * tx + y[i] * ty;
        let to_lamp_variation = shaft.tile_radius * (x[i] * x[i] + y[i] * y[i]).sqrt();
        let margin = outer[i] * farthest;
        let square = shaft.tile_radius * shaft.tile_radius;
        let behind_lamp = to_lamp + to_lamp_variation + margin < 0.0;
        let behind_tile = from_tile + from_tile_variation + square + margin < 0.0;
        let before_lamp = to_lamp - to_lamp_variation - margin > 0.0;
        let after_tile = from_tile - from_tile_variation - margin > 0.0;
        code[i] = bit(left - outer[i] > 0.0, BEYOND_LEFT)
            | bit(right - outer[i] > 0.0, BEYOND_RIGHT)
            | bit(behind_lamp, BEHIND_LAMP)
            | bit(behind_tile, BEHIND_TILE)
            | bit(left + inner[i] >= 0.0, MEETS_LEFT)
            | bit(right + inner[i] >= 0.0, MEETS_RIGHT)
            | bit(before_lamp & after_tile, BETWEEN)
            | bit(before_lamp, BEFORE_LAMP);
    }
    classify_links(discs, shaft, code, |_, _| shaft.lamp_radius);
}

/// The chord of a tube is the tube itself, whatever the point, so before and behind are sides of its line.
#[inline(always)]
fn classify_tube_lanes(discs: Discs, shaft: &Shaft, tube: &Tube, code: &mut [u16]) {
    let n = code.len();
    let (x, y, outer, inner) = (&discs.x[..n], &discs.y[..n], &discs.outer[..n], &discs.inner[..n]);
    let [tx, ty] = shaft.tile;
    let [hx, hy] = tube.half;
    let farthest = shaft.tile_distance + shaft.tile_radius;
    let one_side = tube.gap > 0.0;
    for i in 0..n {
        let left = shaft.left[0] * x[i] + shaft.left[1] * y[i] - shaft.offset[0];
        let right = shaft.right[0] * x[i] + shaft.right[1] * y[i] - shaft.offset[1];
        // The disc's distance from the tube's line, on the tile's side.
        let off = tube.normal[0] * x[i] + tube.normal[1] * y[i];
        // Farther than the tube's far end on the way from every point of the tile to the tube's middle.
        let to_lamp = x[i] * tx + y[i] * ty;
        let to_lamp_variation = shaft.tile_radius * (x[i] * x[i] + y[i] * y[i]).sqrt();
        let behind_ends = to_lamp + to_lamp_variation + (outer[i] + shaft.lamp_radius) * farthest < 0.0;
        // What is behind a point on its way to both ends is so on its way to all between them.
        let (cx, cy) = (x[i] - tx, y[i] - ty);
        let behind = |ex: f32, ey: f32| {
            let (sx, sy) = (cx - (tx - ex), cy - (ty - ey));
            let from_tile = -(cx * (tx - ex) + cy * (ty - ey));
            let from_tile_variation = shaft.tile_radius * (sx * sx + sy * sy).sqrt();
            let margin = outer[i] * (farthest + shaft.lamp_radius);
            from_tile + from_tile_variation + shaft.tile_radius * shaft.tile_radius + margin < 0.0
        };
        let before_lamp = one_side & (off - outer[i] > 0.0);
        code[i] = bit(left - outer[i] > 0.0, BEYOND_LEFT)
            | bit(right - outer[i] > 0.0, BEYOND_RIGHT)
            | bit(behind_ends | (one_side & (off + outer[i] < 0.0)), BEHIND_LAMP)
            | bit(behind(hx, hy) & behind(-hx, -hy), BEHIND_TILE)
            | bit(left + inner[i] >= 0.0, MEETS_LEFT)
            | bit(right + inner[i] >= 0.0, MEETS_RIGHT)
            | bit(before_lamp & (off + outer[i] < tube.gap), BETWEEN)
            | bit(before_lamp, BEFORE_LAMP);
    }
    classify_links(discs, shaft, code, |nx, ny| {
        let half = nx * hx + ny * hy;
        max(half, -half)
    });
}

/// Finds the links that have lamp and tile on one side; `lamp_extent` is how far the lamp reaches along a unit normal.
#[inline(always)]
fn classify_links(discs: Discs, shaft: &Shaft, code: &mut [u16], lamp_extent: impl Fn(f32, f32) -> f32) {
    let n = code.len();
    let (x, y, outer) = (&discs.x[..n], &discs.y[..n], &discs.outer[..n]);
    let [tx, ty] = shaft.tile;
    for i in 1..n {
        // The distances of the lamp's and of the tile's middle from the line through both discs.
        let (ex, ey) = (x[i] - x[i - 1], y[i] - y[i - 1]);
        let scale = 1.0 / max(ex * ex + ey * ey, 1e-12).sqrt();
        let lamp = (ey * x[i] - ex * y[i]) * scale;
        let tile = lamp - (ey * tx - ex * ty) * scale;
        let max_radius = max(outer[i - 1], outer[i]);
        let (lamp_margin, tile_margin) =
            (lamp_extent(ey * scale, -ex * scale) + max_radius, shaft.tile_radius + max_radius);
        let above = (lamp > lamp_margin) & (tile > tile_margin);
        let below = (lamp < -lamp_margin) & (tile < -tile_margin);
        code[i] |= if above | below { OUTSIDE_LINK } else { 0 };
    }
}
