//! The table's elements in a drawing: which XML element is what, where, how thick and of which colour.
//!
//! Refuses to know what `table.toml` says and what an element is good for.

use super::element_class::ElementClass;
use super::outline::Outline;
use super::source::{Diagnostic, Source};
use super::style::{self, Paint};
use super::transform::Transform;
use geometry::{Bounds, DVec2};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::BTreeMap;

/// XML nodes that a drawing may have.
const MAX_NODES: u32 = 200_000;
/// Elements that may lie inside each other.
const MAX_DEPTH: usize = 64;
/// Things that a table may have: parts are counted in 16 bits, with room for the balls.
const MAX_ELEMENTS: usize = 20_000;
/// Pieces and corners of all elements together.
const MAX_PIECES: usize = 200_000;
/// How far an element may reach beyond the playfield, mm.
const MARGIN_MM: f64 = 60.0;
/// The playfield's sides, mm.
const SIDES_MM: std::ops::RangeInclusive<f64> = 50.0..=5000.0;

/// SVG's namespace.
pub(super) const SVG: &str = "http://www.w3.org/2000/svg";

/// Reads the XML, and nothing that could grow without end.
pub(super) fn parse_xml(source: &Source) -> Result<Document<'_>, Diagnostic> {
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(&source.text, options).map_err(|error| match error {
        roxmltree::Error::DtdDetected => {
            Diagnostic::of_file(&source.path, "it has a DOCTYPE; take it out, entities are not read")
        }
        roxmltree::Error::NodesLimitReached => {
            Diagnostic::of_file(&source.path, format!("it has more than {MAX_NODES} nodes; draw it more simply"))
        }
        error => source.diagnostic_in_line(error.pos().row as usize, format!("this is not well-formed XML: {error}")),
    })?;
    match too_deep(&document) {
        Some(at) => {
            let what = format!("more than {MAX_DEPTH} elements lie inside each other; take some out");
            Err(source.diagnostic(at, what))
        }
        None => Ok(document),
    }
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

/// One element of the table.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub class: ElementClass,
    /// Its id, or a name that no id can be.
    pub name: String,
    /// The byte at which its element begins.
    pub at: usize,
    pub outline: Outline,
    /// Of its line, mm.
    pub thickness_mm: f64,
    pub fill: Paint,
    pub stroke: Paint,
    /// The group that it belongs to.
    pub group: Option<String>,
    /// Its `data-` attributes.
    pub data: BTreeMap<String, String>,
}

impl Element {
    /// Half of its line's thickness, mm.
    pub fn radius_mm(&self) -> f64 {
        self.thickness_mm * 0.5
    }

    /// The colour that it is drawn in: of its line, or of its inside.
    pub fn color(&self) -> Option<[u8; 3]> {
        [self.stroke, self.fill].into_iter().find_map(|paint| match paint {
            Paint::Color(color) => Some(color),
            _ => None,
        })
    }
}

/// The playfield and the elements on it.
#[derive(Debug)]
pub(super) struct Drawing {
    pub size_mm: DVec2,
    pub elements: Vec<Element>,
    /// What each id is, even of elements that could not be read.
    pub ids: BTreeMap<String, ElementClass>,
    /// Every element's class and where it is, even of those that could not be read.
    pub drawn: Vec<(ElementClass, usize)>,
}

impl Drawing {
    /// Finds the elements; every diagnostic goes to `diagnostics`.
    pub fn read(source: &Source, document: &Document, diagnostics: &mut Vec<Diagnostic>) -> Drawing {
        let root = document.root_element();
        let size_mm = match size(root) {
            Ok(size) => size,
            Err(why) => {
                diagnostics.push(source.diagnostic(root.range().start, why));
                DVec2::new(514.0, 1067.0)
            }
        };
        let mut reader = Reader {
            source,
            diagnostics,
            size_mm,
            elements: Vec::new(),
            ids: BTreeMap::new(),
            drawn: Vec::new(),
            pieces: 0,
            too_many: false,
        };
        reader.children(root, Inherited { transform: Ok(Transform::IDENTITY), drawn: Ok(()) });
        let Reader { elements, ids, drawn, .. } = reader;
        let ids = ids.into_iter().map(|(id, (class, _))| (id, class)).collect();
        Drawing { size_mm, elements, ids, drawn }
    }
}

