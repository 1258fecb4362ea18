//! Gradients and patterns that shapes are painted with, and that a reader of SVG passes over: a word that it does not know, no
//! colours, no size.

use super::css;
use super::page::SVG;
use super::references::{Links, drawn_by_href, urls};
use super::transform::Transform;
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};
use std::collections::BTreeSet;
use std::str::FromStr;

/// References from one paint to the next that are followed.
const MOST_LINKS: usize = 32;

/// Attributes of which a reader knows these words only.
const WORDS: [(&str, &[&str]); 4] = [
    ("gradientUnits", &["userSpaceOnUse", "objectBoundingBox"]),
    ("patternUnits", &["userSpaceOnUse", "objectBoundingBox"]),
    ("patternContentUnits", &["userSpaceOnUse", "objectBoundingBox"]),
    ("spreadMethod", &["pad", "reflect", "repeat"]),
];

/// Warns of what cannot be read of the gradients and patterns that something is painted with.
pub fn warnings<'d>(
    source: &Source,
    document: &'d Document,
    links: &'d Links<'d, 'd>,
    style_of: impl Fn(Node) -> Option<&'d str>,
) -> Vec<Diagnostic> {
    let mut looked_at: BTreeSet<usize> = BTreeSet::new();
    let mut found = Vec::new();
    for node in document.descendants().filter(|node| node.tag_name().namespace() == Some(SVG)) {
        let style = style_of(node).or_else(|| node.attribute("style")).unwrap_or("");
        let own = node.attributes().map(|attribute| (attribute.name(), attribute.value()));
        let paints = own.chain(css::style_declarations(style)).filter(|(name, _)| matches!(*name, "fill" | "stroke"));
        for server in paints.flat_map(|(_, value)| urls(value)).filter_map(|id| links.named(id)) {
            let chain = chain(server, links);
            let is_new = looked_at.insert(server.id().get_usize());
            // Of one that builds on nothing that is told.
            let is_whole =
                chain.last().is_none_or(|last| drawn_by_href(*last).is_none() || links.target(*last).is_some());
            if is_new && is_whole {
                found.extend(nothing_in(&chain).map(|what| (server, what)));
            }
            for (index, node) in chain.into_iter().enumerate() {
                if (index == 0 && is_new) || looked_at.insert(node.id().get_usize()) {
                    found.extend(unread(node));
                }
            }
        }
    }
    let told = found.into_iter().map(|(node, what)| source.diagnostic(node.range().start, what).into_warning());
    told.collect()
}

/// A gradient or a pattern, and what it builds on.
fn chain<'d>(server: Node<'d, 'd>, links: &'d Links<'d, 'd>) -> Vec<Node<'d, 'd>> {
    let next = |node: &Node<'d, 'd>| drawn_by_href(*node).and_then(|_| links.target(*node));
    std::iter::successors(Some(server), next).take(MOST_LINKS).collect()
}

/// Why nothing is painted with it.
fn nothing_in(chain: &[Node]) -> Option<String> {
    let name = chain[0].tag_name().name();
    let has = |child: &str| chain.iter().any(|node| node.children().any(|own| own.has_tag_name((SVG, child))));
    match name {
        "linearGradient" | "radialGradient" if !has("stop") => Some(format!(
            "this {name} has no <stop>, so nothing is painted with it; give it two, each with a stop-color"
        )),
        "pattern" => {
            let said = |size: &str| chain.iter().find_map(|node| node.attribute(size));
            let is_empty = |size: &&str| said(size).is_none_or(|text| number(text).is_some_and(|number| number <= 0.0));
            let size = ["width", "height"].into_iter().find(is_empty)?;
            Some(format!(
                "this pattern's {size} is {}, so nothing is painted with it",
                said(size).unwrap_or("not said")
            ))
        }
        _ => None,
    }
}

/// What of a gradient or a pattern is not understood, each with its element.
fn unread<'d>(node: Node<'d, 'd>) -> Vec<(Node<'d, 'd>, String)> {
    let name = node.tag_name().name();
    let words = WORDS.iter().filter_map(|(attribute, known)| {
        let value = node.attribute(*attribute)?;
        let what =
            format!("the {attribute} of this {name} is `{value}`, which is not read; write {}", known.join(" or "));
        (!known.contains(&value.trim())).then_some((node, what))
    });
    let transforms = ["gradientTransform", "patternTransform"].into_iter().filter_map(|attribute| {
        let value = node.attribute(attribute)?;
        let what = match Transform::scaling(1.0).transformed(value) {
            Err(why) => why.replacen("the transform", &format!("the {attribute}"), 1),
            Ok(transform) if transform.is_flat() => format!("the {attribute} `{value}` shrinks it to nothing"),
            Ok(_) => return None,
        };
        Some((node, format!("of this {name}: {what}")))
    });
    let stops = node.children().filter(|child| child.has_tag_name((SVG, "stop"))).filter_map(|stop| {
        let offset = stop.attribute("offset").filter(|offset| number(offset).is_none())?;
        Some((stop, format!("the offset of this stop is `{offset}`, which is not read; write a number from 0 to 1")))
    });
    words.chain(transforms).chain(stops).collect()
}

/// A number with or without a unit.
fn number(text: &str) -> Option<f64> {
    svgtypes::Length::from_str(text.trim()).ok().map(|length| length.number)
}
