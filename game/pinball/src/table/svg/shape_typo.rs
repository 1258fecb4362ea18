//! Attributes of shapes that SVG does not have, told from those that were meant to be one, and names of elements likewise.
//!
//! A browser passes over both in silence: the place that was meant is 0, and the shape is not drawn.

use super::class_typo;
use super::page::SVG;
use super::references::href;
use super::written_out::is_container;
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};

/// Attributes that are meant by themselves, wherever they stand.
const SHORT: [&str; 27] = [
    "by", "cx", "cy", "d", "dx", "dy", "fr", "fx", "fy", "id", "in", "in2", "k1", "k2", "k3", "k4", "r", "rx", "ry",
    "to", "x", "x1", "x2", "y", "y1", "y2", "z",
];
/// Attributes of every shape and group.
const COMMON: [&str; 4] = ["class", "id", "style", "transform"];
/// Attributes that are meant by no word that is one letter off: there are too many such words.
const EXACT: [&str; 7] = ["id", "x", "y", "r", "d", "rx", "ry"];

/// What a word that is another shape's, or another language's, means on a shape.
const MEANT: [(&str, &str, &str); 20] = [
    ("circle", "radius", "r"),
    ("circle", "rx", "r"),
    ("circle", "x", "cx"),
    ("circle", "y", "cy"),
    ("ellipse", "x", "cx"),
    ("ellipse", "y", "cy"),
    ("line", "x", "x1"),
    ("line", "y", "y1"),
    ("rect", "w", "width"),
    ("rect", "h", "height"),
    ("rect", "r", "rx"),
    ("rect", "x1", "x"),
    ("rect", "y1", "y"),
    ("path", "path", "d"),
    ("path", "data", "d"),
    ("path", "points", "d"),
    ("polyline", "d", "points"),
    ("polygon", "d", "points"),
    ("use", "src", "href"),
    ("", "classname", "class"),
];

/// Where a shape is and how large it is stands in these attributes; nothing of what is no shape.
fn places(element: &str) -> &'static [&'static str] {
    match element {
        "line" => &["x1", "y1", "x2", "y2"],
        "circle" => &["cx", "cy", "r"],
        "ellipse" => &["cx", "cy", "rx", "ry"],
        "rect" => &["x", "y", "width", "height", "rx", "ry"],
        "polyline" | "polygon" => &["points"],
        "path" => &["d"],
        "use" => &["x", "y", "width", "height", "href"],
        _ => &[],
    }
}

/// What of a drawing's elements and shapes' attributes has a name that SVG does not have, and nearly one.
pub(in crate::table) fn mistakes(source: &Source, document: &Document) -> Vec<Diagnostic> {
    let drawn = document.descendants().filter(|node| node.tag_name().namespace() == Some(SVG));
    drawn.flat_map(|node| told(node).into_iter().map(move |what| source.diagnostic(node.range().start, what))).collect()
}

fn told(node: Node) -> Vec<String> {
    let name = node.tag_name().name();
    if let Some(meant) = meant_element(name) {
        return vec![format!("SVG has no `{name}`; did you mean `{meant}`?")];
    }
    let article = if name == "ellipse" { "an" } else { "a" };
    let typo = |wrong: &str| {
        let meant = meant_attribute(node, wrong)?;
        Some(format!("{article} {name} has no `{wrong}`; did you mean `{meant}`?"))
    };
    let own = node.attributes().filter(|attribute| attribute.namespace().is_none());
    own.filter_map(|attribute| typo(attribute.name())).collect()
}

/// The attribute that was meant by one that a shape or a group does not have, if it lacks what was meant.
fn meant_attribute(node: Node, wrong: &str) -> Option<&'static str> {
    let name = node.tag_name().name();
    let places = places(name);
    if (places.is_empty() && !is_container(node)) || name == "svg" || wrong.starts_with("data-") {
        return None;
    }
    let has = |attribute: &str| match attribute {
        "href" => href(node).is_some(),
        _ => node.has_attribute(attribute),
    };
    let own = || places.iter().chain(&COMMON).copied();
    if own().any(|own| own == wrong) {
        return None;
    }
    let words = || MEANT.iter().filter(|(shape, ..)| shape.is_empty() || *shape == name);
    if let Some((.., meant)) = words().find(|(_, word, _)| is_same(word, wrong)) {
        return Some(*meant).filter(|meant| !has(meant));
    }
    if SHORT.contains(&wrong) {
        return None;
    }
    let near = |known: &str| !EXACT.contains(&known) && class_typo::nearest(wrong, [known]).is_some();
    let reversed: String = wrong.chars().rev().collect();
    let is = |known: &&str| is_same(known, wrong) || is_same(known, &reversed) || near(known);
    let meant = own().find(|known| is_same(known, wrong)).or_else(|| own().filter(|known| !has(known)).find(is));
    let of_word = || words().find(|(_, word, _)| word.len() > 3 && near(word)).map(|(.., meant)| *meant);
    meant.or_else(of_word).filter(|meant| !has(meant))
}

/// Whether two words are one but for case.
fn is_same(word: &str, other: &str) -> bool {
    word.eq_ignore_ascii_case(other)
}

/// What draws something, or holds what does.
const ELEMENTS: [&str; 26] = [
    "circle",
    "clipPath",
    "defs",
    "ellipse",
    "filter",
    "g",
    "image",
    "line",
    "linearGradient",
    "marker",
    "mask",
    "path",
    "pattern",
    "polygon",
    "polyline",
    "radialGradient",
    "rect",
    "stop",
    "style",
    "svg",
    "switch",
    "symbol",
    "text",
    "textPath",
    "tspan",
    "use",
];
/// Elements of SVG, old and new, that are nearly another.
const LIKE_OTHERS: [&str; 7] = ["a", "cursor", "font", "glyph", "mpath", "set", "view"];

