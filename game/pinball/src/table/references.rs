//! References: which elements of a drawing are drawn with which others, and that none is drawn with itself.

use super::page::SVG;
use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// XLink's namespace, where SVG 1.1 has its `href`.
const XLINK: &str = "http://www.w3.org/1999/xlink";
/// Elements whose `href` says what they draw with; that of an `<a>` says where a click would lead.
const DRAWN_WITH_HREF: [&str; 8] =
    ["use", "linearGradient", "radialGradient", "pattern", "filter", "feImage", "textPath", "tref"];

/// Elements that may lie inside each other, those that they refer to included.
const MAX_DEPTH: usize = 64;
/// Elements that a drawing may have when each `<use>` is what it copies.
const MAX_ELEMENTS: usize = 200_000;
/// The text that a drawing may be when each `<use>` is what it copies, bytes.
const MAX_BYTES: usize = 32 << 20;

/// The elements of a drawing by their ids; of two with one id the first is meant.
pub(super) struct Links<'a, 'i> {
    by_id: BTreeMap<&'a str, Node<'a, 'i>>,
}

impl<'a, 'i> Links<'a, 'i> {
    /// Those of a drawing.
    pub fn of(document: &'a Document<'i>) -> Links<'a, 'i> {
        let mut by_id = BTreeMap::new();
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                by_id.entry(id).or_insert(node);
            }
        }
        Links { by_id }
    }

    /// The element with this id.
    pub fn named(&self, id: &str) -> Option<Node<'a, 'i>> {
        self.by_id.get(id).copied()
    }

    /// What the element's `href` names, if it names something in the drawing.
    pub fn target(&self, node: Node) -> Option<Node<'a, 'i>> {
        let id = href(node)?.trim().strip_prefix('#')?;
        self.named(id)
    }

    /// What the element is drawn with besides what is inside it; `style` is what is declared for it.
    fn references(&self, node: Node, style: &str) -> Vec<Node<'a, 'i>> {
        let drawn_with = DRAWN_WITH_HREF.contains(&node.tag_name().name());
        let mut found: Vec<Node> = self.target(node).filter(|_| drawn_with).into_iter().collect();
        let attributes = node.attributes().filter(|attribute| attribute.namespace().is_none());
        for text in attributes.filter(|attribute| attribute.name() != "style").map(|one| one.value()).chain([style]) {
            found.extend(urls(text).filter_map(|id| self.by_id.get(id)));
        }
        found
    }
}

/// An element's `href`, the newer form before the older.
pub(super) fn href<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    node.attribute("href").or_else(|| node.attribute((XLINK, "href")))
}

/// Whether an element is a `<use>`.
pub(super) fn is_use(node: Node) -> bool {
    node.has_tag_name((SVG, "use"))
}

/// The ids in the `url(#id)` of a text.
pub(super) fn urls(text: &str) -> impl Iterator<Item = &str> {
    text.split("url(").skip(1).filter_map(|rest| {
        let inside = rest[..rest.find(')')?].trim();
        inside.trim_matches(['"', '\'']).trim().strip_prefix('#')
    })
}

/// What an element comes to when everything that it is drawn with is counted.
#[derive(Clone, Copy, Default)]
struct Whole {
    /// Elements inside each other.
    depth: usize,
    elements: usize,
    bytes: usize,
}

/// How far the walk has come with an element.
#[derive(Clone, Copy)]
enum Visit {
    Not,
    Begun,
    Done(Whole),
}

/// An element on the walk's way.
struct Step<'a, 'i> {
    node: Node<'a, 'i>,
    /// What it is drawn with: its children, then its references.
    parts: Vec<Node<'a, 'i>>,
    next: usize,
    whole: Whole,
}

/// Mistakes in what a drawing's elements are drawn with: where, and what is wrong.
///
/// `style_of` knows what is declared for an element.
pub(super) fn check<'a>(
    document: &'a Document,
    links: &Links<'a, '_>,
    style_of: impl Fn(Node) -> Option<&'a str>,
) -> Vec<(usize, String)> {
    let root = document.root_element();
    let visits = vec![Visit::Not; document.descendants().count()];
    let mut walk = Walk { links, style_of, visits, way: Vec::new(), circles: Vec::new(), too_deep: None };
    walk.begin(root);
    let whole = walk.walk();
    let mut mistakes = walk.circles;
    mistakes.extend(walk.too_deep.map(|at| {
        let what = "elements lie inside each other, what they refer to included; take some out";
        (at, format!("more than {MAX_DEPTH} {what}"))
    }));
    let limits = [
        (whole.elements > MAX_ELEMENTS, format!("more than {MAX_ELEMENTS} elements")),
        (whole.bytes > MAX_BYTES, format!("more than {} MB", MAX_BYTES >> 20)),
    ];
    if let Some((_, what)) = limits.iter().find(|(is_exceeded, _)| *is_exceeded && mistakes.is_empty()) {
        let why = format!("with all that its <use> elements copy it has {what}; draw it more simply");
        mistakes.push((root.range().start, why));
    }
    mistakes
}

