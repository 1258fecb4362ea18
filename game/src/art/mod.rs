//! The art of a table at a view's resolution: what is printed on the floor and on the plastics, and which pixels each
//! lit window covers.
//!
//! Only the fonts of `assets/fonts` are used and no file is read, so the same drawing gives the same pixels everywhere.

mod cost;
mod guard;
mod letters;
mod mask;
mod normal_map;
mod numbers;
mod print;
mod read;
#[cfg(test)]
mod tests;
mod typefaces;
mod unnamed;

pub use letters::warning as letters_warning;
pub use mask::masks;
pub use print::drawing;
pub use read::{PrintCost, check};

use crate::Failure;
use crate::table::{NormalMapInputs, Table};
use normal_map::Wood;
use print::print;
use tiny_skia::Color;
use tracer::{Floor, View};

/// The colour below the floor's art, and beside the playfield.
const BACKGROUND: [u8; 3] = [8, 8, 10];

/// The art of `table` at `view`: the floor opaque, the tops transparent where nothing is printed; its wood is grained, its
/// inserts are faceted, and the floor leans as its relief says. Beside the playfield there is no art.
///
/// # Errors
/// If the drawing cannot be printed, or so many pixels do not fit into the memory.
pub fn floor(table: &Table, view: &View) -> Result<Floor, Failure> {
    let NormalMapInputs { wood_svg, tops_wood_svg, .. } = &table.normal_map;
    let (floor, tops) = rayon::join(
        || wooden(table, &table.floor_svg, wood_svg.as_deref(), view, background()),
        || wooden(table, &table.tops_svg, tops_wood_svg.as_deref(), view, Color::TRANSPARENT),
    );
    let ((mut floor, wood), (tops, _)) = (floor?, tops?);
    normal_map::facet(table, view, &mut floor);
    let normals = normal_map::normals(table, view, &wood)?;
    Ok(Floor {
        width: view.width,
        height: view.height,
        floor,
        tops,
        normals,
        gloss: table.normal_map.gloss,
        ..Floor::default()
    })
}

fn background() -> Color {
    Color::from_rgba8(BACKGROUND[0], BACKGROUND[1], BACKGROUND[2], 255)
}

/// A layer of art, stained where `wood` is printed, and how much of each pixel is wood (empty when nothing is).
fn wooden(
    table: &Table,
    svg: &str,
    wood: Option<&str>,
    view: &View,
    background: Color,
) -> Result<(Vec<[u8; 4]>, Vec<u8>), Failure> {
    let (pixels, wood) = rayon::join(
        || print(table, svg, view, background),
        || wood.map(|wood| print(table, wood, view, Color::TRANSPARENT)).transpose(),
    );
    let mut pixels = pixels?;
    let Some(wood) = wood? else { return Ok((pixels, Vec::new())) };
    let wood: Vec<u8> = wood.iter().map(|pixel| pixel[3]).collect();
    Wood::new(table.normal_map.planks_mm, table.normal_map.grain, view.mm_per_px).stain(view, &wood, &mut pixels);
    Ok((pixels, wood))
}
