//! SVG art as pixels.

use super::guard::guarded;
use super::read::{Art, screen_from_own};
use crate::Failure;
use crate::table::Table;
use geometry::DVec2;
use tiny_skia::{Color, Pixmap};
use tracer::View;

/// The pixels of one layer of art over `background`, premultiplied.
pub(super) fn print(table: &Table, svg: &str, view: &View, background: Color) -> Result<Vec<[u8; 4]>, Failure> {
    guarded(|| print_guarded(svg, table.size_mm, view, background))
}

/// The pixels of a drawing of this size, premultiplied; transparent where nothing is drawn.
///
/// # Errors
/// If the drawing cannot be printed, or so many pixels do not fit into the memory.
pub fn drawing(svg: &str, size_mm: DVec2, view: &View) -> Result<Vec<[u8; 4]>, Failure> {
    guarded(|| print_guarded(svg, size_mm, view, Color::TRANSPARENT))
}

fn print_guarded(svg: &str, size_mm: DVec2, view: &View, background: Color) -> Result<Vec<[u8; 4]>, Failure> {
    let Art { tree, cost } = Art::read(svg, size_mm)?;
    cost.check_picture(view)?;
    let too_large = || Failure::new(format!("a picture of {} x {} pixels is too large", view.width, view.height));
    let mut pixmap = Pixmap::new(view.width as u32, view.height as u32).ok_or_else(too_large)?;
    pixmap.fill(background);
    resvg::render(&tree, screen_from_own(&tree, size_mm, view), &mut pixmap.as_mut());
    let mut pixels: Vec<[u8; 4]> = pixmap.data().as_chunks().0.to_vec();
    clear_beside(&mut pixels, size_mm, view, background);
    Ok(pixels)
}

/// Art may reach over the playfield's edge in the drawing, but there is nothing there to print on.
fn clear_beside(pixels: &mut [[u8; 4]], size_mm: DVec2, view: &View, background: Color) {
    let blank = background.premultiply().to_color_u8();
    let blank = [blank.red(), blank.green(), blank.blue(), blank.alpha()];
    let columns: Vec<usize> = (0..view.width).filter(|&x| beside(view.table_from_pixel(x, 0).x, size_mm.x)).collect();
    for (y, row) in pixels.chunks_exact_mut(view.width).enumerate() {
        if beside(view.table_from_pixel(0, y).y, size_mm.y) {
            row.fill(blank);
        } else {
            columns.iter().for_each(|&x| row[x] = blank);
        }
    }
}

fn beside(place_mm: f64, size_mm: f64) -> bool {
    !(0.0..=size_mm).contains(&place_mm)
}
