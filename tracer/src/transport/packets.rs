//! Curves in packets: a ray is tried against eight of them at once.
//!
//! The arithmetic is that of [`Curve::cross`], operation by operation, so that both find the same distances, bit for bit; the
//! compiler makes registers of the loops over lanes.

use super::Curve;
use super::surfaces::{EdgeId, StartsOn};
use geometry::{Arc, DVec2, Ray, Segment};

/// Curves of a packet.
pub const LANES: usize = 8;

/// A number for each curve.
pub type Lanes = [f64; LANES];

/// The edge of a lane that holds none.
const NO_EDGE: EdgeId = EdgeId::MAX;

/// Straight lines.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct LinePacket {
    a: [Lanes; 2],
    along: [Lanes; 2],
    /// Whose they are.
    pub edges: [EdgeId; LANES],
}

/// Arcs.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct ArcPacket {
    center: [Lanes; 2],
    radius: Lanes,
    middle: [Lanes; 2],
    /// The cosine of half the angle times the radius; less than any point's of a whole circle.
    least: Lanes,
    /// Whose they are.
    pub edges: [EdgeId; LANES],
}

impl LinePacket {
    /// No lines.
    pub const EMPTY: LinePacket =
        LinePacket { a: [[0.0; LANES]; 2], along: [[0.0; LANES]; 2], edges: [NO_EDGE; LANES] };

    /// Puts a line into a lane.
    pub fn set(&mut self, lane: usize, line: &Segment, edge: EdgeId) {
        for axis in 0..2 {
            self.a[axis][lane] = line.a[axis];
            self.along[axis][lane] = line.along()[axis];
        }
        self.edges[lane] = edge;
    }

    /// How far along the ray each is crossed; infinity where it is not.
    #[inline(always)]
    pub fn cross(&self, ray: &Ray, starts_on: &StartsOn) -> Lanes {
        let ([ox, oy], [dx, dy]) = (ray.origin.to_array(), ray.direction.to_array());
        let starts = starts(&self.edges, starts_on);
        let mut distances = [f64::INFINITY; LANES];
        for lane in 0..LANES {
            let (ex, ey) = (self.along[0][lane], self.along[1][lane]);
            let (ax, ay) = (self.a[0][lane] - ox, self.a[1][lane] - oy);
            let denominator = dx * ey - dy * ex;
            let part = ax * dy - ay * dx;
            let distance = (ax * ey - ay * ex) / denominator;
            let flipped = if denominator < 0.0 { -part } else { part };
            let crosses = (distance > 0.0) & (flipped >= 0.0) & (flipped <= denominator.abs()) & !starts[lane];
            distances[lane] = if crosses { distance } else { f64::INFINITY };
        }
        distances
    }
}

impl ArcPacket {
    /// No arcs.
    pub const EMPTY: ArcPacket = ArcPacket {
        center: [[0.0; LANES]; 2],
        radius: [f64::NAN; LANES],
        middle: [[0.0; LANES]; 2],
        least: [0.0; LANES],
        edges: [NO_EDGE; LANES],
    };

    /// Puts an arc into a lane.
    pub fn set(&mut self, lane: usize, arc: &Arc, edge: EdgeId) {
        for axis in 0..2 {
            self.center[axis][lane] = arc.circle().center[axis];
            self.middle[axis][lane] = arc.middle()[axis];
        }
        self.radius[lane] = arc.circle().radius;
        self.least[lane] = super::curve::least_of_arc(arc);
        self.edges[lane] = edge;
    }

    /// How far along the ray each is crossed; infinity where it is not.
    #[inline(always)]
    pub fn cross(&self, ray: &Ray, starts_on: &StartsOn) -> Lanes {
        let ([ox, oy], [dx, dy]) = (ray.origin.to_array(), ray.direction.to_array());
        let starts = starts(&self.edges, starts_on);
        let mut distances = [f64::INFINITY; LANES];
        for lane in 0..LANES {
            let (cx, cy, radius) = (self.center[0][lane], self.center[1][lane], self.radius[lane]);
            let (fx, fy) = (ox - cx, oy - cy);
            let half = fx * dx + fy * dy;
            let (nx, ny) = (fx - dx * half, fy - dy * half);
            let square = radius * radius - (nx * nx + ny * ny);
            let root = (if square > 0.0 { square } else { 0.0 }).sqrt();
            let outer = if half > 0.0 { -half - root } else { root - half };
            let product = (fx * fx + fy * fy) - radius * radius;
            let inner = if outer == 0.0 { 0.0 } else { product / outer };
            let (near, far) = if inner < outer { (inner, outer) } else { (outer, inner) };
            let near = if starts[lane] { outer } else { near };
            let spans = |distance: f64| {
                let (px, py) = (ox + dx * distance - cx, oy + dy * distance - cy);
                px * self.middle[0][lane] + py * self.middle[1][lane] >= self.least[lane]
            };
            let met = (square >= 0.0) | starts[lane];
            let first = met & (near > 0.0) & spans(near);
            let second = met & (far > 0.0) & spans(far) & !starts[lane];
            let distance = if first { near } else { far };
            distances[lane] = if first | second { distance } else { f64::INFINITY };
        }
        distances
    }
}

