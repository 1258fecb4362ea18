//! Coverage: the signed distance of a top's outline at each pixel of a tile, of which antialiasing and the normals of
//! rounded edges are made.

use crate::simd::dispatch::{LANES, Lanes, max, min, multiversion};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{Plane, TILE};
use crate::{Outline, Profile, Top};
use geometry::{Bounds, Circle, Core, DVec2, Shape, Taper};

/// The widest rounded edge of a polygon with the profile of a dome, mm: art direction, a cushion rather than a tent.
const WIDEST_DOME_MM: f64 = 8.0;

/// The signed distance function of an outline.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct OutlineSdf {
    /// A box around it, mm.
    pub bounds: Bounds,
    kind: Kind,
    /// How wide its rounded edge is, mm.
    bevel_mm: f32,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Hull(Circle, Circle),
    Arc { circle: Circle, middle: DVec2, cos_half: f64, ends: [DVec2; 2], radius: f64 },
    Polygon(Vec<DVec2>),
}

/// What is found at each pixel of a tile.
#[derive(Clone, Debug)]
pub(crate) struct SignedDistance {
    /// Signed distance from the outline, mm, negative inside.
    pub distance: Plane,
    /// Unit vector away from the shape, across.
    pub away_x: Plane,
    /// And down.
    pub away_y: Plane,
}

impl SignedDistance {
    /// Nowhere near.
    pub fn none() -> SignedDistance {
        let far = [[f32::MAX; LANES]; TILE];
        SignedDistance { distance: far, away_x: [[0.0; LANES]; TILE], away_y: [[0.0; LANES]; TILE] }
    }
}

impl OutlineSdf {
    /// The outline of `top`, or `None` where there is nothing of it to see.
    pub fn new(top: &Top) -> Option<OutlineSdf> {
        let (kind, bounds, dome) = match &top.outline {
            Outline::Shape(shape) => OutlineSdf::shape(shape),
            Outline::Polygon(corners) => OutlineSdf::polygon(corners)?,
        };
        let bevel_mm = match top.finish.profile {
            Profile::Bevel(width_mm) => width_mm,
            Profile::Dome => dome as f32,
        };
        let seen = top.finish.opacity > 0.0 && bounds.min.is_finite() && bounds.max.is_finite();
        seen.then_some(OutlineSdf { bounds, kind, bevel_mm: bevel_mm.max(1e-3) })
    }

    fn shape(shape: &Shape) -> (Kind, Bounds, f64) {
        let radius = shape.radius.max(0.0);
        let disc = |center, radius| Circle { center, radius };
        let kind = match shape.core {
            Core::Point(center) => Kind::Hull(disc(center, radius), disc(center, radius)),
            Core::Segment(segment) => Kind::Hull(disc(segment.a, radius), disc(segment.b, radius)),
            Core::Taper(Taper { a, b }) => {
                Kind::Hull(disc(a.center, a.radius + radius), disc(b.center, b.radius + radius))
            }
            Core::Arc(arc) => Kind::Arc {
                circle: arc.circle(),
                middle: arc.middle(),
                cos_half: libm::cos(arc.half_angle()),
                ends: [arc.at(0.0), arc.at(1.0)],
                radius,
            },
        };
        let dome = match kind {
            Kind::Hull(a, b) => a.radius.max(b.radius),
            _ => radius,
        };
        (kind, shape.bounds(), dome)
    }

    fn polygon(corners: &[DVec2]) -> Option<(Kind, Bounds, f64)> {
        let (&first, rest) = corners.split_first()?;
        let bounds =
            rest.iter().fold(Bounds::of(first, first), |bounds, &corner| bounds.union(Bounds::of(corner, corner)));
        let dome = (bounds.size().min_element() * 0.5).min(WIDEST_DOME_MM);
        Some((Kind::Polygon(corners.to_vec()), bounds, dome))
    }

