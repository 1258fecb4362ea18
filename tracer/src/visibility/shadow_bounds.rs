//! Shadow bounds: which rows of a tile the shadow of a moved occluder may fall on, umbra and penumbra; only those are
//! computed again.
//!
//! An occluder casts no shadow on a point if a line separates it from the lamp and the point. The kept lines are:
//! 1. The tangents of occluder and lamp that cross between them, one on each side: in two dimensions, the outer planes
//!    of the penumbra wedges of U. Assarsson and T. Akenine-Moeller, "A geometry-based soft shadow volume algorithm
//!    using graphics hardware", SIGGRAPH 2003.
//! 2. A tangent of the occluder on the lamp's side, across: what is nearer to the lamp than all of the occluder is lit.
//!
//! A row of pixels is a line of points, so "beyond the line" is one comparison for each row. Every test is
//! conservative.

use crate::simd::dispatch::LANES;
use crate::tile::planes::{RowMask, TILE};
use crate::tile::rect::TileRect;
use crate::visibility::disc_chain::{Disc, DiscChains, Link};
use crate::visibility::shaft::SHAFT_MARGIN_MM;
use crate::{Ball, Group, Lamp};
use geometry::DVec2;

/// Separating lines that are kept of one occluder.
const MAX_LINES: usize = 4;

/// An occluder of more discs is taken to shadow everything: its bounds would cost more than they save.
const MAX_DISCS: usize = 8;

/// A margin for rounding in the shadow of an airborne ball, mm.
const AIRBORNE_MARGIN_MM: f64 = 0.05;

/// A separating line: the occluder is where `normal . x <= offset`, the lamp where it is more.
#[derive(Clone, Copy, Debug)]
struct Line {
    normal: DVec2,
    offset: f64,
}

/// Where one occluder may shadow a lamp: not beyond any of its separating lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowBounds {
    /// The group of the occluder.
    pub group: Group,
    lines: [Option<Line>; MAX_LINES],
}

