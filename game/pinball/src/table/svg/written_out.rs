//! A drawing written out: its sheets as `style` attributes, its colours in plain words, its clones of things as copies.
//!
//! Whatever reads the drawing afterwards, for things or for art, finds one and the same simple drawing, and every line is
//! where its maker has it.

use super::clones::{Cloner, Holders, XML};
use super::css::{self, Cascade, Instance};
use super::drawing::is_thing;
use super::page::SVG;
use super::references::{Links, XLINK, href_id, is_use, plain_href};
use super::sheet_values::SheetLines;
use super::text_edit::{Edit, attributes_start, edited, escaped, in_one_line, origin, prefix};
use super::xml;
use super::{amount, hidden, oddities, shape_typo};
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};
use std::collections::BTreeSet;

/// Attributes of an `<svg>` inside the drawing that say something of it as a whole.
const OF_GROUP: [&str; 6] = ["style", "transform", "opacity", "clip-path", "mask", "filter"];

/// A drawing that is written out.
pub(in crate::table) struct WrittenOut {
    pub source: Source,
    /// Words that its sheets have as classes.
    pub styled: BTreeSet<String>,
    pub lines: SheetLines,
    /// Lines of clones whose things have no ids, which has been told.
    pub nameless: BTreeSet<usize>,
    /// The drawing as it is in the file.
    pub file: Source,
    edits: Vec<Edit>,
}

impl WrittenOut {
    /// Where a place in the written out drawing comes from in the file: of a clone, its `use`.
    pub fn origin(&self, at: usize) -> usize {
        origin(&self.edits, &self.file.text, at)
    }
}

/// Writes a drawing out; nothing if it has a mistake that must be mended first.
pub(in crate::table) fn write_out(source: Source, diagnostics: &mut Vec<Diagnostic>) -> Option<WrittenOut> {
    match edits(&source, diagnostics) {
        Ok(Changes { edits, lines, styled, nameless }) => {
            let file = source.clone();
            let source =
                if edits.is_empty() { source } else { Source::new(source.path, edited(&source.text, edits.clone())) };
            Some(WrittenOut { source, styled, lines, nameless, file, edits })
        }
        Err(mistakes) => {
            diagnostics.extend(mistakes);
            None
        }
    }
}

/// What makes a drawing a written out one; see [`WrittenOut`].
struct Changes {
    edits: Vec<Edit>,
    lines: SheetLines,
    styled: BTreeSet<String>,
    nameless: BTreeSet<usize>,
}

fn edits(source: &Source, diagnostics: &mut Vec<Diagnostic>) -> Result<Changes, Vec<Diagnostic>> {
    let document = &xml::parse(source).map_err(|one| vec![one])?;
    let mut cascade = Cascade::read(source, document, diagnostics).map_err(|one| vec![one])?;
    let styles: Vec<Option<String>> = document.descendants().map(|node| style(&mut cascade, node)).collect();
    let links = &Links::of(document);
    let style_of = |node: Node| styles.get(node.id().get_usize()).and_then(Option::as_deref);
    let mut mistakes = shape_typo::mistakes(source, document);
    let amount = amount::check(document, links, style_of);
    mistakes.extend(amount.into_iter().map(|(at, why)| source.diagnostic(at, why)));
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    diagnostics.extend(oddities::warnings(source, document, links, style_of));
    let holders = &Holders::of(document, links);
    diagnostics.extend(hidden::warnings(source, document, (links, holders), style_of));
    let cloner = Cloner {
        text: &source.text,
        links,
        holders,
        cascade: &mut cascade,
        copied: BTreeSet::new(),
        unnamed: Vec::new(),
    };
    let (edits, nameless) = (Vec::new(), BTreeSet::new());
    let mut writer = Writer { source, styles: &styles, diagnostics, cloner, edits, nameless };
    writer.element(document.root_element(), true);
    writer.templates(document);
    let Writer { edits, nameless, .. } = writer;
    cascade.check(source).map_err(|one| vec![one])?;
    diagnostics.extend(cascade.unused(source, document));
    diagnostics.extend(cascade.misplaced(source));
    let lines =
        cascade.lines.into_iter().map(|((at, name, value), line)| ((source.line(at), name, value), line)).collect();
    Ok(Changes { edits, lines, styled: cascade.classes, nameless })
}

