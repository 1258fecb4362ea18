//! Where shadows of what has moved may fall: so much of a tile has to be looked at again, and no more.
//!
//! A thing casts no shadow on a point if a straight line has the thing on one side and the lamp and the point on the
//! other. Of each thing some such lines are kept, tangent to it, and asked row by row. Every answer is on the safe
//! side.

use crate::simd::dispatch::LANES;
use crate::tile::planes::{RowMask, TILE};
use crate::tile::rect::TileRect;
use crate::visibility::disc_chain::{Disc, DiscChains, Link};
use crate::visibility::shaft::SHAFT_MARGIN_MM;
use crate::{Ball, Group, Lamp};
use geometry::DVec2;

/// Lines that are kept of one thing.
const MAX_LINES: usize = 4;

/// Things of more discs are taken to shadow everything.
const MAX_DISCS: usize = 8;

/// Room for rounding in what a floating ball hides, mm.
const AIRBORNE_MARGIN_MM: f64 = 0.05;

/// A thing is where `normal . x <= offset`, the lamp where it is more.
#[derive(Clone, Copy, Debug)]
struct Line {
    normal: DVec2,
    offset: f64,
}

/// Where one thing may shadow a lamp: not beyond any of its lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowBounds {
    /// What the thing belongs to.
    pub group: Group,
    lines: [Option<Line>; MAX_LINES],
}

impl ShadowBounds {
    /// Puts those of all `things`, but for what the lamp is inside of, into `shadow_bounds`.
    pub fn of_all(lamp: &Lamp, things: &DiscChains, shadow_bounds: &mut Vec<ShadowBounds>) {
        shadow_bounds.clear();
        let chains = things.discs[..things.coarse].chunk_by(|_, next| next.link != Link::Start);
        let casts = |chain: &&[Disc]| Some(chain[0].group) != lamp.inside;
        shadow_bounds.extend(chains.filter(casts).map(|chain| ShadowBounds::of(lamp, things, chain)));
    }

    fn of(lamp: &Lamp, things: &DiscChains, chain: &[Disc]) -> ShadowBounds {
        let mut bounds = ShadowBounds { group: chain[0].group, lines: [None; MAX_LINES] };
        if chain.len() > MAX_DISCS {
            return bounds;
        }
        let swell = |disc: &Disc| match disc.link {
            Link::Bulge(bulge) => things.bulges[bulge as usize].sagitta_mm,
            _ => 0.0,
        };
        let swell = chain.iter().map(swell).fold(0.0, f64::max) + f64::from(SHAFT_MARGIN_MM);
        let half = lamp.tube().unwrap_or(DVec2::ZERO);
        let lamp_radius = if lamp.tube().is_some() { 0.0 } else { lamp.radius_mm() };
        let mut room = bounds.lines.iter_mut();
        let mut add = |normal: DVec2| {
            let offset =
                chain.iter().map(|disc| normal.dot(disc.center) + disc.radius + swell).fold(f64::MIN, f64::max);
            let before_lamp = normal.dot(lamp.center_mm) - lamp_radius - normal.dot(half).abs() + 1e-9;
            // What is a tangent of one disc only cuts through the thing.
            if before_lamp >= offset
                && let Some(line) = room.next()
            {
                *line = Some(Line { normal, offset });
            }
        };
        let ends = [lamp.center_mm - half, lamp.center_mm + half];
        for end in &ends[..if half == DVec2::ZERO { 1 } else { 2 }] {
            for disc in chain {
                let way = *end - disc.center;
                let part = (lamp_radius + disc.radius + swell) / way.length();
                if part < 1.0 {
                    let (ahead, aside) = (way.normalize(), (1.0 - part * part).sqrt());
                    [aside, -aside].into_iter().for_each(|aside| add(ahead * part + ahead.perp() * aside));
                }
            }
        }
        // What is nearer to the lamp than all of the thing.
        let middle = chain.iter().map(|disc| disc.center).sum::<DVec2>() / chain.len() as f64;
        (lamp.center_mm - middle).try_normalize().into_iter().for_each(add);
        bounds
    }

