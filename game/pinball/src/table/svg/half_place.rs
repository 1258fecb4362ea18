//! Half a place: a thing of which one coordinate is said and the one that belongs to it is not, so that it is 0 in silence.

use super::element::Element;
use super::page::SVG;
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};
use std::collections::BTreeSet;

/// Shapes, two coordinates that belong together, and what of the shape they place.
const PAIRS: [(&str, [&str; 2], &str); 5] = [
    ("circle", ["cx", "cy"], "its middle is"),
    ("ellipse", ["cx", "cy"], "its middle is"),
    ("rect", ["x", "y"], "its corner is"),
    ("line", ["x1", "y1"], "it begins"),
    ("line", ["x2", "y2"], "it ends"),
];

/// Warns of each such thing of these.
pub(in crate::table) fn warnings(source: &Source, document: &Document, things: &[Element]) -> Vec<Diagnostic> {
    let places: BTreeSet<usize> = things.iter().map(|thing| thing.at).collect();
    let drawn = document.descendants().filter(|node| node.is_element() && places.contains(&node.range().start));
    let told = drawn.filter_map(|node| Some(source.diagnostic(node.range().start, told(node)?)));
    told.map(Diagnostic::into_warning).collect()
}

/// What to say of a thing whose place is said by half. In a frame of its own, as a transform or an inner `<svg>` gives it, 0 is
/// as good a place as any.
fn told(node: Node) -> Option<String> {
    let is_moved = node.ancestors().any(|around| around.has_attribute("transform"));
    let is_inner = |around: Node| around.has_tag_name((SVG, "svg")) && around.parent_element().is_some();
    if is_moved || node.ancestors().any(is_inner) {
        return None;
    }
    let name = node.tag_name().name();
    let own = PAIRS.iter().filter(|(shape, ..)| *shape == name);
    own.into_iter().find_map(|(_, [across, down], what)| {
        let (said, missing, edge) = match (node.has_attribute(*across), node.has_attribute(*down)) {
            (true, false) => (across, down, "upper"),
            (false, true) => (down, across, "left"),
            _ => return None,
        };
        Some(format!(
            "this {name} has `{said}` and no `{missing}`, so {what} at the drawing's {edge} edge; write {missing}=\"0\" if that \
             is meant"
        ))
    })
}
