//! Lines in a lamp's plane, and which part of each a ball hides, for a block of samples.

use super::Sizes;
use crate::simd::atan2::angle;
use crate::simd::dispatch::{LANES, Lanes, max, min};

/// How near the point may be to the place under the ball's middle, mm: nearer ones are taken to be so far from it.
const LEAST_OFF_MM: f32 = 1e-3;

/// Room for rounding where blocks are left out, mm.
const CULL_MARGIN_MM: f32 = 0.05;

/// An end that no line has.
const FAR: f32 = 1e30;

/// A lamp and a ball seen from a block of samples. The first axis goes from the point to below the ball's middle.
pub(super) struct View {
    /// How far that is.
    off: Lanes,
    /// That axis on the table.
    axis_x: Lanes,
    axis_y: Lanes,
    /// The lamp's middle, from the point.
    lamp_x: Lanes,
    lamp_y: Lanes,
    /// The same, from the ellipse's middle.
    from_x: Lanes,
    /// The square of the ellipse's width over that of its length.
    round: Lanes,
    /// How far away the cone touches the ball at the lamp's height.
    touch: Lanes,
}

impl View {
    #[inline(always)]
    pub fn new(x: &Lanes, y: &Lanes, ball: [f32; 2], lamp: [f32; 2], sizes: &Sizes) -> View {
        let zero = [0.0; LANES];
        let (mut off, mut axis_x, mut axis_y, mut round) = (zero, zero, zero, zero);
        let (mut lamp_x, mut lamp_y, mut from_x, mut touch) = (zero, zero, zero, zero);
        for i in 0..LANES {
            let (dx, dy) = (ball[0] - x[i], ball[1] - y[i]);
            let distance = (dx * dx + dy * dy).sqrt();
            let here = distance < LEAST_OFF_MM;
            off[i] = max(distance, LEAST_OFF_MM);
            let scale = 1.0 / off[i];
            axis_x[i] = if here { 1.0 } else { dx * scale };
            axis_y[i] = if here { 0.0 } else { dy * scale };
            let (lx, ly) = (lamp[0] - x[i], lamp[1] - y[i]);
            lamp_x[i] = lx * axis_x[i] + ly * axis_y[i];
            lamp_y[i] = ly * axis_x[i] - lx * axis_y[i];
            from_x[i] = lamp_x[i] - off[i] * sizes.stretch;
            round[i] = sizes.square / (off[i] * off[i] + sizes.square);
            touch[i] = (off[i] * off[i] + sizes.square - sizes.level) * scale;
        }
        View { off, axis_x, axis_y, lamp_x, lamp_y, from_x, round, touch }
    }

    /// Whether anything of the lamp may be hidden from any of the samples: whether it comes into the ellipse's box,
    /// beyond what is nearest of the ball.
    #[inline(always)]
    pub fn may_hide(&self, sizes: &Sizes) -> bool {
        let mut near = 0u32;
        for i in 0..LANES {
            let room = sizes.half * 1.001 + CULL_MARGIN_MM;
            let aside = max(self.lamp_y[i], -self.lamp_y[i]) - room;
            let ahead = max(self.from_x[i], -self.from_x[i]) - room;
            let within = (aside < sizes.width) & (max(ahead, 0.0) * self.round[i].sqrt() < sizes.width * 1.001);
            let first = if sizes.reaches_above { min(self.touch[i], self.off[i] - sizes.rim) } else { -FAR };
            near |= u32::from(within & (self.lamp_x[i] + room > first));
        }
        near != 0
    }
}

/// Parallel lines in the lamp's plane, one through the lamp's middle.
pub(super) struct Lines {
    /// The unit vector along them.
    x: Lanes,
    y: Lanes,
    /// How far the ellipse's middle is from the one in the middle, to the side.
    side: Lanes,
    /// What takes the square of that to the square of half of what is hidden, with a sign; and the square of the width.
    thin: Lanes,
    scale: Lanes,
    /// Where the middle of what is hidden is, and how much farther a millimetre to the side.
    middle: Lanes,
    drift: Lanes,
    /// Where the cone touches the ball: the least and the most, and how much farther a millimetre to the side.
    least: Lanes,
    most: Lanes,
    lean: Lanes,
    /// Where the ball's cut is, along the lines and to the side.
    rim_middle: Lanes,
    rim_side: Lanes,
}

impl Lines {
    /// Lines across the ellipse's edge where that is nearest to the lamp. Of an ellipse that is less wide than the lamp
    /// both long edges may be before the lamp: then rather across these.
    #[inline(always)]
    pub fn across_edge(view: &View, sizes: &Sizes) -> Lines {
        let (mut along_x, mut along_y) = ([0.0; LANES], [0.0; LANES]);
        let beyond = max(sizes.half - sizes.width, 0.0);
        for i in 0..LANES {
            let aside = if view.lamp_y[i] < 0.0 { view.lamp_y[i] - beyond } else { view.lamp_y[i] + beyond };
            let (x, y) = (view.round[i] * view.from_x[i], aside);
            let length = (x * x + y * y).sqrt();
            let here = length < 1e-6;
            let scale = 1.0 / max(length, 1e-6);
            along_x[i] = if here { 1.0 } else { x * scale };
            along_y[i] = if here { 0.0 } else { y * scale };
        }
        Lines::new(view, sizes, along_x, along_y)
    }