fn size(root: Node) -> Result<DVec2, String> {
    if root.tag_name().name() != "svg" || root.tag_name().namespace() != Some(SVG) {
        return Err(format!("the drawing must begin with <svg xmlns=\"{SVG}\" ...>"));
    }
    let expected = "viewBox=\"0 0 WIDTH HEIGHT\", the playfield's size in millimetres";
    let text = root.attribute("viewBox").ok_or_else(|| format!("the drawing has no viewBox; write {expected}"))?;
    let numbers: Vec<f64> = text.split([',', ' ']).filter(|word| !word.is_empty()).flat_map(str::parse).collect();
    match numbers[..] {
        [x, y, width, height] if x == 0.0 && y == 0.0 && [width, height].iter().all(|side| SIDES_MM.contains(side)) => {
            Ok(DVec2::new(width, height))
        }
        _ => Err(format!(
            "the viewBox is `{text}`; write {expected}, each side from {} to {}",
            SIDES_MM.start(),
            SIDES_MM.end()
        )),
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
    diagnostics: &'a mut Vec<Diagnostic>,
    size_mm: DVec2,
    elements: Vec<Element>,
    /// What each id is, and the line that took it.
    ids: BTreeMap<String, (ElementClass, usize)>,
    drawn: Vec<(ElementClass, usize)>,
    pieces: usize,
    too_many: bool,
}

/// The class of an XML element, if it is an element of the table: the first word that is a class.
pub(super) fn element_class(node: Node) -> Option<ElementClass> {
    classes(node).next()
}

fn classes<'a>(node: Node<'a, '_>) -> impl Iterator<Item = ElementClass> + 'a {
    node.attribute("class").unwrap_or("").split_ascii_whitespace().filter_map(ElementClass::from_word)
}

impl Reader<'_> {
    fn diagnostic(&mut self, node: Node, what: impl std::fmt::Display) {
        self.diagnostics.push(self.source.diagnostic(node.range().start, what));
    }

    fn children(&mut self, parent: Node, inherited: Inherited) {
        for node in parent.children().filter(Node::is_element) {
            if self.too_many || style::own_property(node, "display") == Some("none") {
                continue;
            }
            self.visit(node, &inherited);
        }
    }

    fn visit(&mut self, node: Node, inherited: &Inherited) {
        let transform = match (&inherited.transform, node.attribute("transform")) {
            (Ok(transform), Some(attribute)) => transform.transformed(attribute),
            (transform, _) => transform.clone(),
        };
        if classes(node).next().is_some() {
            self.element(node, &transform, inherited);
        } else {
            self.art(node);
        }
        let drawn = match node.tag_name().name() {
            "g" | "a" => inherited.drawn.clone(),
            other => inherited.drawn.clone().and(Err(other.to_string())),
        };
        self.children(node, Inherited { transform, drawn });
    }

    /// Whatever is no element of the table must be art that can be printed.
    fn art(&mut self, node: Node) {
        let name = node.tag_name().name();
        if matches!(name, "image" | "foreignObject") && node.tag_name().namespace() == Some(SVG) {
            self.diagnostic(node, format!("`{name}` cannot be printed on a playfield; draw it with shapes"));
        }
        if let Some(data) = element_data(node) {
            self.diagnostic(
                node,
                format!("it has `data-{data}` but its class is no thing; it may be {}", ElementClass::words()),
            );
        }
    }

    fn element(&mut self, node: Node, transform: &Result<Transform, String>, inherited: &Inherited) {
        let all: Vec<&str> = classes(node).map(ElementClass::word).collect();
        if all.len() > 1 {
            return self.diagnostic(node, format!("it is both {}; a thing is one of them", all.join(" and ")));
        }
        let Some(class) = element_class(node) else { return };
        if let Err(outside) = &inherited.drawn {
            return self.diagnostic(node, format!("a {} inside `{outside}` is not drawn; move it out", class.word()));
        }
        if self.drawn.len() >= MAX_ELEMENTS {
            self.too_many = true;
            return self.diagnostic(node, format!("there are more than {MAX_ELEMENTS} things"));
        }
        self.drawn.push((class, node.range().start));
        let name = self.name(node, class);
        self.data(node, class, &name);
        match transform.clone().and_then(|transform| read_element(node, class, &name, transform)) {
            Ok(element) => self.keep(node, element),
            Err(why) => self.diagnostic(node, format!("{name}: {why}")),
        }
    }

    fn keep(&mut self, node: Node, element: Element) {
        let bounds = element.outline.bounds();
        let playfield = Bounds::of(DVec2::ZERO, self.size_mm);
        let grown = playfield.grown(MARGIN_MM);
        let inside = grown.contains(bounds.min) && grown.contains(bounds.max) && playfield.overlaps(&bounds);
        if !inside {
            let DVec2 { x, y } = bounds.min;
            self.diagnostic(node, format!("{}: it lies outside the playfield, near {x:.0} {y:.0}", element.name));
        }
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
            if class.needs_id() {
                self.diagnostic(node, format!("this {} has no id, so no rule can name it", class.word()));
            }
            return unnamed;
        };
        let line = self.source.line(node.range().start);
        if let Some((_, first)) = self.ids.insert(id.to_string(), (class, line)) {
            self.diagnostic(node, format!("the id `{id}` is already taken in line {first}"));
        }
        id.to_string()
    }

    fn data(&mut self, node: Node, class: ElementClass, name: &str) {
        let unknown = node.attributes().filter_map(|attribute| attribute.name().strip_prefix("data-"));
        let unknown: Vec<&str> =
            unknown.filter(|&data| data != "group" && class.data().all(|known| known != data)).collect();
        for data in unknown {
            let known: Vec<String> = class.data().map(|data| format!("data-{data}")).collect();
            let known = if known.is_empty() { "none".to_string() } else { known.join(", ") };
            self.diagnostic(node, format!("{name}: a {} has no `data-{data}`; it may have {known}", class.word()));
        }
    }
}

fn element_data<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    let known = |data: &str| ElementClass::ALL.iter().any(|class| class.data().any(|known| known == data));
    node.attributes().filter_map(|attribute| attribute.name().strip_prefix("data-")).find(|data| known(data))
}

fn read_element(node: Node, class: ElementClass, name: &str, transform: Transform) -> Result<Element, String> {
    let scale = transform.scale()?;
    let thickness_mm = style::stroke_width(node)? * scale;
    if !(0.0..=1000.0).contains(&thickness_mm) {
        return Err(format!("its line is {thickness_mm} mm thick; it must be from 0 to 1000 mm"));
    }
    let group = node.ancestors().find_map(|node| node.attribute("data-group"));
    let data = node.attributes().filter_map(|attribute| {
        let key = attribute.name().strip_prefix("data-")?;
        Some((key.to_string(), attribute.value().trim().to_string()))
    });
    Ok(Element {
        class,
        name: name.to_string(),
        at: node.range().start,
        outline: Outline::of(node, transform, scale)?,
        thickness_mm,
        fill: style::fill(node)?,
        stroke: style::stroke(node)?,
        group: group.map(str::to_string),
        data: data.collect(),
    })
}
