//! Elements without an id: names for them, so that one of them can be told by its line.

use resvg::usvg::roxmltree::{Document, Node};

/// How such a name begins.
const BEGIN: &str = "caustic-unnamed-";
/// What draws something, or holds what does.
const DRAWN: [&str; 10] = ["g", "path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "text", "use"];

/// The drawing with a name for each element that draws something and has none.
pub(super) fn named(svg: &str, document: &Document) -> String {
    let is_unnamed = |node: &Node| DRAWN.contains(&node.tag_name().name()) && node.attribute("id").is_none();
    let (mut out, mut copied, mut line, mut counted) = (String::with_capacity(svg.len()), 0, 1, 0);
    // They come in the order of the text, so that it is counted through once.
    for (count, node) in document.descendants().filter(is_unnamed).enumerate() {
        let at = node.range().start;
        line += svg[counted..at].matches('\n').count();
        counted = at;
        let tag = svg[at + 1..].find(|letter: char| letter.is_ascii_whitespace() || matches!(letter, '/' | '>'));
        let Some(end) = tag.map(|length| at + 1 + length) else { continue };
        out += &svg[copied..end];
        out += &format!(" id=\"{BEGIN}{}-{line}-{count}\"", node.tag_name().name());
        copied = end;
    }
    out + &svg[copied..]
}

/// What an element with such a name is called in a sentence.
pub(super) fn told(id: &str) -> Option<String> {
    let mut words = id.strip_prefix(BEGIN)?.split('-');
    let (name, line) = (words.next()?, words.next()?);
    Some(format!("a {name} in line {line}"))
}
