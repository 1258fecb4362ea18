//! References: what an element of a drawing refers to, and how often it draws that.

use super::css;
use super::page::SVG;
use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// XLink's namespace, where SVG 1.1 has its `href`.
pub(in crate::table) const XLINK: &str = "http://www.w3.org/1999/xlink";

/// How often an element draws what it refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::table) enum Times {
    /// Once, as if it stood there.
    AsOwn,
    /// Once, for itself.
    Once,
    /// For each shape in it: paint is inherited.
    EachShape,
    /// For each corner of each shape in it.
    EachCorner,
}

impl Times {
    /// Whether an element of this name can be meant: paint is a gradient or a pattern, and a corner's is a marker.
    fn may_mean(self, element: &str) -> bool {
        match self {
            Times::AsOwn | Times::Once => true,
            Times::EachShape => matches!(element, "linearGradient" | "radialGradient" | "pattern"),
            Times::EachCorner => element == "marker",
        }
    }
}

/// A reference by id.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::table) struct Reference<'a> {
    pub times: Times,
    pub id: &'a str,
}

/// The elements of a drawing by their ids.
pub(in crate::table) struct Links<'a, 'i> {
    /// The first and the last element of an id: of two, readers of SVG mean either.
    by_id: BTreeMap<&'a str, [Node<'a, 'i>; 2]>,
}

impl<'a, 'i> Links<'a, 'i> {
    /// Those of a drawing.
    pub fn of(document: &'a Document<'i>) -> Links<'a, 'i> {
        let mut by_id: BTreeMap<&str, [Node; 2]> = BTreeMap::new();
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                by_id.entry(id).or_insert([node; 2])[1] = node;
            }
        }
        Links { by_id }
    }

    /// The first element with this id.
    pub fn named(&self, id: &str) -> Option<Node<'a, 'i>> {
        self.by_id.get(id).map(|[first, _]| *first)
    }

    /// What the element's `href` names, if it names something in the drawing.
    pub fn target(&self, node: Node) -> Option<Node<'a, 'i>> {
        self.named(href_id(node)?)
    }

    /// The elements that a reference may mean: several where an id is there twice, as a gradient and the group in it.
    pub fn find(&self, reference: Reference) -> impl Iterator<Item = Node<'a, 'i>> + use<'a, 'i> {
        let [first, last] = self.by_id.get(reference.id).copied().map_or([None; 2], |found| found.map(Some));
        let both = first.into_iter().chain(last.filter(|last| Some(*last) != first));
        both.filter(move |node| reference.times.may_mean(node.tag_name().name()))
    }
}

/// What an element refers to; `style` is what is declared for it. What stands in for the element's own content comes
/// first: what is inherited is counted for it too.
pub(in crate::table) fn references<'a>(node: Node<'a, '_>, style: &'a str) -> Vec<Reference<'a>> {
    let mut found: Vec<Reference> = drawn_by_href(node).into_iter().collect();
    let attributes = node.attributes().map(|attribute| (attribute.name(), attribute.value()));
    for (name, value) in attributes.chain(css::style_declarations(style)) {
        if let Some(times) = times_of(name) {
            found.extend(urls(value).map(|id| Reference { times, id }));
        }
    }
    found
}

/// How often what a property names is drawn; `None` of a property that names nothing.
fn times_of(property: &str) -> Option<Times> {
    match property {
        "clip-path" | "mask" | "filter" => Some(Times::Once),
        "fill" | "stroke" => Some(Times::EachShape),
        "marker" | "marker-start" | "marker-mid" | "marker-end" => Some(Times::EachCorner),
        _ => None,
    }
}

/// Whether a property names elements.
pub(in crate::table) fn is_link(property: &str) -> bool {
    times_of(property).is_some()
}

/// What an element draws with by its `href`; that of an `<a>` says where a click would lead.
pub(in crate::table) fn drawn_by_href<'a>(node: Node<'a, '_>) -> Option<Reference<'a>> {
    let times = match node.tag_name().name() {
        "use" => Times::AsOwn,
        "textPath" | "tref" | "feImage" | "linearGradient" | "radialGradient" | "pattern" | "filter" => Times::Once,
        _ => return None,
    };
    Some(Reference { times, id: href_id(node)? })
}

/// An element's `href`, the newer form before the older.
pub(in crate::table) fn href<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    plain_href(node).or_else(|| node.attribute((XLINK, "href")))
}

/// An element's `href` in the newer form. Without a namespace the library would take one of any.
pub(in crate::table) fn plain_href<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    let mut attributes = node.attributes();
    let plain = attributes.find(|attribute| attribute.namespace().is_none() && attribute.name() == "href");
    plain.map(|attribute| attribute.value())
}

/// The id that an element's `href` names.
pub(in crate::table) fn href_id<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    href(node)?.trim().strip_prefix('#')
}

/// Whether an element is a `<use>`.
pub(in crate::table) fn is_use(node: Node) -> bool {
    node.has_tag_name((SVG, "use"))
}

/// The ids in the `url(#id)` of a text.
pub(in crate::table) fn urls(text: &str) -> impl Iterator<Item = &str> {
    text.split("url(").skip(1).filter_map(|rest| {
        let inside = rest[..rest.find(')')?].trim();
        inside.trim_matches(['"', '\'']).trim().strip_prefix('#')
    })
}
