//! Lines that are not TOML, in words for whoever writes them: the library says which token it expected.

use super::hint::hint;
use std::ops::Range;

/// Quotes of texts that may have many lines.
const LONG: [&str; 2] = ["\"\"\"", "'''"];

/// What is wrong with a line, from 1; `message` is the library's.
pub(super) fn sentence(text: &str, line: usize, message: &str) -> String {
    let written = text.lines().nth(line - 1).unwrap_or("").trim();
    if message.contains("duplicate key") {
        let first = first(text, line).map_or_else(String::new, |first| format!(", from line {first}"));
        return format!("`{written}` is there already{first}; take one of them out");
    }
    format!("this is not TOML: `{written}`; {}", hint(written, message))
}

/// The line that names already what this one names again.
fn first(text: &str, line: usize) -> Option<usize> {
    let lines: Vec<&str> = text.lines().take(line).map(str::trim).collect();
    let (again, before) = lines.split_last()?;
    let name = |line: &str| line.trim_start_matches('[').split([']', '=']).next().unwrap_or("").trim().to_string();
    let (wanted, is_table) = (name(again), again.starts_with('['));
    let place = if is_table {
        let dotted = format!("{wanted}.");
        let is_it = |line: &&str| name(line) == wanted || !line.starts_with('[') && name(line).starts_with(&dotted);
        before.iter().position(is_it)
    } else {
        before.iter().rposition(|line| line.starts_with('[') || name(line) == wanted)
    }?;
    (is_table || !before[place].starts_with('[')).then_some(place + 1)
}

/// The line, from 1, in which a text of many lines begins that is never closed, and its quotes.
pub(super) fn unclosed(text: &str) -> Option<(usize, &'static str)> {
    let (mut at, mut open) = (0, None);
    while let Some(letter) = text[at..].chars().next() {
        let rest = &text[at..];
        let long = LONG.into_iter().find(|quote| rest.starts_with(quote));
        at += match (open, long, letter) {
            (None, Some(quote), _) => {
                open = Some((at, quote));
                quote.len()
            }
            (Some((_, own)), Some(quote), _) if own == quote => {
                open = None;
                quote.len()
            }
            (Some(_), _, '\\') => 1 + rest[1..].chars().next().map_or(0, char::len_utf8),
            (None, _, '#') => rest.find('\n').unwrap_or(rest.len()),
            (None, _, '"' | '\'') => 1 + rest[1..].find([letter, '\n']).map_or(rest.len() - 1, |length| length + 1),
            _ => letter.len_utf8(),
        };
    }
    open.map(|(begin, quote)| (1 + text[..begin].matches('\n').count(), quote))
}

/// The lines that belong to a table whose name cannot be read, behind its line.
pub(super) fn lost(text: &str, line: usize) -> Range<usize> {
    let is_name = |line: &str| line.trim_start().starts_with('[');
    let mut lines = text.lines().skip(line - 1);
    if !lines.next().is_some_and(is_name) {
        return line..line;
    }
    line + 1..line + 1 + lines.take_while(|line| !is_name(line)).count()
}
