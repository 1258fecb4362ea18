//! SVG art as pixels, with the fonts that are built in and nothing from a file.

use crate::Failure;
use crate::fonts::FONTS;
use crate::table::Table;
use geometry::DVec2;
use resvg::usvg::{self, ImageHrefResolver, Options, Tree};
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, PoisonError};
use tiny_skia::{Color, Pixmap, Transform};
use tracer::View;

/// Whether the table's art can be printed.
///
/// # Errors
/// If it cannot, or if it asks for a font that is not there.
pub fn check(table: &Table) -> Result<(), Failure> {
    let layers = [&table.floor_svg, &table.tops_svg].into_iter().chain(&table.normal_map.height_svg);
    layers.into_iter().try_for_each(|svg| tree(svg).map(|_| ()))
}

/// The pixels of one layer of art over `background`, premultiplied.
pub(super) fn print(table: &Table, svg: &str, view: &View, background: Color) -> Result<Vec<[u8; 4]>, Failure> {
    let tree = tree(svg)?;
    let too_large = || Failure::new(format!("a picture of {} x {} pixels is too large", view.width, view.height));
    let mut pixmap = Pixmap::new(view.width as u32, view.height as u32).ok_or_else(too_large)?;
    pixmap.fill(background);
    let scale = 1.0 / view.mm_per_px;
    // The tree's own size is the viewBox, unless the drawing scales itself.
    let own = DVec2::new(f64::from(tree.size().width()), f64::from(tree.size().height()));
    let [x, y] = (table.size_mm / own * scale).to_array();
    let shift = -view.origin_mm * scale;
    let screen_from_own = Transform::from_row(x as f32, 0.0, 0.0, y as f32, shift.x as f32, shift.y as f32);
    resvg::render(&tree, screen_from_own, &mut pixmap.as_mut());
    let mut pixels: Vec<[u8; 4]> = pixmap.data().as_chunks().0.to_vec();
    clear_beside(&mut pixels, table.size_mm, view, background);
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

fn tree(svg: &str) -> Result<Tree, Failure> {
    let fonts = fonts();
    let missing = Mutex::new(BTreeSet::new());
    let select = usvg::FontResolver::default_font_selector();
    let mut options = Options {
        font_family: "Oxanium".to_string(),
        fontdb: fonts.clone(),
        image_href_resolver: ImageHrefResolver {
            resolve_data: Box::new(|_, _, _| None),
            resolve_string: Box::new(|_, _| None),
        },
        ..Options::default()
    };
    options.font_resolver.select_font = Box::new(|font, fonts| {
        if !font.families().iter().any(|family| is_known(family, fonts)) {
            let wanted: Vec<String> = font.families().iter().map(ToString::to_string).collect();
            missing.lock().unwrap_or_else(PoisonError::into_inner).insert(wanted.join(", "));
        }
        select(font, fonts)
    });
    let tree = Tree::from_str(svg, &options);
    drop(options);
    let tree = tree.map_err(|error| Failure::new(format!("its art cannot be printed: {error}")))?;
    let missing = missing.into_inner().unwrap_or_else(PoisonError::into_inner);
    if missing.is_empty() {
        return Ok(tree);
    }
    let missing: Vec<String> = missing.into_iter().collect();
    let known: BTreeSet<&str> = families(&fonts).collect();
    let known: Vec<&str> = known.into_iter().collect();
    Err(Failure::new(format!("there is no font {}; there are {}", missing.join(" and no "), known.join(", "))))
}

fn fonts() -> Arc<usvg::fontdb::Database> {
    let mut fonts = usvg::fontdb::Database::new();
    for (_, data) in FONTS {
        fonts.load_font_source(usvg::fontdb::Source::Binary(Arc::new(data)));
    }
    fonts.set_serif_family("Marcellus");
    fonts.set_sans_serif_family("Oxanium");
    fonts.set_monospace_family("Oxanium");
    fonts.set_cursive_family("Marcellus");
    fonts.set_fantasy_family("Cinzel");
    Arc::new(fonts)
}

fn families(fonts: &usvg::fontdb::Database) -> impl Iterator<Item = &str> {
    fonts.faces().flat_map(|face| face.families.iter().map(|(name, _)| name.as_str()))
}

fn is_known(family: &usvg::FontFamily, fonts: &usvg::fontdb::Database) -> bool {
    match family {
        usvg::FontFamily::Named(name) => families(fonts).any(|known| known == name),
        _ => true,
    }
}
