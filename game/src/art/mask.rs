//! The pixels that lit windows cover.

use crate::table::{LampKind, Table};
use geometry::DVec2;
use tiny_skia::{FillRule, PathBuilder, Transform};
use tracer::{Mask, View};

/// The pixels of `view` that each of the table's inserts covers, in the lamps' order; a bulb's mask is empty.
pub fn masks(table: &Table, view: &View) -> Vec<Mask> {
    let mask = |kind: &LampKind| match kind {
        LampKind::Bulb { .. } => None,
        LampKind::Insert { outlines_mm } => mask(outlines_mm, view),
    };
    table.lamps.iter().map(|lamp| mask(&lamp.kind).unwrap_or_default()).collect()
}

/// The coverage of the part of the view that closed outlines may touch.
pub(super) fn mask(outlines_mm: &[Vec<DVec2>], view: &View) -> Option<Mask> {
    let points = || outlines_mm.iter().flatten().map(|&point| view.screen_from_table(point));
    let screen = DVec2::new(view.width as f64, view.height as f64);
    let low = points().reduce(DVec2::min)?.floor().clamp(DVec2::ZERO, screen);
    let high = points().reduce(DVec2::max)?.ceil().clamp(DVec2::ZERO, screen);
    let size = high - low;
    let mut skia = tiny_skia::Mask::new(size.x as u32, size.y as u32)?;
    let mut builder = PathBuilder::new();
    for outline in outlines_mm {
        for (index, &point) in outline.iter().enumerate() {
            let DVec2 { x, y } = view.screen_from_table(point) - low;
            if index == 0 { builder.move_to(x as f32, y as f32) } else { builder.line_to(x as f32, y as f32) }
        }
        builder.close();
    }
    skia.fill_path(&builder.finish()?, FillRule::EvenOdd, true, Transform::identity());
    let (x, y) = (low.x as usize, low.y as usize);
    Some(Mask { x, y, width: size.x as usize, coverage: skia.data().to_vec(), ..Mask::default() })
}