    /// That of a ball that floats: of one that is all below the lamp a box round its shadow, else what the shadow of a
    /// column would be, since whatever meets the ball meets the column.
    pub fn of_airborne(lamp: &Lamp, ball: &Ball) -> ShadowBounds {
        let (height, radius) = (lamp.height_mm(), ball.radius_mm + AIRBORNE_MARGIN_MM);
        let below = height - (ball.radius_mm + ball.lift_mm());
        let (group, link) = (ball.group, Link::Start);
        if below <= 1.01 * radius {
            let column = Disc { center: ball.center_mm, radius, group, link };
            return ShadowBounds::of(lamp, &DiscChains::default(), &[column]);
        }
        let square = below * below - radius * radius;
        let from_lamp = ball.center_mm - lamp.center_mm;
        let ahead = from_lamp.try_normalize().unwrap_or(DVec2::X);
        let line = |normal: DVec2| {
            let room = lamp.tube().map_or(lamp.radius_mm(), |half| normal.dot(half).abs());
            // Seen along the floor the ball is a circle, and the last ray that it stops its tangent.
            let off = normal.dot(from_lamp) + room;
            let far = height * (off * below + radius * (off * off + square).sqrt()) / square;
            let margin = AIRBORNE_MARGIN_MM + 1e-5 * (far.abs() + off.abs());
            Some(Line { normal, offset: normal.dot(lamp.center_mm) + far - room + margin })
        };
        ShadowBounds { group, lines: [ahead, -ahead, ahead.perp(), -ahead.perp()].map(line) }
    }

    /// Whether the shadow may fall into a square round `middle_mm`, half of whose side is given.
    pub fn may_reach(&self, middle_mm: DVec2, half_mm: f64) -> bool {
        let beyond = |line: &Line| {
            let nearest = line.normal.dot(middle_mm) - half_mm * (line.normal.x.abs() + line.normal.y.abs());
            nearest > line.offset
        };
        !self.lines.iter().flatten().any(beyond)
    }

