//! Reading: SVG art as a tree that can be printed in time, with the fonts that are built in and nothing from a file.

use super::cost::{self, PICTURE, Tally, millions};
use super::guard::guarded;
use super::numbers;
use super::typefaces::{families, fonts, is_known, name_of};
use super::unnamed;
use crate::Failure;
use crate::table::{Table, style_declarations};
use geometry::DVec2;
use resvg::usvg::roxmltree::{Document, Node};
use resvg::usvg::{self, ImageHrefResolver, Options, Transform, Tree};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Mutex, PoisonError};
use tracer::View;

/// Pixel operations that a layer of art may take, for a picture of [`PICTURE`] pixels. One takes 1 to 2.5 ns on a core
/// (`caustic bench art`), so the slowest art that is let through takes 10 to 25 s.
const MAX_OPERATIONS: f64 = 10e9;
/// Pixels that may be held at once to print a layer, so many times those of the picture: a picture is 9 MB.
const MAX_PICTURES: f64 = 32.0;
/// Pixels that may be held at once for any picture: 4 GB.
const MAX_PIXELS: f64 = (1u64 << 30) as f64;

/// What it costs to print art.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PrintCost {
    /// Pixel operations.
    pub operations: f64,
    /// Pixels that are held at once, at most.
    pub peak_pixels: f64,
}

/// What it costs to print a table's art on 1080 x 2160 pixels.
///
/// # Errors
/// If the art cannot be printed, or not in time, or if it asks for a font that is not there.
pub fn check(table: &Table) -> Result<PrintCost, Failure> {
    let inputs = &table.normal_map;
    let layers = [Some(&table.floor_svg), Some(&table.tops_svg), inputs.height_svg.as_ref(), inputs.wood_svg.as_ref()];
    let layers = layers.into_iter().flatten().chain(&inputs.tops_wood_svg);
    guarded(|| {
        let mut whole = PrintCost::default();
        for svg in layers {
            let cost = Art::read(svg, table.size_mm)?.cost;
            whole.operations += cost.operations;
            whole.peak_pixels = whole.peak_pixels.max(cost.peak_pixels);
        }
        Ok(whole)
    })
}

/// A layer of art.
pub(super) struct Art {
    pub tree: Tree,
    pub cost: PrintCost,
}

impl Art {
    /// Reads a layer of a table of this size. To be called where a panic is caught.
    ///
    /// # Errors
    /// As [`check`].
    pub fn read(svg: &str, size_mm: DVec2) -> Result<Art, Failure> {
        let failure = |error: &dyn std::fmt::Display| Failure::new(format!("its art cannot be printed: {error}"));
        let document = Document::parse(svg).map_err(|error| failure(&error))?;
        numbers::check(&document)?;
        let tree = tree(&document, failure)?;
        let tally = tally(&document, &tree, size_mm)?;
        if check_tally(&tally).is_err() {
            // What takes the most may have no id: it is told by its line.
            let named = unnamed::named(svg, &document);
            let document = Document::parse(&named).map_err(|error| failure(&error))?;
            check_tally(&self::tally(&document, &self::tree(&document, failure)?, size_mm)?)?;
        }
        check_tally(&tally)?;
        let Tally { operations, peak_pixels, .. } = tally;
        Ok(Art { tree, cost: PrintCost { operations, peak_pixels } })
    }
}

fn tally(document: &Document, tree: &Tree, size_mm: DVec2) -> Result<Tally, Failure> {
    let view = View::fit(PICTURE.0, PICTURE.1, size_mm);
    let mut tally = Tally::new(document);
    let size = (PICTURE.0 as f64, PICTURE.1 as f64);
    cost::count(tree, screen_from_own(tree, size_mm, &view), size, &mut tally)?;
    Ok(tally)
}

fn check_tally(tally: &Tally) -> Result<(), Failure> {
    let most_pixels = MAX_PICTURES * (PICTURE.0 * PICTURE.1) as f64;
    for (what, count, most) in
        [("pixel operations", tally.operations, MAX_OPERATIONS), ("pixels at once", tally.peak_pixels, most_pixels)]
    {
        // What is no number is too much.
        if count <= most {
            continue;
        }
        let (count, most, largest) = (millions(count), millions(most), tally.largest());
        return Err(Failure::new(format!(
            "the art takes {count} {what} to be printed, and {most} is the most{largest}"
        )));
    }
    Ok(())
}

impl PrintCost {
    /// Whether art may be printed on a picture of this size.
    ///
    /// # Errors
    /// If too much would be held at once.
    pub(super) fn check_picture(&self, view: &View) -> Result<(), Failure> {
        let larger = (view.width * view.height) as f64 / (PICTURE.0 * PICTURE.1) as f64;
        if self.peak_pixels * larger <= MAX_PIXELS {
            return Ok(());
        }
        let (width, height) = (view.width, view.height);
        Err(Failure::new(format!("a picture of {width} x {height} pixels is too large for this table's art")))
    }
}

/// What leads from a tree's own coordinates to the picture.
pub(super) fn screen_from_own(tree: &Tree, size_mm: DVec2, view: &View) -> Transform {
    let scale = 1.0 / view.mm_per_px;
    // The tree's own size is the viewBox, unless the drawing scales itself.
    let own = DVec2::new(f64::from(tree.size().width()), f64::from(tree.size().height()));
    let [x, y] = (size_mm / own * scale).to_array();
    let shift = -view.origin_mm * scale;
    Transform::from_row(x as f32, 0.0, 0.0, y as f32, shift.x as f32, shift.y as f32)
}

fn tree(document: &Document, failure: impl Fn(&dyn std::fmt::Display) -> Failure) -> Result<Tree, Failure> {
    let fonts = fonts();
    let missing = Mutex::new(BTreeMap::new());
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
            let first = font.families().first().and_then(name_of).map(str::to_string);
            missing.lock().unwrap_or_else(PoisonError::into_inner).insert(wanted.join(", "), first);
        }
        select(font, fonts)
    });
    let tree = Tree::from_xmltree(document, &options);
    drop(options);
    let tree = tree.map_err(|error| failure(&error))?;
    let missing = missing.into_inner().unwrap_or_else(PoisonError::into_inner);
    if missing.is_empty() {
        return Ok(tree);
    }
    let known: BTreeSet<&str> = families(&fonts).collect();
    let known: Vec<&str> = known.into_iter().collect();
    let mut missing: Vec<(u32, String)> =
        missing.into_iter().map(|(wanted, first)| (line_of_font(document, first.as_deref()), wanted)).collect();
    missing.sort();
    let line = missing[0].0;
    let missing: Vec<String> = missing.into_iter().map(|(_, wanted)| wanted).collect();
    let (missing, known) = (missing.join(" and no "), known.join(", "));
    Err(Failure::new(format!("line {line}: there is no font {missing}; there are {known}")))
}

/// The line of the first element that asks for this font; of the first text where none does by name.
fn line_of_font(document: &Document, family: Option<&str>) -> u32 {
    let asks = |node: &Node, family: &str| {
        let own = node.attributes().map(|attribute| (attribute.name(), attribute.value()));
        let declared = own.chain(style_declarations(node.attribute("style").unwrap_or("")));
        let mut fonts = declared.filter(|(name, _)| matches!(*name, "font-family" | "font"));
        fonts.any(|(_, value)| value.contains(family))
    };
    let elements = || document.descendants().filter(Node::is_element);
    let asking = family.and_then(|family| elements().find(|node| asks(node, family)));
    let node = asking.or_else(|| elements().find(|node| node.tag_name().name() == "text"));
    node.map_or(1, |node| document.text_pos_at(node.range().start).row)
}