    /// Finds distance and direction for the samples of a whole tile round `middle_mm`. Beyond `margin_mm` from the
    /// outline only the side is right.
    pub fn evaluate(
        &self,
        simd: SimdLevel,
        samples: &PackedSamples,
        middle_mm: DVec2,
        margin_mm: f64,
        edge: &mut SignedDistance,
    ) {
        let local = |v: DVec2| [(v.x - middle_mm.x) as f32, (v.y - middle_mm.y) as f32];
        match &self.kind {
            Kind::Hull(a, b) => {
                let (a, b) = if a.radius >= b.radius { (a, b) } else { (b, a) };
                hull(simd, samples, Hull::new(a, b, local(a.center)), edge);
            }
            Kind::Arc { circle, middle, cos_half, ends, radius } => {
                let bow = ThickArc {
                    center: local(circle.center),
                    core: circle.radius as f32,
                    radius: *radius as f32,
                    middle: [middle.x as f32, middle.y as f32],
                    cos_half: *cos_half as f32,
                    ends: ends.map(local),
                };
                arc(simd, samples, bow, edge);
            }
            Kind::Polygon(corners) => {
                let far = (margin_mm + f64::from(self.bevel_mm)) as f32;
                begin_polygon(edge);
                let reach = far + samples.x[0][LANES - 1].abs();
                for (at, &to) in corners.iter().enumerate() {
                    let from = corners[(at + corners.len() - 1) % corners.len()];
                    let (from, to) = (local(from), local(to));
                    let near = from[0].min(to[0]) < reach
                        && from[0].max(to[0]) > -reach
                        && from[1].min(to[1]) < reach
                        && from[1].max(to[1]) > -reach;
                    let level =
                        from[1].min(to[1]) < reach && from[1].max(to[1]) > -reach && from[0].max(to[0]) > -reach;
                    if near || level {
                        side(simd, samples, [from, to], near, edge);
                    }
                }
                end_polygon(simd, edge);
            }
        }
    }

    /// Width of the rounded edge, mm.
    pub fn bevel_mm(&self) -> f32 {
        self.bevel_mm
    }
}

use crate::simd::dispatch::SimdLevel;

/// The hull of two discs, the first not the smaller.
#[derive(Clone, Copy, Debug)]
struct Hull {
    a: [f32; 2],
    along: [f32; 2],
    length: f32,
    a_radius: f32,
    b_radius: f32,
    /// The straight sides' outward normal, along and across.
    lean: f32,
    upright: f32,
}

impl Hull {
    fn new(a: &Circle, b: &Circle, a_local: [f32; 2]) -> Hull {
        let along = b.center - a.center;
        let length = along.length();
        let shrink = a.radius - b.radius;
        let held = length <= shrink;
        let direction = along.try_normalize().unwrap_or(DVec2::X);
        let lean = if held { 1.0 } else { shrink / length };
        Hull {
            a: a_local,
            along: [direction.x as f32, direction.y as f32],
            length: if held { 0.0 } else { length as f32 },
            a_radius: a.radius as f32,
            b_radius: if held { a.radius as f32 } else { b.radius as f32 },
            lean: if held { 0.0 } else { lean as f32 },
            upright: (1.0 - if held { 0.0 } else { lean * lean }).sqrt() as f32,
        }
    }
}

/// A thick arc.
#[derive(Clone, Copy, Debug)]
struct ThickArc {
    center: [f32; 2],
    core: f32,
    radius: f32,
    middle: [f32; 2],
    cos_half: f32,
    ends: [[f32; 2]; 2],
}

multiversion! {
    fn hull(samples: &PackedSamples, hull: Hull, edge: &mut SignedDistance) = hull_lanes;
}
multiversion! {
    fn arc(samples: &PackedSamples, bow: ThickArc, edge: &mut SignedDistance) = arc_lanes;
}
multiversion! {
    fn side(samples: &PackedSamples, ends: [[f32; 2]; 2], near: bool, edge: &mut SignedDistance) = side_lanes;
}
multiversion! {
    fn end_polygon(edge: &mut SignedDistance) = end_polygon_lanes;
}

#[inline(always)]
fn hull_lanes(samples: &PackedSamples, hull: Hull, edge: &mut SignedDistance) {
    let Hull { a, along, length, a_radius, b_radius, lean, upright } = hull;
    for block in 0..TILE {
        let (x, y) = (&samples.x[block], &samples.y[block]);
        let (mut distance, mut away_x, mut away_y) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let (px, py) = (x[i] - a[0], y[i] - a[1]);
            let forward = px * along[0] + py * along[1];
            let sideways = py * along[0] - px * along[1];
            let mirror = if sideways < 0.0 { -1.0 } else { 1.0 };
            let offset = forward * upright - sideways * mirror * lean;
            let at_b = offset > length * upright;
            let on_side = (offset >= 0.0) & !at_b;
            let beyond = forward - if at_b { length } else { 0.0 };
            let from_disc = max(beyond * beyond + sideways * sideways, 1e-12).sqrt();
            let radius = if at_b { b_radius } else { a_radius };
            let (nf, ns) = (
                if on_side { lean } else { beyond / from_disc },
                if on_side { upright * mirror } else { sideways / from_disc },
            );
            distance[i] =
                if on_side { forward * lean + sideways * mirror * upright - a_radius } else { from_disc - radius };
            away_x[i] = nf * along[0] - ns * along[1];
            away_y[i] = nf * along[1] + ns * along[0];
        }
        (edge.distance[block], edge.away_x[block], edge.away_y[block]) = (distance, away_x, away_y);
    }
}

