//! Drawn shapes: every shape of a drawing that has a class, whatever its class means.
//!
//! What a table's things are to [`super::drawing`], these are to a scene of light: places, looks and words, read as a browser reads
//! them. Curves become arcs ([`super::biarc`]), so that mirrors and lenses have the slopes that are drawn.

use super::drawing::{inner_svg, is_chosen};
use super::element::check_place;
use super::element_class::ElementClass;
use super::outline::Outline;
use super::page::Page;
use super::path_flattening::{Curves, Piece};
use super::style::{self, Paint};
use super::transform::Transform;
use super::written_out::{self, WrittenOut, is_container};
use super::{class_typo, xml};
use crate::Failure;
use crate::table::source::{self, Diagnostic, Source};
use geometry::{Arc, Circle, DVec2, Segment};
use roxmltree::Node;
use std::collections::{BTreeMap, BTreeSet};

/// Shapes that a drawing may have.
const MOST_SHAPES: usize = 100_000;
/// The largest drawing, bytes.
const LIMIT_BYTES: u64 = 8 << 20;

/// A drawing's shapes.
#[derive(Clone, Debug)]
pub struct DrawnShapes {
    /// Width and height of the drawing, mm.
    pub size_mm: DVec2,
    /// In the order in which they are drawn.
    pub shapes: Vec<DrawnShape>,
    /// The `data-` attributes of the drawing as a whole.
    pub data: BTreeMap<String, String>,
    /// The drawing with its sheets and clones written out, as SVG text: its art is read from this.
    pub svg: String,
    /// What is odd in the file and yet no mistake.
    pub warnings: Vec<Failure>,
    source: Source,
    /// The drawing as it is in the file.
    pub(super) file: Source,
}

/// A shape with a class.
#[derive(Clone, Debug)]
pub struct DrawnShape {
    /// The words of its class.
    pub words: Vec<String>,
    /// Its id, if it has one.
    pub id: Option<String>,
    /// Where it begins in the written out drawing.
    at: usize,
    /// Where it begins in the file; of a clone, its `use`.
    pub(super) in_file: usize,
    /// What is drawn, mm.
    pub outline: DrawnOutline,
    /// Of its line, mm.
    pub thickness_mm: f64,
    /// The colour inside, sRGB; `None` for nothing and for gradients.
    pub fill: Option<[u8; 3]>,
    /// Whether anything is painted inside.
    pub is_filled: bool,
    /// The colour of its line.
    pub stroke: Option<[u8; 3]>,
    /// Its `data-` attributes and those of the groups around it; the nearest counts.
    pub data: BTreeMap<String, String>,
    /// The names of its own `data-` attributes.
    pub own_data: BTreeSet<String>,
}

/// What a shape draws.
#[derive(Clone, Debug, PartialEq)]
pub enum DrawnOutline {
    /// A circle.
    Circle(Circle),
    /// Connected lines, each of at least one piece.
    Lines(Vec<DrawnLine>),
}

/// A connected line.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnLine {
    /// Its pieces, one after the other.
    pub pieces: Vec<DrawnPiece>,
    /// It ends where it began.
    pub closed: bool,
}

/// A piece of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrawnPiece {
    /// A straight one.
    Line(Segment),
    /// A circular one.
    Arc(Arc),
}

impl DrawnShapes {
    /// Reads the drawing called `path`, which holds `bytes`. A class that is none of `words` nor a table's is told, with the word
    /// that was meant.
    ///
    /// # Errors
    /// Every mistake in it, one line each: file, line, what was expected.
    pub fn read(path: &str, bytes: Vec<u8>, words: &[&'static str]) -> Result<DrawnShapes, Vec<Failure>> {
        let mut diagnostics = Vec::new();
        match read(path, bytes, words, &mut diagnostics) {
            Some(drawn) if diagnostics.iter().all(Diagnostic::is_warning) => {
                Ok(DrawnShapes { warnings: source::failures(diagnostics), ..drawn })
            }
            _ => Err(source::failures(diagnostics)),
        }
    }

    /// The mistake `what` in the line where the drawing begins.
    pub fn mistake_of_all(&self, what: impl std::fmt::Display) -> Failure {
        let begin = self.source.text.find("<svg").unwrap_or(0);
        self.source.diagnostic(begin, what).failure()
    }

    /// The mistake `what` in the line of a shape.
    pub fn mistake(&self, shape: &DrawnShape, what: impl std::fmt::Display) -> Failure {
        self.source.diagnostic(shape.at, what).failure()
    }

    /// The same as a warning.
    pub fn warning(&self, shape: &DrawnShape, what: impl std::fmt::Display) -> Failure {
        self.source.diagnostic(shape.at, what).into_warning().failure()
    }
}

fn read(path: &str, bytes: Vec<u8>, words: &[&'static str], diagnostics: &mut Vec<Diagnostic>) -> Option<DrawnShapes> {
    let source = Source::read(path.to_string(), Ok(bytes), LIMIT_BYTES);
    let source = source.map_err(|diagnostic| diagnostics.push(diagnostic)).ok()?;
    let written = written_out::write_out(source, diagnostics)?;
    let WrittenOut { source, styled, file, .. } = &written;
    let document = xml::parse(source).map_err(|diagnostic| diagnostics.push(diagnostic)).ok()?;
    let root = document.root_element();
    let page = Page::of(root).map_err(|why| diagnostics.push(source.diagnostic(root.range().start, why))).ok()?;
    let mut reader = Reader { source, diagnostics, words, styled, told: BTreeSet::new(), shapes: vec![] };
    reader.children(root, &Ok(Transform::scaling(page.mm_per_unit)));
    let mut shapes = reader.shapes;
    shapes.iter_mut().for_each(|shape| shape.in_file = written.origin(shape.at));
    let (svg, data, size_mm) = (source.text.clone(), data(root), page.size_mm);
    Some(DrawnShapes { size_mm, shapes, data, svg, warnings: Vec::new(), source: source.clone(), file: file.clone() })
}

struct Reader<'a> {
    source: &'a Source,
    diagnostics: &'a mut Vec<Diagnostic>,
    words: &'a [&'static str],
    styled: &'a BTreeSet<String>,
    /// Words without a meaning that were told.
    told: BTreeSet<String>,
    shapes: Vec<DrawnShape>,
}

