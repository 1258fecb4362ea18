//! What of a lamp shines, as the points of one tile see it: its chord, and what each part of the chord counts.

use crate::Lamp;
use crate::simd::atan2::angle;
use crate::simd::dispatch::{LANES, Lanes, max, min};
use geometry::DVec2;

/// How near a point may be to the line of a segment that shines, mm: nearer ones are taken to be so far from it.
const LEAST_OFF_MM: f32 = 1e-3;

/// A lamp, in mm from the tile's middle.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ProjectedEmitter {
    Disc(ProjectedDisc),
    Tube(ProjectedTube),
}

/// A disc.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProjectedDisc {
    /// Across.
    pub x: f32,
    /// Down.
    pub y: f32,
    /// 0 for hard shadows.
    pub radius: f32,
}

/// A segment; the first axis is its normal, the second points along it.
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

/// A form that shines and has a size, seen from a point.
pub(crate) trait ProjectedChord: Copy {
    /// The way to the line of the chord, at right angles to it, and the square of its length: never zero, so that there
    /// is a direction.
    fn way(self, x: f32, y: f32) -> (f32, f32, f32);

    /// The slopes of the chord's ends.
    fn limits(self, x: f32, y: f32) -> (f32, f32);

    /// Turns slopes into what counts, for the limits and for the ends of the intervals within them.
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
    fn way(self, x: f32, y: f32) -> (f32, f32, f32) {
        let (ux, uy) = (self.x - x, self.y - y);
        let square = ux * ux + uy * uy;
        let here = square < 1e-8;
        (if here { 1e-4 } else { ux }, if here { 0.0 } else { uy }, if here { 1e-8 } else { square })
    }

    #[inline(always)]
    fn limits(self, x: f32, y: f32) -> (f32, f32) {
        let limit = self.radius / self.way(x, y).2.sqrt();
        (-limit, limit)
    }

    /// Every part of the chord counts the same.
    #[inline(always)]
    fn measure(self, _: &Lanes, _: &Lanes, _: &mut Lanes, _: &mut Lanes, _: &mut [Lanes], _: &mut [Lanes]) {}
}

impl ProjectedTube {
    /// A block of points in the segment's frame.
    #[inline(always)]
    pub fn turned(&self, x: &Lanes, y: &Lanes) -> (Lanes, Lanes) {
        let (mut ahead, mut along) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            ahead[i] = x[i] * self.axis[0] + y[i] * self.axis[1];
            along[i] = y[i] * self.axis[0] - x[i] * self.axis[1];
        }
        (ahead, along)
    }

    /// How far ahead the segment's line is.
    #[inline(always)]
    fn off(&self, x: f32) -> f32 {
        let off = self.ahead - x;
        if off < 0.0 { min(off, -LEAST_OFF_MM) } else { max(off, LEAST_OFF_MM) }
    }
}

impl ProjectedChord for ProjectedTube {
    #[inline(always)]
    fn way(self, x: f32, _: f32) -> (f32, f32, f32) {
        let off = self.off(x);
        (off, 0.0, off * off)
    }

    #[inline(always)]
    fn limits(self, x: f32, y: f32) -> (f32, f32) {
        let off = self.off(x);
        let (one, other) = ((self.middle - self.half - y) / off, (self.middle + self.half - y) / off);
        (min(one, other), max(one, other))
    }

    /// Light from a place that is `t` along the line counts dt / (t^2 + q^2), so a stretch counts the angle between its
    /// ends as seen from a point that is `q` off the line.
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
