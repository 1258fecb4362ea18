//! Edits of a text: ranges of its bytes, and what stands in their place afterwards.
//!
//! Everything else is left as it was, so art stays what its maker wrote.

use roxmltree::Node;
use std::ops::Range;

/// Text to put in the place of a range of bytes.
pub(in crate::table) type Edit = (Range<usize>, String);

/// The text after `edits`, which do not overlap; of two at one place the earlier comes first. No line moves: the line
/// breaks that an edit has fewer than what it replaces come after it.
pub(in crate::table) fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|(range, _)| range.start);
    let mut result = String::with_capacity(text.len());
    let mut from = 0;
    for (range, new) in edits {
        result.push_str(&text[from..range.start]);
        result.push_str(&new);
        let lines = |text: &str| text.matches('\n').count();
        result.extend(std::iter::repeat_n('\n', lines(&text[range.clone()]).saturating_sub(lines(&new))));
        from = range.end;
    }
    result.push_str(&text[from..]);
    result
}

/// Where a place in the edited text comes from: the same byte, or the beginning of what an edit has replaced there.
pub(in crate::table) fn origin(edits: &[Edit], text: &str, at: usize) -> usize {
    let mut sorted: Vec<&Edit> = edits.iter().collect();
    sorted.sort_by_key(|(range, _)| range.start);
    // How far what follows has moved, and back.
    let (mut longer, mut shorter) = (0, 0);
    for (range, new) in sorted {
        let begin = range.start + longer - shorter;
        if at < begin {
            break;
        }
        let new = placed_length(&text[range.clone()], new);
        if at < begin + new {
            return range.start;
        }
        longer += new;
        shorter += range.len();
    }
    at + shorter - longer
}

/// How long a text is that has been put in the place of another.
fn placed_length(old: &str, new: &str) -> usize {
    let lines = |text: &str| text.matches('\n').count();
    new.len() + lines(old).saturating_sub(lines(new))
}

/// A text in one line, which moves no line of what it is put into.
pub(in crate::table) fn in_one_line(text: &str) -> String {
    text.replace(['\n', '\r'], " ")
}

/// A text as the value of an attribute in double quotes.
pub(in crate::table) fn escaped(value: &str) -> String {
    value.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// An element's name as the text writes it, with its prefix: `svg:use`.
fn written_name<'a>(text: &'a str, node: Node) -> &'a str {
    let tag = &text[node.range().start + 1..];
    let end = tag.find(|c: char| c.is_ascii_whitespace() || matches!(c, '/' | '>')).unwrap_or(tag.len());
    &tag[..end]
}

/// The prefix of an element's name with its colon: `svg:`, or nothing.
pub(in crate::table) fn prefix<'a>(text: &'a str, node: Node) -> &'a str {
    let name = written_name(text, node);
    name.find(':').map_or("", |colon| &name[..=colon])
}

/// The byte at which another attribute can be put into an element's tag.
pub(in crate::table) fn attributes_start(text: &str, node: Node) -> usize {
    node.range().start + 1 + written_name(text, node).len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edit_moves_no_line() {
        let text = "<a>\n<b\nc='d'/>\n</a>";
        let document = roxmltree::Document::parse(text).unwrap();
        let inner = document.root_element().first_element_child().unwrap();
        let new = edited(text, vec![(inner.range(), in_one_line("<e>\n</e>"))]);
        assert_eq!(new, "<a>\n<e> </e>\n\n</a>");
    }

    #[test]
    fn a_place_is_found_again_where_it_came_from() {
        let text = "<a>\n<b\nc='d'/>\n</a>";
        let edits = vec![(8..13, "long long".to_string()), (3..3, "<!-- -->".to_string()), (16..17, String::new())];
        let new = edited(text, edits.clone());
        assert_eq!(new, "<a><!-- -->\n<b\nclong long>\n<a>");
        // By both texts: the first letter of the lines, what follows an edit, and what an edit has put there.
        for (at, expected) in [(0, 0), (12, 4), (15, 7), (16, 8), (24, 8), (25, 13), (27, 15), (28, 17)] {
            assert_eq!(origin(&edits, text, at), expected, "{at}");
        }
    }

    #[test]
    fn names_are_found_with_their_prefix() {
        let text = r#"<s:svg xmlns:s="x"><s:g/></s:svg>"#;
        let document = roxmltree::Document::parse(text).unwrap();
        let inner = document.root_element().first_element_child().unwrap();
        assert_eq!((prefix(text, inner), attributes_start(text, inner)), ("s:", text.find("/>").unwrap()));
    }
}
