//! The projected emitter: a lamp as the points of one tile see it. It is a chord in the plane of the floor, and a
//! measure on that chord: how much of the lamp's irradiance each part of it gives.
//!
//! - A disc is projected on its diameter across the line of sight; each part of the diameter counts alike. (A disc's
//!   own measure would be the length of the disc across the chord; the even one is the design's choice, and the
//!   reference samples the same.)
//! - A tube is its own chord. Its element dt at t along its line, seen from q off the line, gives dt / (t^2 + q^2),
//!   whose integral is atan(t / q) / q: a part counts the angle that it subtends (Nishita, Okamura, Nakamae 1985,
//!   without their cosine, which [`Lamp`] has not either).

use crate::Lamp;
use crate::simd::atan2::angle;
use crate::simd::dispatch::{LANES, Lanes, max, min};
use geometry::DVec2;

/// The least distance of a point from a tube's line, mm: nearer points are moved off the line, so that slopes stay
/// finite.
const LEAST_OFF_MM: f32 = 1e-3;

/// A lamp, in mm from the tile's middle.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ProjectedEmitter {
    Disc(ProjectedDisc),
    Tube(ProjectedTube),
}

/// A disc lamp.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProjectedDisc {
    /// Across.
    pub x: f32,
    /// Down.
    pub y: f32,
    /// 0 for hard shadows.
    pub radius: f32,
}

/// A tube, in a frame whose first axis is its normal and whose second axis is its direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProjectedTube {
    axis: [f32; 2],
    ahead: f32,
    /// Where its middle is along the second axis.
    middle: f32,
    half: f32,
    height_square: f32,
}

impl ProjectedEmitter {
    /// `lamp` from a tile round `middle_mm`, and the unit vector that is its frame's first axis.
    pub fn new(lamp: &Lamp, middle_mm: DVec2) -> (ProjectedEmitter, DVec2) {
        let from_tile = lamp.center_mm - middle_mm;
        let Some(half) = lamp.tube() else {
            let radius = lamp.radius_mm() as f32;
            return (
                ProjectedEmitter::Disc(ProjectedDisc { x: from_tile.x as f32, y: from_tile.y as f32, radius }),
                DVec2::X,
            );
        };
        let length = half.length();
        let axis = -half.perp() / length;
        let tube = ProjectedTube {
            axis: [axis.x as f32, axis.y as f32],
            ahead: from_tile.dot(axis) as f32,
            middle: from_tile.dot(half / length) as f32,
            half: length as f32,
            height_square: (lamp.height_mm() * lamp.height_mm()) as f32,
        };
        (ProjectedEmitter::Tube(tube), axis)
    }
}

/// The chord of a lamp with a size, seen from a point.
pub(crate) trait ProjectedChord: Copy {
    /// The vector u from the point to the chord's line, at right angles to it, and d^2, the square of its length: never
    /// zero, so that there is a direction.
    fn to_chord_line(self, x: f32, y: f32) -> (f32, f32, f32);

    /// The slopes of the chord's ends.
    fn limits(self, x: f32, y: f32) -> (f32, f32);

    /// Turns slopes into the chord's measure, for the chord's ends and for the ends of the intervals within them.
    fn measure(
        self,
        x: &Lanes,
        y: &Lanes,
        least: &mut Lanes,
        most: &mut Lanes,
        lows: &mut [Lanes],
        highs: &mut [Lanes],
    );
}

impl ProjectedChord for ProjectedDisc {
    #[inline(always)]
    fn to_chord_line(self, x: f32, y: f32) -> (f32, f32, f32) {
        let (ux, uy) = (self.x - x, self.y - y);
        let square = ux * ux + uy * uy;
        let here = square < 1e-8;
        (if here { 1e-4 } else { ux }, if here { 0.0 } else { uy }, if here { 1e-8 } else { square })
    }

    #[inline(always)]
    fn limits(self, x: f32, y: f32) -> (f32, f32) {
        let limit = self.radius / self.to_chord_line(x, y).2.sqrt();
        (-limit, limit)
    }

    /// Every part of the chord counts the same.
    #[inline(always)]
    fn measure(self, _: &Lanes, _: &Lanes, _: &mut Lanes, _: &mut Lanes, _: &mut [Lanes], _: &mut [Lanes]) {}
}

impl ProjectedTube {
    /// A block of samples in the tube's frame.
    #[inline(always)]
    pub fn turned(&self, x: &Lanes, y: &Lanes) -> (Lanes, Lanes) {
        let (mut ahead, mut along) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            ahead[i] = x[i] * self.axis[0] + y[i] * self.axis[1];
            along[i] = y[i] * self.axis[0] - x[i] * self.axis[1];
        }
        (ahead, along)
    }

    /// How far ahead the tube's line is.
    #[inline(always)]
    fn off(&self, x: f32) -> f32 {
        let off = self.ahead - x;
        if off < 0.0 { min(off, -LEAST_OFF_MM) } else { max(off, LEAST_OFF_MM) }
    }
}

impl ProjectedChord for ProjectedTube {
    #[inline(always)]
    fn to_chord_line(self, x: f32, _: f32) -> (f32, f32, f32) {
        let off = self.off(x);
        (off, 0.0, off * off)
    }

    #[inline(always)]
    fn limits(self, x: f32, y: f32) -> (f32, f32) {
        let off = self.off(x);
        let (one, other) = ((self.middle - self.half - y) / off, (self.middle + self.half - y) / off);
        (min(one, other), max(one, other))
    }

    /// The measure of the part from the chord's first end to a slope s is the angle between both as seen from q off the
    /// line, where q^2 = d^2 + height^2:
    /// 1. With a and b along the line, the vectors (q, a) and (q, b) have the dot product q^2 + a b and the cross
    ///    product q (b - a).
    /// 2. Places are slopes times d: a b is s s0 d^2 and q (b - a) is (s - s0) d q.
    /// 3. The angle is atan2(cross, dot).
    #[inline(always)]
    fn measure(
        self,
        x: &Lanes,
        _: &Lanes,
        least: &mut Lanes,
        most: &mut Lanes,
        lows: &mut [Lanes],
        highs: &mut [Lanes],
    ) {
        let (mut square, mut per_slope) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let off = self.off(x[i]);
            square[i] = off * off;
            per_slope[i] = max(off, -off) * (square[i] + self.height_square).sqrt();
        }
        let weigh = |slopes: &mut Lanes| {
            for i in 0..LANES {
                let inner = square[i] + self.height_square + slopes[i] * least[i] * square[i];
                slopes[i] = angle(inner, (slopes[i] - least[i]) * per_slope[i]);
            }
        };
        lows.iter_mut().for_each(weigh);
        highs.iter_mut().for_each(weigh);
        weigh(most);
        *least = [0.0; LANES];
    }
}
