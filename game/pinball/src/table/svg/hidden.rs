//! Hidden things: what a sheet takes off the table, far from where it is drawn, and layers with things that are switched off.

use super::clones::Holders;
use super::drawing::is_thing;
use super::references::{Links, is_use};
use super::written_out::is_container;
use super::{css, style};

use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};
use std::collections::BTreeSet;

/// The namespace of Inkscape's own words.
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

/// Warns of the first element with things in it of which a sheet says `display: none`, and of each group with things that
/// says so itself. Where a single thing says so it is meant.
pub(super) fn warnings<'d>(
    source: &Source,
    document: &Document,
    (links, holders): (&Links, &Holders),
    style_of: impl Fn(Node) -> Option<&'d str>,
) -> Vec<Diagnostic> {
    let by_sheet = by_sheet(source, document, holders, style_of);
    by_sheet.into_iter().chain(by_themselves(source, document, links, holders)).collect()
}

fn by_sheet<'d>(
    source: &Source,
    document: &Document,
    holders: &Holders,
    style_of: impl Fn(Node) -> Option<&'d str>,
) -> Option<Diagnostic> {
    let is_none = |style: &str| {
        css::style_declarations(style)
            .rev()
            .find(|(name, _)| *name == "display")
            .is_some_and(|(_, value)| value == "none")
    };
    let by_sheet = |node: &Node| holders.has(*node) && !is_off(node) && style_of(*node).is_some_and(is_none);
    let mut hidden = document.descendants().filter(by_sheet);
    let first = hidden.next()?;
    let name = first.tag_name().name();
    let what = match first.descendants().filter(|node| is_thing(*node)).count() {
        _ if is_thing(first) => "it is not on the table".to_string(),
        0 | 1 => "what is in it is not on the table".to_string(),
        things => format!("the {things} things in it are not on the table"),
    };
    let more = match hidden.count() {
        0 => String::new(),
        more => format!(" (so it is with {more} more)"),
    };
    let what = format!("a sheet says `display: none` of this {name}, so {what}{more}");
    Some(source.diagnostic(first.range().start, what).into_warning())
}

fn is_off(node: &Node) -> bool {
    style::own_property(*node, "display") == Some("none")
}

/// The groups with things that are switched off; what clones are made from is a template.
fn by_themselves(source: &Source, document: &Document, links: &Links, holders: &Holders) -> Vec<Diagnostic> {
    let uses = document.descendants().filter(|node| is_use(*node));
    let templates: BTreeSet<usize> =
        uses.filter_map(|node| links.target(node)).map(|node| node.id().get_usize()).collect();
    let is_own = |node: &Node| {
        let is_thing = is_thing(*node) || is_use(*node) && holders.has(*node);
        is_thing && !node.ancestors().any(|around| templates.contains(&around.id().get_usize()))
    };
    let is_drawn = |node: &Node| node.ancestors().skip(1).filter(Node::is_element).all(is_container);
    let off = |node: &Node| is_container(*node) && is_off(node) && is_drawn(node);
    let outermost = document.descendants().filter(off).filter(|node| !node.ancestors().skip(1).any(|one| is_off(&one)));
    let told = outermost.filter_map(|group| {
        let things = match group.descendants().filter(is_own).count() {
            0 => return None,
            1 => "the thing in it is".to_string(),
            things => format!("the {things} things in it are"),
        };
        let is_layer = group.attribute((INKSCAPE, "groupmode")) == Some("layer");
        let word = if is_layer { "layer" } else { group.tag_name().name() };
        let label = group.attribute((INKSCAPE, "label")).or(group.attribute("id"));
        let label = label.map_or_else(String::new, |label| format!(" `{label}`"));
        let what = format!(
            "this {word}{label} is hidden (`display: none`), so {things} not on the table; show it, or delete it"
        );
        Some(source.diagnostic(group.range().start, what).into_warning())
    });
    told.collect()
}
