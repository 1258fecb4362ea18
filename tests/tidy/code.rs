//! Just enough of a Rust lexer for tests about style: what of a text is code, what of the code is test code, and the
//! code's words.

/// The text with comments, strings and characters replaced by blanks; every line keeps its number and its length in
/// characters.
pub fn blanked(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    while at < chars.len() {
        let end = opaque_end(&chars, at);
        if end == at {
            out.push(chars[at]);
            at += 1;
        } else {
            out.extend(chars[at..end].iter().map(|&c| if c == '\n' { '\n' } else { ' ' }));
            at = end;
        }
    }
    out
}

/// The end of the comment, string or character that starts at `at`; `at` itself where none starts there.
fn opaque_end(chars: &[char], at: usize) -> usize {
    let follows_word = at > 0 && is_word(chars[at - 1]);
    match (chars[at], chars.get(at + 1)) {
        ('/', Some('/')) => position(chars, at, |rest| rest[0] == '\n'),
        ('/', Some('*')) => block_comment_end(chars, at),
        ('"', _) => string_end(chars, at),
        ('r', Some('"' | '#')) if !follows_word || chars[at - 1] == 'b' => raw_string_end(chars, at),
        ('\'', Some('\\')) => 1 + position(chars, at + 3, |rest| rest[0] == '\''),
        ('\'', Some(_)) if chars.get(at + 2) == Some(&'\'') => at + 3,
        _ => at,
    }
}

/// The first index from `at` on where `found` holds of the rest, or the end.
fn position(chars: &[char], at: usize, found: impl Fn(&[char]) -> bool) -> usize {
    (at..chars.len()).find(|&index| found(&chars[index..])).unwrap_or(chars.len())
}

fn block_comment_end(chars: &[char], start: usize) -> usize {
    let (mut at, mut depth) = (start, 0);
    loop {
        match (chars.get(at), chars.get(at + 1)) {
            (Some('/'), Some('*')) => (at, depth) = (at + 2, depth + 1),
            (Some('*'), Some('/')) => (at, depth) = (at + 2, depth - 1),
            (Some(_), _) => at += 1,
            (None, _) => return at,
        }
        if depth == 0 {
            return at;
        }
    }
}

fn string_end(chars: &[char], start: usize) -> usize {
    let mut at = start + 1;
    while at < chars.len() && chars[at] != '"' {
        at += if chars[at] == '\\' { 2 } else { 1 };
    }
    (at + 1).min(chars.len())
}

fn raw_string_end(chars: &[char], start: usize) -> usize {
    let hashes = chars[start + 1..].iter().take_while(|&&c| c == '#').count();
    if chars.get(start + 1 + hashes) != Some(&'"') {
        // A raw identifier.
        return start;
    }
    let closes =
        |rest: &[char]| rest[0] == '"' && rest[1..].iter().take(hashes).filter(|&&c| c == '#').count() == hashes;
    (position(chars, start + 2 + hashes, closes) + 1 + hashes).min(chars.len())
}

/// The code with every item under `#[cfg(test)]` and the like blanked, and the names of the modules in files of their
/// own that are declared so.
pub fn without_tests(code: &str) -> (String, Vec<String>) {
    let (mut kept, mut modules) = (String::new(), Vec::new());
    let mut rest = code;
    while let Some(start) = rest.find("#[cfg(") {
        let attribute = &rest[start..start + rest[start..].find(']').expect("an attribute ends") + 1];
        kept.push_str(&rest[..start]);
        rest = &rest[start + attribute.len()..];
        if !asks_for_tests(attribute) {
            kept.push_str(attribute);
            continue;
        }
        let item = &rest[..item_length(rest)];
        if item.ends_with(';') {
            let words = words(item);
            let module = words.iter().position(|word| word.text == "mod");
            modules.extend(module.map(|at| words[at + 1].text.to_string()));
        }
        kept.extend(attribute.chars().chain(item.chars()).map(|c| if c == '\n' { '\n' } else { ' ' }));
        rest = &rest[item.len()..];
    }
    kept.push_str(rest);
    (kept, modules)
}

/// Whether what stands under a `cfg` is built for tests only.
fn asks_for_tests(attribute: &str) -> bool {
    let words: Vec<_> = words(attribute).iter().map(|word| word.text).collect();
    words.contains(&"test") && !words.contains(&"not") && !words.contains(&"any")
}

/// The length in bytes of the item that blanked code starts with, further attributes included: up to the first
/// semicolon or closed brace outside of brackets.
fn item_length(code: &str) -> usize {
    let mut depth = 0;
    for (at, c) in code.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 && (c == ';' || c == '}') {
            return at + 1;
        }
    }
    code.len()
}

/// A name, a number, `::` or one other mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Word<'a> {
    pub text: &'a str,
    /// From 1.
    pub line: usize,
}

/// The words of blanked code.
pub fn words(code: &str) -> Vec<Word<'_>> {
    let mut found = Vec::new();
    for (number, line) in code.lines().enumerate() {
        let mut rest = line.trim_start();
        while let Some(first) = rest.chars().next() {
            let length = match first {
                c if is_word(c) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
                ':' if rest.starts_with("::") => 2,
                '-' if rest.starts_with("->") => 2,
                '=' if rest.starts_with("=>") => 2,
                c => c.len_utf8(),
            };
            found.push(Word { text: &rest[..length], line: number + 1 });
            rest = rest[length..].trim_start();
        }
    }
    found
}

/// Whether `c` may stand in a name or a number.
pub fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

#[test]
fn comments_strings_and_characters_are_not_code() {
    let cases = [
        ("a // b\nc", "a     \nc"),
        ("a /* b /* c */ d */ e", "a                   e"),
        (r#"f("{ \" }") g"#, "f(        ) g"),
        ("r#\"{ \" \"# g", "          g"),
        ("br\"{\" g", "b     g"),
        ("for_r\"x\"", "for_r   "),
        ("r#type g", "r#type g"),
        ("'{' '\\'' '\\u{7d}' <'a> 'b", "                  <'a> 'b"),
    ];
    for (text, code) in cases {
        assert_eq!(blanked(text), code, "{text}");
    }
}

#[test]
fn test_code_is_told_apart() {
    let code = "use a;\n#[cfg(test)]\nmod tests {\n  fn f() { }\n}\n#[cfg(all(test, x))]\npub(crate) mod oracle;\n\
                #[cfg(not(test))] fn g() {}\n";
    let (kept, modules) = without_tests(code);
    assert_eq!(modules, ["oracle"]);
    let kept_words: Vec<_> = words(&kept).iter().map(|word| (word.text, word.line)).collect();
    assert_eq!(kept_words[..3], [("use", 1), ("a", 1), (";", 1)]);
    assert_eq!(kept_words[3..5], [("#", 8), ("[", 8)]);
    assert_eq!(kept_words.last(), Some(&("}", 8)));
}
