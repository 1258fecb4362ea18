//! Amount: how much a drawing is once everything that it refers to stands where it is drawn.
//!
//! A pattern in a pattern in a pattern is short in the file and endless in the picture, and whoever draws follows every
//! reference before anybody sees how much comes of it. So it is counted here first, from the file alone.

use super::references::{Links, Reference, Times, references};
use roxmltree::{Document, Node};

/// Elements that a drawing may have, written out.
const MAX_ELEMENTS: f64 = 200_000.0;
/// Letters that it may have, written out.
const MAX_LETTERS: f64 = 50_000.0;
/// Corners of paths that it may have, written out: as many as the largest drawing has bytes, halved.
const MAX_CORNERS: f64 = 4e6;
/// The text that it may be when each `<use>` is what it copies, MB.
const MAX_MB: f64 = 32.0;
/// Pairs of pieces of the same text: a text of a thousand pieces takes a second.
const MAX_PAIRS_OF_PIECES: f64 = 1e6;
/// How deep elements may lie in each other, references counted.
const MAX_DEPTH: usize = 128;

/// How much an element is, with all that is in it and all that it refers to.
#[derive(Clone, Copy, Debug, Default)]
struct Amount {
    elements: f64,
    letters: f64,
    /// Of the text, where each `<use>` is what it copies.
    bytes: f64,
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
        self.bytes = sum(self.bytes, other.bytes);
        self.shapes = sum(self.shapes, other.shapes);
        self.corners = sum(self.corners, other.corners);
    }

    /// Adds what is drawn so many times, and inherits nothing from here.
    fn add_drawn(&mut self, other: Amount, times: f64) {
        self.elements = sum(self.elements, other.elements * times);
        self.letters = sum(self.letters, other.letters * times);
        self.drawn_corners = sum(self.drawn_corners, other.drawn_corners * times);
        self.depth = self.depth.max(other.depth + 1);
    }
}

/// A sum that stays a number, whatever is added.
fn sum(a: f64, b: f64) -> f64 {
    (a + b).min(1e15)
}

/// What is known of an element.
#[derive(Clone, Copy)]
enum Known {
    Nothing,
    /// It is being counted.
    Open,
    Counted(Amount),
}

struct Counter<'c, 'a, 'i, S> {
    links: &'c Links<'a, 'i>,
    style_of: S,
    /// By the number of the node.
    known: Vec<Known>,
    /// From the drawing's first element to the one that is being counted.
    way: Vec<Node<'a, 'i>>,
    /// The reference that adds the most elements, and where it is.
    largest: Option<(f64, Reference<'a>, usize)>,
    circles: Vec<(usize, String)>,
    /// Where the first element lies that is inside too many.
    too_deep: Option<usize>,
}

/// What is wrong with what the elements of a drawing refer to: where, and what is too much or endless.
///
/// `style_of` knows what is declared for an element.
pub(in crate::table) fn check<'a>(
    document: &'a Document,
    links: &Links<'a, '_>,
    style_of: impl Fn(Node) -> Option<&'a str>,
) -> Vec<(usize, String)> {
    let known = vec![Known::Nothing; document.descendants().count()];
    let mut counter =
        Counter { links, style_of, known, way: Vec::new(), largest: None, circles: Vec::new(), too_deep: None };
    let all = counter.count(document.root_element());
    let mut mistakes = counter.circles;
    mistakes.extend(scattered_text(document));
    mistakes.extend(counter.too_deep.map(|at| {
        let what = "elements lie inside each other here, what they refer to included; take some out";
        (at, format!("more than {MAX_DEPTH} {what}"))
    }));
    if mistakes.is_empty() {
        mistakes.extend(too_much(&all).map(|what| {
            let (at, adds) = counter.largest.map_or((0, String::new()), |(_, reference, at)| {
                (at, format!("; `{}`, which is drawn here, adds the most of them", reference.id))
            });
            (at, format!("the drawing has {what} once it is written out{adds}"))
        }));
    }
    mistakes
}

