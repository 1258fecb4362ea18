//! Brackets that are not closed, or close nothing: told at the line where one is missing, as far as that can be seen.

use super::read::Mistake;
use super::tokens::{Token, tokens};

/// A bracket that is open.
struct Open {
    mark: char,
    line: usize,
    indent: usize,
}

/// The first bracket that has no partner.
pub fn unbalanced(text: &str) -> Option<Mistake> {
    let indents: Vec<usize> = text.lines().map(|line| line.len() - line.trim_start().len()).collect();
    let indent = |line: usize| indents.get(line - 1).copied().unwrap_or(0);
    let tokens = tokens(text);
    let mut open: Vec<Open> = Vec::new();
    // A block that ends farther left than it began lacks its own end: it has that of another.
    let mut suspect = None;
    for (place, token) in tokens.iter().enumerate() {
        let mark = token.text.chars().next()?;
        match mark {
            '(' | '[' | '{' => open.push(Open { mark, line: token.line, indent: indent(token.line) }),
            ')' | ']' | '}' => {
                let Some(last) = open.pop() else { return Some((token.line, stray(mark))) };
                if last.mark == '{' && mark != '}' {
                    return Some((token.line, stray(mark)));
                }
                if closing(last.mark) != mark {
                    return Some((last.line, unclosed_before(&last, token)));
                }
                let is_first = place.checked_sub(1).is_none_or(|before| tokens[before].last_line() < token.line);
                if mark == '}' && is_first && suspect.is_none() && indent(token.line) < last.indent {
                    suspect = Some(last.line);
                }
            }
            'f' if token.text == "fn" && !open.is_empty() => {
                let name = tokens.get(place + 1).filter(|next| next.text.starts_with(|c: char| c.is_alphabetic()));
                let (Some(name), true) = (name, open.iter().all(|one| one.mark == '{')) else { continue };
                let line = suspect.unwrap_or(open[0].line);
                let what = format!(
                    "a `}}` is missing: the `{{` on this line is not closed before `fn {}` on line {}",
                    name.text, token.line
                );
                return Some((line, what));
            }
            _ => {}
        }
    }
    let first = open.first()?;
    let (mark, line) = (first.mark, suspect.filter(|_| first.mark == '{').unwrap_or(first.line));
    let missing = closing(mark);
    Some((line, format!("a `{missing}` is missing: the `{mark}` on this line is never closed")))
}

fn closing(mark: char) -> char {
    match mark {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

fn stray(mark: char) -> String {
    let opening = match mark {
        ')' => '(',
        ']' => '[',
        _ => '{',
    };
    format!("this `{mark}` closes nothing: take it away, or write the `{opening}` that is missing before it")
}

fn unclosed_before(last: &Open, token: &Token) -> String {
    let missing = closing(last.mark);
    let place = if token.line == last.line { "behind it".to_string() } else { format!("on line {}", token.line) };
    format!(
        "a `{missing}` is missing: the `{}` on this line is not closed before the `{}` {place}",
        last.mark, token.text
    )
}
