//! Oddities of a drawing that a browser passes over in silence, and that no maker means: properties that are none, references
//! to nothing, ids that are given twice, text that nobody draws.

use super::drawing::element_class;
use super::page::SVG;
use super::references::{self, Links, href, is_use, urls};
use super::sheet_values::READ;
use super::{art_shapes, css, paint_servers};
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};
use std::collections::{BTreeMap, BTreeSet};

/// Warns of what is odd in a drawing; `style_of` knows what is declared for an element.
pub(in crate::table) fn warnings<'d>(
    source: &Source,
    document: &'d Document,
    links: &'d Links<'d, 'd>,
    style_of: impl Fn(Node) -> Option<&'d str>,
) -> Vec<Diagnostic> {
    let mut reader = Reader { source, links, told: BTreeSet::new(), names: BTreeSet::new(), found: Vec::new() };
    for node in drawn(document) {
        let style = style_of(node).or_else(|| node.attribute("style")).unwrap_or("");
        reader.properties(node);
        reader.colors(node);
        reader.values(node);
        reader.references(node, style);
        reader.link(node);
        reader.size(node, style);
        if node.has_tag_name((SVG, "flowRoot")) {
            reader.tell(node, "`flowRoot` is text that only an old Inkscape draws; make plain text of it");
        }
    }
    reader.found.extend(given_twice(source, document));
    reader.found.extend(paint_servers::warnings(source, document, links, &style_of));
    reader.found.extend(art_shapes::warnings(source, document, &style_of));
    reader.found.into_iter().map(Diagnostic::into_warning).collect()
}

fn drawn<'a, 'i>(document: &'a Document<'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    document.descendants().filter(|node| node.tag_name().namespace() == Some(SVG))
}

