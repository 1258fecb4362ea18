//! The art of a drawing, cut in two: what is printed on the floor, and what is printed on plastics and caps.
//!
//! The text is cut by byte range and everything else is left as it was, so the art stays what its maker wrote: its
//! gradients, its sheets, its transforms.

use super::class::Class;
use super::drawing::class_of;
use super::place::Place;
use super::style;
use roxmltree::{Document, Node};
use std::fmt::Write;
use std::ops::Range;

/// Text to put in the place of a range of bytes.
type Edit = (Range<usize>, String);

/// The floor's art and the plastics' art of a drawing, both well-formed SVG whose size is the `viewBox`.
pub(super) fn split(text: &str, document: &Document) -> (String, String) {
    let root = document.root_element();
    let [mut floor, mut tops] = [root_size(root), root_size(root)];
    floor_edits(root, &mut floor);
    tops_edits(root, &mut tops);
    (edited(text, floor), edited(text, tops))
}

/// The page's size in print has no meaning here: one unit is one millimetre.
fn root_size(root: Node) -> Vec<Edit> {
    let printed = |name: &str| matches!(name, "width" | "height" | "preserveAspectRatio" | "x" | "y");
    let attributes = root.attributes().filter(|attribute| attribute.namespace().is_none() && printed(attribute.name()));
    attributes.map(|attribute| (attribute.range(), String::new())).collect()
}

fn is_plastics(node: Node) -> bool {
    node.attribute("class").is_some_and(|class| class.split_ascii_whitespace().any(|word| word == "plastics"))
}

fn floor_edits(parent: Node, edits: &mut Vec<Edit>) {
    for node in parent.children().filter(Node::is_element) {
        match class_of(node) {
            // A hole and a window are in the floor itself.
            Some(Class::Saucer) => {}
            Some(Class::Insert) => edits.push(unlit(node)),
            Some(_) => edits.push((node.range(), String::new())),
            None if is_plastics(node) => edits.push((node.range(), String::new())),
            None => floor_edits(node, edits),
        }
    }
}

fn tops_edits(parent: Node, edits: &mut Vec<Edit>) {
    for node in parent.children().filter(Node::is_element) {
        let plastic = |node: Node| class_of(node) == Some(Class::Plastic);
        let resource = !matches!(node.tag_name().name(), "g" | "a" | "svg" | "switch") && is_resource(node);
        if resource || plastic(node) {
            continue;
        }
        if is_plastics(node) {
            cut_things(node, edits);
        } else if class_of(node).is_none() && node.descendants().any(|inner| is_plastics(inner) || plastic(inner)) {
            tops_edits(node, edits);
        } else {
            edits.push((node.range(), String::new()));
        }
    }
}

/// Art among the plastics stays; a lamp or a post that was drawn among them is no art.
fn cut_things(parent: Node, edits: &mut Vec<Edit>) {
    for node in parent.children().filter(Node::is_element) {
        match class_of(node) {
            Some(Class::Plastic) => {}
            Some(_) => edits.push((node.range(), String::new())),
            None => cut_things(node, edits),
        }
    }
}

/// Elements that draw nothing where they stand but may be needed by what does.
fn is_resource(node: Node) -> bool {
    matches!(
        node.tag_name().name(),
        "defs"
            | "style"
            | "linearGradient"
            | "radialGradient"
            | "pattern"
            | "clipPath"
            | "mask"
            | "filter"
            | "symbol"
            | "marker"
    )
}

/// Properties that decide how a window looks, which its state decides instead.
const LOOKS: [&str; 13] = [
    "style",
    "class",
    "fill",
    "fill-opacity",
    "fill-rule",
    "stroke",
    "stroke-width",
    "stroke-opacity",
    "stroke-dasharray",
    "opacity",
    "filter",
    "mask",
    "paint-order",
];

/// A window with no light behind it: a dark, translucent version of its colour with an engraved line round it.
fn unlit(node: Node) -> Edit {
    let name = node.tag_name().name();
    let mut tag = format!("<{name}");
    let kept = node.attributes().filter(|attribute| {
        attribute.namespace().is_none() && !LOOKS.contains(&attribute.name()) && !attribute.name().starts_with("data-")
    });
    for attribute in kept {
        let _ = write!(tag, " {}=\"{}\"", attribute.name(), escaped(attribute.value()));
    }
    let [red, green, blue] = match style::fill(node) {
        Ok(style::Paint::Color(color)) => color.map(|channel| (f32::from(channel) * UNLIT) as u8 + 4),
        _ => [24; 3],
    };
    let _ = write!(
        tag,
        " style=\"fill:#{red:02x}{green:02x}{blue:02x};fill-opacity:.9;fill-rule:evenodd;stroke:#000;\
         stroke-opacity:.6;stroke-width:{}\"/>",
        ENGRAVED_MM / scale(node)
    );
    (node.range(), tag)
}

/// How much the transforms of an element and its ancestors enlarge it; things have only such that do it uniformly.
fn scale(node: Node) -> f64 {
    let transforms: Vec<&str> = node.ancestors().filter_map(|node| node.attribute("transform")).collect();
    let place = transforms.iter().rev().try_fold(Place::TABLE, |place, transform| place.transformed(transform));
    place.and_then(|place| place.scale()).unwrap_or(1.0)
}

/// How bright a window's colour is with no light behind it.
const UNLIT: f32 = 0.22;
/// The width of the line round a window, mm.
const ENGRAVED_MM: f64 = 0.8;

fn escaped(value: &str) -> String {
    value.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|(range, _)| range.start);
    let mut result = String::with_capacity(text.len());
    let mut from = 0;
    for (range, new) in edits {
        result.push_str(&text[from..range.start]);
        result.push_str(&new);
        from = range.end;
    }
    result.push_str(&text[from..]);
    result
}
