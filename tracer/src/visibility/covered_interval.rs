//! Covered intervals: which part of a lamp's chord a convex occluder hides from a point, bounded by the occluder's two
//! tangents through the point.
//!
//! The frame of all formulas below, for a point P:
//! - the origin is P;
//! - u is the vector from P to the chord's line, at right angles to it, of length d; it is not normalised, which saves
//!   a square root and a division;
//! - the vector c has the coordinates (ahead, aside) = (c . u, u x c), so each is in mm times d;
//! - a direction is its slope, aside / ahead. The ray of slope s meets the chord's line s d from the foot of u, so
//!   intervals of slopes are intervals of the chord, and the chord of a disc of radius r is [-r/d, r/d].

use crate::simd::dispatch::{LANES, Lanes, clamp, max, min};
use crate::visibility::blockers::{Blockers, Cap, Element, Piece};
use crate::visibility::projected_emitter::ProjectedChord;

/// A slope that stands for infinity: a direction parallel to the chord. Its square is finite in single precision.
const SLOPE_INFINITY: f32 = 1e18;

/// The interval that the chain or piece of this number covers, for each of a block of samples.
#[inline(always)]
pub(crate) fn covered_interval<S: ProjectedChord>(
    x: &Lanes,
    y: &Lanes,
    emitter: S,
    blockers: &Blockers,
    at: usize,
    low: &mut Lanes,
    high: &mut Lanes,
) {
    let chains = blockers.ends.len();
    if at < chains {
        let first = if at == 0 { 0 } else { blockers.ends[at - 1] };
        return cover_chain(x, y, emitter, &blockers.elements[first..blockers.ends[at]], low, high);
    }
    let piece = &blockers.pieces[at - chains];
    match (piece.clipped, piece.cap.is_some()) {
        (false, false) => cover_piece::<S, false, false>(x, y, emitter, piece, low, high),
        (false, true) => cover_piece::<S, false, true>(x, y, emitter, piece, low, high),
        (true, false) => cover_piece::<S, true, false>(x, y, emitter, piece, low, high),
        (true, true) => cover_piece::<S, true, true>(x, y, emitter, piece, low, high),
    }
}

/// The interval of a chain that lies, for every sample of the block, between the point and the lamp's chord.
///
/// From outside, the hull of two discs spans the same directions as the two discs together and whatever lies between
/// them, and the links of a chain leave no gap: its interval goes from its discs' lowest tangent to their highest.
///
/// The tangents of a disc, with c the vector from P to its centre, R its radius and t = sqrt(c^2 - R^2) the distance to
/// the points of tangency:
/// 1. They are c turned by plus and minus the angle whose sine is R / |c| and whose cosine is t / |c|.
/// 2. In the frame their directions are (ahead t + aside R, aside t - ahead R) and (ahead t - aside R, aside t + ahead
///    R).
/// 3. Each slope, expanded by the other direction's `ahead` and divided by c^2, is
///    (ahead aside -+ R d^2 t) / (ahead^2 - R^2 d^2): one division serves both.
#[inline(always)]
fn cover_chain<S: ProjectedChord>(
    x: &Lanes,
    y: &Lanes,
    emitter: S,
    elements: &[Element],
    low: &mut Lanes,
    high: &mut Lanes,
) {
    let (mut lowest, mut highest) = ([SLOPE_INFINITY; LANES], [-SLOPE_INFINITY; LANES]);
    for element in elements {
        match *element {
            Element::Disc([qx, qy, radius]) => {
                for i in 0..LANES {
                    let (ux, uy, square) = emitter.to_chord_line(x[i], y[i]);
                    let (cx, cy) = (qx - x[i], qy - y[i]);
                    let (ahead, aside) = (cx * ux + cy * uy, cy * ux - cx * uy);
                    let tangent = max(cx * cx + cy * cy - radius * radius, 0.0).sqrt();
                    let swing = radius * square * tangent;
                    let product = ahead * aside;
                    let scale = 1.0 / (ahead * ahead - radius * radius * square);
                    lowest[i] = min(lowest[i], (product - swing) * scale);
                    highest[i] = max(highest[i], (product + swing) * scale);
                }
            }
            Element::Bulge(cap) => {
                for i in 0..LANES {
                    let (ux, uy, square) = emitter.to_chord_line(x[i], y[i]);
                    let ends = tangents(x[i], y[i], cap.circle, ux, uy);
                    let middle = in_frame(cap.middle, ux, uy);
                    let least = cap.least * square;
                    let (lower, upper) =
                        (on_cap(&ends, ends.lower, middle, least), on_cap(&ends, ends.upper, middle, least));
                    lowest[i] = if lower { min(lowest[i], slope(ends.lower, -SLOPE_INFINITY)) } else { lowest[i] };
                    highest[i] = if upper { max(highest[i], slope(ends.upper, SLOPE_INFINITY)) } else { highest[i] };
                }
            }
        }
    }
    (*low, *high) = (lowest, highest);
}

