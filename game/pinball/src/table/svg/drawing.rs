//! The table's elements in a drawing: which XML element is what, where, how thick and of which colour.
//!
//! Refuses to know what `table.toml` says and what an element is good for.

use super::element::Element;
use super::element_class::{ElementClass, LIGHT_BENDING_WORDS};
use super::ids::Ids;
use super::page::{Page, SVG};
use super::sheet_values::SheetMistakes;
use super::style;
use super::transform::Transform;
use super::written_out::{WrittenOut, is_container};
use super::{class_typo, outside, viewport};
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};
use std::collections::{BTreeMap, BTreeSet};

/// Things that a table may have: parts are counted in 16 bits, with room for the balls.
const MAX_ELEMENTS: usize = 20_000;
/// Pieces and corners of all elements together.
const MAX_PIECES: usize = 200_000;
/// What is drawn as a shape, and so can be a thing.
const SHAPES: [&str; 8] = ["line", "polyline", "polygon", "path", "circle", "ellipse", "rect", "use"];

/// The playfield and the elements on it.
#[derive(Debug)]
pub(in crate::table) struct Drawing {
    pub page: Page,
    pub elements: Vec<Element>,
    pub ids: Ids,
    /// Every element's class and where it is, even of those that could not be read.
    pub drawn: Vec<(ElementClass, usize)>,
}

impl Drawing {
    /// Finds the elements; every diagnostic goes to `diagnostics`. Nothing of a drawing whose size is not known, or that is
    /// not read to its end: whatever were said of its elements would come of that.
    pub fn read(written: &WrittenOut, document: &Document, diagnostics: &mut Vec<Diagnostic>) -> Option<Drawing> {
        let source = &written.source;
        let root = document.root_element();
        let at = root.range().start;
        let page = Page::of(root).map_err(|why| diagnostics.push(source.diagnostic(at, why))).ok()?;
        let mut reader = Reader {
            source,
            written,
            diagnostics,
            elements: Vec::new(),
            ids: Ids::default(),
            drawn: Vec::new(),
            words: BTreeSet::new(),
            pieces: 0,
            too_many: false,
            of_sheets: SheetMistakes::default(),
        };
        reader.children(root, &Inherited { transform: Ok(Transform::scaling(page.mm_per_unit)), drawn: Ok(()) });
        let Reader { elements, mut ids, drawn, of_sheets, too_many, .. } = reader;
        of_sheets.tell(source, diagnostics);
        if too_many {
            return None;
        }
        ids.note_art(source, document);
        match outside::turned(page.size_mm, &elements) {
            Some(what) => diagnostics.push(source.diagnostic(at, what)),
            None => {
                diagnostics.extend(page.warnings().map(|what| source.diagnostic(at, what).into_warning()));
                diagnostics.extend(outside::mistakes(source, page.size_mm, &elements));
            }
        }
        Some(Drawing { page, elements, ids, drawn })
    }
}

/// What an element inherits.
#[derive(Clone)]
struct Inherited {
    transform: Result<Transform, String>,
    /// Or the name of an ancestor that is not drawn where it stands.
    drawn: Result<(), String>,
}

struct Reader<'a> {
    source: &'a Source,
    written: &'a WrittenOut,
    diagnostics: &'a mut Vec<Diagnostic>,
    elements: Vec<Element>,
    ids: Ids,
    drawn: Vec<(ElementClass, usize)>,
    /// Classes without a meaning that were told.
    words: BTreeSet<String>,
    pieces: usize,
    too_many: bool,
    of_sheets: SheetMistakes,
}

/// The class of an XML element, if it is an element of the table: the first word that is a class.
pub(in crate::table) fn element_class(node: Node) -> Option<ElementClass> {
    classes(node).next()
}

/// Whether an XML element is a thing: an element of the table, or what bends light in a rendered scene.
pub(in crate::table) fn is_thing(node: Node) -> bool {
    let mut words = node.attribute("class").unwrap_or("").split_ascii_whitespace();
    words.any(|word| ElementClass::from_word(word).is_some() || LIGHT_BENDING_WORDS.contains(&word))
}

fn classes<'a>(node: Node<'a, '_>) -> impl Iterator<Item = ElementClass> + 'a {
    node.attribute("class").unwrap_or("").split_ascii_whitespace().filter_map(ElementClass::from_word)
}

