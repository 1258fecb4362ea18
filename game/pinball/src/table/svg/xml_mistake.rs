//! What is wrong with a text that is not XML, in words for whoever draws: the library says which token it expected.

use super::xml::{SKIPPED, tag, tag_from};
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Error, TextPos};

/// What a prefix stands for that drawing programs write.
const PREFIXES: [(&str, &str); 3] = [
    ("xlink", "http://www.w3.org/1999/xlink"),
    ("inkscape", "http://www.inkscape.org/namespaces/inkscape"),
    ("sodipodi", "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"),
];
/// Characters of what stands at a mistake that show where it is.
const SHOWN: usize = 24;

/// The mistake that the library has found.
pub(super) fn told(source: &Source, error: &Error) -> Diagnostic {
    let (text, at) = (&source.text, byte_of(source, error.pos()));
    if is_cut_off(text, error, at) {
        let what = "the drawing ends here, in the middle of an element; it was not saved whole";
        return source.diagnostic(text.trim_end().len(), what);
    }
    let swallows = |begin: usize| begin <= at && SKIPPED.iter().any(|(open, _)| text[begin..].starts_with(open));
    let (at, what) = match unfinished(text).filter(|begin| swallows(*begin) || !text[at..].contains('<')) {
        Some(begin) if text[begin..].starts_with("<!--") => {
            (begin, "this comment is never closed with `-->`".to_string())
        }
        Some(begin) if text[begin..].starts_with("<![CDATA[") => {
            (begin, "this `<![CDATA[` is never closed with `]]>`".to_string())
        }
        // The file is whole, so what never ends is a value.
        Some(begin) => swallowing(text, begin),
        None => sentence(source, error, at),
    };
    source.diagnostic(at, format!("this is not well-formed XML: {what}"))
}

/// Of a tag with a quote that is not closed, or without its end.
fn swallowing(text: &str, begin: usize) -> (usize, String) {
    let tag = text[begin + 1..].split('<').next().unwrap_or("");
    if ['"', '\''].iter().all(|quote| tag.matches(*quote).count() % 2 == 0) {
        return (begin, format!("the tag `{}` does not end: a `>` is missing behind it", shown(text, begin)));
    }
    (begin, format!("a quote is missing in `{}`: its value swallows what follows it", shown(text, begin)))
}

/// Where the mistake is, and what it is.
fn sentence(source: &Source, error: &Error, at: usize) -> (usize, String) {
    let text = &source.text;
    let what = match error {
        Error::NoRootNode => "there is no <svg> in it".to_string(),
        Error::UnclosedRootNode => "the first <svg> is not closed; another `</svg>` is missing at the end".to_string(),
        Error::UnexpectedCloseTag(open, close, _) => return unclosed(source, open, close, at),
        Error::UnknownEntityReference(name, _) => {
            format!("nobody says what `&{name};` is; write the letter itself, and `&amp;` for a plain &")
        }
        Error::MalformedEntityReference(_) => return malformed(text, at),
        Error::InvalidAttributeValue(_) => return swallowing(text, tag_around(text, at)),
        Error::DuplicatedAttribute(name, _) => format!("`{name}` is given twice in one element; take one of them out"),
        Error::UnknownNamespace(prefix, _) => unknown_prefix(prefix),
        Error::NonXmlChar(letter, _) => format!("U+{:04X} is no letter of a text; take it out", u32::from(*letter)),
        Error::UnexpectedDeclaration(_) => {
            "`<?xml` can only be the very first of a file; take out what stands before it".to_string()
        }
        Error::InvalidComment(_) => "a comment, `<!-- ... -->`, must not hold `--`".to_string(),
        Error::InvalidCharacterData(_) => "`]]>` must not stand in a text".to_string(),
        Error::UnknownToken(_) if text[at..].trim_start().starts_with("</") => {
            format!("`{}` closes what is not open", shown(text, at))
        }
        Error::UnknownToken(_) if !text[..at].contains("<") => {
            format!("it begins with `{}`, and a drawing with <svg", shown(text, at))
        }
        _ => {
            let begin = tag_around(text, at);
            if text[begin + 1..].find('<').is_some_and(|next| begin + 1 + next <= at) {
                return swallowing(text, begin);
            }
            let what = format!(
                "`{}` in `{}` cannot be read; a quote may be missing before it: an attribute is written name=\"value\", and a \
                 tag ends with >",
                shown(text, at),
                shown(text, begin)
            );
            return (at, what);
        }
    };
    (at, what)
}