struct Walk<'w, 'a, 'i, S> {
    links: &'w Links<'a, 'i>,
    style_of: S,
    visits: Vec<Visit>,
    /// From the drawing's first element to where the walk is. A stack of its own: a file may nest without end.
    way: Vec<Step<'a, 'i>>,
    circles: Vec<(usize, String)>,
    /// Where the first element lies that is inside too many.
    too_deep: Option<usize>,
}

impl<'a, 'i, S: Fn(Node) -> Option<&'a str>> Walk<'_, 'a, 'i, S> {
    fn begin(&mut self, node: Node<'a, 'i>) {
        if self.way.len() >= MAX_DEPTH {
            self.too_deep.get_or_insert(node.range().start);
            return self.visits[node.id().get_usize()] = Visit::Done(Whole::default());
        }
        let children: Vec<Node> = node.children().filter(Node::is_element).collect();
        let inside: usize = children.iter().map(|child| child.range().len()).sum();
        let whole = Whole { depth: 0, elements: 1, bytes: node.range().len() - inside };
        let style = (self.style_of)(node).or_else(|| node.attribute("style")).unwrap_or("");
        let mut parts = children;
        parts.extend(self.links.references(node, style));
        self.visits[node.id().get_usize()] = Visit::Begun;
        self.way.push(Step { node, parts, next: 0, whole });
    }

    fn walk(&mut self) -> Whole {
        while let Some(step) = self.way.last_mut() {
            let part = step.parts.get(step.next).copied();
            step.next += 1;
            let Some(part) = part else {
                if let Some(whole) = self.end() {
                    return whole;
                }
                continue;
            };
            match self.visits[part.id().get_usize()] {
                Visit::Not => self.begin(part),
                Visit::Begun => self.circle(part),
                Visit::Done(whole) => self.add(part, whole),
            }
        }
        Whole::default()
    }

    /// The element at the end of the way is done: what it comes to, if it was the first.
    fn end(&mut self) -> Option<Whole> {
        let Step { node, mut whole, .. } = self.way.pop()?;
        whole.depth += 1;
        self.visits[node.id().get_usize()] = Visit::Done(whole);
        if self.way.is_empty() {
            return Some(whole);
        }
        self.add(node, whole);
        None
    }

    /// Counts what a part comes to: only a `<use>` makes a copy of what it refers to.
    fn add(&mut self, part: Node, whole: Whole) {
        let inside = self.way.len() + whole.depth;
        let Some(step) = self.way.last_mut() else { return };
        if inside > MAX_DEPTH {
            self.too_deep.get_or_insert(step.node.range().start);
        }
        step.whole.depth = step.whole.depth.max(whole.depth);
        if part.parent() == Some(step.node) || is_use(step.node) {
            step.whole.elements = step.whole.elements.saturating_add(whole.elements);
            step.whole.bytes = step.whole.bytes.saturating_add(whole.bytes);
        }
    }

    /// The way has come back to `first`: tells which elements refer to each other.
    fn circle(&mut self, first: Node) {
        let start = self.way.iter().position(|step| step.node == first).unwrap_or(0);
        let round = &self.way[start..];
        let mut names: Vec<String> = vec![name(first)];
        for pair in round.windows(2) {
            if pair[1].node.parent() != Some(pair[0].node) {
                names.push(name(pair[1].node));
            }
        }
        names.push(name(first));
        let at = round.last().map_or(0, |step| step.node.range().start);
        let what = if names.len() == 2 { "refers to itself" } else { "and what it refers to refer to each other" };
        let way = names.join(" -> ");
        self.circles.push((at, format!("{} {what} without end: {way}; take this reference out", names[0])));
    }
}

fn name(node: Node) -> String {
    format!("#{}", node.attribute("id").unwrap_or_else(|| node.tag_name().name()))
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
            <mask id="o"><path fill="url(#m)"/></mask>"##;
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
        ] {
            assert_eq!(told(good), [""; 0], "{good}");
        }
    }

    #[test]
    fn copies_without_end_are_refused_before_they_are_made() {
        let mut laughs = String::from(r#"<defs><g id="l0"><path/><path/></g>"#);
        for i in 1..20 {
            laughs += &format!(r##"<g id="l{i}"><use href="#l{}"/><use href="#l{}"/></g>"##, i - 1, i - 1);
        }
        let told_of = told(&format!("{laughs}</defs>"));
        assert!(told_of[0].contains("more than 200000 elements"), "{told_of:?}");
        let long = "M0 0".repeat(20_000);
        let heavy = format!(r##"<path id="p" d="{long}"/>{}"##, r##"<use href="#p"/>"##.repeat(1000));
        assert!(told(&heavy)[0].contains("more than 32 MB"));
        let chain: String = (0..5000).map(|i| format!(r##"<use id="c{i}" href="#c{}"/>"##, i + 1)).collect();
        assert!(told(&chain)[0].contains("more than 64 elements lie inside each other"));
    }
}
