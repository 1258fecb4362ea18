//! Inserts as what they are: windows of faceted plastic, let into the wood.
//!
//! A groove runs round each, its edge is rounded, its top is a shallow dome, and behind it a star of facets spreads the
//! light of the lamp. All of it follows from the outline alone.

use super::heights::Heights;
use super::noise;
use crate::art::mask::mask;
use crate::table::{LampKind, Table};
use geometry::{DVec2, trig};
use std::f64::consts::{PI, TAU};
use tracer::{Mask, View};

/// How deep the groove round an insert is, mm.
const GROOVE_MM: f32 = 0.13;
/// How far from the outline the groove reaches, as a Gaussian's standard deviation, mm.
const GROOVE_WIDTH_MM: f64 = 0.42;
/// How high the middle of an insert stands above its edge, mm.
const DOME_MM: f32 = 0.16;
/// How far from the edge the dome still rises, mm.
const DOME_WIDTH_MM: f64 = 1.7;
/// How steep a facet is.
const FACET: f32 = 0.085;
/// The width of a facet at the middle of its length, mm.
const FACET_MM: f64 = 2.0;

/// The heights of the inserts; `None` if there are none, or they are said to be flush.
pub(super) fn heights(table: &Table, view: &View) -> Option<Heights> {
    let strength = table.normal_map.inserts as f32;
    let inserts: Vec<Insert> = inserts(table, view).collect();
    if inserts.is_empty() || strength <= 0.0 {
        return None;
    }
    let mut covered = vec![0_u8; view.width * view.height];
    for insert in &inserts {
        insert.for_each_pixel(|x, y, part| {
            let pixel = &mut covered[y * view.width + x];
            *pixel = part.max(*pixel);
        });
    }
    let cover = Heights::new(view.width, view.height, |x, y| f32::from(covered[y * view.width + x]) / 255.0);
    let edge = cover.blurred(GROOVE_WIDTH_MM / view.mm_per_px);
    let dome = edge.blurred(DOME_WIDTH_MM / view.mm_per_px);
    let mut facets = vec![0.0_f32; view.width * view.height];
    for insert in &inserts {
        insert.for_each_pixel(|x, y, _| {
            facets[y * view.width + x] = insert.facet(view.table_from_pixel(x, y), view.mm_per_px).0;
        });
    }
    Some(Heights::new(view.width, view.height, |x, y| {
        let (i, j) = (x as isize, y as isize);
        let (inside, deep) = (edge.at(i, j), dome.at(i, j));
        // Half covered is the outline itself: there the groove is deepest.
        let groove = -4.0 * GROOVE_MM * inside * (1.0 - inside);
        let inner = inside * inside;
        strength * (groove + inner * (DOME_MM * deep + facets[y * view.width + x]))
    }))
}

/// Prints the facets of the inserts on `floor`: they are brighter over the lamp and darker at the rim, lit or not.
pub(in crate::art) fn facet(table: &Table, view: &View, floor: &mut [[u8; 4]]) {
    let strength = table.normal_map.inserts as f32;
    if strength <= 0.0 {
        return;
    }
    for insert in inserts(table, view) {
        insert.for_each_pixel(|x, y, part| {
            let (_, tone) = insert.facet(view.table_from_pixel(x, y), view.mm_per_px);
            let tone = 1.0 + strength * f32::from(part) / 255.0 * tone;
            for channel in &mut floor[y * view.width + x][..3] {
                *channel = (f32::from(*channel) * tone + 0.5).clamp(0.0, 255.0) as u8;
            }
        });
    }
}

/// A window, where a view shows it.
struct Insert {
    mask: Mask,
    middle_mm: DVec2,
    /// The distance of its corners from its middle, mm, on average.
    radius_mm: f64,
    facets: f64,
    seed: i32,
}

fn inserts<'a>(table: &'a Table, view: &'a View) -> impl Iterator<Item = Insert> + 'a {
    table.lamps.iter().enumerate().filter_map(move |(index, lamp)| match &lamp.kind {
        LampKind::Insert { outlines_mm } => Insert::new(outlines_mm, view, index),
        LampKind::Bulb { .. } => None,
    })
}

impl Insert {
    fn new(outlines_mm: &[Vec<DVec2>], view: &View, index: usize) -> Option<Insert> {
        let mask = mask(outlines_mm, view)?;
        let corners = || outlines_mm.iter().flatten();
        let count = corners().count().max(1) as f64;
        let low = corners().copied().reduce(DVec2::min)?;
        let high = corners().copied().reduce(DVec2::max)?;
        let middle_mm = (low + high) * 0.5;
        let radius_mm = (corners().map(|corner| corner.distance(middle_mm)).sum::<f64>() / count).max(0.1);
        // An even number, so that ridge and valley take turns all the way round.
        let facets = 2.0 * (PI * radius_mm * 0.5 / FACET_MM).round().clamp(4.0, 24.0);
        Some(Insert { mask, middle_mm, radius_mm, facets, seed: index as i32 })
    }

    fn for_each_pixel(&self, mut visit: impl FnMut(usize, usize, u8)) {
        for (index, &part) in self.mask.coverage.iter().enumerate().filter(|&(_, &part)| part > 0) {
            visit(self.mask.x + index % self.mask.width, self.mask.y + index / self.mask.width, part);
        }
    }

    /// The height of the star at a point, mm, and how much brighter its facet is than plain plastic.
    fn facet(&self, at_mm: DVec2, mm_per_px: f64) -> (f32, f32) {
        let from = at_mm - self.middle_mm;
        let distance = from.length();
        // Towards the middle facets become finer than a pixel, and are gone.
        let width_px = PI * distance / self.facets / mm_per_px;
        let seen = ((width_px - 0.6) / 0.8).clamp(0.0, 1.0) as f32;
        let turn = trig::angle(from) / TAU * self.facets * 0.5;
        let phase = turn - turn.floor();
        let ridge = (1.0 - (2.0 * phase - 1.0).abs()) as f32;
        // The slope across a facet is the same at every distance from the middle.
        let height = FACET * (TAU / self.facets * distance) as f32 * (ridge - 0.5) * seen;
        let side = if phase < 0.5 { 1.0 } else { -1.0 };
        let glint = noise::unit((turn * 2.0).floor() as i32, self.seed) - 0.5;
        let near = (1.0 - distance / (1.15 * self.radius_mm)).max(0.0) as f32;
        let tone = 1.5 * near * near - 0.1 + seen * (0.22 * side + 0.16 * glint) * (0.5 + near);
        (height, tone)
    }
}