/// The text of the most pieces, if all texts' pieces take too long to be set: of each piece all others of its text are looked
/// at.
fn scattered_text(document: &Document) -> Option<(usize, String)> {
    let pieces = |text: &Node| text.descendants().filter(Node::is_element).count();
    let texts = document.descendants().filter(|node| node.tag_name().name() == "text");
    let counted: Vec<(usize, usize)> = texts.map(|text| (pieces(&text), text.range().start)).collect();
    let pairs: f64 = counted.iter().map(|(pieces, _)| (*pieces as f64).powi(2)).sum();
    let (pieces, at) = counted.into_iter().max_by_key(|(pieces, _)| *pieces)?;
    let what = format!("this text has {pieces} pieces (`tspan`), which take too long to set; make several texts of it");
    (pairs > MAX_PAIRS_OF_PIECES).then_some((at, what))
}

fn too_much(all: &Amount) -> Option<String> {
    let limits = [
        (all.elements, "elements", MAX_ELEMENTS),
        (all.letters, "letters", MAX_LETTERS),
        (all.drawn_corners, "corners", MAX_CORNERS),
        ((all.bytes * 1e-6).ceil(), "MB", MAX_MB),
    ];
    let exceeded = limits.iter().find(|(count, _, most)| count > most);
    exceeded.map(|(count, what, most)| format!("{count:.0} {what}, and {most} is the most,"))
}

impl<'a, 'i, S: Fn(Node) -> Option<&'a str>> Counter<'_, 'a, 'i, S> {
    fn count(&mut self, node: Node<'a, 'i>) -> Amount {
        let number = node.id().get_usize();
        let depth = self.way.len();
        match self.known[number] {
            Known::Counted(amount) => {
                if depth + amount.depth > MAX_DEPTH {
                    self.too_deep.get_or_insert(node.range().start);
                }
                return amount;
            }
            Known::Open => {
                self.circle(node);
                return Amount::default();
            }
            Known::Nothing if depth > MAX_DEPTH => {
                self.too_deep.get_or_insert(node.range().start);
                return Amount::default();
            }
            Known::Nothing => self.known[number] = Known::Open,
        }
        self.way.push(node);
        let mut amount = own(node);
        for child in node.children().filter(Node::is_element) {
            let child = self.count(child);
            amount.add(child);
        }
        let style = (self.style_of)(node).or_else(|| node.attribute("style")).unwrap_or("");
        for reference in references(node, style) {
            self.refer(node, reference, &mut amount);
        }
        self.way.pop();
        self.known[number] = Known::Counted(amount);
        amount
    }

    /// Adds what a reference of an element draws to what the element is.
    fn refer(&mut self, node: Node<'a, 'i>, reference: Reference<'a>, amount: &mut Amount) {
        for target in self.links.find(reference) {
            let drawn = self.count(target);
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
                self.largest = Some((added, reference, node.range().start));
            }
        }
    }

    /// The way has come back to `first`: tells which elements refer to each other.
    fn circle(&mut self, first: Node) {
        let start = self.way.iter().position(|node| *node == first).unwrap_or(0);
        let round = &self.way[start..];
        let referred = round.windows(2).filter(|pair| pair[1].parent() != Some(pair[0])).map(|pair| name(pair[1]));
        let names: Vec<String> = [name(first)].into_iter().chain(referred).chain([name(first)]).collect();
        let at = round.last().map_or(0, |node| node.range().start);
        let id_of_two = |node: &&Node| node.attribute("id").is_some_and(|id| self.links.named(id) != Some(**node));
        if let Some(second) = round.iter().find(id_of_two) {
            let id = second.attribute("id").unwrap_or_default();
            let what = format!("the id `{id}` is given twice, and is meant to draw itself; give each its own");
            return self.circles.push((at, what));
        }
        let what = if names.len() == 2 { "refers to itself" } else { "and what it refers to refer to each other" };
        let way = names.join(" -> ");
        self.circles.push((at, format!("{} {what} without end: {way}; take this reference out", names[0])));
    }
}

fn name(node: Node) -> String {
    format!("#{}", node.attribute("id").unwrap_or_else(|| node.tag_name().name()))
}

