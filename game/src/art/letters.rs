//! Letters of a table's art that no built-in typeface has: a box is printed in their place, or nothing.

use super::typefaces::fonts;
use crate::Failure;
use crate::table::{Table, style_declarations};
use resvg::usvg::roxmltree::{Document, Node};
use resvg::usvg::{FontResolver, fontdb};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Letters that are named in one sentence.
const MAX_NAMED: usize = 8;

/// A warning of the letters in the drawing that cannot be printed, with the line of the first; `None` if there is none.
pub fn warning(table: &Table) -> Option<Failure> {
    let fonts = &mut fonts();
    let mut missing: BTreeMap<char, u32> = BTreeMap::new();
    for svg in [&table.floor_svg, &table.tops_svg] {
        let Ok(document) = Document::parse(svg) else { continue };
        for text in document.descendants().filter(|node| node.is_text() && is_printed(*node)) {
            let line = document.text_pos_at(text.range().start).row;
            for letter in text.text().unwrap_or("").chars().filter(|letter| is_seen(*letter)) {
                if !missing.contains_key(&letter) && !has(fonts, letter) {
                    missing.insert(letter, line);
                }
            }
        }
    }
    let line = missing.values().min()?;
    let named: Vec<String> = missing.keys().take(MAX_NAMED).map(|letter| name(*letter)).collect();
    let more = match missing.len() - named.len() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let what = format!("no built-in font has the letter {}{more}, so a box is printed, or nothing", named.join(", "));
    Some(Failure::warning(format!("line {line}: {what}; draw it as a path")).in_file(table.file("table.svg")))
}

/// A letter for a sentence: itself and its number, as many are alike.
fn name(letter: char) -> String {
    format!("`{letter}` (U+{:04X})", u32::from(letter))
}

/// Whether a text is a text's, and not hidden.
fn is_printed(text: Node) -> bool {
    let mut around = text.ancestors().filter(Node::is_element);
    let is_silent = |node: &Node| matches!(node.tag_name().name(), "title" | "desc" | "style" | "script" | "metadata");
    let is_hidden = |node: &Node| {
        let mut style = style_declarations(node.attribute("style").unwrap_or(""));
        node.attribute("display") == Some("none") || style.any(|declared| declared == ("display", "none"))
    };
    let is_text = text.ancestors().any(|node| node.tag_name().name() == "text");
    is_text && !around.any(|node| is_silent(&node) || is_hidden(&node))
}

/// Whether a letter is drawn by itself: no space, no accent that goes onto another letter, no sign that only says how to
/// set others.
fn is_seen(letter: char) -> bool {
    let is_set_only = matches!(u32::from(letter), 0xad | 0x300..=0x36f | 0x200b..=0x200f | 0x2028..=0x202e | 0x2060..=0x206f
        | 0xfe00..=0xfe0f | 0xfeff | 0xe0000..=0xe0fff);
    !letter.is_whitespace() && !letter.is_control() && !is_set_only
}

/// Whether any typeface has a letter; one of them is left out of each search.
fn has(fonts: &mut Arc<fontdb::Database>, letter: char) -> bool {
    let search = FontResolver::default_fallback_selector();
    let first: Vec<fontdb::ID> = fonts.faces().take(2).map(|face| face.id).collect();
    first.into_iter().any(|left_out| search(letter, &[left_out], fonts).is_some())
}
