//! Layers: the art of a drawing, cut apart: what is printed on the floor, what is printed on plastics and caps, which of
//! both is wood, and how high the floor is.
//!
//! The text is cut by byte range and everything else is left as it was, so the art stays what its maker wrote: its
//! gradients, its filters, its transforms. What is cut out of a layer and is needed by something else becomes a
//! definition there.

use super::drawing::element_class;
use super::element_class::ElementClass;
use super::page::SVG;
use super::references::{href_id, urls};
use super::text_edit::{Edit, edited, escaped, prefix};
use super::transform::Transform;
use super::{style, viewport};
use roxmltree::{Document, Node};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The layers of a drawing, each a well-formed SVG whose size is the `viewBox`.
pub(in crate::table) struct Layers {
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

/// The layers of a drawing of this scale.
pub(in crate::table) fn split_layers(text: &str, document: &Document, mm_per_unit: f64) -> Layers {
    let root = document.root_element();
    let cutter = Cutter { text, mm_per_unit, needed: needed(document) };
    let with = |cut: &dyn Fn(&mut Vec<Edit>)| {
        let mut edits = root_size(root);
        cut(&mut edits);
        edited(text, edits)
    };
    let only = |layer: Layer| with(&|edits| cutter.keep_only(root, layer, edits));
    let some = |layer: Layer| root.descendants().any(|node| layer.holds(node)).then(|| only(layer));
    Layers {
        floor: with(&|edits| cutter.floor(root, edits)),
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

/// Where each id of a drawing is named by another element, bytes.
fn needed<'a>(document: &'a Document) -> BTreeMap<&'a str, Vec<usize>> {
    let mut needed: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for node in document.descendants().filter(Node::is_element) {
        let named = href_id(node);
        let painted = node.attributes().flat_map(|attribute| urls(attribute.value()));
        for id in named.into_iter().chain(painted) {
            needed.entry(id).or_default().push(node.range().start);
        }
    }
    needed
}

/// Cuts a drawing apart.
struct Cutter<'a> {
    text: &'a str,
    mm_per_unit: f64,
    needed: BTreeMap<&'a str, Vec<usize>>,
}

impl Cutter<'_> {
    fn floor(&self, parent: Node, edits: &mut Vec<Edit>) {
        for node in parent.children().filter(Node::is_element) {
            match element_class(node) {
                // A hole and a window are in the floor itself.
                Some(ElementClass::Saucer) => {}
                Some(ElementClass::Insert) => edits.push(self.unlit(node)),
                Some(_) => self.cut(node, edits),
                None if is(node, "plastics") || is(node, "relief") => self.cut(node, edits),
                None => self.floor(node, edits),
            }
        }
    }

    fn keep_only(&self, parent: Node, layer: Layer, edits: &mut Vec<Edit>) {
        for node in parent.children().filter(Node::is_element) {
            if is_resource(node) {
                continue;
            }
            if layer.holds(node) {
                self.cut_strangers(node, layer, edits);
            } else if element_class(node).is_none() && node.descendants().any(|inner| layer.holds(inner)) {
                self.keep_only(node, layer, edits);
            } else {
                self.cut(node, edits);
            }
        }
    }

    /// Art in a layer stays; a lamp or a post that was drawn in it is no art.
    fn cut_strangers(&self, parent: Node, layer: Layer, edits: &mut Vec<Edit>) {
        for node in parent.children().filter(Node::is_element) {
            if layer.refuses(node) {
                self.cut(node, edits);
            } else {
                self.cut_strangers(node, layer, edits);
            }
        }
    }

    /// Takes an element out, or makes a definition of it if something outside needs it: a gradient that is kept in
    /// the relief layer, a shape that art uses.
    fn cut(&self, node: Node, edits: &mut Vec<Edit>) {
        let range = node.range();
        let from_outside = |users: &Vec<usize>| users.iter().any(|user| !range.contains(user));
        let needed = |inner: Node| inner.attribute("id").and_then(|id| self.needed.get(id)).is_some_and(from_outside);
        if !node.descendants().any(needed) {
            return edits.push((range, String::new()));
        }
        let prefix = prefix(self.text, node);
        edits.push((range.start..range.start, format!("<{prefix}defs>")));
        edits.push((range.end..range.end, format!("</{prefix}defs>")));
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

impl Cutter<'_> {
    /// A window with no light behind it: a dark, translucent version of its colour with an engraved line round it.
    fn unlit(&self, node: Node) -> Edit {
        let name = node.tag_name().name();
        let mut tag = format!("<{}{name}", prefix(self.text, node));
        let kept = node.attributes().filter(|attribute| {
            let name = attribute.name();
            attribute.namespace().is_none() && !LOOKS.contains(&name) && !name.starts_with("data-")
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
            ENGRAVED_MM / self.scale(node)
        );
        (node.range(), tag)
    }

    /// How much the drawing, the transforms of an element and those around it enlarge it; elements have only such that
    /// do it uniformly.
    fn scale(&self, node: Node) -> f64 {
        let around: Vec<Node> = node.ancestors().filter(Node::is_element).collect();
        let transform = around.iter().rev().try_fold(Transform::scaling(self.mm_per_unit), |outer, one| {
            let outer = outer.transformed(one.attribute("transform").unwrap_or(""))?;
            let is_inner_svg = one.has_tag_name((SVG, "svg")) && one.parent_element().is_some();
            if is_inner_svg { outer.transformed(&viewport::transform(*one, None)?) } else { Ok(outer) }
        });
        transform.and_then(|transform| transform.scale()).unwrap_or(1.0)
    }
}

/// How bright a window's colour is with no light behind it.
const UNLIT: f32 = 0.22;
/// The width of the line round a window, mm.
const ENGRAVED_MM: f64 = 0.8;