impl Reader<'_> {
    fn diagnostic(&mut self, node: Node, what: impl std::fmt::Display) {
        self.diagnostics.push(self.source.diagnostic(node.range().start, what));
    }

    fn children(&mut self, parent: Node, inherited: &Inherited) {
        for node in parent.children().filter(Node::is_element) {
            if self.too_many || style::own_property(node, "display") == Some("none") || !is_chosen(node) {
                continue;
            }
            self.visit(node, inherited);
        }
    }

    fn visit(&mut self, node: Node, inherited: &Inherited) {
        let attribute = node.attribute("transform").unwrap_or("");
        let transform = inherited.transform.clone().and_then(|transform| transform.transformed(attribute));
        let typo = self.unknown_classes(node);
        let transform = self.told_once(node, inherited, transform);
        if classes(node).next().is_some() {
            self.element(node, &transform, inherited);
        } else {
            self.art(node, typo);
        }
        let is_inner_svg = node.has_tag_name((SVG, "svg"));
        let transform = if is_inner_svg { transform.and_then(|outer| inner_svg(outer, node)) } else { transform };
        let not_drawn = || Err(node.tag_name().name().to_string());
        let drawn = inherited.drawn.clone().and_then(|()| if is_container(node) { Ok(()) } else { not_drawn() });
        self.children(node, &Inherited { transform, drawn });
    }

    /// Tells words in an element's class that mean nothing; whether one of them was meant to be a thing's.
    fn unknown_classes(&mut self, node: Node) -> bool {
        let is_shape = SHAPES.contains(&node.tag_name().name());
        let mut typo = false;
        if node.tag_name().namespace() != Some(SVG) || !(is_shape || is_container(node)) {
            return typo;
        }
        let words = || node.attribute("class").unwrap_or("").split_ascii_whitespace();
        // What a drawing program adds to a thing's class says nothing wrong.
        let is_thing = words().any(|word| ElementClass::from_word(word).is_some());
        for word in words() {
            if ElementClass::from_word(word).is_some() || class_typo::is_known(word) {
                continue;
            }
            if let Some(meant) = class_typo::meant(word).filter(|_| is_shape) {
                self.diagnostic(node, format!("the class `{word}` means nothing; did you mean `{meant}`?"));
                self.refuse(node);
                // A table that lacks what was meant here has no second mistake.
                self.drawn.extend(ElementClass::from_word(meant).map(|class| (class, node.range().start)));
                typo = true;
            } else if !is_thing && !self.written.styled.contains(word) && self.words.insert(word.to_string()) {
                let meant = class_typo::meant_for_art(word).map(|meant| format!("; did you mean `{meant}`?"));
                let art = if is_shape { ", so what has it is art" } else { " here: give each shape in it a class" };
                let meant = meant.unwrap_or_else(|| art.to_string());
                let what = match LIGHT_BENDING_WORDS.contains(&word) {
                    true => format!("a table in play does not bend light: what has the class `{word}` is art there"),
                    false => format!("the class `{word}` means nothing{meant}"),
                };
                self.diagnostics.push(self.source.diagnostic(node.range().start, what).into_warning());
            } else if let Some(meant) = class_typo::meant_for_art(word).filter(|_| is_thing) {
                let what = format!("the class `{word}` means nothing; did you mean `{meant}`?");
                self.diagnostics.push(self.source.diagnostic(node.range().start, what).into_warning());
            }
        }
        typo
    }

    /// Whatever is no element of the table must be art that can be printed.
    fn art(&mut self, node: Node, typo: bool) {
        let name = node.tag_name().name();
        if matches!(name, "image" | "foreignObject") && node.tag_name().namespace() == Some(SVG) {
            self.diagnostic(node, format!("`{name}` cannot be printed on a playfield; draw it with shapes"));
        }
        self.misspelt_group(node);
        if let Some(data) = element_data(node).filter(|_| !typo) {
            self.diagnostic(
                node,
                format!("it has `data-{data}` but its class is no thing; it may be {}", ElementClass::words()),
            );
        }
    }

    /// Tells what is nearly the `data-group` of a group.
    fn misspelt_group(&mut self, node: Node) {
        let own = node.attributes().map(|attribute| attribute.name()).filter(|name| *name != "data-group");
        // That of a copy is told where it was copied from.
        let is_copy = || {
            let begin = self.written.file.text.get(self.written.origin(node.range().start)..).unwrap_or_default();
            let tag = begin.trim_start_matches('<').split(|c: char| c.is_whitespace() || matches!(c, '>' | '/')).next();
            tag.is_some_and(|tag| tag.rsplit(':').next() == Some("use"))
        };
        let is_meant = |name: &&str| class_typo::nearest(name, ["data-group"]).is_some();
        let wrong = own.into_iter().find(is_meant).filter(|_| is_container(node) && !node.has_attribute("data-group"));
        if let Some(wrong) = wrong.filter(|_| !is_copy()) {
            let name = node.tag_name().name();
            self.diagnostic(node, format!("a {name} has no `{wrong}`; did you mean `data-group`?"));
        }
    }

    /// A transform, or nothing more to say where what is wrong with it was told: a group's and that of art is told once, with
    /// its own line; a thing's with its name.
    fn told_once(
        &mut self,
        node: Node,
        inherited: &Inherited,
        transform: Result<Transform, String>,
    ) -> Result<Transform, String> {
        match transform {
            Err(why) if inherited.transform.is_ok() && is_art(node) && node.parent_element().is_some() => {
                self.diagnostic(node, format!("of this {}: {why}", node.tag_name().name()));
                Err(String::new())
            }
            other => other,
        }
    }

    fn element(&mut self, node: Node, transform: &Result<Transform, String>, inherited: &Inherited) {
        let all: Vec<&str> = classes(node).map(ElementClass::word).collect();
        if all.len() > 1 {
            self.refuse(node);
            return self.diagnostic(node, format!("it is both {}; a thing is one of them", all.join(" and ")));
        }
        let Some(class) = element_class(node) else { return };
        if let Err(outside) = &inherited.drawn {
            self.refuse(node);
            return self
                .diagnostic(node, format!("{} inside `{outside}` is not drawn; move it out", class.with_article()));
        }
        if self.drawn.len() >= MAX_ELEMENTS {
            self.too_many = true;
            return self.diagnostic(node, format!("there are more than {MAX_ELEMENTS} things"));
        }
        self.drawn.push((class, node.range().start));
        let name = self.name(node, class);
        let data = self.data(node, class, &name);
        match transform.clone().and_then(|transform| Element::read(node, class, &name, transform)) {
            Ok(element) => self.keep(node, Element { data, ..element }),
            Err(why) => {
                self.refuse(node);
                let lines = &self.written.lines;
                if !why.is_empty() && !self.of_sheets.take(lines, self.source, (node, &name), &why) {
                    self.diagnostic(node, format!("{name}: {why}"));
                }
            }
        }
    }

    /// What names a thing that is refused is no further mistake.
    fn refuse(&mut self, node: Node) {
        node.attribute("id").into_iter().for_each(|id| self.ids.refuse(id));
    }

    fn keep(&mut self, node: Node, element: Element) {
        self.pieces += element.outline.pieces();
        self.elements.push(element);
        if self.pieces > MAX_PIECES && !self.too_many {
            self.too_many = true;
            self.diagnostic(
                node,
                format!("all things together have more than {MAX_PIECES} pieces; draw them more simply"),
            );
        }
    }

    fn name(&mut self, node: Node, class: ElementClass) -> String {
        // Counted among their like, so that one more plastic gives no wall another name.
        let like = self.drawn.iter().filter(|(other, _)| other.is_part() == class.is_part()).count();
        let unnamed = format!("{}#{}", class.word(), like - 1);
        let Some(id) = node.attribute("id").filter(|id| !id.is_empty()) else {
            if class.needs_id() && !self.written.nameless.contains(&self.source.line(node.range().start)) {
                self.diagnostic(node, format!("this {} has no id, so no rule can name it", class.word()));
            }
            return unnamed;
        };
        let line = self.source.line(node.range().start);
        if let Err(first) = self.ids.take(id, class, line) {
            self.diagnostic(node, format!("the id `{id}` is already taken in line {first}"));
        }
        id.to_string()
    }

    /// Tells of a word that lacks its `data-`, and takes it for what was meant.
    fn without_prefix(&mut self, node: Node, class: ElementClass, name: &str, data: &mut BTreeMap<String, String>) {
        for attribute in node.attributes().filter(|attribute| attribute.namespace().is_none()) {
            let Some(meant) = class.data().find(|word| class_typo::is_same(word, attribute.name())) else { continue };
            if !data.contains_key(meant) {
                let (wrong, article) = (attribute.name(), class.with_article());
                self.diagnostic(node, format!("{name}: {article} has no `{wrong}`; did you mean `data-{meant}`?"));
                data.insert(meant.to_string(), attribute.value().trim().to_string());
            }
        }
    }

    /// What its `data-` attributes say: a misspelt one is told, and says all the same what was meant.
    fn data(&mut self, node: Node, class: ElementClass, name: &str) -> BTreeMap<String, String> {
        let written = node.attributes().filter_map(|attribute| {
            let key = attribute.name().strip_prefix("data-")?;
            Some((key.to_string(), attribute.value().trim().to_string()))
        });
        let mut data: BTreeMap<String, String> = written.collect();
        let known: Vec<&str> = class.data().chain(["group"]).collect();
        self.without_prefix(node, class, name, &mut data);
        let unknown: Vec<String> = data.keys().filter(|key| !known.contains(&key.as_str())).cloned().collect();
        for key in unknown {
            let lacking = || known.iter().copied().filter(|known| !data.contains_key(*known));
            // `data-eject` lacks what it is measured in.
            let begins = |known: &&str| known.strip_prefix(key.as_str()).is_some_and(|rest| rest.starts_with('-'));
            let meant = class_typo::nearest(&key, lacking()).or_else(|| lacking().find(begins));
            let what = match meant {
                Some(meant) => format!("did you mean `data-{meant}`?"),
                None => format!("it may have {}", words_of_data(class)),
            };
            let what = format!("{name}: {} has no `data-{key}`; {what}", class.with_article());
            let told = self.source.diagnostic(node.range().start, what);
            // A word of the maker's own is allowed, and says nothing.
            self.diagnostics.push(if meant.is_some() || is_tables_word(&key) { told } else { told.into_warning() });
            if let (Some(meant), Some(value)) = (meant, data.remove(&key)) {
                data.insert(meant.to_string(), value);
            }
        }
        data
    }
}

