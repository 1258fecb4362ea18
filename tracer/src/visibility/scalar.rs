//! The scalar twin of the visible fraction: one point at a time, in double precision, plain where
//! `crate::visibility::fraction` is fast.
//!
//! It takes another way where it can: a hull's interval comes from the extreme points of its part before the chord, the
//! union from a sweep over sorted pairs, and pieces of an arc are cut so finely that their chords will do.

use crate::visibility::disc_chain::{Bulge, Disc, DiscChains, Link};
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::sphere_shadow::unoccluded_fraction;
use crate::visibility::transmission;
use crate::{Group, Lamp, Rgb, Scene};
use geometry::{Circle, DVec2, Taper, trig};

/// A point no deeper than this in a shape only touches it, mm: the rotation of the axes rounds by as much.
const TOUCHING_MM: f64 = 1e-9;

/// The parts of a fine piece of an arc where the chord goes through it.
const ARC_PARTS: u32 = 32;

/// What arrives at a point of the floor from all lamps; what is of the group `exclude` casts no shadow.
pub fn irradiance(scene: &Scene, point_mm: DVec2, exclude: Option<Group>) -> Rgb {
    let mut disc_chains = DiscChains::default();
    disc_chains.set(&scene.occluders);
    let mut potential_occluders = PotentialOccluders::default();
    let mut tinted = Vec::new();
    transmission::find_tinted(&scene.occluders, &mut tinted);
    let mut sum = [0.0; 3];
    for lamp in scene.lamps.iter().filter(|lamp| lamp.shines()) {
        let falloff = lamp.falloff(point_mm);
        if falloff > 0.0 {
            potential_occluders.set(lamp, &disc_chains);
            let met = transmission::on_path(&tinted, |group| potential_occluders.group.contains(&group));
            let seen = transmission::transmitted(met.as_slice(), |removed| {
                let without: Vec<Group> = exclude.into_iter().chain(removed.iter().copied()).collect();
                visible_fraction_of(&disc_chains, &potential_occluders, lamp, point_mm, &without, &mut Vec::new())
            });
            let open = unoccluded_fraction(&scene.balls, lamp, point_mm, exclude);
            for channel in 0..3 {
                sum[channel] += f64::from(lamp.color[channel]) * falloff * open * seen[channel];
            }
        }
    }
    sum.map(|light| light as f32)
}

/// How much of `lamp` the point sees past `potential_occluders`, but for some groups; `intervals` is room to work in.
pub(crate) fn visible_fraction_of(
    chains: &DiscChains,
    potential_occluders: &PotentialOccluders,
    lamp: &Lamp,
    point: DVec2,
    without: &[Group],
    intervals: &mut Vec<(f64, f64)>,
) -> f64 {
    let chord = Chord::new(lamp, point);
    intervals.clear();
    for at in 0..potential_occluders.len() {
        if without.contains(&potential_occluders.group[at]) {
            continue;
        }
        let circle = |disc: &Disc| Circle { center: disc.center, radius: disc.radius };
        let here = circle(&chains.discs[potential_occluders.index[at] as usize]);
        match potential_occluders.link[at] {
            Link::Start => intervals.extend(chord.covered(here, here)),
            Link::Straight => {
                intervals.extend(chord.covered(circle(&chains.discs[potential_occluders.index[at - 1] as usize]), here))
            }
            Link::Bulge(bulge) => {
                for ends in chains.discs[chains.bulges[bulge as usize].fine.clone()].windows(2) {
                    let Link::Bulge(part) = ends[1].link else { continue };
                    let ends = [circle(&ends[0]), circle(&ends[1])];
                    chord.cover_arc(ends, &chains.bulges[part as usize], intervals);
                }
            }
        }
    }
    for (low, high) in intervals.iter_mut() {
        (*low, *high) = (chord.counts(*low), chord.counts(*high));
    }
    let whole = chord.counts(chord.ends.1) - chord.counts(chord.ends.0);
    (1.0 - union_length(intervals) / whole).clamp(0.0, 1.0)
}

/// A lamp's chord seen from a point: the point is the origin, the way to the chord's line the first axis.
struct Chord {
    point: DVec2,
    ahead: DVec2,
    distance: f64,
    /// What the ends are measured in, mm: a disc's radius, or 1.
    unit: f64,
    /// Where the chord begins and ends along the second axis.
    ends: (f64, f64),
    /// For a tube, how far from its line in space the point is, mm.
    off: Option<f64>,
}

impl Chord {
    fn new(lamp: &Lamp, point: DVec2) -> Chord {
        let way = lamp.center_mm - point;
        let Some(half) = lamp.tube() else {
            return Chord {
                point,
                ahead: way.try_normalize().unwrap_or(DVec2::X),
                distance: way.length().max(1e-9),
                unit: lamp.radius_mm().max(1e-9),
                ends: (-1.0, 1.0),
                off: None,
            };
        };
        let along = half / half.length();
        let ahead = if way.dot(along.perp()) < 0.0 { -along.perp() } else { along.perp() };
        let distance = way.dot(ahead).max(1e-9);
        let middle = way.dot(ahead.perp());
        Chord {
            point,
            ahead,
            distance,
            unit: 1.0,
            ends: (middle - half.length(), middle + half.length()),
            off: Some((distance * distance + lamp.height_mm() * lamp.height_mm()).sqrt()),
        }
    }

