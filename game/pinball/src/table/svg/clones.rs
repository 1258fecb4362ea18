//! Clones: a `<use>` of things, written out as what it draws, so that its things are things and its art is art.
//!
//! A clone is a group with what the `<use>` says and a copy of what it names inside (SVG 2, 5.6): its transform first,
//! then its place, styles inherited from where it stands.

use super::css::{self, Cascade, Instance};
use super::drawing::{element_class, is_thing};
use super::page::SVG;
use super::references::{Links, href, is_use, plain_href};
use super::text_edit::{escaped, prefix};
use super::transform::Transform;
use super::{style, viewport};
use roxmltree::{Document, Node, NodeId};
use std::collections::BTreeSet;
use std::fmt::Write;

/// XML's own namespace: `xml:space`.
pub(in crate::table) const XML: &str = "http://www.w3.org/XML/1998/namespace";
/// What of a `<use>` is no attribute of the group in its place.
const OF_USE: [&str; 6] = ["x", "y", "width", "height", "href", "transform"];
/// What of an `<svg>` or a `<symbol>` is no attribute of the group in its place.
const OF_VIEWPORT: [&str; 9] =
    ["x", "y", "width", "height", "viewBox", "preserveAspectRatio", "transform", "overflow", "version"];
/// Elements that draw nothing and say nothing about what is drawn.
const SILENT: [&str; 5] = ["style", "script", "title", "desc", "metadata"];

/// Which elements hold things, in themselves or in what they `<use>`, by their numbers in the document.
pub(in crate::table) struct Holders {
    holds: Vec<bool>,
}

impl Holders {
    /// Those of a drawing whose references have no circles.
    pub fn of(document: &Document, links: &Links) -> Holders {
        let mut known = vec![None; document.descendants().count()];
        for node in document.descendants() {
            holds_things(node, links, &mut known);
        }
        Holders { holds: known.into_iter().map(|holds| holds == Some(true)).collect() }
    }

    /// Whether an element is a thing, or one is in it or in what it uses.
    pub fn has(&self, node: Node) -> bool {
        self.holds[node.id().get_usize()]
    }
}

fn holds_things(node: Node, links: &Links, known: &mut [Option<bool>]) -> bool {
    let number = node.id().get_usize();
    if let Some(holds) = known[number] {
        return holds;
    }
    let target = links.target(node).filter(|_| is_use(node));
    let holds = is_thing(node)
        || target.is_some_and(|target| holds_things(target, links, known))
        || node.children().any(|child| holds_things(child, links, known));
    known[number] = Some(holds);
    holds
}

/// Writes clones.
pub(in crate::table) struct Cloner<'c, 'a, 'i> {
    pub text: &'i str,
    pub links: &'c Links<'a, 'i>,
    pub holders: &'c Holders,
    pub cascade: &'c mut Cascade,
    /// What has been copied.
    pub copied: BTreeSet<usize>,
    /// What of the last copies rules could name if the clone had an id.
    pub unnamed: Vec<String>,
}

/// A copy that is being written.
struct Copy<'p> {
    /// What its `<use>` names.
    root: Option<NodeId>,
    /// The clone's id: what is in it is called CLONE-ID.
    id: Option<String>,
    /// Of the names of elements where it is written.
    prefix: &'p str,
}

impl Copy<'_> {
    /// What the copy of an element is called.
    fn name(&self, node: Node) -> Option<String> {
        match (self.root == Some(node.id()), &self.id, node.attribute("id")) {
            (true, id, _) => id.clone(),
            (false, Some(id), Some(own)) => Some(format!("{id}-{own}")),
            _ => None,
        }
    }
}

