//! The floor's normal map: what is raised, engraved, let in, grained and scratched, as normals at a view's resolution.
//!
//! Three sources add up. The drawing's relief layer and the scratches are heights on a raster; inserts get their rims and
//! facets from their outlines; wood gets boards and grain from numbers. Every form has its size in millimetres, so that a
//! larger picture shows the same relief more clearly, and what is finer than a pixel fades. It refuses to know how light
//! answers a normal.

mod drawn;
mod heights;
mod inserts;
mod noise;
mod scratches;
mod wood;

pub(super) use inserts::facet;
pub(super) use wood::Wood;

use crate::Failure;
use crate::table::{NormalMapInputs, Table};
use heights::Heights;
use rayon::prelude::*;
use tracer::View;

/// Boards and grain, if there is wood on the floor that shows them.
fn floor_wood(inputs: &NormalMapInputs, view: &View) -> Option<Wood> {
    (inputs.wood_svg.is_some() && (inputs.grain > 0.0 || inputs.planks_mm > 0.0))
        .then(|| Wood::new(inputs.planks_mm, inputs.grain, view.mm_per_px))
}

/// The horizontal part of the floor's unit normals at `view`, 127 is 1; empty if the table's floor is flat. `wooden` is
/// how much of each pixel is wood, empty for none.
///
/// # Errors
/// If the relief layer cannot be printed.
pub(super) fn normals(table: &Table, view: &View, wooden: &[u8]) -> Result<Vec<[i8; 2]>, Failure> {
    let worked = worked(table, view)?;
    let wood = floor_wood(&table.normal_map, view).filter(|_| !wooden.is_empty());
    if worked.is_none() && wood.is_none() {
        return Ok(Vec::new());
    }
    let wood = wood.map(|wood| (wood.heights(view, wooden), wood));
    let mut normals = vec![[0; 2]; view.width * view.height];
    normals.par_chunks_mut(view.width).enumerate().for_each(|(y, row)| {
        for (x, normal) in row.iter_mut().enumerate() {
            let mut slope = worked.as_ref().map_or([0.0; 2], |heights| heights.slope(x, y, view.mm_per_px));
            let part = wooden.get(y * view.width + x).map_or(0.0, |&part| f32::from(part) / 255.0);
            if let Some((heights, wood)) = wood.as_ref().filter(|_| part > 0.0) {
                let grain = heights.slope(x, y, view.mm_per_px);
                slope[0] += part * (grain[0] + wood.crown(view.table_from_pixel(x, y)));
                slope[1] += part * grain[1];
            }
            *normal = rounded(slope, x, y);
        }
    });
    Ok(normals)
}

/// What hands made: the drawn layer, the scratches, the inserts; `None` if there is nothing of it.
fn worked(table: &Table, view: &View) -> Result<Option<Heights>, Failure> {
    let mut heights = drawn::heights(table, view)?;
    if let Some(scratched) = scratches::heights(table, view) {
        heights = Some(match heights {
            Some(drawn) => drawn.plus(&scratched),
            None => scratched,
        });
    }
    // The tool that cuts an edge is round: what the pixels have not softened yet is softened here.
    let mut heights = heights.map(|heights| heights.blurred(softening_px(view.mm_per_px)));
    if let Some(rims) = inserts::heights(table, view) {
        heights = Some(match heights {
            Some(drawn) => drawn.plus(&rims),
            None => rims,
        });
    }
    Ok(heights)
}

/// The standard deviation of the softest edge, mm.
const EDGE_MM: f64 = 0.3;

/// What is left to soften when a pixel and the differences between pixels have softened as much as they do: a box of one
/// pixel has the variance 1/12, the kernel of the differences about 1/4.
fn softening_px(mm_per_px: f64) -> f64 {
    let wanted = EDGE_MM / mm_per_px;
    (wanted * wanted - 1.0 / 3.0).max(0.0).sqrt()
}

/// The steepest normal: 50 degrees from upright.
const STEEPEST: f32 = 0.766;

/// The unit normal of a slope, rounded. Eight bits are too few for a soft slope, so the part that rounding would lose
/// decides how often the next step is taken; level stays level.
fn rounded(slope: [f32; 2], x: usize, y: usize) -> [i8; 2] {
    let long = (1.0 + slope[0] * slope[0] + slope[1] * slope[1]).sqrt();
    let mut normal = slope.map(|part| -part / long);
    let across = (normal[0] * normal[0] + normal[1] * normal[1]).sqrt();
    if across > STEEPEST {
        normal = normal.map(|part| part * (STEEPEST / across));
    }
    let chance = noise::pair(x as i32, y as i32);
    [0, 1].map(|axis| (normal[axis] * 127.0 + chance[axis]).floor().clamp(-127.0, 127.0) as i8)
}