/// In which lanes the ray starts on the curve.
#[inline(always)]
fn starts(edges: &[EdgeId; LANES], starts_on: &StartsOn) -> [bool; LANES] {
    let mut starts = [false; LANES];
    for edge in starts_on.edges() {
        for lane in 0..LANES {
            starts[lane] |= edges[lane] == *edge;
        }
    }
    starts
}

/// The packets of a leaf, and the curves of it that have none.
#[derive(Clone, Debug, Default)]
pub struct Leaf {
    /// From and to, in the list of packets of lines.
    pub lines: [u32; 2],
    /// In that of arcs.
    pub arcs: [u32; 2],
    /// In that of other edges.
    pub others: [u32; 2],
}

/// All packets of a hierarchy's leaves.
#[derive(Clone, Debug, Default)]
pub struct Packets {
    /// Of straight lines.
    pub lines: Vec<LinePacket>,
    /// Of arcs.
    pub arcs: Vec<ArcPacket>,
    /// Edges that are neither.
    pub others: Vec<EdgeId>,
}

impl Packets {
    /// Packs the edges of a leaf.
    pub fn pack(&mut self, edges: &[EdgeId], curve: impl Fn(EdgeId) -> Curve) -> Leaf {
        let begins = [self.lines.len(), self.arcs.len(), self.others.len()];
        let mut counts = [0; 2];
        for edge in edges {
            match curve(*edge) {
                Curve::Line(line) => {
                    if counts[0] % LANES == 0 {
                        self.lines.push(LinePacket::EMPTY);
                    }
                    self.lines.last_mut().expect("one was pushed").set(counts[0] % LANES, &line, *edge);
                    counts[0] += 1;
                }
                Curve::Arc(arc) => {
                    if counts[1] % LANES == 0 {
                        self.arcs.push(ArcPacket::EMPTY);
                    }
                    self.arcs.last_mut().expect("one was pushed").set(counts[1] % LANES, &arc, *edge);
                    counts[1] += 1;
                }
                Curve::Parabola(_) => self.others.push(*edge),
            }
        }
        let ends = [self.lines.len(), self.arcs.len(), self.others.len()];
        let [lines, arcs, others] = std::array::from_fn(|of| [begins[of] as u32, ends[of] as u32]);
        Leaf { lines, arcs, others }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Circle;
    use geometry::rng::SplitMix64;

    fn same(curve: &Curve, ray: &Ray, starts_on: &StartsOn, lanes: Lanes, count: &mut u32) {
        let expected = curve.cross(ray, starts_on.holds(5)).map_or(f64::INFINITY, |crossing| crossing.distance);
        assert_eq!(lanes[3].to_bits(), expected.to_bits(), "{curve:?} {ray:?} {starts_on:?}");
        assert!((0..LANES).all(|lane| lane == 3 || lanes[lane] == f64::INFINITY), "{lanes:?}");
        *count += u32::from(expected.is_finite());
    }

    /// A lane finds what the curve itself does, from anywhere and from where the ray starts on it, bit for bit.
    #[test]
    fn lanes_cross_as_curves_do() {
        let mut random = SplitMix64::new(9);
        let mut count = 0;
        for turn in 0..50_000 {
            let mut point = || DVec2::new(random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0));
            let (a, b, c) = (point(), point(), point());
            let mut ray = Ray { origin: point(), direction: point().normalize() };
            let line = Segment { a, b: if turn % 50 == 0 { a } else { b } };
            if turn % 51 == 0 {
                ray.direction = DVec2::X;
            }
            let sweep = if turn % 3 == 0 { 7.0 } else { c.y * 0.1 };
            let radius = if turn % 50 == 0 { 0.0 } else { b.x.abs() };
            let arc = Arc::new(Circle { center: a, radius }, c.x, sweep);
            let (mut lines, mut arcs) = (LinePacket::EMPTY, ArcPacket::EMPTY);
            lines.set(3, &line, 5);
            arcs.set(3, &arc, 5);
            for curve in [Curve::Line(line), Curve::Arc(arc)] {
                let mut starts_on = StartsOn::NOTHING;
                for _ in 0..3 {
                    let lanes = match curve {
                        Curve::Line(_) => lines.cross(&ray, &starts_on),
                        _ => arcs.cross(&ray, &starts_on),
                    };
                    same(&curve, &ray, &starts_on, lanes, &mut count);
                    let Some(crossing) = curve.cross(&ray, starts_on.holds(5)) else { break };
                    ray.origin = ray.at(crossing.distance);
                    starts_on = StartsOn::one(5);
                }
            }
        }
        assert!(count > 15_000, "{count}");
    }
}