struct Reader<'d> {
    source: &'d Source,
    links: &'d Links<'d, 'd>,
    /// Properties that name what is not there, and what.
    told: BTreeSet<(String, String)>,
    /// Properties that were looked at.
    names: BTreeSet<String>,
    found: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn tell(&mut self, node: Node, what: impl std::fmt::Display) {
        self.found.push(self.source.diagnostic(node.range().start, what));
    }

    /// Tells what is nearly a property, each once.
    fn properties(&mut self, node: Node) {
        self.unread_style(node);
        let line = self.source.line(node.range().start);
        for name in css::own_properties(node) {
            if !self.names.contains(name.as_ref()) {
                self.found.extend(css::misspelt(self.source, line, &name));
                self.names.insert(name.into_owned());
            }
        }
    }

    /// Tells colours that are none, each once. What a thing is read from is a mistake, and told elsewhere.
    fn colors(&mut self, node: Node) {
        let name = node.tag_name().name();
        // Of an animation `fill` says what comes behind it.
        if name.starts_with("animate") || name == "set" {
            return;
        }
        for (property, value) in css::wrong_colors(node) {
            let is_told = READ.contains(&&*property) && css::is_read_alone(node, &property);
            if (is_told && element_class(node).is_some()) || !self.told.insert((property.clone(), value.clone())) {
                continue;
            }
            let what = format!(
                "the {property} of this {name} is `{value}`, which is no colour, so a browser passes over it; write it as \"#rrggbb\""
            );
            self.tell(node, what);
        }
    }

    /// Tells other values that nobody reads, each once.
    fn values(&mut self, node: Node) {
        let name = node.tag_name().name();
        // Of a typeface a weight is a range.
        if name == "font-face" || name.starts_with("animate") || name == "set" {
            return;
        }
        for (property, value, hint) in css::unread_values(node) {
            let is_told = READ.contains(&&*property) && element_class(node).is_some();
            if !is_told && self.told.insert((property.clone(), value.clone())) {
                self.tell(node, format!("the {property} of this {name} is `{value}`, which is not read; {hint}"));
            }
        }
    }

    /// Tells what in a style is no declaration, each once.
    fn unread_style(&mut self, node: Node) {
        for (begin, warning) in css::unread_style(self.source, node) {
            if self.names.insert(begin) {
                self.found.push(warning);
            }
        }
    }

    /// Tells which gradients, filters and their like are not there, each once.
    fn references(&mut self, node: Node, style: &str) {
        let own = node.attributes().filter(|attribute| attribute.namespace().is_none());
        let attributes = own.map(|attribute| (attribute.name(), attribute.value()));
        for (name, value) in attributes.chain(css::style_declarations(style)) {
            let is_paint = matches!(name, "fill" | "stroke");
            let has_choice = is_paint && !value.trim_end().ends_with(')');
            if !references::is_link(name) || has_choice {
                continue;
            }
            self.hashless(node, (name, value), is_paint);
            for id in urls(value) {
                if self.links.named(id).is_some() || !self.told.insert((name.to_string(), id.to_string())) {
                    continue;
                }
                let so = if is_paint { "nothing is painted" } else { "it is not drawn as it is meant" };
                let element = node.tag_name().name();
                let what = format!("the {name} of this {element} is `#{id}`, which is not in the drawing, so {so}");
                self.tell(node, what);
            }
        }
    }

    /// Tells a `url()` that names an element without its `#`.
    fn hashless(&mut self, node: Node, (name, value): (&str, &str), is_paint: bool) {
        let Some(inside) = value.trim().strip_prefix("url(").and_then(|rest| rest.split(')').next()) else { return };
        let id = inside.trim().trim_matches(['"', '\'']).trim();
        if id.contains('#') || id.is_empty() || !self.told.insert((name.to_string(), value.to_string())) {
            return;
        }
        let so = if is_paint { "nothing is painted" } else { "it is not drawn as it is meant" };
        let meant = if self.links.named(id).is_some() { id } else { "ID" };
        let element = node.tag_name().name();
        let what =
            format!("the {name} of this {element} is `{value}`, which names a file, so {so}; write url(#{meant})");
        self.tell(node, what);
    }

    /// Tells art that lacks what no maker leaves out; of a thing it is a mistake, and told elsewhere.
    fn size(&mut self, node: Node, style: &str) {
        let name = node.tag_name().name();
        let (wanted, so): (&[&str], _) = match name {
            "circle" => (&["r"], "draws nothing"),
            "rect" => (&["width", "height"], "draws nothing"),
            "line" => (&["x2", "y2"], "ends at 0 0"),
            _ => return,
        };
        let declared = |word: &str| css::style_declarations(style).any(|(name, _)| name == word);
        let lacks = |word: &&str| !node.has_attribute(*word) && !declared(word);
        let lacking: Vec<&str> = wanted.iter().copied().filter(lacks).collect();
        // Of a line one of them may be 0; what is inside a shape may move it.
        let is_short = lacking.len() == wanted.len() || (name == "rect" && !lacking.is_empty());
        if is_short && element_class(node).is_none() && node.first_element_child().is_none() {
            let missing = lacking.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" and no ");
            self.tell(node, format!("this {name} has no {missing}, so it {so}"));
        }
    }

    /// Tells an `href` that leads nowhere.
    fn link(&mut self, node: Node) {
        if self.links.target(node).is_some() {
            return;
        }
        let missing = |id: &str| format!("there is no `{id}` in the drawing");
        if is_use(node) {
            let what = href(node).map_or("it has no href".to_string(), missing);
            self.tell(node, format!("this <use> draws nothing: {what}"));
        } else if let Some(reference) = references::drawn_by_href(node) {
            let (element, what) = (node.tag_name().name(), missing(&format!("#{}", reference.id)));
            self.tell(node, format!("this {element} builds on nothing: {what}"));
        }
    }
}

/// The first of the ids that two elements have; what is told of two things is a mistake, and not told here.
fn given_twice(source: &Source, document: &Document) -> Option<Diagnostic> {
    let mut owners: BTreeMap<&str, Node> = BTreeMap::new();
    let mut twice: Vec<(Node, Node)> = Vec::new();
    for node in drawn(document) {
        let Some(id) = node.attribute("id").filter(|id| !id.is_empty()) else { continue };
        let owner = *owners.entry(id).or_insert(node);
        let is_told = element_class(owner).is_some() && element_class(node).is_some();
        if owner != node && !is_told {
            twice.push((owner, node));
        }
    }
    let ((owner, node), rest) = twice.split_first()?;
    let id = node.attribute("id").unwrap_or_default();
    let more = if rest.is_empty() { String::new() } else { format!(", and {} more are given twice", rest.len()) };
    let line = source.line(owner.range().start);
    let what = format!("the id `{id}` is already taken in line {line}{more}; give each element its own");
    Some(source.diagnostic(node.range().start, what))
}