impl Reader<'_> {
    fn children(&mut self, parent: Node, transform: &Result<Transform, String>) {
        for node in parent.children().filter(Node::is_element) {
            let is_drawn = style::own_property(node, "display") != Some("none") && is_chosen(node);
            if is_drawn && self.shapes.len() <= MOST_SHAPES {
                self.visit(node, transform);
            }
        }
    }

    fn visit(&mut self, node: Node, around: &Result<Transform, String>) {
        let attribute = node.attribute("transform").unwrap_or("");
        let transform = around.clone().and_then(|transform| transform.transformed(attribute));
        if is_container(node) {
            self.group_with_a_word(node);
            let is_inner_svg = node.tag_name().name() == "svg";
            let inner = if is_inner_svg { transform.and_then(|outer| inner_svg(outer, node)) } else { transform };
            return self.children(node, &inner);
        }
        let is_silent =
            matches!(node.tag_name().name(), "defs" | "symbol" | "marker" | "clipPath" | "mask" | "pattern");
        if is_silent || !self.is_thing(node) {
            return;
        }
        if self.shapes.len() == MOST_SHAPES {
            self.tell(node, format!("there are more than {MOST_SHAPES} shapes with a class"));
        }
        match transform.and_then(|transform| shape(node, transform)) {
            Ok(shape) => self.shapes.push(shape),
            Err(why) => self.tell(node, why),
        }
    }

    /// Tells of a group that is meant to be a thing: its shapes would be art.
    fn group_with_a_word(&mut self, node: Node) {
        let words = node.attribute("class").unwrap_or("").split_ascii_whitespace();
        let is_known = |word: &&str| self.words.contains(word) || ElementClass::from_word(word).is_some();
        if words.into_iter().any(|word| is_known(&word)) {
            self.tell(node, "a group is no thing: give the class to each shape in it instead");
        }
    }

    fn tell(&mut self, node: Node, what: impl std::fmt::Display) {
        self.diagnostics.push(self.source.diagnostic(node.range().start, what));
    }

    /// Whether an element has a word that means something; tells of words that mean nothing.
    fn is_thing(&mut self, node: Node) -> bool {
        let words: Vec<&str> = node.attribute("class").unwrap_or("").split_ascii_whitespace().collect();
        let is_known = |word: &str| self.words.contains(&word) || ElementClass::from_word(word).is_some();
        if words.iter().any(|word| is_known(word)) {
            return true;
        }
        for word in words {
            if class_typo::is_known(word) || self.styled.contains(word) || !self.told.insert(word.to_string()) {
                continue;
            }
            let known = self.words.iter().copied().chain(ElementClass::ALL.map(ElementClass::word));
            match class_typo::nearest(word, known) {
                Some(meant) => self.tell(node, format!("the class `{word}` means nothing; did you mean `{meant}`?")),
                None => {
                    let what = format!("the class `{word}` means nothing, so what has it is art");
                    self.diagnostics.push(self.source.diagnostic(node.range().start, what).into_warning());
                }
            }
        }
        false
    }
}

fn shape(node: Node, transform: Transform) -> Result<DrawnShape, String> {
    check_place(node)?;
    let scale = transform.scale()?;
    let thickness_mm = style::stroke_width(node)? * scale;
    let (fill, stroke) = (style::fill(node)?, style::stroke(node)?);
    let color = |paint: Paint| match paint {
        Paint::Color(color) => Some(color),
        Paint::None | Paint::Other => None,
    };
    let own = data(node);
    let own_data = own.keys().cloned().collect();
    let data = node.ancestors().skip(1).fold(own, |mut near, outer| {
        for (name, value) in data(outer) {
            near.entry(name).or_insert(value);
        }
        near
    });
    let words = node.attribute("class").unwrap_or("").split_ascii_whitespace().map(str::to_string).collect();
    Ok(DrawnShape {
        words,
        id: node.attribute("id").map(str::to_string),
        at: node.range().start,
        in_file: node.range().start,
        outline: drawn(Outline::of(node, transform, scale, Curves::Arcs)?),
        thickness_mm,
        fill: color(fill),
        is_filled: fill.is_painted(),
        stroke: color(stroke),
        data,
        own_data,
    })
}

/// The `data-` attributes of an element.
fn data(node: Node) -> BTreeMap<String, String> {
    let named = node.attributes().filter_map(|attribute| {
        let name = attribute.name().strip_prefix("data-")?;
        Some((name.to_string(), attribute.value().trim().to_string()))
    });
    named.collect()
}

fn drawn(outline: Outline) -> DrawnOutline {
    let piece = |piece: &Piece| match piece {
        Piece::Segment(line) => DrawnPiece::Line(*line),
        Piece::Arc(arc) => DrawnPiece::Arc(*arc),
    };
    match outline {
        Outline::Circle(circle) => DrawnOutline::Circle(circle),
        Outline::Subpaths(subpaths) => DrawnOutline::Lines(
            subpaths
                .iter()
                .map(|subpath| DrawnLine { pieces: subpath.pieces.iter().map(piece).collect(), closed: subpath.closed })
                .collect(),
        ),
    }
}