impl ShadowBounds {
    /// Puts the bounds of all `things`, but for the group that the lamp is inside of, into `shadow_bounds`.
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
        let bulge_mm = |disc: &Disc| match disc.link {
            Link::Bulge(bulge) => things.bulges[bulge as usize].sagitta_mm,
            _ => 0.0,
        };
        let bulge_mm = chain.iter().map(bulge_mm).fold(0.0, f64::max) + f64::from(SHAFT_MARGIN_MM);
        let half = lamp.tube().unwrap_or(DVec2::ZERO);
        let lamp_radius = if lamp.tube().is_some() { 0.0 } else { lamp.radius_mm() };
        let mut free_lines = bounds.lines.iter_mut();
        let mut add = |normal: DVec2| {
            let offset =
                chain.iter().map(|disc| normal.dot(disc.center) + disc.radius + bulge_mm).fold(f64::MIN, f64::max);
            let before_lamp = normal.dot(lamp.center_mm) - lamp_radius - normal.dot(half).abs() + 1e-9;
            // A tangent of one disc may cut through the others, or through the lamp: it separates nothing.
            if before_lamp >= offset
                && let Some(line) = free_lines.next()
            {
                *line = Some(Line { normal, offset });
            }
        };
        let ends = [lamp.center_mm - half, lamp.center_mm + half];
        for end in &ends[..if half == DVec2::ZERO { 1 } else { 2 }] {
            for disc in chain {
                let to_lamp = *end - disc.center;
                let cosine = (lamp_radius + disc.radius + bulge_mm) / to_lamp.length();
                // The tangent that has lamp and disc on different sides: its normal n has
                // n . (end - center) = lamp radius + disc radius, so it is the line of sight turned by the arc cosine
                // of that over the distance.
                if cosine < 1.0 {
                    let (ahead, aside) = (to_lamp.normalize(), (1.0 - cosine * cosine).sqrt());
                    [aside, -aside].into_iter().for_each(|aside| add(ahead * cosine + ahead.perp() * aside));
                }
            }
        }
        // The tangent across, on the side of the lamp.
        let middle = chain.iter().map(|disc| disc.center).sum::<DVec2>() / chain.len() as f64;
        (lamp.center_mm - middle).try_normalize().into_iter().for_each(add);
        bounds
    }

    /// The bounds of an airborne ball's shadow. Below the lamp, the shadow is bounded: the box round it, along the line
    /// from the lamp. A ball that reaches up to the lamp is bounded as an endless column of its radius would be, since
    /// whatever ray meets the ball meets the column.
    ///
    /// One side of the box, in the vertical plane along its normal, with the lamp's edge as the origin, z = `below`
    /// down to the ball's centre and `off` across to it:
    /// 1. The last stopped ray is the tangent of a circle of radius R: with t its run per unit of descent,
    ///    (off - t below)^2 = R^2 (1 + t^2).
    /// 2. The larger root is t = (off below + R sqrt(off^2 + below^2 - R^2)) / (below^2 - R^2).
    /// 3. It meets the floor at `height` t.
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
            let lamp_extent = lamp.tube().map_or(lamp.radius_mm(), |half| normal.dot(half).abs());
            let off = normal.dot(from_lamp) + lamp_extent;
            let far = height * (off * below + radius * (off * off + square).sqrt()) / square;
            let margin = AIRBORNE_MARGIN_MM + 1e-5 * (far.abs() + off.abs());
            Some(Line { normal, offset: normal.dot(lamp.center_mm) + far - lamp_extent + margin })
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
    use crate::scenes::any_shape;
    use crate::tile::packed_samples::PackedSamples;
    use crate::tile::planes::ALL_ROWS;
    use crate::visibility::airborne_shadow::AirborneShadow;
    use crate::visibility::potential_occluders::PotentialOccluders;
    use crate::visibility::scalar;
    use crate::visibility::sphere_shadow;
    use crate::{Emitter, ItemId, Occluder, SimdLevel, View};
    use geometry::rng::SplitMix64;

    /// A lamp somewhere, a disc or a tube.
    fn any_lamp(random: &mut SplitMix64, size: DVec2) -> Lamp {
        let emitter = match random.unit() {
            kind if kind < 0.5 => Emitter::Disc { radius_mm: random.uniform(0.0, 8.0) },
            _ => Emitter::Tube { half_mm: random.point_within(size * 0.2) - size * 0.1 },
        };
        let center_mm = random.point_within(size);
        Lamp { id: ItemId(0), center_mm, emitter, height_mm: 20.0, reach_mm: 1000.0, color: [1.0; 3], inside: None }
    }

    /// Nor does a ball in the air.
    #[test]
    fn rows_that_are_left_alone_are_below_no_floating_ball() {
        let (mut random, size) = (SplitMix64::new(10), DVec2::splat(160.0));
        let (mut left_alone, mut dark) = (0, 0);
        for round in 0..3_000 {
            let lamp = Lamp { height_mm: random.uniform(5.0, 150.0), ..any_lamp(&mut random, size) };
            let (center_mm, radius_mm) = (random.point_within(size), random.uniform(1.0, 20.0));
            let height_mm = random.uniform(0.11, if round % 3 == 0 { 2.0 } else { 0.9 * lamp.height_mm });
            let ball = Ball {
                id: ItemId(0),
                center_mm,
                radius_mm,
                height_mm,
                below: false,
                group: Group(1),
                rotation: [0.0; 4],
            };
            let near = center_mm + (random.point_within(size) - size * 0.5) * 0.6;
            let view = View { origin_mm: near, mm_per_px: random.uniform(0.3, 2.0), width: 16, height: 16 };
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
        let (mut random, size) = (SplitMix64::new(9), DVec2::splat(160.0));
        let (mut left_alone, mut dark) = (0, 0);
        for round in 0..3_000 {
            let lamp = any_lamp(&mut random, size);
            let occluder = Occluder::opaque(ItemId(0), any_shape(&mut random, size, round), Group(1));
            let view = View {
                origin_mm: random.point_within(size),
                mm_per_px: random.uniform(0.3, 2.0),
                width: 16,
                height: 16,
            };
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
