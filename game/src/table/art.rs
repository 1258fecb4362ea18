//! The art of a table at a view's resolution: what is printed on the floor and on the plastics, and which pixels each
//! lit window covers.
//!
//! Only the fonts of `assets/fonts` are used and no file is read, so the same drawing gives the same pixels everywhere.

use super::relief::wood::Wood;
use super::{LampKind, Relief, Table, relief};
use crate::{Failure, assets};
use geometry::DVec2;
use resvg::usvg::{self, ImageHrefResolver, Options, Tree};
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, PoisonError};
use tiny_skia::{Color, FillRule, PathBuilder, Pixmap, Transform};
use tracer::{Floor, Mask, View};

/// The colour below the floor's art, and beside the playfield.
const BACKGROUND: [u8; 3] = [8, 8, 10];

/// The art of `table` at `view`: the floor opaque, the tops transparent where nothing is printed; its wood is grained, its
/// inserts are faceted, and the floor leans as its relief says. Beside the playfield there is no art.
///
/// # Errors
/// If the drawing cannot be printed, or so many pixels do not fit into the memory.
pub fn floor(table: &Table, view: &View) -> Result<Floor, Failure> {
    let Relief { wood_svg, tops_wood_svg, .. } = &table.relief;
    let (floor, tops) = rayon::join(
        || wooden(table, &table.floor_svg, wood_svg.as_deref(), view, background()),
        || wooden(table, &table.tops_svg, tops_wood_svg.as_deref(), view, Color::TRANSPARENT),
    );
    let ((mut floor, wood), (tops, _)) = (floor?, tops?);
    relief::facet(table, view, &mut floor);
    let normals = relief::normals(table, view, &wood)?;
    Ok(Floor { width: view.width, height: view.height, floor, tops, normals, gloss: table.relief.gloss })
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
    Wood::new(table.relief.planks_mm, table.relief.grain, view.mm_per_px).stain(view, &wood, &mut pixels);
    Ok((pixels, wood))
}

/// The pixels of `view` that each of the table's inserts covers, in the lamps' order; a bulb's mask is empty.
pub fn masks(table: &Table, view: &View) -> Vec<Mask> {
    let mask = |kind: &LampKind| match kind {
        LampKind::Bulb { .. } => None,
        LampKind::Insert { outlines_mm } => mask(outlines_mm, view),
    };
    table.lamps.iter().map(|lamp| mask(&lamp.kind).unwrap_or_default()).collect()
}

/// Whether the table's art can be printed.
///
/// # Errors
/// If it cannot, or if it asks for a font that is not there.
pub fn check(table: &Table) -> Result<(), Failure> {
    let layers = [&table.floor_svg, &table.tops_svg].into_iter().chain(&table.relief.svg);
    layers.into_iter().try_for_each(|svg| tree(table, svg).map(|_| ()))
}

/// The pixels of one layer of art over `background`, premultiplied.
pub(super) fn print(table: &Table, svg: &str, view: &View, background: Color) -> Result<Vec<[u8; 4]>, Failure> {
    let tree = tree(table, svg)?;
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

fn tree(table: &Table, svg: &str) -> Result<Tree, Failure> {
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
    let place = table.dir.join(super::load::FILES[0]);
    let fail = |why: String| Failure::new(format!("{}: {why}", place.display()));
    let tree = tree.map_err(|error| fail(format!("its art cannot be printed: {error}")))?;
    let missing = missing.into_inner().unwrap_or_else(PoisonError::into_inner);
    if missing.is_empty() {
        return Ok(tree);
    }
    let missing: Vec<String> = missing.into_iter().collect();
    let known: BTreeSet<&str> = families(&fonts).collect();
    let known: Vec<&str> = known.into_iter().collect();
    Err(fail(format!("there is no font {}; there are {}", missing.join(" and no "), known.join(", "))))
}

fn fonts() -> Arc<usvg::fontdb::Database> {
    let mut fonts = usvg::fontdb::Database::new();
    for (_, data) in assets::FONTS {
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
    Some(Mask { x, y, width: size.x as usize, coverage: skia.data().to_vec() })
}