/// An `&` that begins nothing, or the number of a character that XML does not have.
fn malformed(text: &str, at: usize) -> (usize, String) {
    let begin = if text[at..].starts_with('&') { at } else { text[..at].rfind('&').unwrap_or(at) };
    let Some(number) = text[begin..].strip_prefix("&#") else {
        return (at, "a plain & is written `&amp;`".to_string());
    };
    let number = number.find(';').filter(|end| *end <= SHOWN).map(|end| &number[..end]);
    let code = number.and_then(|number| match number.strip_prefix('x') {
        Some(hexadecimal) => u32::from_str_radix(hexadecimal, 16).ok(),
        None => number.parse().ok(),
    });
    let what = match (number, code) {
        (Some(number), Some(code)) => {
            format!("`&#{number};` is the character U+{code:04X}, which no XML may hold; take it out")
        }
        _ => "a letter by its number is written `&#38;` or `&#x26;`, and a plain & is `&amp;`".to_string(),
    };
    (begin, what)
}

/// Which element is still open where another is closed.
fn unclosed(source: &Source, open: &str, close: &str, at: usize) -> (usize, String) {
    let text = &source.text;
    let mut stack: Vec<usize> = Vec::new();
    let mut next = 0;
    while let Some(start) = tag_from(text, next).filter(|start| *start < at.saturating_sub(1)) {
        next = start + tag(&text[start..]).length;
        match text[start..next].starts_with("</") {
            true => drop(stack.pop()),
            false if !text[start..next].ends_with("/>") => stack.push(start),
            false => {}
        }
    }
    let begun = stack.last().map_or_else(String::new, |begin| format!(" of line {}", source.line(*begin)));
    (at, format!("`</{close}>` stands here, and the `<{open}>`{begun} is still open; close it with `</{open}>` first"))
}

fn unknown_prefix(prefix: &str) -> String {
    let known = PREFIXES.iter().find(|(known, _)| *known == prefix);
    let meant = known.map_or("...", |(_, meant)| meant);
    format!("nobody says what `{prefix}:` is; write xmlns:{prefix}=\"{meant}\" into the <svg> tag")
}

/// Whether the file ends before the tag or the comment that the mistake is in is whole.
fn is_cut_off(text: &str, error: &Error, at: usize) -> bool {
    match error {
        _ if text.trim_end().ends_with("</svg>") => false,
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => true,
        Error::NoRootNode => unfinished(text).is_some(),
        // A quote that is missing lets no tag end, and what follows it stands in the file.
        _ => unfinished(text).is_some_and(|begin| {
            let is_silent = SKIPPED.iter().any(|(start, _)| text[begin..].starts_with(start));
            (1..=at).contains(&begin) && (is_silent || !text[at..].trim_start_matches('<').contains('<'))
        }),
    }
}

/// Where the tag or the comment begins that never ends.
fn unfinished(text: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        let start = at + text[at..].find('<')?;
        let rest = &text[start..];
        let length = match SKIPPED.iter().find(|(begin, _)| rest.starts_with(begin)) {
            Some((_, end)) => rest.find(end).map(|length| length + end.len()),
            None => Some(tag(rest)).filter(|tag| tag.is_whole).map(|tag| tag.length),
        };
        let Some(length) = length else { return Some(start) };
        at = start + length;
    }
}

/// Where the tag begins that a place is in; the place itself if it is in none.
fn tag_around(text: &str, place: usize) -> usize {
    let mut at = 0;
    while let Some(start) = tag_from(text, at).filter(|start| *start <= place) {
        at = start + tag(&text[start..]).length;
        if at > place {
            return start;
        }
    }
    place
}

/// What stands at a place.
fn shown(text: &str, at: usize) -> String {
    let line = text[at..].trim_start().lines().next().unwrap_or("");
    let shown: String = line.chars().take(SHOWN).collect();
    shown.trim_end().to_string()
}

/// The byte that the library means, or the last before it that begins a letter.
fn byte_of(source: &Source, pos: TextPos) -> usize {
    let row = source.text.split_inclusive('\n').take(pos.row as usize - 1).map(str::len).sum::<usize>();
    let line = &source.text[row.min(source.text.len())..];
    let column = line.char_indices().nth(pos.col as usize - 1).map_or(line.len(), |(at, _)| at);
    row + column
}