/// The element that a name means but for case, a hyphen, a plural or one letter, if it is none itself.
pub(in crate::table) fn meant_element(name: &str) -> Option<&'static str> {
    if ELEMENTS.contains(&name) || LIKE_OTHERS.contains(&name) {
        return None;
    }
    let short = name.chars().count() < 3;
    let known = ELEMENTS.into_iter().filter(|known| known.len() > 2 && !short || is_same(known, name));
    class_typo::nearest(name, known.collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told_of(inner: &str) -> Vec<String> {
        let text = format!("<svg xmlns=\"{SVG}\" xmlns:i=\"i\">{inner}</svg>");
        let source = Source::new("a.svg".to_string(), text);
        let document = Document::parse(&source.text).unwrap();
        let told = mistakes(&source, &document).into_iter().map(|one| one.to_string());
        told.map(|one| one.strip_prefix("a.svg:1: ").unwrap().to_string()).collect()
    }

    /// The place that was meant was 0 in silence.
    #[test]
    fn an_attribute_but_for_case_order_or_a_letter_is_told_with_the_right_one() {
        for (shape, wrong, meant) in [
            ("circle", "yc", "cy"),
            ("circle", "CX", "cx"),
            ("circle", "R", "r"),
            ("circle", "radius", "r"),
            ("circle", "raduis", "r"),
            ("circle", "x", "cx"),
            ("ellipse", "Rx", "rx"),
            ("ellipse", "yr", "ry"),
            ("line", "X2", "x2"),
            ("line", "x", "x1"),
            ("line", "xx2", "x2"),
            ("rect", "widht", "width"),
            ("rect", "hieght", "height"),
            ("rect", "Height", "height"),
            ("rect", "w", "width"),
            ("polygon", "Points", "points"),
            ("polyline", "point", "points"),
            ("path", "D", "d"),
            ("use", "Href", "href"),
            ("g", "tranform", "transform"),
            ("path", "Class", "class"),
            ("path", "className", "class"),
            ("path", "ID", "id"),
        ] {
            let article = if shape == "ellipse" { "an" } else { "a" };
            let expected = format!("{article} {shape} has no `{wrong}`; did you mean `{meant}`?");
            assert_eq!(told_of(&format!("<{shape} {wrong}='5'/>")), [expected]);
        }
        assert_eq!(told_of("<rect widht='5' hieght='5'/>").len(), 2);
    }

    /// What programs leave behind, and what is there already, says nothing wrong.
    #[test]
    fn other_attributes_are_left_alone() {
        for good in [
            "<circle cx='1' cy='2' r='3' CX='4' radius='3' rx='3' ry='3'/>",
            "<path d='M0 0h9' x='1' y='2' width='3' height='4' cx='1' cy='1' r='2' rx='4' id='a' role='img'/>",
            "<line x1='1' y1='2' x2='3' y2='4' x='1' y='1' z='1' w='3'/>",
            "<rect width='3' height='3' i:widht='4' rx='1' ix='3' is='a' ids='b' tx='4' fx='3' data-x='4' Data-x='3'/>",
            "<circle r='5' dx='3' fx='3' by='3' k1='4' in='a' to='b' ry='2' lang='de' pathLength='1' tabindex='0'/>",
            "<use xlink='a' x='3' width='9' Width='9' href='#a'/>",
            "<text X='3' x='4' clas='a'/><linearGradient X1='3' id='a'/><i:rect widht='3'/>",
            "<g fill='red' name='a' label='b' xid='3' ie='4' styles='a' style='fill:red'/>",
        ] {
            assert_eq!(told_of(good), [""; 0], "{good}");
        }
    }

    #[test]
    fn an_element_but_for_case_or_a_letter_is_told_with_the_right_one() {
        for (wrong, meant) in [
            ("cirlce", "circle"),
            ("Line", "line"),
            ("lin", "line"),
            ("polylines", "polyline"),
            ("pollygon", "polygon"),
            ("lineargradient", "linearGradient"),
            ("rectt", "rect"),
            ("G", "g"),
            ("txt", "text"),
        ] {
            assert_eq!(told_of(&format!("<{wrong}/>")), [format!("SVG has no `{wrong}`; did you mean `{meant}`?")]);
        }
        let others = "a altGlyph altGlyphDef altGlyphItem animate animateColor animateMotion animateTransform audio canvas \
                      color-profile cursor desc discard feBlend feColorMatrix feComponentTransfer feComposite \
                      feConvolveMatrix feDiffuseLighting feDisplacementMap feDistantLight feDropShadow feFlood feFuncA \
                      feFuncB feFuncG feFuncR feGaussianBlur feImage feMerge feMergeNode feMorphology feOffset \
                      fePointLight feSpecularLighting feSpotLight feTile feTurbulence flowDiv flowLine flowPara \
                      flowRegion flowRegionBreak flowRegionExcluded flowRoot flowSpan flowTref font font-face \
                      font-face-format font-face-name font-face-src font-face-uri foreignObject glyph glyphRef hatch \
                      hatchpath hkern iframe mesh meshgradient meshpatch meshrow metadata missing-glyph mpath script \
                      set solidColor solidcolor title tref unknown video view vkern";
        for name in others.split_ascii_whitespace().chain(ELEMENTS) {
            assert_eq!(meant_element(name), None, "{name}");
        }
    }
}