#[inline(always)]
fn arc_lanes(samples: &PackedSamples, bow: ThickArc, edge: &mut SignedDistance) {
    for block in 0..TILE {
        let (x, y) = (&samples.x[block], &samples.y[block]);
        let (mut distance, mut away_x, mut away_y) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let (px, py) = (x[i] - bow.center[0], y[i] - bow.center[1]);
            let length = max(px * px + py * py, 1e-12).sqrt();
            let spans = px * bow.middle[0] + py * bow.middle[1] >= bow.cos_half * length;
            let off = length - bow.core;
            let (ax, ay) = (x[i] - bow.ends[0][0], y[i] - bow.ends[0][1]);
            let (bx, by) = (x[i] - bow.ends[1][0], y[i] - bow.ends[1][1]);
            let (a_square, b_square) = (ax * ax + ay * ay, bx * bx + by * by);
            let at_b = b_square < a_square;
            let (ex, ey) = (if at_b { bx } else { ax }, if at_b { by } else { ay });
            let end = max(min(a_square, b_square), 1e-12).sqrt();
            let outwards = if off < 0.0 { -1.0 } else { 1.0 };
            distance[i] = (if spans { off * outwards } else { end }) - bow.radius;
            away_x[i] = if spans { px * outwards / length } else { ex / end };
            away_y[i] = if spans { py * outwards / length } else { ey / end };
        }
        (edge.distance[block], edge.away_x[block], edge.away_y[block]) = (distance, away_x, away_y);
    }
}

/// Squared distances, and a sign that turns with each side crossed, until [`end_polygon`].
fn begin_polygon(edge: &mut SignedDistance) {
    edge.distance = [[1e12; LANES]; TILE];
    edge.away_x = [[0.0; LANES]; TILE];
    edge.away_y = [[0.0; LANES]; TILE];
}

#[inline(always)]
fn side_lanes(samples: &PackedSamples, [from, to]: [[f32; 2]; 2], near: bool, edge: &mut SignedDistance) {
    let (ex, ey) = (to[0] - from[0], to[1] - from[1]);
    let inverse = 1.0 / max(ex * ex + ey * ey, 1e-12);
    let slant = ex / if ey == 0.0 { 1.0 } else { ey };
    for block in 0..TILE {
        let (x, y): (&Lanes, &Lanes) = (&samples.x[block], &samples.y[block]);
        let (signed, away_x, away_y) = (&mut edge.distance[block], &mut edge.away_x[block], &mut edge.away_y[block]);
        for i in 0..LANES {
            let (px, py) = (x[i] - from[0], y[i] - from[1]);
            let crossed = ((from[1] > y[i]) != (to[1] > y[i])) & (px < slant * py);
            let turned = if crossed { -signed[i] } else { signed[i] };
            let part = max(min((px * ex + py * ey) * inverse, 1.0), 0.0);
            let (ax, ay) = (px - ex * part, py - ey * part);
            let square = ax * ax + ay * ay;
            let nearer = near & (square < turned.abs());
            signed[i] = if nearer { square.copysign(turned) } else { turned };
            away_x[i] = if nearer { ax } else { away_x[i] };
            away_y[i] = if nearer { ay } else { away_y[i] };
        }
    }
}

#[inline(always)]
fn end_polygon_lanes(edge: &mut SignedDistance) {
    for block in 0..TILE {
        let (signed, away_x, away_y) = (&mut edge.distance[block], &mut edge.away_x[block], &mut edge.away_y[block]);
        for i in 0..LANES {
            let inside = signed[i] < 0.0;
            let length = signed[i].abs().sqrt();
            let scale = (if inside { -1.0 } else { 1.0 }) / max(length, 1e-6);
            signed[i] = if inside { -length } else { length };
            away_x[i] *= scale;
            away_y[i] *= scale;
        }
    }
}
