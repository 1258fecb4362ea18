//! The things in a drawing: which element is what, where, how thick and of which colour.
//!
//! Refuses to know what `table.toml` says and what a thing is good for.

use super::class::Class;
use super::outline::Outline;
use super::place::Place;
use super::source::{Mistake, Source};
use super::style::{self, Paint};
use geometry::{Bounds, DVec2};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::BTreeMap;

/// XML nodes that a drawing may have.
const MOST_NODES: u32 = 200_000;
/// Elements that may lie inside each other.
const DEEPEST: usize = 64;
/// Things that a table may have: parts are counted in 16 bits, with room for the balls.
const MOST_THINGS: usize = 20_000;
/// Pieces and corners of all things together.
const MOST_PIECES: usize = 200_000;
/// How far a thing may reach beyond the playfield, mm.
const MARGIN_MM: f64 = 60.0;
/// The playfield's sides, mm.
const SIDES_MM: std::ops::RangeInclusive<f64> = 50.0..=5000.0;

/// SVG's namespace.
pub(super) const SVG: &str = "http://www.w3.org/2000/svg";

/// Reads the XML, and nothing that could grow without end.
pub(super) fn parse(source: &Source) -> Result<Document<'_>, Mistake> {
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(&source.text, options).map_err(|error| match error {
        roxmltree::Error::DtdDetected => {
            Mistake::of_file(&source.path, "it has a DOCTYPE; take it out, entities are not read")
        }
        roxmltree::Error::NodesLimitReached => {
            Mistake::of_file(&source.path, format!("it has more than {MOST_NODES} nodes; draw it more simply"))
        }
        error => source.mistake_in_line(error.pos().row as usize, format!("this is not well-formed XML: {error}")),
    })
}

/// One thing.
#[derive(Clone, Debug)]
pub(super) struct Thing {
    pub class: Class,
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

impl Thing {
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

/// The playfield and the things on it.
#[derive(Debug)]
pub(super) struct Drawing {
    pub size_mm: DVec2,
    pub things: Vec<Thing>,
    /// What each id is, even of things that could not be read.
    pub ids: BTreeMap<String, Class>,
    /// Every thing's class and where it is, even of those that could not be read.
    pub drawn: Vec<(Class, usize)>,
}

impl Drawing {
    /// Finds the things; every mistake goes to `mistakes`.
    pub fn read(source: &Source, document: &Document, mistakes: &mut Vec<Mistake>) -> Drawing {
        let root = document.root_element();
        let size_mm = match size(root) {
            Ok(size) => size,
            Err(why) => {
                mistakes.push(source.mistake(root.range().start, why));
                DVec2::new(514.0, 1067.0)
            }
        };
        let mut reader = Reader {
            source,
            mistakes,
            size_mm,
            things: Vec::new(),
            ids: BTreeMap::new(),
            drawn: Vec::new(),
            pieces: 0,
            too_many: false,
        };
        reader.children(root, Around { place: Ok(Place::TABLE), depth: 1, drawn: Ok(()) });
        let Reader { things, ids, drawn, .. } = reader;
        let ids = ids.into_iter().map(|(id, (class, _))| (id, class)).collect();
        Drawing { size_mm, things, ids, drawn }
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
struct Around {
    place: Result<Place, String>,
    depth: usize,
    /// Or the name of an ancestor that is not drawn where it stands.
    drawn: Result<(), String>,
}

struct Reader<'a> {
    source: &'a Source,
    mistakes: &'a mut Vec<Mistake>,
    size_mm: DVec2,
    things: Vec<Thing>,
    /// What each id is, and the line that took it.
    ids: BTreeMap<String, (Class, usize)>,
    drawn: Vec<(Class, usize)>,
    pieces: usize,
    too_many: bool,
}

/// The class of an element, if it is a thing: the first word that is one.
pub(super) fn class_of(node: Node) -> Option<Class> {
    classes(node).next()
}

fn classes<'a>(node: Node<'a, '_>) -> impl Iterator<Item = Class> + 'a {
    node.attribute("class").unwrap_or("").split_ascii_whitespace().filter_map(Class::of)
}

impl Reader<'_> {
    fn mistake(&mut self, node: Node, what: impl std::fmt::Display) {
        self.mistakes.push(self.source.mistake(node.range().start, what));
    }

    fn children(&mut self, parent: Node, around: Around) {
        for node in parent.children().filter(Node::is_element) {
            if self.too_many || style::own_property(node, "display") == Some("none") {
                continue;
            }
            self.element(node, &around);
        }
    }

    fn element(&mut self, node: Node, around: &Around) {
        if around.depth >= DEEPEST {
            return self.mistake(node, format!("more than {DEEPEST} elements lie inside each other; take some out"));
        }
        let place = match (&around.place, node.attribute("transform")) {
            (Ok(place), Some(attribute)) => place.transformed(attribute),
            (place, _) => place.clone(),
        };
        if classes(node).next().is_some() {
            self.thing(node, &place, around);
        } else {
            self.art(node);
        }
        let drawn = match node.tag_name().name() {
            "g" | "a" => around.drawn.clone(),
            other => around.drawn.clone().and(Err(other.to_string())),
        };
        self.children(node, Around { place, depth: around.depth + 1, drawn });
    }