/// The tangents of a disc from a point, in the frame of the module: coordinates in mm times d.
struct Tangents {
    /// The vector c to the disc's centre.
    center: [f32; 2],
    /// The direction of the lower tangent: step 2 of [`cover_chain`].
    lower: [f32; 2],
    /// The direction of the upper tangent.
    upper: [f32; 2],
    /// The distance t to the points of tangency, mm.
    tangent: f32,
    /// c^2, mm^2. A direction times t / c^2 is the point of tangency.
    square: f32,
    /// Whether the point is inside the disc.
    inside: bool,
}

/// A vector in the frame of the module: (v . u, u x v).
#[inline(always)]
fn in_frame(v: [f32; 2], ux: f32, uy: f32) -> [f32; 2] {
    [v[0] * ux + v[1] * uy, v[1] * ux - v[0] * uy]
}

/// The tangents of a disc, given by its centre and radius, from (x, y).
#[inline(always)]
fn tangents(x: f32, y: f32, [qx, qy, radius]: [f32; 3], ux: f32, uy: f32) -> Tangents {
    let (cx, cy) = (qx - x, qy - y);
    let [ahead, aside] = in_frame([cx, cy], ux, uy);
    let square = cx * cx + cy * cy;
    let tangent_square = square - radius * radius;
    let tangent = max(tangent_square, 0.0).sqrt();
    Tangents {
        center: [ahead, aside],
        lower: [ahead * tangent + aside * radius, aside * tangent - ahead * radius],
        upper: [ahead * tangent - aside * radius, aside * tangent + ahead * radius],
        tangent,
        square,
        inside: tangent_square < 0.0,
    }
}

/// The slope of a direction, or `behind` for a direction that points away from the lamp.
#[inline(always)]
fn slope([ahead, aside]: [f32; 2], behind: f32) -> f32 {
    let forward = ahead > 0.0;
    let quotient = clamp(aside / (if forward { ahead } else { 1.0 }), -SLOPE_INFINITY, SLOPE_INFINITY);
    if forward { quotient } else { behind }
}

/// Whether a tangent of the cap's circle touches it within the cap; `least` is the cap's, times d^2.
///
/// 1. The point of tangency is direction t / c^2, so from the circle's centre it is n = direction t / c^2 - center.
/// 2. The cap is where n . middle >= least. Both vectors are in the frame, so their product carries d^2, and multiplied
///    by c^2 the comparison needs no division.
#[inline(always)]
fn on_cap(seen: &Tangents, direction: [f32; 2], middle: [f32; 2], least: f32) -> bool {
    let nx = direction[0] * seen.tangent - seen.center[0] * seen.square;
    let ny = direction[1] * seen.tangent - seen.center[1] * seen.square;
    (nx * middle[0] + ny * middle[1] >= least * seen.square) & !seen.inside
}

