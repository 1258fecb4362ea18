//! The words of a script's text, for what must be known before it is parsed, or where it cannot be.
//!
//! Reads the text only as far as that needs: words and marks, without comments and strings.

/// Constants that a script may have.
pub const MAX_CONSTANTS: usize = 1024;
/// Variables that a function may make, one after the other.
const MAX_LETS: usize = 4096;

/// The line of a script's first constant or variable too many, before it is parsed: that takes the longer for each the
/// more there are.
pub fn too_many(text: &str) -> Option<(usize, String)> {
    let (mut constants, mut lets) = (0, 0);
    for token in tokens(text) {
        match token.text {
            "const" => constants += 1,
            "let" => lets += 1,
            "fn" => lets = 0,
            _ => {}
        }
        if constants > MAX_CONSTANTS {
            return Some((token.line, format!("a script has at most {MAX_CONSTANTS} constants")));
        }
        if lets > MAX_LETS {
            return Some((token.line, format!("a function makes at most {MAX_LETS} variables")));
        }
    }
    None
}

/// The last word, mark or string before a place that is counted in lines and in letters, both from 1.
pub fn last_before(text: &str, line: usize, column: usize) -> Option<Token<'_>> {
    let start = place(text, line, column)?;
    tokens(text).into_iter().take_while(|token| token.start < start).last()
}

/// The word, mark or string before another.
pub fn before<'a>(text: &'a str, token: Token) -> Option<Token<'a>> {
    tokens(text).into_iter().take_while(|other| other.start < token.start).last()
}

/// A mark with the signs that make one operator with it: `==` for its second sign.
pub fn whole_operator<'a>(text: &'a str, token: Token<'a>) -> &'a str {
    const SIGNS: [char; 10] = ['=', '!', '<', '>', '&', '|', '+', '-', '*', '%'];
    match token.text.starts_with(SIGNS) {
        true => {
            let start = text[..token.end()].trim_end_matches(SIGNS).len();
            &text[start..token.end()]
        }
        false => token.text,
    }
}

/// The line on which a comment begins that is never closed.
pub fn open_comment(text: &str) -> Option<usize> {
    let mut found = None;
    each_piece(text, |line, piece| {
        if piece.starts_with("/*") && comment(piece).1 {
            found = Some(line);
        }
    });
    found
}

/// The number with a fraction that stands at or just before a place.
pub fn fraction_at(text: &str, line: usize, column: usize) -> Option<&str> {
    let at = place(text, line, column)?;
    let tokens = tokens(text);
    let is_number = |token: &Token| token.text.starts_with(|c: char| c.is_ascii_digit());
    let fraction = tokens.windows(3).find(|window| match window {
        [whole, point, part] => {
            let is_one = whole.end() == point.start && point.end() == part.start;
            let is_here = whole.start <= at && at <= part.end();
            is_here && is_one && point.text == "." && is_number(whole) && is_number(part)
        }
        _ => false,
    })?;
    text.get(fraction[0].start..fraction[2].end())
}

fn place(text: &str, line: usize, column: usize) -> Option<usize> {
    let whole = text.split_inclusive('\n').nth(line.checked_sub(1)?)?;
    let start = text.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
    let within = whole.char_indices().nth(column.saturating_sub(1)).map_or(whole.len(), |(index, _)| index);
    Some(start + within)
}

/// A word, a string or a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token<'a> {
    /// The line on which it begins, from 1.
    pub line: usize,
    /// Its first byte.
    pub start: usize,
    /// As it stands there.
    pub text: &'a str,
}

impl Token<'_> {
    /// The byte behind it.
    pub fn end(&self) -> usize {
        self.start + self.text.len()
    }

    /// The line on which it ends.
    pub fn last_line(&self) -> usize {
        self.line + self.text.matches('\n').count()
    }
}

/// The words, strings and marks of a script, without comments.
pub fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut start = 0;
    each_piece(text, |line, piece| {
        let is_comment = piece.starts_with("//") || piece.starts_with("/*");
        if !is_comment && !piece.starts_with(char::is_whitespace) {
            tokens.push(Token { line, start, text: piece });
        }
        start += piece.len();
    });
    tokens
}

/// Calls `each` with all pieces of a text, one behind the other, and their lines.
fn each_piece<'a>(text: &'a str, mut each: impl FnMut(usize, &'a str)) {
    let (mut start, mut line) = (0, 1);
    while let Some(first) = text[start..].chars().next() {
        let rest = &text[start..];
        let length = match first {
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => comment(rest).0,
            '"' | '\'' | '`' => quoted(rest, first),
            _ if is_of_word(first) => rest.find(|letter| !is_of_word(letter)).unwrap_or(rest.len()),
            _ => first.len_utf8(),
        };
        each(line, &rest[..length]);
        line += rest[..length].matches('\n').count();
        start += length;
    }
}

fn is_of_word(letter: char) -> bool {
    letter == '_' || letter.is_ascii_alphanumeric()
}

/// The length of the block comment that the text begins with, and whether it is never closed; they nest.
fn comment(text: &str) -> (usize, bool) {
    let mut depth = 0;
    let mut place = 0;
    while let Some(mark) = text.get(place..).and_then(|rest| rest.find(['/', '*'])) {
        place += mark;
        match text.get(place..place + 2) {
            Some("/*") => {
                depth += 1;
                place += 2;
            }
            Some("*/") => {
                depth -= 1;
                place += 2;
                if depth == 0 {
                    return (place, false);
                }
            }
            _ => place += 1,
        }
    }
    (text.len(), true)
}

/// The length of the text in quotes that this begins with, both quotes included.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (place, letter) in text.char_indices().skip(1) {
        if letter == quote && !escaped {
            return place + 1;
        }
        escaped = letter == '\\' && !escaped && quote != '`';
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 50,000 constants took ten seconds to be refused.
    #[test]
    fn a_script_of_too_many_names_is_refused_before_it_is_parsed() {
        let constants = |count: usize| (0..count).map(|name| format!("const C{name} = 1;\n")).collect::<String>();
        assert_eq!(too_many(&constants(1024)), None);
        assert_eq!(too_many(&constants(1025)), Some((1025, "a script has at most 1024 constants".to_string())));
        let lets = |count: usize| format!("fn f() {{ {} }}\n", "let x = 1; ".repeat(count));
        assert_eq!(too_many(&lets(4096).repeat(2)), None);
        assert_eq!(too_many(&lets(4097)), Some((1, "a function makes at most 4096 variables".to_string())));
    }
}