    /// Lines in a direction on the table.
    #[inline(always)]
    pub fn towards(view: &View, sizes: &Sizes, along: [f32; 2]) -> Lines {
        let (mut along_x, mut along_y) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            along_x[i] = along[0] * view.axis_x[i] + along[1] * view.axis_y[i];
            along_y[i] = along[1] * view.axis_x[i] - along[0] * view.axis_y[i];
        }
        Lines::new(view, sizes, along_x, along_y)
    }

    #[inline(always)]
    fn new(view: &View, sizes: &Sizes, x: Lanes, y: Lanes) -> Lines {
        let zero = [0.0; LANES];
        let (mut side, mut thin, mut scale, mut middle, mut drift) = (zero, zero, zero, zero, zero);
        for i in 0..LANES {
            // round x^2 + y^2 = B^2 along a line.
            let (ex, ey, round) = (x[i], y[i], view.round[i]);
            scale[i] = 1.0 / (round * ex * ex + ey * ey);
            thin[i] = round * scale[i];
            side[i] = ex * view.lamp_y[i] - ey * view.from_x[i];
            middle[i] = -(round * view.from_x[i] * ex + view.lamp_y[i] * ey) * scale[i];
            drift[i] = -(1.0 - round) * ex * ey * scale[i];
        }
        let (mut least, mut most, mut lean, mut rim_middle, mut rim_side) = (zero, zero, zero, zero, zero);
        if sizes.reaches_above {
            for i in 0..LANES {
                let (ex, ey) = (x[i], y[i]);
                let scale = 1.0 / (if max(ex, -ex) < 1e-6 { 1e-6 } else { ex });
                let touches = (view.touch[i] - view.lamp_x[i]) * scale;
                least[i] = if scale > 0.0 { touches } else { -FAR };
                most[i] = if scale > 0.0 { FAR } else { touches };
                lean[i] = ey * scale;
                let (bx, by) = (view.off[i] - view.lamp_x[i], -view.lamp_y[i]);
                rim_middle[i] = bx * ex + by * ey;
                rim_side[i] = by * ex - bx * ey;
            }
        }
        Lines { x, y, side, thin, scale, middle, drift, least, most, lean, rim_middle, rim_side }
    }

    /// Which part is hidden of the line that is so far to the side, from its middle.
    #[inline(always)]
    pub fn hidden(&self, sizes: &Sizes, aside: f32) -> (Lanes, Lanes) {
        let (mut low, mut high) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let side = self.side[i] + aside;
            let half_square = (sizes.width_square - self.thin[i] * side * side) * self.scale[i];
            let half = max(half_square, 0.0).sqrt();
            let middle = self.middle[i] + aside * self.drift[i];
            let meets = half_square > 0.0;
            low[i] = if meets { middle - half } else { FAR };
            high[i] = if meets { middle + half } else { -FAR };
        }
        if sizes.reaches_above {
            self.cut(sizes, aside, &mut low, &mut high);
        }
        (low, high)
    }

    /// Leaves of the ellipse what is beyond where the cone touches the ball, and adds what is inside the ball.
    #[inline(always)]
    fn cut(&self, sizes: &Sizes, aside: f32, low: &mut Lanes, high: &mut Lanes) {
        for i in 0..LANES {
            let first = max(low[i], self.least[i] + aside * self.lean[i]);
            let last = min(high[i], self.most[i] + aside * self.lean[i]);
            let empty = first > last;
            let side = self.rim_side[i] - aside;
            let half_square = sizes.rim_square - side * side;
            let half = max(half_square, 0.0).sqrt();
            let meets = half_square > 0.0;
            let (inner_first, inner_last) = (self.rim_middle[i] - half, self.rim_middle[i] + half);
            low[i] = min(if empty { FAR } else { first }, if meets { inner_first } else { FAR });
            high[i] = max(if empty { -FAR } else { last }, if meets { inner_last } else { -FAR });
        }
    }

    /// Weighs what is hidden of a tube by what arrives: a stretch counts the angle that it is seen under.
    #[inline(always)]
    pub fn weigh(&self, view: &View, low: &Lanes, high: &Lanes, half: f32, height_square: f32, hidden: &mut Lanes) {
        for i in 0..LANES {
            let (low, high) = (max(low[i], -half), min(high[i], half));
            let foot = view.lamp_x[i] * self.x[i] + view.lamp_y[i] * self.y[i];
            let side = view.lamp_y[i] * self.x[i] - view.lamp_x[i] * self.y[i];
            let square = side * side + height_square;
            let off = square.sqrt();
            let part = angle(square + (foot + low) * (foot + high), max(high - low, 0.0) * off);
            let whole = angle(square + (foot - half) * (foot + half), 2.0 * half * off);
            hidden[i] = if high > low { part / whole } else { 0.0 };
        }
    }
}
