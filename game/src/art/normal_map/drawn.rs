//! The drawing's relief layer as heights.

use super::heights::Heights;
use crate::Failure;
use crate::art::print::print;
use crate::table::Table;
use tiny_skia::Color;
use tracer::View;

/// The grey of the floor's own level.
const LEVEL: u8 = 128;

/// The heights of the table's relief layer; `None` if it has none.
pub(super) fn heights(table: &Table, view: &View) -> Result<Option<Heights>, Failure> {
    let Some(svg) = table.normal_map.height_svg.as_ref().filter(|_| table.normal_map.height_mm > 0.0) else {
        return Ok(None);
    };
    let pixels = print(table, svg, view, Color::from_rgba8(LEVEL, LEVEL, LEVEL, 255))?;
    let step_mm = table.normal_map.height_mm as f32 / 255.0;
    // A colour counts as the mean of its channels.
    let height = |[red, green, blue, _]: [u8; 4]| {
        let sum = i32::from(red) + i32::from(green) + i32::from(blue) - 3 * i32::from(LEVEL);
        sum as f32 * (step_mm / 3.0)
    };
    let heights = Heights::new(view.width, view.height, |x, y| height(pixels[y * view.width + x]));
    Ok(Some(heights.without_terraces(step_mm)))
}