impl Cloner<'_, '_, '_> {
    /// What a `<use>` of things draws, as text.
    ///
    /// # Errors
    /// If its place is no plain number.
    pub fn clone_of(&mut self, node: Node) -> Result<String, String> {
        let copy = Copy { root: None, id: node.attribute("id").map(str::to_string), prefix: prefix(self.text, node) };
        let mut out = String::new();
        self.user(node, &copy, copy.id.clone(), &mut out)?;
        Ok(out)
    }

    /// A `<use>`, as it stands or in the copy that another makes; its clone is called `id`.
    fn user(&mut self, node: Node, around: &Copy, id: Option<String>, out: &mut String) -> Result<(), String> {
        let Some(target) = self.links.target(node) else { return Ok(()) };
        // What is written out is a group, and its maker knows of none.
        let transform = node.attribute("transform").unwrap_or("");
        Transform::scaling(1.0).transformed(transform).map_err(|why| format!("of this use: {why}"))?;
        let number = |name: &str| node.attribute(name).map_or(Ok(0.0), |text| style::length(node, text, name));
        let (x, y) = (number("x")?, number("y")?);
        let place = if x == 0.0 && y == 0.0 { String::new() } else { format!("translate({x} {y})") };
        let copy = Copy { root: Some(target.id()), id, prefix: around.prefix };
        self.open("g", node, around, &OF_USE, &[transform, &place], out);
        if matches!(target.tag_name().name(), "svg" | "symbol") {
            let inner = viewport::transform(target, Some(node))?;
            self.open("g", target, &copy, &OF_VIEWPORT, &[target.attribute("transform").unwrap_or(""), &inner], out);
            self.inside(target, &copy, out)?;
            let _ = write!(out, "</{}g>", copy.prefix);
        } else {
            self.element(target, &copy, out)?;
        }
        let _ = write!(out, "</{}g>", around.prefix);
        Ok(())
    }

    fn inside(&mut self, node: Node, copy: &Copy, out: &mut String) -> Result<(), String> {
        for child in node.children() {
            if child.is_element() {
                self.element(child, copy, out)?;
            } else if child.is_text() {
                out.push_str(&escaped(child.text().unwrap_or("")).replace('>', "&gt;"));
            }
        }
        Ok(())
    }

    fn element(&mut self, node: Node, copy: &Copy, out: &mut String) -> Result<(), String> {
        let name = node.tag_name().name();
        if node.tag_name().namespace() != Some(SVG) || SILENT.contains(&name) {
            return Ok(());
        }
        self.copied.insert(node.id().get_usize());
        if is_use(node) && self.holders.has(node) {
            return self.user(node, copy, copy.name(node), out);
        }
        let transform = [node.attribute("transform").unwrap_or("")];
        self.open(name, node, copy, &["transform"], &transform, out);
        self.inside(node, copy, out)?;
        let _ = write!(out, "</{}{name}>", copy.prefix);
        Ok(())
    }

    /// A tag with the attributes of an element but for some, and with these transforms.
    fn open(&mut self, name: &str, node: Node, copy: &Copy, without: &[&str], transforms: &[&str], out: &mut String) {
        let _ = write!(out, "<{}{name}", copy.prefix);
        let mut add = |name: &str, value: &str| {
            if !value.is_empty() {
                let _ = write!(out, " {name}=\"{}\"", escaped(value));
            }
        };
        // Two elements with one id would be one too many; only things are asked for by name.
        if let Some(class) = element_class(node) {
            let own = copy.name(node);
            add("id", own.as_deref().unwrap_or_default());
            let wanted = node.attribute("id").filter(|_| own.is_none() && class.needs_id());
            self.unnamed.extend(wanted.map(str::to_string));
        }
        let instance = Instance { node, root: copy.root };
        let style = self.cascade.style(instance);
        add("style", style.as_deref().or_else(|| node.attribute("style")).unwrap_or(""));
        add("transform", transforms.join(" ").trim());
        for attribute in node.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            let own = attribute.namespace().is_none() && !matches!(name, "id" | "style") && !without.contains(&name);
            if own {
                let renamed = self.renamed(name, value, copy);
                add(name, renamed.or_else(|| css::plain_attribute(name, value)).as_deref().unwrap_or(value));
            } else if attribute.namespace() == Some(XML) {
                add(&format!("xml:{name}"), value);
            }
        }
        if !without.contains(&"href") && plain_href(node).is_none() {
            add("href", href(node).unwrap_or(""));
        }
        out.push('>');
    }

    /// A name in a copy that means something else than in the original: a bumper in the same copy, a group of its own.
    fn renamed(&self, name: &str, value: &str, copy: &Copy) -> Option<String> {
        match name {
            "data-inside" => {
                let target = self.links.named(value)?;
                let is_copied = target.ancestors().any(|outer| copy.root == Some(outer.id()));
                copy.name(target).filter(|_| is_copied)
            }
            "data-group" => copy.id.as_ref().filter(|_| copy.root.is_some()).map(|id| format!("{id}-{value}")),
            _ => None,
        }
    }
}