fn style(cascade: &mut Cascade, node: Node) -> Option<String> {
    if node.is_element() { cascade.style(Instance { node, root: None }) } else { None }
}

struct Writer<'w, 'a, 'i> {
    source: &'w Source,
    /// What is declared for each element, where that is not what its own attribute says.
    styles: &'w [Option<String>],
    diagnostics: &'w mut Vec<Diagnostic>,
    cloner: Cloner<'w, 'a, 'i>,
    edits: Vec<Edit>,
    /// See [`WrittenOut::nameless`].
    nameless: BTreeSet<usize>,
}

impl Writer<'_, '_, '_> {
    fn put(&mut self, range: std::ops::Range<usize>, new: &str) {
        self.edits.push((range, in_one_line(new)));
    }

    /// Writes out an element; `drawn` says whether it is drawn where it stands.
    fn element(&mut self, node: Node, drawn: bool) {
        if css::is_sheet(node) {
            return self.put(node.range(), "");
        }
        if is_use(node) && drawn && !is_thing(node) && self.cloner.holders.has(node) {
            return self.clone_of_things(node);
        }
        let is_inner_svg = node.has_tag_name((SVG, "svg")) && node.parent_element().is_some();
        if is_inner_svg {
            self.inner_svg(node)
        } else {
            self.style(node)
        }
        // Of two links the newer counts, and readers of SVG do not agree about that.
        let older = node.attribute_node((XLINK, "href")).filter(|_| plain_href(node).is_some());
        // What a program notes for itself, `sodipodi:cx`, could be taken for what its name says.
        let is_note = |name: &&str| ![SVG, XLINK, XML].contains(name);
        let notes = node.attributes().filter(|attribute| attribute.namespace().as_ref().is_some_and(is_note));
        for attribute in notes.chain(older) {
            self.put(attribute.range(), "");
        }
        for attribute in node.attributes().filter(|attribute| attribute.namespace().is_none()) {
            if let Some(plain) = css::plain_attribute(attribute.name(), attribute.value()) {
                self.put(attribute.range(), &format!("{}=\"{}\"", attribute.name(), escaped(&plain)));
            }
        }
        for child in node.children().filter(Node::is_element) {
            self.element(child, drawn && is_container(node));
        }
        if is_inner_svg {
            self.end_of_inner_svg(node);
        }
    }

    fn clone_of_things(&mut self, node: Node) {
        match self.cloner.clone_of(node) {
            Ok(text) => self.put(node.range(), &text),
            Err(why) => self.diagnostics.push(self.source.diagnostic(node.range().start, why)),
        }
        let unnamed = std::mem::take(&mut self.cloner.unnamed);
        let Some(thing) = unnamed.first() else { return };
        let original = href_id(node).unwrap_or_default();
        let called = if thing == original { String::new() } else { format!("; with id=\"two\" one is `two-{thing}`") };
        let why =
            format!("this clone of `{original}` has no id, so no rule can name what it shows; give it one{called}");
        self.diagnostics.push(self.source.diagnostic(node.range().start, why));
        self.nameless.insert(self.source.line(node.range().start));
    }

    fn declared(&self, node: Node) -> Option<String> {
        self.styles.get(node.id().get_usize()).cloned().flatten()
    }

    fn style(&mut self, node: Node) {
        let Some(style) = self.declared(node) else { return };
        match node.attribute_node("style") {
            Some(attribute) => self.put(attribute.range(), &format!("style=\"{}\"", escaped(&style))),
            None => self.add_attribute(node, "style", &style),
        }
    }

    fn add_attribute(&mut self, node: Node, name: &str, value: &str) {
        let start = attributes_start(&self.source.text, node);
        self.put(start..start, &format!(" {name}=\"{}\"", escaped(value)));
    }

    /// The art's rasteriser (usvg 0.45) draws an inner `<svg>` twice inside what is said of it as a whole, so a group
    /// around it says that instead.
    fn inner_svg(&mut self, node: Node) {
        let declared = self.declared(node);
        let mut group = format!("<{}g", prefix(&self.source.text, node));
        for name in OF_GROUP {
            let declared = declared.as_deref().filter(|_| name == "style");
            if let Some(value) = declared.or_else(|| node.attribute(name)) {
                group += &format!(" {name}=\"{}\"", escaped(value));
            }
        }
        let start = node.range().start;
        self.put(start..start, &(group + ">"));
        for attribute in node.attributes().filter(|attribute| OF_GROUP.contains(&attribute.name())) {
            self.put(attribute.range(), "");
        }
        // Of all that a style says this is the one that is about the edge of the <svg> itself.
        let style = declared.as_deref().or_else(|| node.attribute("style")).unwrap_or("");
        let overflow = css::style_declarations(style).find(|(name, _)| *name == "overflow");
        if let Some((name, value)) = overflow.filter(|_| !node.has_attribute("overflow")) {
            self.add_attribute(node, name, value);
        }
    }

    fn end_of_inner_svg(&mut self, node: Node) {
        let end = node.range().end;
        let tag = format!("</{}g>", prefix(&self.source.text, node));
        self.put(end..end, &tag);
    }

    /// Things that were copied from where nothing is drawn are templates: art that is drawn nowhere.
    fn templates(&mut self, document: &Document) {
        let copied = std::mem::take(&mut self.cloner.copied);
        let is_template = |node: &Node| {
            let is_drawn = node.ancestors().skip(1).filter(Node::is_element).all(is_container);
            copied.contains(&node.id().get_usize()) && is_thing(*node) && !is_drawn
        };
        for node in document.descendants().filter(is_template) {
            let of_thing = |name: &str| name == "class" || name.starts_with("data-");
            for attribute in node.attributes().filter(|attribute| of_thing(attribute.name())) {
                self.put(attribute.range(), "");
            }
        }
    }
}

