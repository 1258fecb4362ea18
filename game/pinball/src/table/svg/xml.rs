//! XML: what a drawing's text must be before it is read as a drawing. Nothing in it may take long, or grow without end.

use super::xml_mistake;
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node, ParsingOptions};

/// XML nodes that a drawing may have.
const MAX_NODES: u32 = 200_000;
/// Attributes that an element may have: each is compared with all before it.
const MAX_ATTRIBUTES: usize = 1000;
/// Elements that may lie inside each other.
const MAX_DEPTH: usize = 64;

/// What is no tag: how it begins, and how it ends.
pub(super) const SKIPPED: [(&str, &str); 3] = [("<!--", "-->"), ("<?", "?>"), ("<![CDATA[", "]]>")];

/// Reads the XML, and nothing that could grow without end.
pub(in crate::table) fn parse(source: &Source) -> Result<Document<'_>, Diagnostic> {
    if let Some(at) = too_many_attributes(&source.text) {
        return Err(source.diagnostic(at, format!("this element has more than {MAX_ATTRIBUTES} attributes")));
    }
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(&source.text, options).map_err(|error| match error {
        roxmltree::Error::DtdDetected => {
            source.diagnostic(doctype(&source.text), "it has a DOCTYPE; take it out, entities are not read")
        }
        roxmltree::Error::NodesLimitReached => {
            Diagnostic::of_file(&source.path, format!("it has more than {MAX_NODES} nodes; draw it more simply"))
        }
        error => xml_mistake::told(source, &error),
    })?;
    match too_deep(&document) {
        Some(at) => {
            let what = format!("more than {MAX_DEPTH} elements lie inside each other; take some out");
            Err(source.diagnostic(at, what))
        }
        None => Ok(document),
    }
}

/// Where the DOCTYPE is: before the first element, among comments and instructions.
fn doctype(text: &str) -> usize {
    tag_from(text, 0).unwrap_or(text.len())
}

/// Where the first tag at or after `at` begins that is no comment, no instruction and no plain text.
pub(super) fn tag_from(text: &str, mut at: usize) -> Option<usize> {
    while let Some(start) = text[at..].find('<').map(|start| at + start) {
        let Some((_, end)) = SKIPPED.iter().find(|(begin, _)| text[start..].starts_with(begin)) else {
            return Some(start);
        };
        at = start + text[start..].find(end)? + end.len();
    }
    None
}

/// Where the first element begins that has too many attributes.
fn too_many_attributes(text: &str) -> Option<usize> {
    let mut at = 0;
    while let Some(start) = tag_from(text, at) {
        let Tag { attributes, length, .. } = tag(&text[start..]);
        if attributes > MAX_ATTRIBUTES {
            return Some(start);
        }
        at = start + length;
    }
    None
}

/// A tag, as far as can be told without reading it.
pub(super) struct Tag {
    attributes: usize,
    /// Bytes.
    pub length: usize,
    /// Whether it ends before its text does.
    pub is_whole: bool,
}

/// The tag that a text begins with.
pub(super) fn tag(text: &str) -> Tag {
    let (mut quote, mut attributes) = (None, 0);
    for (place, letter) in text.bytes().enumerate() {
        match (quote, letter) {
            (None, b'"' | b'\'') => (quote, attributes) = (Some(letter), attributes + 1),
            (Some(open), letter) if open == letter => quote = None,
            (None, b'>') => return Tag { attributes, length: place + 1, is_whole: true },
            _ => {}
        }
    }
    Tag { attributes, length: text.len(), is_whole: false }
}

/// Where the first element begins that lies too deep in others for what walks through them, shown or not.
fn too_deep(document: &Document) -> Option<usize> {
    let mut depths = vec![0; document.descendants().count()];
    for node in document.descendants().filter(Node::is_element) {
        let depth = node.parent_element().map_or(0, |parent| depths[parent.id().get_usize()] + 1);
        if depth > MAX_DEPTH {
            return Some(node.range().start);
        }
        depths[node.id().get_usize()] = depth;
    }
    None
}