    /// Whatever is not a thing must be art that can be printed.
    fn art(&mut self, node: Node) {
        let name = node.tag_name().name();
        if matches!(name, "image" | "foreignObject") && node.tag_name().namespace() == Some(SVG) {
            self.mistake(node, format!("`{name}` cannot be printed on a playfield; draw it with shapes"));
        }
        if let Some(data) = thing_data(node) {
            self.mistake(node, format!("it has `data-{data}` but its class is no thing; it may be {}", Class::words()));
        }
    }

    fn thing(&mut self, node: Node, place: &Result<Place, String>, around: &Around) {
        let all: Vec<&str> = classes(node).map(Class::word).collect();
        if all.len() > 1 {
            return self.mistake(node, format!("it is both {}; a thing is one of them", all.join(" and ")));
        }
        let Some(class) = class_of(node) else { return };
        if let Err(outside) = &around.drawn {
            return self.mistake(node, format!("a {} inside `{outside}` is not drawn; move it out", class.word()));
        }
        if self.drawn.len() >= MOST_THINGS {
            self.too_many = true;
            return self.mistake(node, format!("there are more than {MOST_THINGS} things"));
        }
        self.drawn.push((class, node.range().start));
        let name = self.name(node, class);
        self.data(node, class, &name);
        match place.clone().and_then(|place| read_thing(node, class, &name, place)) {
            Ok(thing) => self.keep(node, thing),
            Err(why) => self.mistake(node, format!("{name}: {why}")),
        }
    }

    fn keep(&mut self, node: Node, thing: Thing) {
        let bounds = thing.outline.bounds();
        let playfield = Bounds::of(DVec2::ZERO, self.size_mm);
        let grown = playfield.grown(MARGIN_MM);
        let inside = grown.contains(bounds.min) && grown.contains(bounds.max) && playfield.overlaps(&bounds);
        if !inside {
            let DVec2 { x, y } = bounds.min;
            self.mistake(node, format!("{}: it lies outside the playfield, near {x:.0} {y:.0}", thing.name));
        }
        self.pieces += thing.outline.pieces();
        self.things.push(thing);
        if self.pieces > MOST_PIECES && !self.too_many {
            self.too_many = true;
            self.mistake(
                node,
                format!("all things together have more than {MOST_PIECES} pieces; draw them more simply"),
            );
        }
    }

    fn name(&mut self, node: Node, class: Class) -> String {
        // Counted among their like, so that one more plastic gives no wall another name.
        let like = self.drawn.iter().filter(|(other, _)| other.is_part() == class.is_part()).count();
        let unnamed = format!("{}#{}", class.word(), like - 1);
        let Some(id) = node.attribute("id").filter(|id| !id.is_empty()) else {
            if class.needs_id() {
                self.mistake(node, format!("this {} has no id, so no rule can name it", class.word()));
            }
            return unnamed;
        };
        let line = self.source.line(node.range().start);
        if let Some((_, first)) = self.ids.insert(id.to_string(), (class, line)) {
            self.mistake(node, format!("the id `{id}` is already taken in line {first}"));
        }
        id.to_string()
    }

    fn data(&mut self, node: Node, class: Class, name: &str) {
        let unknown = node.attributes().filter_map(|attribute| attribute.name().strip_prefix("data-"));
        let unknown: Vec<&str> =
            unknown.filter(|&data| data != "group" && class.data().all(|known| known != data)).collect();
        for data in unknown {
            let known: Vec<String> = class.data().map(|data| format!("data-{data}")).collect();
            let known = if known.is_empty() { "none".to_string() } else { known.join(", ") };
            self.mistake(node, format!("{name}: a {} has no `data-{data}`; it may have {known}", class.word()));
        }
    }
}

fn thing_data<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    let known = |data: &str| Class::ALL.iter().any(|class| class.data().any(|known| known == data));
    node.attributes().filter_map(|attribute| attribute.name().strip_prefix("data-")).find(|data| known(data))
}

fn read_thing(node: Node, class: Class, name: &str, place: Place) -> Result<Thing, String> {
    let scale = place.scale()?;
    let thickness_mm = style::stroke_width(node)? * scale;
    if !(0.0..=1000.0).contains(&thickness_mm) {
        return Err(format!("its line is {thickness_mm} mm thick; it must be from 0 to 1000 mm"));
    }
    let group = node.ancestors().find_map(|node| node.attribute("data-group"));
    let data = node.attributes().filter_map(|attribute| {
        let key = attribute.name().strip_prefix("data-")?;
        Some((key.to_string(), attribute.value().trim().to_string()))
    });
    Ok(Thing {
        class,
        name: name.to_string(),
        at: node.range().start,
        outline: Outline::of(node, place, scale)?,
        thickness_mm,
        fill: style::fill(node)?,
        stroke: style::stroke(node)?,
        group: group.map(str::to_string),
        data: data.collect(),
    })
}