/// Whether an element is no thing and may have a transform.
fn is_art(node: Node) -> bool {
    let name = node.tag_name().name();
    let has_transform = SHAPES.contains(&name) || matches!(name, "text" | "clipPath");
    let is_art = has_transform && node.tag_name().namespace() == Some(SVG) && element_class(node).is_none();
    is_art || is_container(node)
}

/// Whether a word of an element's class is nearly a thing's: that is a mistake of its own.
pub(in crate::table) fn meant_as_thing(node: Node) -> bool {
    node.attribute("class").unwrap_or("").split_ascii_whitespace().any(|word| class_typo::meant(word).is_some())
}

/// Whether this is a `data-` word of any thing, or nearly.
fn is_tables_word(key: &str) -> bool {
    class_typo::nearest(key, ElementClass::ALL.into_iter().flat_map(ElementClass::data).chain(["group"])).is_some()
}

/// The `data-` attributes that a thing of this class may have, for a sentence.
fn words_of_data(class: ElementClass) -> String {
    let known: Vec<String> = class.data().map(|data| format!("data-{data}")).collect();
    if known.is_empty() { "none".to_string() } else { known.join(", ") }
}

/// Whether an element is drawn as far as a `<switch>` around it says: that draws the first that needs nothing special.
pub(super) fn is_chosen(node: Node) -> bool {
    let plain = |node: &Node| node.is_element() && !node.has_attribute("requiredExtensions");
    let switch = node.parent().filter(|around| around.has_tag_name((SVG, "switch")));
    switch.is_none_or(|switch| switch.children().find(plain) == Some(node))
}

/// The transform of what is in an inner `<svg>`.
pub(super) fn inner_svg(outer: Transform, node: Node) -> Result<Transform, String> {
    outer.transformed(&viewport::transform(node, None)?)
}

fn element_data<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    let known = |data: &str| ElementClass::ALL.iter().any(|class| class.data().any(|known| known == data));
    node.attributes().filter_map(|attribute| attribute.name().strip_prefix("data-")).find(|data| known(data))
}