/// What an element is by itself.
fn own(node: Node) -> Amount {
    let inside: usize = node.children().filter(Node::is_element).map(|child| child.range().len()).sum();
    let plain = Amount { elements: 1.0, bytes: (node.range().len() - inside) as f64, ..Amount::default() };
    let shape = |corners: f64| Amount { shapes: 1.0, corners, drawn_corners: corners, ..plain };
    let length = |attribute: &str| node.attribute(attribute).map_or(0.0, |text| text.len() as f64);
    match node.tag_name().name() {
        // No command of a path, and no corner, is shorter than two bytes.
        "path" => shape((length("d") / 2.0).ceil()),
        "polyline" | "polygon" => shape((length("points") / 2.0).ceil()),
        "line" => shape(2.0),
        "rect" | "circle" | "ellipse" | "image" => shape(0.0),
        "text" | "tspan" | "textPath" | "a" => {
            let text = node.children().filter(Node::is_text).filter_map(|text| text.text());
            Amount { letters: text.map(|text| text.chars().count() as f64).sum(), ..shape(0.0) }
        }
        _ => plain,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(inner: &str) -> Vec<String> {
        let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg">{inner}</svg>"#);
        let document = Document::parse(&svg).unwrap();
        let told = check(&document, &Links::of(&document), |_| None);
        told.into_iter().map(|(_, what)| what).collect()
    }

    #[test]
    fn circles_are_told_by_their_ids() {
        let two = r##"<defs><g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g></defs><use href="#a"/>"##;
        assert_eq!(
            told(two),
            ["#a and what it refers to refer to each other without end: #a -> #b -> #a; take this reference out"]
        );
        let own = r##"<g id="a"><g><use href="#a"/></g></g>"##;
        assert_eq!(told(own), ["#a refers to itself without end: #a -> #a; take this reference out"]);
        let masks = r##"<mask id="m"><path mask="url(#n)"/></mask><mask id="n"><path style="mask: url( '#o' )"/></mask>
            <mask id="o"><path clip-path="url(#m)"/></mask>"##;
        let [circle] = &told(masks)[..] else { panic!() };
        assert!(circle.contains("#m -> #n -> #o -> #m"), "{circle}");
        let three = r##"<use id="p" href="#q"/><use id="q" href="#r"/><use id="r" href="#p"/>"##;
        assert!(told(three)[0].contains("#p -> #q -> #r -> #p"), "{:?}", told(three));
    }

    #[test]
    fn what_only_looks_like_a_circle_is_none() {
        for good in [
            r##"<g id="a"><a href="#a"><path/></a></g>"##,
            r##"<g id="a" clip-path="url(#c)"><clipPath id="c"><path/></clipPath></g>"##,
            r##"<linearGradient id="a"/><linearGradient id="b" href="#a"/><path fill="url(#b)" stroke="url(#b)"/>"##,
            r##"<path id="a"/><use href="#a"/><use href="#a"/><use href="#nobody"/>"##,
            r##"<g id="a"><linearGradient id="a"/><path fill="url(#a)"/></g>"##,
        ] {
            assert_eq!(told(good), [""; 0], "{good}");
        }
    }

    /// A text of 5,000 pieces, 80 kB of file, took half a minute.
    #[test]
    fn a_text_of_too_many_pieces_is_refused() {
        let text = |pieces: usize| format!("<text>{}</text>", "<tspan>a</tspan>".repeat(pieces));
        assert_eq!(told(&text(900)), [""; 0]);
        assert!(told(&text(1100))[0].starts_with("this text has 1101 pieces (`tspan`)"), "{:?}", told(&text(1100)));
        assert!(told(&text(300).repeat(20))[0].starts_with("this text has 301 pieces"));
    }

    #[test]
    fn copies_without_end_are_refused_before_they_are_made() {
        let mut laughs = String::from(r#"<defs><g id="l0"><path/><path/></g>"#);
        for i in 1..20 {
            laughs += &format!(r##"<g id="l{i}"><use href="#l{}"/><use href="#l{}"/></g>"##, i - 1, i - 1);
        }
        let told_of = told(&format!("{laughs}</defs>"));
        assert!(told_of[0].contains(" elements, and 200000 is the most, once it is written out; `l"), "{told_of:?}");
        let heavy =
            format!(r##"<desc id="p">{}</desc>{}"##, "M0 0".repeat(20_000), r##"<use href="#p"/>"##.repeat(1000));
        assert!(told(&heavy)[0].contains("81 MB, and 32 is the most"), "{:?}", told(&heavy));
        let chain: String = (0..5000).map(|i| format!(r##"<use id="c{i}" href="#c{}"/>"##, i + 1)).collect();
        assert!(told(&chain)[0].contains("more than 128 elements lie inside each other"));
    }
}