/// The interval of the hull of two discs, wherever it lies: round the point, behind it, across the chord.
///
/// 1. The extreme tangents are those of either disc, or of the cap that bulges out of an arc's piece.
/// 2. A hull whose two extreme tangents both point away from the lamp is behind the point: no interval.
/// 3. A point inside the hull sees nothing: the interval is everything.
/// 4. Where an extreme tangent touches beyond the chord (`CLIPPED`), the hull's part before the chord ends on the
///    chord's line: the interval's end is where the outline crosses that line.
#[inline(always)]
fn cover_piece<S: ProjectedChord, const CLIPPED: bool, const CAPPED: bool>(
    x: &Lanes,
    y: &Lanes,
    emitter: S,
    piece: &Piece,
    low: &mut Lanes,
    high: &mut Lanes,
) {
    let cap = piece.cap.unwrap_or(Cap { circle: [0.0; 3], middle: [0.0; 2], least: 0.0, inner: [-1.0; 2] });
    let hull = !piece.single;
    for i in 0..LANES {
        let (ux, uy, square) = emitter.to_chord_line(x[i], y[i]);
        let a = tangents(x[i], y[i], piece.a, ux, uy);
        let b = tangents(x[i], y[i], piece.b, ux, uy);
        // Directions are compared by the sign of their cross product, not by slope: a hull may reach round the point.
        let b_lowest = cross(b.lower, a.lower) > 0.0;
        let b_highest = cross(a.upper, b.upper) > 0.0;
        let mut lower = Touch::pick(b_lowest, &b, b.lower, &Touch::of(&a, a.lower));
        let mut upper = Touch::pick(b_highest, &b, b.upper, &Touch::of(&a, a.upper));
        if CAPPED {
            let ends = tangents(x[i], y[i], cap.circle, ux, uy);
            let middle = in_frame(cap.middle, ux, uy);
            let least = cap.least * square;
            let lowest = on_cap(&ends, ends.lower, middle, least) & (cross(ends.lower, lower.direction) > 0.0);
            let highest = on_cap(&ends, ends.upper, middle, least) & (cross(upper.direction, ends.upper) > 0.0);
            lower = Touch::pick(lowest, &ends, ends.lower, &lower);
            upper = Touch::pick(highest, &ends, ends.upper, &upper);
        }
        // Step 2: the hull spans less than half a turn, so both ends behind means all behind.
        let behind = (lower.direction[0] <= 0.0) & (upper.direction[0] <= 0.0);
        let (mut lowest, mut highest) =
            (slope(lower.direction, -SLOPE_INFINITY), slope(upper.direction, SLOPE_INFINITY));
        // Step 3: from outside, the turn from the lower tangent of one disc to the upper tangent of the other is less
        // than half a turn; from within the hull it is more.
        let b_above_a = cross(a.center, b.center) >= 0.0;
        let span = if b_above_a { cross(a.lower, b.upper) } else { cross(b.lower, a.upper) };
        let inside = a.inside | b.inside | (hull & (span < 0.0));
        if CLIPPED {
            let (mut bottom, mut top) = across_chord(x[i], y[i], piece, &a, &b, ux, uy, square);
            if CAPPED {
                let center = in_frame([cap.circle[0] - x[i], cap.circle[1] - y[i]], ux, uy);
                let middle = in_frame(cap.middle, ux, uy);
                for [radius, least] in [[cap.circle[2], cap.least], cap.inner] {
                    for at in rim_across_chord(center, radius, middle, least, square) {
                        bottom = min(bottom, at.0);
                        top = max(top, at.1);
                    }
                }
            }
            lowest = if lower.is_beyond(square) { bottom } else { lowest };
            highest = if upper.is_beyond(square) { top } else { highest };
        }
        let empty = behind | (lowest > highest);
        low[i] = if inside { -SLOPE_INFINITY } else { if empty { SLOPE_INFINITY } else { lowest } };
        high[i] = if inside | empty { SLOPE_INFINITY } else { highest };
    }
}

