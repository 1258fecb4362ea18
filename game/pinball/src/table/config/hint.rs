//! Hints: what to do about a line of `table.toml` that is not TOML.

/// What numbers are in, by how their names end.
const UNITS: [(&str, &str); 9] = [
    ("_m_s2", "metres a second squared"),
    ("_s_per_m", "seconds a metre"),
    ("_per_s", "shares a second"),
    ("_m_s", "metres a second"),
    ("_n_m", "newton metres"),
    ("_mm", "millimetres"),
    ("_deg", "degrees"),
    ("_kg", "kilograms"),
    ("_s", "seconds"),
];
/// What other languages begin a comment with.
const COMMENTS: [&str; 5] = ["//", "/*", ";", "--", "<!--"];
/// Quotes of books.
const CURLY: [char; 6] = ['\u{201c}', '\u{201d}', '\u{201e}', '\u{ab}', '\u{bb}', '\u{2019}'];

const COMMENT: &str = "a comment begins with #";

/// What to do about a line; `message` is what the library says of it.
pub(super) fn hint(written: &str, message: &str) -> String {
    let code = without_comment(written);
    match code.split_once('=') {
        _ if COMMENTS.iter().any(|sign| written.starts_with(sign)) => COMMENT.to_string(),
        _ if written.starts_with('[') => "a table is written in brackets, as [class.wall]".to_string(),
        None => "a line is NAME = VALUE, or [TABLE]".to_string(),
        Some((name, value)) => of_value(name.trim(), value.trim(), written, message),
    }
}

fn of_value(name: &str, value: &str, written: &str, message: &str) -> String {
    let is_quoted = value.starts_with(['"', '\'']);
    let plain = outside_quotes(value);
    let is_decimal_comma =
        value.contains(',') && value.chars().all(|letter| letter.is_ascii_digit() || matches!(letter, ',' | '-' | ' '));
    let known = match value {
        "" if written.ends_with('=') => "its value is missing",
        _ if value.starts_with('=') => "one = is enough",
        _ if is_decimal_comma => "a number has a point, not a comma",
        _ if value.contains(CURLY) => "quotes are written \", straight ones",
        _ if value.matches('"').count() % 2 == 1 => "a quote is missing",
        _ if plain.trim_end().ends_with([';', ',']) => "nothing stands behind a value, no comma and no ;",
        _ if COMMENTS.iter().any(|sign| plain.contains(sign)) => COMMENT,
        _ if plain.contains('=') => "each NAME = VALUE stands on a line of its own",
        _ if is_quoted && value.contains('\\') => "a \\ in a text is written \\\\",
        "True" | "False" | "TRUE" | "FALSE" | "yes" | "no" | "on" | "off" => "write true or false",
        _ => return of_number(name, value).unwrap_or_else(|| of_text(message)),
    };
    known.to_string()
}

fn of_text(message: &str) -> String {
    let quoted = message.contains("quoted");
    let whole = "a line is NAME = VALUE: a number with a point, text in \"quotes\", or true or false";
    if quoted { "text stands in \"quotes\"" } else { whole }.to_string()
}

/// What to do about a value that begins as a number does.
fn of_number(name: &str, value: &str) -> Option<String> {
    let is_of_number = |letter: char| letter.is_ascii_digit() || matches!(letter, '+' | '-' | '.');
    let (number, rest) = value.split_at(value.find(|letter| !is_of_number(letter)).unwrap_or(value.len()));
    if !number.contains(|letter: char| letter.is_ascii_digit()) {
        return None;
    }
    if rest.trim().is_empty() || rest.trim().starts_with(|letter: char| letter.is_ascii_digit()) {
        return Some("a number is written as 5, -5 or 0.5".to_string());
    }
    let unit = UNITS.iter().find(|(end, _)| name.ends_with(end));
    let unit = unit.map_or_else(String::new, |(_, unit)| format!(", which is in {unit}"));
    Some(format!("a number stands alone: write {name} = {number}{unit}"))
}

/// A line up to its comment.
fn without_comment(line: &str) -> &str {
    let mut quote = None;
    for (place, letter) in line.char_indices() {
        match (quote, letter) {
            (None, '#') => return line[..place].trim_end(),
            (None, '"' | '\'') => quote = Some(letter),
            (Some(open), letter) if open == letter => quote = None,
            _ => {}
        }
    }
    line
}

/// What of a value stands in no quotes.
fn outside_quotes(value: &str) -> String {
    let mut quote = None;
    let is_outside = |letter: &char| match quote {
        None if matches!(letter, '"' | '\'') => {
            quote = Some(*letter);
            false
        }
        Some(open) => {
            quote = quote.filter(|_| open != *letter);
            false
        }
        None => true,
    };
    value.chars().filter(is_outside).collect()
}
