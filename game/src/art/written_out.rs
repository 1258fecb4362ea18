//! Art written out: how much it is once everything that it refers to stands where it is drawn.
//!
//! A pattern in a pattern in a pattern is short in the file and endless in the picture, and the library that reads art
//! follows every reference before anybody sees how much comes of it. So it is counted here first, from the file alone.

use super::numbers;
use super::references::{Reference, References, Times, sheets};
use crate::Failure;
use resvg::usvg::roxmltree::{Document, Node};

/// Elements that art may have, written out.
const MAX_ELEMENTS: f64 = 200_000.0;
/// Letters that art may have, written out.
const MAX_LETTERS: f64 = 50_000.0;
/// How deep elements may lie in each other, references counted.
const MAX_DEPTH: usize = 128;
/// Corners of paths that art may have, written out: as many as the largest drawing has bytes, halved.
const MAX_CORNERS: f64 = 4e6;
/// Comparisons of selectors with elements.
const MAX_COMPARISONS: f64 = 5e7;
/// Bytes of the style sheets times rules in them: the library that reads them counts lines from the start for each.
const MAX_SHEET_STEPS: f64 = 2e8;

/// How much an element is, with all that is in it and all that it refers to.
#[derive(Clone, Copy, Debug, Default)]
struct Amount {
    elements: f64,
    letters: f64,
    /// What takes an inherited paint...
    shapes: f64,
    /// ... and where inherited markers stand.
    corners: f64,
    /// Corners with those of all that is referred to.
    drawn_corners: f64,
    depth: usize,
}

impl Amount {
    fn add(&mut self, other: Amount) {
        self.add_drawn(other, 1.0);
        self.shapes += other.shapes;
        self.corners += other.corners;
    }

    /// Adds what is drawn so many times, and inherits nothing from here.
    fn add_drawn(&mut self, other: Amount, times: f64) {
        self.elements += other.elements * times;
        self.letters += other.letters * times;
        self.drawn_corners += other.drawn_corners * times;
        self.depth = self.depth.max(other.depth + 1);
    }
}

/// What is known of an element.
#[derive(Clone, Copy)]
enum Known {
    Nothing,
    /// It is being counted.
    Open,
    Counted(Amount),
}

struct Counter<'a, 'input> {
    document: &'a Document<'input>,
    references: References<'a, 'input>,
    /// By the number of the node.
    known: Vec<Known>,
    /// The reference that adds the most elements, and where it is.
    largest: Option<(f64, Reference<'a>, Node<'a, 'input>)>,
}

/// Refuses art that is too much written out.
///
/// # Errors
/// What is too much, and where it comes from.
pub(super) fn check(document: &Document) -> Result<(), Failure> {
    check_sheets(document)?;
    let mut counter = Counter {
        document,
        references: References::new(document),
        known: vec![Known::Nothing; document.descendants().count()],
        largest: None,
    };
    // Sheets first: they are compared with elements as soon as references are looked for.
    let depth = counter.depth_in_file()?;
    counter.check_numbers()?;
    let plain = document.descendants().filter(Node::is_element).count() as f64;
    counter.check_comparisons(plain, depth)?;
    let all = counter.count(document.root_element(), 0)?;
    counter.check_comparisons(all.elements, depth)?;
    let at = || counter.largest_place();
    let too_many = |count: f64, what: &str, most: f64| {
        Failure::new(format!("the art has {count:.0} {what} once it is written out, and {most} is the most{}", at()))
    };
    if all.elements > MAX_ELEMENTS {
        return Err(too_many(all.elements, "elements", MAX_ELEMENTS));
    }
    if all.letters > MAX_LETTERS {
        return Err(too_many(all.letters, "letters", MAX_LETTERS));
    }
    if all.drawn_corners > MAX_CORNERS {
        return Err(too_many(all.drawn_corners, "corners", MAX_CORNERS));
    }
    Ok(())
}

fn check_sheets(document: &Document) -> Result<(), Failure> {
    let (mut bytes, mut rules) = (0, 0);
    for sheet in sheets(document) {
        bytes += sheet.len();
        rules += sheet.matches(['{', ',', ';']).count();
    }
    if bytes as f64 * rules as f64 <= MAX_SHEET_STEPS {
        return Ok(());
    }
    Err(Failure::new(format!("the style sheets have {rules} rules in {bytes} bytes; that is too much, write fewer")))
}

impl<'a, 'input> Counter<'a, 'input> {
    /// How deep elements lie in each other as the file has them.
    fn depth_in_file(&self) -> Result<usize, Failure> {
        let mut depths = vec![0; self.known.len()];
        for node in self.document.descendants().filter(Node::is_element) {
            let Some(parent) = node.parent_element() else { continue };
            let depth = depths[parent.id().get_usize()] + 1;
            if depth > MAX_DEPTH {
                return Err(self.too_deep(node));
            }
            depths[node.id().get_usize()] = depth;
        }
        Ok(depths.into_iter().max().unwrap_or(0))
    }