/// A point of tangency: the direction of the tangent, and t and c^2, whose quotient takes the direction to the point.
#[derive(Clone, Copy)]
struct Touch {
    direction: [f32; 2],
    tangent: f32,
    square: f32,
}

impl Touch {
    #[inline(always)]
    fn of(seen: &Tangents, direction: [f32; 2]) -> Touch {
        Touch { direction, tangent: seen.tangent, square: seen.square }
    }

    #[inline(always)]
    fn pick(first: bool, seen: &Tangents, direction: [f32; 2], other: &Touch) -> Touch {
        Touch {
            direction: [
                if first { direction[0] } else { other.direction[0] },
                if first { direction[1] } else { other.direction[1] },
            ],
            tangent: if first { seen.tangent } else { other.tangent },
            square: if first { seen.square } else { other.square },
        }
    }

    /// Whether the point of tangency lies beyond the chord's line, where `ahead` is d^2: direction t / c^2 > d^2.
    #[inline(always)]
    fn is_beyond(&self, square: f32) -> bool {
        self.direction[0] * self.tangent > square * self.square
    }
}

#[inline(always)]
fn cross(a: [f32; 2], b: [f32; 2]) -> f32 {
    a[0] * b[1] - a[1] * b[0]
}

/// The slopes between which the hull's outline crosses the chord's line, where `ahead` is d^2 (`square`); in the wrong
/// order if it does not cross.
///
/// In the frame, a circle of radius R has the radius R d. It crosses the line at `center.aside -+ half`, where
/// half^2 = (R d)^2 - (d^2 - center.ahead)^2. A straight side crosses where it is cut in the proportion of its ends'
/// distances from the line. On the line the slope is aside / d^2.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn across_chord(
    x: f32,
    y: f32,
    piece: &Piece,
    a: &Tangents,
    b: &Tangents,
    ux: f32,
    uy: f32,
    square: f32,
) -> (f32, f32) {
    let (mut bottom, mut top) = (SLOPE_INFINITY, -SLOPE_INFINITY);
    for (disc, radius) in [(a, piece.a[2]), (b, piece.b[2])] {
        let off = square - disc.center[0];
        let half_square = radius * radius * square - off * off;
        let half = max(half_square, 0.0).sqrt();
        let crosses = half_square >= 0.0;
        bottom = if crosses { min(bottom, disc.center[1] - half) } else { bottom };
        top = if crosses { max(top, disc.center[1] + half) } else { top };
    }
    for side in &piece.sides {
        let from = in_frame([side[0] - x, side[1] - y], ux, uy);
        let to = in_frame([side[2] - x, side[3] - y], ux, uy);
        let crosses = (from[0] < square) != (to[0] < square);
        let run = to[0] - from[0];
        let part = (square - from[0]) / (if crosses { run } else { 1.0 });
        let at = from[1] + (to[1] - from[1]) * part;
        let counts = crosses & !piece.single;
        bottom = if counts { min(bottom, at) } else { bottom };
        top = if counts { max(top, at) } else { top };
    }
    (bottom / square, top / square)
}

/// The slopes at which the piece of a circle crosses the chord's line, as in [`across_chord`]; in the wrong order where
/// it does not cross.
#[inline(always)]
fn rim_across_chord(center: [f32; 2], radius: f32, middle: [f32; 2], least: f32, square: f32) -> [(f32, f32); 2] {
    let off = square - center[0];
    let half_square = radius * radius * square - off * off;
    let half = max(half_square, 0.0).sqrt();
    [-half, half].map(|aside| {
        let on_piece = off * middle[0] + aside * middle[1] >= least * square;
        let crosses = (half_square >= 0.0) & (radius > 0.0) & on_piece;
        let slope = (center[1] + aside) / square;
        (if crosses { slope } else { SLOPE_INFINITY }, if crosses { slope } else { -SLOPE_INFINITY })
    })
}
