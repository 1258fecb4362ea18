//! References: what an element of a drawing refers to, by attributes, by its style and by style sheets.
//!
//! Sheets are read with the same library with which the art's own library reads them.

use resvg::usvg::roxmltree::{Document, Node};
use simplecss::{AttributeOperator, DeclarationTokenizer, PseudoClass, StyleSheet};
use std::collections::BTreeMap;

/// How often an element draws what it refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Times {
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
pub(super) struct Reference<'a> {
    pub times: Times,
    pub id: &'a str,
}

/// The sheets of a drawing, and where its ids are.
pub(super) struct References<'a, 'input> {
    sheet: StyleSheet<'a>,
    /// The first and the last element of an id: either may be meant.
    ids: BTreeMap<&'a str, [Node<'a, 'input>; 2]>,
}

impl<'a, 'input> References<'a, 'input> {
    pub fn new(document: &'a Document<'input>) -> References<'a, 'input> {
        let mut sheet = StyleSheet::new();
        sheets(document).for_each(|text| sheet.parse_more(text));
        let mut ids: BTreeMap<&str, [Node; 2]> = BTreeMap::new();
        for node in document.descendants().filter(Node::is_element) {
            if let Some(id) = node.attribute("id") {
                ids.entry(id).or_insert([node; 2])[1] = node;
            }
        }
        References { sheet, ids }
    }

    /// The elements that a reference may mean: several where an id is there twice, as a gradient and the group in it.
    pub fn find(&self, reference: Reference) -> impl Iterator<Item = Node<'a, 'input>> + use<'a, 'input> {
        let [first, last] = self.ids.get(reference.id).copied().map_or([None; 2], |found| found.map(Some));
        let both = first.into_iter().chain(last.filter(|last| Some(*last) != first));
        both.filter(move |node| reference.times.may_mean(node.tag_name().name()))
    }

    /// How many comparisons the sheets take for each element, where elements lie up to `depth` deep: a selector of
    /// several words tries every way up.
    pub fn comparisons(&self, depth: f64) -> f64 {
        let words = |text: String| text.split_whitespace().filter(|word| !matches!(*word, ">" | "+")).count();
        self.sheet.rules.iter().map(|rule| depth.powi(words(rule.selector.to_string()) as i32 - 1)).sum()
    }

    /// What an element refers to.
    pub fn of(&self, node: Node<'a, 'input>) -> Vec<Reference<'a>> {
        // What stands in for the element's own content comes first: what is inherited is counted for it too.
        let mut found: Vec<Reference> = href(node).into_iter().collect();
        let mut add = |name: &str, value: &'a str| {
            if let Some(times) = times_of(name) {
                found.extend(urls(value).map(|id| Reference { times, id }));
            }
        };
        node.attributes().for_each(|attribute| add(attribute.name(), attribute.value()));
        if let Some(style) = node.attribute("style") {
            DeclarationTokenizer::from(style).for_each(|declaration| add(declaration.name, declaration.value));
        }
        for rule in &self.sheet.rules {
            let mut declarations = rule.declarations.iter().filter(|own| own.value.contains("url(")).peekable();
            if declarations.peek().is_some() && rule.selector.matches(&Styled(node)) {
                declarations.for_each(|declaration| add(declaration.name, declaration.value));
            }
        }
        found
    }
}

/// The texts of a drawing's style sheets.
pub(super) fn sheets<'a>(document: &'a Document) -> impl Iterator<Item = &'a str> {
    let styles = document.descendants().filter(|node| node.is_element() && node.tag_name().name() == "style");
    styles.flat_map(|style| style.children()).filter_map(|text| text.text())
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

/// The ids in `url(#id)`.
fn urls(value: &str) -> impl Iterator<Item = &str> {
    value.split("url(").skip(1).filter_map(|rest| {
        let address = rest.split(')').next()?.trim().trim_matches(['\'', '"']);
        address.trim().strip_prefix('#')
    })
}

fn href<'a>(node: Node<'a, '_>) -> Option<Reference<'a>> {
    let times = match node.tag_name().name() {
        "use" => Times::AsOwn,
        "textPath" | "tref" | "feImage" | "linearGradient" | "radialGradient" | "pattern" | "filter" => Times::Once,
        _ => return None,
    };
    let address = node.attributes().find(|attribute| attribute.name() == "href")?.value();
    Some(Reference { times, id: address.trim().strip_prefix('#')? })
}

/// An element as selectors see it.
struct Styled<'a, 'input>(Node<'a, 'input>);

impl simplecss::Element for Styled<'_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Styled)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Styled)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, name: &str, operator: AttributeOperator) -> bool {
        self.0.attribute(name).is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass) -> bool {
        class == PseudoClass::FirstChild && self.0.prev_sibling_element().is_none()
    }
}