/// Elements that draw what is in them, where they stand.
pub(in crate::table) fn is_container(node: Node) -> bool {
    let containers = ["g", "a", "svg", "switch"];
    node.tag_name().namespace() == Some(SVG) && containers.contains(&node.tag_name().name())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(inner: &str) -> String {
        let text = format!("<svg xmlns=\"{SVG}\" viewBox=\"0 0 500 1000\">{inner}</svg>");
        let mut diagnostics = Vec::new();
        let written = write_out(Source::new("a.svg".to_string(), text), &mut diagnostics);
        let written = written.unwrap_or_else(|| panic!("{diagnostics:?}")).source.text;
        written.split_once('>').unwrap().1.strip_suffix("</svg>").unwrap().to_string()
    }

    #[test]
    fn a_plain_drawing_stays_as_it_is_to_the_byte() {
        let plain =
            "<g style=\" fill : #ff0;stroke:url(#a)\"\n a='b'><path\nd='M0 0'/><use href=\"#x\"/></g><!-- c -->";
        assert_eq!(written(plain), plain);
    }

    #[test]
    fn sheets_become_attributes_and_lines_stay() {
        let styled = "<style>\npath { FILL: red; stroke: blue }\n</style>\n<path class='a'\nstyle='Stroke:lime/* */'/>";
        assert_eq!(written(styled), "\n\n\n<path class='a'\nstyle=\"fill:red;stroke:lime\"/>");
    }

    #[test]
    fn an_inner_svg_says_nothing_of_itself_as_a_whole() {
        let inner = "<svg x='3' transform='scale(2)' style='opacity:.5'><path/></svg>";
        assert_eq!(written(inner), "<g style=\"opacity:.5\" transform=\"scale(2)\"><svg x='3'  ><path/></svg></g>");
    }
}
