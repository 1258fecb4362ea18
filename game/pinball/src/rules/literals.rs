//! Names that stand in a script as literals, checked before anyone plays: `lamp("insert-rde", "on")` is found even
//! where play seldom comes.
//!
//! Reads the text only as far as that needs: comments, strings, and a call's first argument.

use super::names::Names;
use super::part_commands::PART_COMMANDS;
use std::collections::BTreeSet;

/// A literal first argument of a call.
struct Call<'a> {
    line: usize,
    function: &'a str,
    argument: &'a str,
}

/// Line and sentence for every literal name that the drawing does not have. A name that the script also asks
/// `exists(...)` about may be absent.
pub fn unknown_names(text: &str, names: &Names) -> Vec<(usize, String)> {
    let calls = literal_calls(text);
    let optional: BTreeSet<&str> =
        calls.iter().filter(|call| call.function == "exists").map(|call| call.argument).collect();
    let mandatory = calls.iter().filter(|call| !optional.contains(call.argument));
    mandatory.filter_map(|call| Some((call.line, check(call, names).err()?))).collect()
}

fn check(call: &Call, names: &Names) -> Result<(), String> {
    match call.function {
        "lamp" | "lamp_color" | "flash" | "show" => names.lamps(call.argument).map(|_| ()),
        "closed" => names.part(call.argument).map(|_| ()),
        word => match PART_COMMANDS.iter().find(|command| command.word == word) {
            Some(command) => names.part_for(command, call.argument).map(|_| ()),
            None => Ok(()),
        },
    }
}

/// Constants that a script may have.
pub const MAX_CONSTANTS: usize = 1024;
/// Variables that a function may make, one after the other.
const MAX_LETS: usize = 4096;

/// The line of a script's first constant or variable too many, before it is parsed: that takes the longer for each the
/// more there are.
pub fn too_many(text: &str) -> Option<(usize, String)> {
    let (mut constants, mut lets) = (0, 0);
    for (line, token) in tokens(text) {
        match token {
            Token::Word("const") => constants += 1,
            Token::Word("let") => lets += 1,
            Token::Word("fn") => lets = 0,
            _ => {}
        }
        if constants > MAX_CONSTANTS {
            return Some((line, format!("a script has at most {MAX_CONSTANTS} constants")));
        }
        if lets > MAX_LETS {
            return Some((line, format!("a function makes at most {MAX_LETS} variables")));
        }
    }
    None
}

/// A message that a script says in so many words, and for how long.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LiteralMessage {
    /// The script's line, from 1.
    pub line: usize,
    /// The display's lines.
    pub lines: Vec<String>,
    /// How long it stands, ms; 0 if it stays.
    pub ms: u64,
}

/// Every `message("literal", ..., ms)` whose lines and time all stand there.
pub fn messages(text: &str) -> Vec<LiteralMessage> {
    let tokens = tokens(text);
    let calls = tokens
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| matches!(pair, [(_, Token::Word("message")), (_, Token::Mark('('))]));
    calls.filter_map(|(at, pair)| literal_message(pair[0].0, &tokens[at + 2..])).collect()
}

/// The message whose arguments begin here.
fn literal_message(line: usize, arguments: &[(usize, Token)]) -> Option<LiteralMessage> {
    let mut lines = Vec::new();
    for pair in arguments.chunks(2) {
        match pair {
            [(_, Token::Text(text)), (_, Token::Mark(','))] => lines.push(text.to_string()),
            [(_, Token::Word(ms)), (_, Token::Mark(')'))] if !lines.is_empty() => {
                let ms = ms.replace('_', "").parse().ok()?;
                return Some(LiteralMessage { line, lines, ms });
            }
            _ => return None,
        }
    }
    None
}

/// Every `name("literal"` followed by `,` or `)`.
fn literal_calls(text: &str) -> Vec<Call<'_>> {
    let tokens = tokens(text);
    let mut calls = Vec::new();
    for window in tokens.windows(4) {
        if let [
            (line, Token::Word(function)),
            (_, Token::Mark('(')),
            (_, Token::Text(argument)),
            (_, Token::Mark(',' | ')')),
        ] = window
        {
            calls.push(Call { line: *line, function, argument });
        }
    }
    calls
}

enum Token<'a> {
    Word(&'a str),
    Text(&'a str),
    Mark(char),
}

/// The words, double-quoted strings and marks of a script, with their lines.
fn tokens(text: &str) -> Vec<(usize, Token<'_>)> {
    let mut tokens = Vec::new();
    let mut rest = text;
    let mut line = 1;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            comment(rest)
        } else if first == '"' {
            let length = quoted(rest, '"');
            tokens.push((line, Token::Text(rest[1..length].trim_end_matches('"'))));
            length
        } else if first == '\'' || first == '`' {
            // What stands in these is no literal name: a letter, or a text with values in it.
            tokens.push((line, Token::Mark(first)));
            quoted(rest, first)
        } else if first == '_' || first.is_ascii_alphanumeric() {
            let end = |letter: char| letter != '_' && !letter.is_ascii_alphanumeric();
            let length = rest.find(end).unwrap_or(rest.len());
            tokens.push((line, Token::Word(&rest[..length])));
            length
        } else {
            if !first.is_whitespace() {
                tokens.push((line, Token::Mark(first)));
            }
            first.len_utf8()
        };
        line += rest[..length].matches('\n').count();
        rest = &rest[length..];
    }
    tokens
}

/// The length of the block comment that the text begins with; they nest.
fn comment(text: &str) -> usize {
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
                    return place;
                }
            }
            _ => place += 1,
        }
    }
    text.len()
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

    #[test]
    fn messages_that_stand_there_whole_are_found_and_no_others() {
        let script = "fn on_start() {\n  message(\"JACKPOT\", 1_500);\n  message(\"A\", \"B // C\", 0); // message(\"no\", 1)\n\
                      \n  message(name, 200); message(\"A\", time); message(`x ${y}`, 3); message();\n}";
        let message = |line, lines: &[&str], ms| LiteralMessage {
            line,
            lines: lines.iter().map(ToString::to_string).collect(),
            ms,
        };
        assert_eq!(messages(script), [message(2, &["JACKPOT"], 1500), message(3, &["A", "B // C"], 0)]);
    }
}
