//! Layers: the art of a drawing, cut apart: what is printed on the floor, what is printed on plastics and caps, which of
//! both is wood, and how high the floor is.
//!
//! The text is cut by byte range and everything else is left as it was, so the art stays what its maker wrote: its
//! gradients, its sheets, its transforms, and the lines on which they stand.

use super::drawing::element_class;
use super::element_class::ElementClass;
use super::style;
use super::transform::Transform;
use roxmltree::{Document, Node};
use std::fmt::Write;
use std::ops::Range;

/// Text to put in the place of a range of bytes.
type Edit = (Range<usize>, String);

/// The layers of a drawing, each a well-formed SVG whose size is the `viewBox`.
pub(super) struct Layers {
    /// What is printed on the floor.
    pub floor: String,
    /// What is printed on plastics and caps.
    pub tops: String,
    /// Grey that is height, if there is any.
    pub height: Option<String>,
    /// What of the floor's art is wood, if anything is.
    pub wood: Option<String>,
    /// What of the plastics' art is wood, if anything is.
    pub tops_wood: Option<String>,
}

/// The layers of a drawing.
pub(super) fn split_layers(text: &str, document: &Document) -> Layers {
    let root = document.root_element();
    let with = |cut: &dyn Fn(&mut Vec<Edit>)| {
        let mut edits = root_size(root);
        cut(&mut edits);
        edited(text, edits)
    };
    let only = |layer: Layer| with(&|edits| keep_only(root, layer, edits));
    let some = |layer: Layer| root.descendants().any(|node| layer.holds(node)).then(|| only(layer));
    Layers {
        floor: with(&|edits| floor_edits(root, edits)),
        tops: only(Layer::Tops),
        height: some(Layer::Height),
        wood: some(Layer::Wood),
        tops_wood: some(Layer::TopsWood),
    }
}

/// A layer whose elements are marked as such.
#[derive(Clone, Copy, PartialEq)]
enum Layer {
    Tops,
    Height,
    Wood,
    TopsWood,
}

impl Layer {
    /// Whether an element and what is in it belong to this layer.
    fn holds(self, node: Node) -> bool {
        match self {
            Layer::Tops => is_top(node),
            Layer::Height => is(node, "relief"),
            Layer::Wood => is(node, "wood") && !node.ancestors().any(is_top),
            Layer::TopsWood => is(node, "wood") && node.ancestors().any(is_top),
        }
    }

    /// Whether an element inside this layer is printed nevertheless elsewhere, or nowhere.
    fn refuses(self, node: Node) -> bool {
        let above = matches!(self, Layer::Tops | Layer::TopsWood);
        match element_class(node) {
            Some(class) => !(above && class == ElementClass::Plastic),
            None => (is(node, "relief") && self != Layer::Height) || (is(node, "plastics") && !above),
        }
    }
}

fn is(node: Node, word: &str) -> bool {
    node.attribute("class").is_some_and(|class| class.split_ascii_whitespace().any(|other| other == word))
}

/// Plastics and what is printed on them.
fn is_top(node: Node) -> bool {
    is(node, "plastics") || element_class(node) == Some(ElementClass::Plastic)
}

/// The page's size in print has no meaning here: one unit is one millimetre.
fn root_size(root: Node) -> Vec<Edit> {
    let printed = |name: &str| matches!(name, "width" | "height" | "preserveAspectRatio" | "x" | "y");
    let attributes = root.attributes().filter(|attribute| attribute.namespace().is_none() && printed(attribute.name()));
    attributes.map(|attribute| (attribute.range(), String::new())).collect()
}

fn floor_edits(parent: Node, edits: &mut Vec<Edit>) {
    for node in parent.children().filter(Node::is_element) {
        match element_class(node) {
            // A hole and a window are in the floor itself.
            Some(ElementClass::Saucer) => {}
            Some(ElementClass::Insert) => edits.push(unlit(node)),
            Some(_) => edits.push((node.range(), String::new())),
            None if is(node, "plastics") || is(node, "relief") => edits.push((node.range(), String::new())),
            None => floor_edits(node, edits),
        }
    }
}

fn keep_only(parent: Node, layer: Layer, edits: &mut Vec<Edit>) {
    for node in parent.children().filter(Node::is_element) {
        if is_resource(node) {
            continue;
        }
        if layer.holds(node) {
            cut_strangers(node, layer, edits);
        } else if element_class(node).is_none() && node.descendants().any(|inner| layer.holds(inner)) {
            keep_only(node, layer, edits);
        } else {
            edits.push((node.range(), String::new()));
        }
    }
}

/// Art in a layer stays; a lamp or a post that was drawn in it is no art.
fn cut_strangers(parent: Node, layer: Layer, edits: &mut Vec<Edit>) {
    for node in parent.children().filter(Node::is_element) {
        if layer.refuses(node) {
            edits.push((node.range(), String::new()));
        } else {
            cut_strangers(node, layer, edits);
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

/// How much the transforms of an element and its ancestors enlarge it; elements have only such that do it uniformly.
fn scale(node: Node) -> f64 {
    let transforms: Vec<&str> = node.ancestors().filter_map(|node| node.attribute("transform")).collect();
    let transform =
        transforms.iter().rev().try_fold(Transform::IDENTITY, |transform, attribute| transform.transformed(attribute));
    transform.and_then(|transform| transform.scale()).unwrap_or(1.0)
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
        let lines = |text: &str| text.matches('\n').count();
        result.extend(std::iter::repeat_n('\n', lines(&text[range.clone()]).saturating_sub(lines(&new))));
        from = range.end;
    }
    result.push_str(&text[from..]);
    result
}