    fn check_numbers(&self) -> Result<(), Failure> {
        for node in self.document.descendants().filter(Node::is_element) {
            if let Some(mistake) = numbers::mistake(node) {
                return Err(self.failure(node, format!("{}: {mistake}", name(node))));
            }
        }
        Ok(())
    }

    fn check_comparisons(&self, elements: f64, depth: usize) -> Result<(), Failure> {
        let comparisons = elements * self.references.comparisons(depth.max(1) as f64);
        if comparisons <= MAX_COMPARISONS {
            return Ok(());
        }
        Err(Failure::new(format!(
            "the style sheet takes {comparisons:.0} comparisons of selectors with elements, and {MAX_COMPARISONS} is the \
             most; write fewer rules, and selectors of one word"
        )))
    }

    fn count(&mut self, node: Node<'a, 'input>, depth: usize) -> Result<Amount, Failure> {
        let number = node.id().get_usize();
        let deepest = |own: usize| depth + own > MAX_DEPTH;
        match self.known[number] {
            Known::Counted(amount) if deepest(amount.depth) => return Err(self.too_deep(node)),
            Known::Counted(amount) => return Ok(amount),
            Known::Open => return Err(self.failure(node, format!("{} is drawn inside itself", name(node)))),
            Known::Nothing if deepest(0) => return Err(self.too_deep(node)),
            Known::Nothing => self.known[number] = Known::Open,
        }
        let mut amount = own(node);
        for child in node.children().filter(Node::is_element) {
            let child = self.count(child, depth + 1)?;
            amount.add(child);
        }
        for reference in self.references.of(node) {
            self.refer(node, reference, depth, &mut amount)?;
        }
        self.known[number] = Known::Counted(amount);
        Ok(amount)
    }

    /// Adds what a reference of an element draws to what the element is.
    fn refer(
        &mut self,
        node: Node<'a, 'input>,
        reference: Reference<'a>,
        depth: usize,
        amount: &mut Amount,
    ) -> Result<(), Failure> {
        for target in self.references.find(reference) {
            let drawn = self.count(target, depth + 1)?;
            let times = match reference.times {
                Times::AsOwn | Times::Once => 1.0,
                Times::EachShape => amount.shapes,
                Times::EachCorner => amount.corners,
            };
            if reference.times == Times::AsOwn {
                amount.add(drawn)
            } else {
                amount.add_drawn(drawn, times)
            }
            let added = drawn.elements * times;
            if self.largest.is_none_or(|(most, ..)| added > most) {
                self.largest = Some((added, reference, node));
            }
        }
        Ok(())
    }

    fn too_deep(&self, node: Node) -> Failure {
        let what = format!("more than {MAX_DEPTH} elements lie inside each other here, references counted");
        self.failure(node, format!("{what}; take some out"))
    }

    fn failure(&self, node: Node, what: impl std::fmt::Display) -> Failure {
        Failure::new(format!("line {}: {what}", self.line(node)))
    }

    fn line(&self, node: Node) -> u32 {
        self.document.text_pos_at(node.range().start).row
    }

    /// Where the most comes from, to be put behind a sentence.
    fn largest_place(&self) -> String {
        self.largest.map_or_else(String::new, |(_, reference, node)| {
            format!("; `{}` adds the most in line {}", reference.id, self.line(node))
        })
    }
}

fn name(node: Node) -> String {
    let tag = node.tag_name().name();
    node.attribute("id").map_or_else(|| format!("this {tag}"), |id| format!("{tag} `{id}`"))
}

/// What an element is by itself.
fn own(node: Node) -> Amount {
    let tag = node.tag_name().name();
    let shape =
        |corners: f64| Amount { elements: 1.0, shapes: 1.0, corners, drawn_corners: corners, ..Amount::default() };
    let length = |attribute: &str| node.attribute(attribute).map_or(0.0, |text| text.len() as f64);
    match tag {
        // No command of a path, and no corner, is shorter than two bytes.
        "path" => shape((length("d") / 2.0).ceil()),
        "polyline" | "polygon" => shape((length("points") / 2.0).ceil()),
        "line" => shape(2.0),
        "rect" | "circle" | "ellipse" | "image" => shape(0.0),
        "text" | "tspan" | "textPath" | "a" => {
            let text = node.children().filter(Node::is_text).filter_map(|text| text.text());
            Amount { letters: text.map(|text| text.chars().count() as f64).sum(), ..shape(0.0) }
        }
        _ => Amount { elements: 1.0, ..Amount::default() },
    }
}
