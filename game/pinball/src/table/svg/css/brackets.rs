//! Brackets of a sheet. What is opened and never closed swallows all that follows, and a browser says nothing of it.

/// Where something begins that is never closed, and what it is: a bracket, or a comment.
pub(super) fn unclosed(sheet: &str) -> Option<(usize, &'static str)> {
    let bytes = sheet.as_bytes();
    let mut open: Vec<usize> = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        match bytes[at] {
            b'/' if bytes.get(at + 1) == Some(&b'*') => match sheet[at + 2..].find("*/") {
                Some(length) => at += length + 3,
                None => return Some((at, "/*")),
            },
            b'"' | b'\'' => at = string_end(bytes, at),
            b'\\' => at += 1,
            b'(' if is_address(bytes, at) => match sheet[at..].find(')') {
                Some(length) => at += length,
                None => return Some((at, "(")),
            },
            b'(' | b'[' | b'{' => open.push(at),
            close @ (b')' | b']' | b'}') => {
                open.pop_if(|at| closing(bytes[*at]) == close);
            }
            _ => {}
        }
        at += 1;
    }
    // Of braces the outermost is the one that was forgotten: what follows it was written for the sheet itself. A round or
    // square one lets no brace close, so it comes first.
    let inner = open.iter().find(|at| bytes[**at] != b'{').or(open.first());
    inner.map(|&at| (at, opening(bytes[at])))
}

/// A bracket as it is written.
fn opening(open: u8) -> &'static str {
    match open {
        b'(' => "(",
        b'[' => "[",
        _ => "{",
    }
}

/// What closes a bracket.
fn closing(open: u8) -> u8 {
    match open {
        b'(' => b')',
        b'[' => b']',
        _ => b'}',
    }
}

/// Whether a bracket is that of an address without quotes, in which everything is an address: `url(a{b)`.
fn is_address(bytes: &[u8], at: usize) -> bool {
    let is_url = at >= 3 && bytes[at - 3..at].eq_ignore_ascii_case(b"url");
    let first = bytes[at + 1..].iter().find(|byte| !byte.is_ascii_whitespace());
    is_url && !matches!(first, Some(b'"' | b'\''))
}

/// The last byte of a text in quotes; it ends with its line at the latest.
fn string_end(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while at < bytes.len() && bytes[at] != bytes[start] && bytes[at] != b'\n' {
        at += if bytes[at] == b'\\' { 2 } else { 1 };
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_swallows_the_rest_is_found() {
        assert_eq!(unclosed(".a { fill: red }\n.b { fill: blue\n.c { fill: lime }"), Some((20, "{")));
        assert_eq!(unclosed("@media screen { .a { fill: red }"), Some((14, "{")));
        assert_eq!(unclosed(".a { fill: rgb(1, 2, 3; }\n.b { fill: red }"), Some((14, "(")));
        assert_eq!(unclosed(".a[b { fill: red }"), Some((2, "[")));
        assert_eq!(unclosed(".a { fill: url(#b; }"), Some((14, "(")));
        assert_eq!(unclosed("/* a */ .a { fill: red /* } .b { }"), Some((23, "/*")));
    }

    #[test]
    fn what_only_looks_like_a_bracket_is_none() {
        for good in [
            "",
            ".a { fill: red } .b { }",
            ".a { } } .b { }",
            "/* { */ .a::after { content: '{'; fill: url( #b ) }",
            ".a { fill: url(a{b'c) }",
            ".a { fill: URL(\"a{b\") }",
            ".a\\{ { content: \"\\\"{\" }",
            ".\u{e4}\\\u{e4} { font-family: 'a\n }",
        ] {
            assert_eq!(unclosed(good), None, "{good}");
        }
    }
}