    /// A measure of the chord up to a place: from a tube, dt / (t^2 + off^2) arrives.
    fn counts(&self, place: f64) -> f64 {
        self.off.map_or(place, |off| {
            let begin = self.ends.0;
            libm::atan2((place - begin) * off, off * off + place * begin)
        })
    }

    /// The parts of the chord that a piece of an arc covers. Where the chord goes through it, it is cut still finer: a
    /// chord that grazes it is long.
    fn cover_arc(&self, ends: [Circle; 2], bulge: &Bulge, intervals: &mut Vec<(f64, f64)>) {
        let ahead = |disc: &Circle| (disc.center - self.point).dot(self.ahead);
        let thick = ends[0].radius + bulge.sagitta_mm;
        let [near, far] = [ahead(&ends[0]), ahead(&ends[1])];
        let crosses = near.min(far) - thick < self.distance && near.max(far) + thick > self.distance;
        let parts = if crosses { ARC_PARTS } else { 1 };
        let center = bulge.outer.center;
        let [from, to] = ends.map(|disc| disc.center - center);
        let angle = libm::acos(bulge.cos_half.min(1.0)) * 2.0 / f64::from(parts);
        let step = trig::direction(angle.copysign(from.perp_dot(to)));
        let mut way = from;
        for _ in 0..parts {
            let next = step.rotate(way);
            let disc = |way| Circle { center: center + way, radius: ends[0].radius };
            intervals.extend(self.covered(disc(way), disc(next)));
            way = next;
        }
    }

    /// The part of the chord that the hull of two discs covers.
    fn covered(&self, a: Circle, b: Circle) -> Option<(f64, f64)> {
        let local = |disc: Circle| {
            let from = disc.center - self.point;
            Circle { center: DVec2::new(from.dot(self.ahead), from.dot(self.ahead.perp())), radius: disc.radius }
        };
        let hull = Taper { a: local(a), b: local(b) };
        if hull.distance(DVec2::ZERO).0 < -TOUCHING_MM {
            return Some(self.ends);
        }
        let touches = self.touches(&hull);
        let slopes = touches.into_iter().flatten().filter(|touch| touch.x > 1e-12).map(|touch| touch.y / touch.x);
        let (low, high) = slopes.fold((f64::MAX, f64::MIN), |(low, high), s| (low.min(s), high.max(s)));
        let (mut low, mut high) = if low <= high { (low, high) } else { return None };
        // A hull that goes round behind the point is cut off by the line across the point: straight to that side. The
        // point is outside, so it is one side; which one must not hang on the rounding of an outline through the point.
        if let Some((below, above)) = line_interval(&hull, 0.0) {
            if below + above > 0.0 {
                high = f64::MAX;
            } else {
                low = f64::MIN;
            }
        }
        let scale = self.distance / self.unit;
        let within = |slope: f64| (slope * scale).clamp(self.ends.0, self.ends.1);
        let (low, high) = (within(low), within(high));
        (low < high).then_some((low, high))
    }

    /// The extreme points of the hull's part before the chord, seen from the origin.
    fn touches(&self, hull: &Taper) -> [Option<DVec2>; 6] {
        let mut found = [None; 6];
        let held = hull.side_normals().is_none();
        for (at, disc) in [hull.a, hull.b].iter().enumerate() {
            let other = [hull.b, hull.a][at];
            if held && disc.radius < other.radius {
                continue;
            }
            let square = disc.center.length_squared();
            let tangent = (square - disc.radius * disc.radius).max(0.0).sqrt();
            for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
                let turned = disc.center * tangent + disc.center.perp() * (sign * disc.radius);
                let touch = if square > 0.0 { turned * (tangent / square) } else { DVec2::ZERO };
                let touch = if tangent == 0.0 { turned_limit(disc, sign) } else { touch };
                found[at * 2 + side] = (touch.x <= self.distance).then_some(touch);
            }
        }
        if let Some((below, above)) = line_interval(hull, self.distance) {
            found[4] = Some(DVec2::new(self.distance, below));
            found[5] = Some(DVec2::new(self.distance, above));
        }
        found
    }
}

/// The direction of a tangent of a disc whose edge the origin is on.
fn turned_limit(disc: &Circle, sign: f64) -> DVec2 {
    disc.center.perp() * sign
}

/// Where a hull crosses the line `x`.
fn line_interval(hull: &Taper, x: f64) -> Option<(f64, f64)> {
    let mut interval: Option<(f64, f64)> = None;
    let mut add = |low: f64, high: f64| {
        interval = Some(interval.map_or((low, high), |(a, b)| (a.min(low), b.max(high))));
    };
    for disc in [hull.a, hull.b] {
        let off = x - disc.center.x;
        let half_square = disc.radius * disc.radius - off * off;
        if half_square >= 0.0 {
            add(disc.center.y - half_square.sqrt(), disc.center.y + half_square.sqrt());
        }
    }
    for side in hull.side_normals().into_iter().flatten().map(|normal| hull.side(normal)) {
        if (side.a.x < x) != (side.b.x < x) {
            let y = side.a.y + (side.b.y - side.a.y) * (x - side.a.x) / (side.b.x - side.a.x);
            add(y, y);
        }
    }
    interval
}

/// The length of a union of intervals.
fn union_length(intervals: &mut [(f64, f64)]) -> f64 {
    intervals.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let (mut length, mut end) = (0.0, f64::MIN);
    for &(low, high) in intervals.iter() {
        length += (high - low.max(end)).max(0.0);
        end = end.max(high);
    }
    length
}