    /// The rows of pixels of a tile that it may fall on.
    pub fn rows(&self, rect: &TileRect, mm_per_px: f64) -> RowMask {
        let mut clear = [false; LANES];
        for line in self.lines.iter().flatten() {
            let half = (TILE as f64 - 1.0) * 0.5;
            let across = half * mm_per_px * line.normal.x.abs();
            let first = line.normal.dot(rect.middle_mm) - half * mm_per_px * line.normal.y - across - line.offset;
            let (first, step) = (first as f32, (line.normal.y * mm_per_px) as f32);
            for row in 0..LANES {
                clear[row] |= first + step * row as f32 > SHAFT_MARGIN_MM;
            }
        }
        clear.iter().rev().fold(0, |rows, &clear| rows << 1 | RowMask::from(!clear))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::{Random, any_shape};
    use crate::tile::packed_samples::PackedSamples;
    use crate::tile::planes::ALL_ROWS;
    use crate::visibility::airborne_shadow::AirborneShadow;
    use crate::visibility::potential_occluders::PotentialOccluders;
    use crate::visibility::scalar;
    use crate::visibility::sphere_shadow;
    use crate::{Emitter, ItemId, Occluder, SimdLevel, View};

    /// A lamp somewhere, a disc or a segment.
    fn any_lamp(random: &mut Random, size: DVec2) -> Lamp {
        let emitter = match random.unit() {
            kind if kind < 0.5 => Emitter::Disc { radius_mm: random.between(0.0, 8.0) },
            _ => Emitter::Segment { half_mm: random.within(size * 0.2) - size * 0.1 },
        };
        let center_mm = random.within(size);
        Lamp { id: ItemId(0), center_mm, emitter, height_mm: 20.0, reach_mm: 1000.0, color: [1.0; 3], inside: None }
    }

    /// Nor does a ball in the air.
    #[test]
    fn rows_that_are_left_alone_are_below_no_floating_ball() {
        let (mut random, size) = (Random(10), DVec2::splat(160.0));
        let (mut left_alone, mut dark) = (0, 0);
        for round in 0..3_000 {
            let lamp = Lamp { height_mm: random.between(5.0, 150.0), ..any_lamp(&mut random, size) };
            let (center_mm, radius_mm) = (random.within(size), random.between(1.0, 20.0));
            let height_mm = random.between(0.11, if round % 3 == 0 { 2.0 } else { 0.9 * lamp.height_mm });
            let ball = Ball {
                id: ItemId(0),
                center_mm,
                radius_mm,
                height_mm,
                below: false,
                group: Group(1),
                rotation: [0.0; 4],
            };
            let near = center_mm + (random.within(size) - size * 0.5) * 0.6;
            let view = View { origin_mm: near, mm_per_px: random.between(0.3, 2.0), width: 16, height: 16 };
            let rect = TileRect::new(&view, 0, 0);
            let bounds = ShadowBounds::of_airborne(&lamp, &ball);
            let reaches = bounds.may_reach(rect.middle_mm, rect.half_mm);
            let rows = if reaches { bounds.rows(&rect, view.mm_per_px) } else { 0 };
            let points = PackedSamples::full_tile(view.mm_per_px);
            let mut fraction = [[1.0; LANES]; TILE];
            AirborneShadow::new(&lamp, &ball).attenuate(SimdLevel::best(), &rect, &points, ALL_ROWS, &mut fraction);
            for (row, column) in (0..TILE).flat_map(|row| [0, 5, 10, 15].map(|column| (row, column))) {
                let point = view.origin_mm + (DVec2::new(column as f64, row as f64) + 0.5) * view.mm_per_px;
                let seen = sphere_shadow::unoccluded_fraction(&[ball], &lamp, point, None);
                let alone = rows >> row & 1 == 0;
                let whole = seen > 1.0 - 1e-12 && fraction[row][column] == 1.0;
                assert!(whole || !alone, "{seen} in row {row} of {view:?}, {lamp:?}, {ball:?}");
                left_alone += u32::from(alone);
                dark += u32::from(seen < 1.0);
            }
        }
        assert!(left_alone > 50_000 && dark > 10_000, "{left_alone} pixels left alone, {dark} in shadow");
    }

    /// A thing takes no light from a pixel of a row that its shadow is said not to fall on.
    #[test]
    fn rows_that_are_left_alone_are_in_no_shadow() {
        let (mut random, size) = (Random(9), DVec2::splat(160.0));
        let (mut left_alone, mut dark) = (0, 0);
        for round in 0..3_000 {
            let lamp = any_lamp(&mut random, size);
            let occluder = Occluder::opaque(ItemId(0), any_shape(&mut random, size, round), Group(1));
            let view =
                View { origin_mm: random.within(size), mm_per_px: random.between(0.3, 2.0), width: 16, height: 16 };
            let rect = TileRect::new(&view, 0, 0);
            let mut disc_chains = DiscChains::default();
            disc_chains.set(&[occluder]);
            let (mut shadow_bounds, mut potential_occluders) = (Vec::new(), PotentialOccluders::default());
            ShadowBounds::of_all(&lamp, &disc_chains, &mut shadow_bounds);
            potential_occluders.set(&lamp, &disc_chains);
            let reaching = shadow_bounds.iter().filter(|bounds| bounds.may_reach(rect.middle_mm, rect.half_mm));
            let rows = reaching.fold(0, |rows, bounds| rows | bounds.rows(&rect, view.mm_per_px));
            for (row, column) in (0..TILE).flat_map(|row| [0, 5, 10, 15].map(|column| (row, column))) {
                let point = view.origin_mm + (DVec2::new(column as f64, row as f64) + 0.5) * view.mm_per_px;
                let seen =
                    scalar::visible_fraction_of(&disc_chains, &potential_occluders, &lamp, point, &[], &mut Vec::new());
                let alone = rows >> row & 1 == 0;
                assert!(seen == 1.0 || !alone, "{seen} in row {row} of {view:?}, {lamp:?}, {occluder:?}");
                left_alone += u32::from(alone);
                dark += u32::from(seen < 1.0);
            }
        }
        assert!(left_alone > 80_000 && dark > 20_000, "{left_alone} pixels left alone, {dark} in shadow");
    }
}
