//! Lines that are not TOML, in words for whoever writes them: the library says which token it expected.

use std::ops::Range;

/// What is wrong with a line, from 1; `message` is the library's.
pub(super) fn sentence(text: &str, line: usize, message: &str) -> String {
    let written = text.lines().nth(line - 1).unwrap_or("").trim();
    if message.contains("duplicate key") {
        return format!("`{written}` is there already; take one of them out");
    }
    let is_decimal_comma = || {
        let value = written.split_once('=').map_or("", |(_, value)| value.trim());
        value.contains(',') && value.chars().all(|letter| letter.is_ascii_digit() || matches!(letter, ',' | '-' | ' '))
    };
    let quotes = written.matches('"').count();
    let hint = match message {
        _ if written.starts_with('[') => "a table is written in brackets, as [class.wall]",
        _ if !written.contains('=') => "a line is NAME = VALUE, or [TABLE]",
        _ if is_decimal_comma() => "a number has a point, not a comma",
        _ if quotes % 2 == 1 => "a quote is missing",
        _ if message.contains("quoted") => "text stands in \"quotes\"",
        _ => "a line is NAME = VALUE: a number with a point, text in \"quotes\", or true or false",
    };
    format!("this is not TOML: `{written}`; {hint}")
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
