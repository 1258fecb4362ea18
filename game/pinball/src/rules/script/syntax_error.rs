//! What is told of a script that cannot be read: one sentence that says what is wrong there and what to do.

use super::brackets::unbalanced;
use super::foreign::{hint, unknown_name};
use super::read::Mistake;
use super::tokens;
use rhai::{LexError, ParseError, ParseErrorType};

/// What is told of a comment without an end.
pub const UNCLOSED_COMMENT: &str = "a comment begins on this line and is never closed: a `*/` is missing";
/// Words behind which a name stands.
const NAMING: [&str; 4] = ["let", "const", "fn", "for"];

/// What is told of an error of the parser, where a person sees it: what is missing is missing behind the last word that
/// is there.
pub fn told(error: &ParseError, text: &str) -> Mistake {
    let (line, column) = (error.position().line().unwrap_or(1), error.position().position().unwrap_or(1));
    if let Some(mistake) = unprintable(text).filter(|(own, _)| *own <= line) {
        return mistake;
    }
    if let Some(fraction) = tokens::fraction_at(text, line, column) {
        return (line, format!("a whole number is expected, not {fraction}: rules know no fractions"));
    }
    if let Some(begin) = tokens::open_comment(text).filter(|begin| *begin <= line) {
        return (begin, UNCLOSED_COMMENT.to_string());
    }
    let last = tokens::last_before(text, line, column);
    let behind = last.map_or_else(String::new, |last| format!(" behind `{}`", tokens::whole_operator(text, last)));
    // Of what is missing, the line on which it would stand.
    let missing_line = last.map_or(line, |last| last.last_line());
    if let ParseErrorType::BadInput(error) = error.err_type() {
        if let Some(opened) = unclosed_text(error, text, line) {
            return opened;
        }
        if !matches!(error, LexError::UnexpectedInput(_)) {
            return (line, unreadable(error, &behind));
        }
    }
    if has_odd_quotes(text.lines().nth(line - 1).unwrap_or_default()) {
        return (line, "a `\"` is missing on this line: texts stand between two of them".to_string());
    }
    if let Some(mistake) = unbalanced(text).filter(|(own, _)| *own <= line) {
        return mistake;
    }
    match (error.err_type(), last) {
        (ParseErrorType::MissingToken(missing, _), Some(last)) => {
            let what = in_its_place(missing, text, last).unwrap_or_else(|| absent(missing, &behind));
            (missing_line, what)
        }
        (ParseErrorType::Reserved(word), Some(last)) if is_word(word) && NAMING.contains(&last.text) => {
            (line, kept(word))
        }
        (error, _) => of_type(error, line, (missing_line, &behind)),
    }
}

/// What is told of something that is missing behind a word, where what stands there says more.
fn in_its_place(missing: &str, text: &str, last: tokens::Token) -> Option<String> {
    let next = text[last.end()..].trim_start();
    let word = next.find(|letter: char| !letter.is_alphanumeric() && letter != '_').map_or(next, |end| &next[..end]);
    let is_named = || tokens::before(text, last).is_some_and(|before| matches!(before.text, "let" | "const"));
    match missing {
        _ if is_word(last.text) && hint(last.text).is_some() => Some(foreign(last.text)),
        _ if !word.is_empty() && hint(word).is_some() => Some(foreign(word)),
        _ if next.starts_with("::") => Some("rules have no `::`: they have no modules".to_string()),
        ";" if is_named() && next.starts_with("==") => Some("`==` compares: to set a variable, write `=`".to_string()),
        ";" if is_named() => Some(absent("=", &format!(" behind `{}`", last.text))),
        _ => None,
    }
}

/// Whether a line has a quote without its partner. Of a line with a text in back quotes or with a comment nothing is said.
fn has_odd_quotes(line: &str) -> bool {
    let quotes = line.replace("\\\\", "").replace("\\\"", "").matches('"').count();
    quotes % 2 == 1 && !line.contains(['`', '\'']) && !line.contains("//") && !line.contains("/*")
}

/// Whether a value must stand behind what is there.
fn is_open(behind: &str) -> bool {
    let last = behind.strip_suffix('`').and_then(|behind| behind.chars().last());
    last.is_some_and(|last| "=<>+-*/%&|([,!:".contains(last))
}

fn absent(missing: &str, behind: &str) -> String {
    let article = if is_word(missing) { "" } else { "a " };
    format!("{article}`{missing}` is missing{behind}")
}

/// What is told of an error on this line, of what is missing on that one behind that.
fn of_type(error: &ParseErrorType, line: usize, (missing_line, behind): (usize, &str)) -> Mistake {
    match error {
        ParseErrorType::BadInput(LexError::UnexpectedInput(sign))
            if sign.is_ascii() && !is_word(sign) && is_open(behind) =>
        {
            (missing_line, format!("a value is missing{behind}, before `{sign}`"))
        }
        ParseErrorType::BadInput(error) => (line, unreadable(error, behind)),
        ParseErrorType::MissingToken(missing, _) => (missing_line, absent(missing, behind)),
        ParseErrorType::UnexpectedEOF => {
            (missing_line, format!("the script ends in the middle: the rest is missing{behind}"))
        }
        ParseErrorType::ExprExpected(_) if behind.ends_with("`while`") || behind.ends_with("`if`") => {
            (missing_line, format!("a condition is missing{behind}"))
        }
        ParseErrorType::ExprExpected(what) if what.contains("literal") => (
            line,
            "a case of a `switch` is a number, a text in quotes, `true`, `false` or `_`, and `=>` stands behind it"
                .into(),
        ),
        ParseErrorType::ExprExpected(_) => (missing_line, format!("a value is missing{behind}")),
        ParseErrorType::PropertyExpected | ParseErrorType::VariableExpected | ParseErrorType::FnMissingName => {
            (missing_line, format!("a name is missing{behind}"))
        }
        ParseErrorType::FnDuplicatedDefinition(name, _) => {
            let name = name.split('(').next().unwrap_or(name).trim();
            (line, format!("there are two functions `{name}`: take one away, or put both into one"))
        }
        ParseErrorType::FnMissingBody(name) => {
            let name = name.split('(').next().unwrap_or(name).trim();
            (missing_line, format!("a `{{` is missing: the function `{name}` has no body"))
        }
        other => (line, misplaced(other).unwrap_or_else(|| format!("the script cannot be read from here on: {other}"))),
    }
}

/// What is told of an error that has no place but its own.
fn misplaced(error: &ParseErrorType) -> Option<String> {
    use ParseErrorType as Type;
    Some(match error {
        Type::UnknownOperator(sign) => foreign(sign),
        Type::Reserved(word) => foreign(word),
        Type::MalformedIndexExpr(_) => "an index in `[ ]` is a whole number, or a text for a map".to_string(),
        Type::FnMissingParams(name) => format!("a `(` is missing: write `fn {name}()`, or parameters in it"),
        Type::FnDuplicatedParam(name, parameter) => {
            format!("`{name}` has two parameters called `{parameter}`: give one another name")
        }
        Type::DuplicatedProperty(name) => format!("the map has two entries `{name}`: take one away"),
        Type::DuplicatedVariable(name) | Type::VariableExists(name) => {
            format!("there are two variables `{name}`: give one another name")
        }
        Type::VariableUndefined(name) => unknown_name(name),
        Type::ModuleUndefined(name) => format!("rules have no modules: `{name}::` is nothing"),
        Type::MismatchedType(needed, is) if needed.contains("boolean") => {
            format!("a condition must be true or false, not {}", plain_type(is))
        }
        Type::MismatchedType(_, is) => {
            format!("`for` goes through an array, a text or a range, not {}", plain_type(is))
        }
        Type::AssignmentToConstant(name) if !name.is_empty() => format!("the constant {name} cannot be changed"),
        Type::AssignmentToConstant(_) | Type::AssignmentToInvalidLHS(_) => {
            "only a variable or a part of one can be set with `=`; to compare, write `==`".to_string()
        }
        Type::LiteralTooLarge(..) => "a text, an array or a map holds at most 4096 bytes or values".to_string(),
        Type::WrongSwitchIntegerCase => "a number stands behind a range: put numbers before ranges".to_string(),
        Type::WrongSwitchDefaultCase => {
            "`_` is the case for everything else, and cases behind it would never be reached: put it last".to_string()
        }
        Type::WrongSwitchCaseCondition => "the case `_` is for everything else and takes no `if`".to_string(),
        Type::WrongFnDefinition => "a function stands in another: put it outside, where no `{` is open".to_string(),
        Type::WrongDocComment => "`///` stands before functions only: write `//`".to_string(),
        Type::ExprTooDeep => {
            "this nests too deep: put parts of it into variables, or into functions of their own".to_string()
        }
        Type::TooManyFunctions => "a script has at most 512 functions".to_string(),
        Type::LoopBreak => "`break` and `continue` stand in a loop: `return` leaves a function".to_string(),
        _ => return None,
    })
}

/// What is told of letters that make no words.
fn unreadable(error: &LexError, behind: &str) -> String {
    match error {
        LexError::UnexpectedInput(sign)
            if sign.chars().any(|letter| "\u{201c}\u{201d}\u{201e}\u{ab}\u{bb}".contains(letter)) =>
        {
            format!("`{sign}` is no quote that a script knows: write a text as \"...\"")
        }
        LexError::UnexpectedInput(sign) if sign == "else" => {
            "`else` stands behind the `}` of an `if`, and there is none here".to_string()
        }
        LexError::UnexpectedInput(sign) => {
            format!("`{sign}` does not belong here{behind}: take it away, or complete what is before it")
        }
        LexError::MalformedEscapeSequence(sign) => {
            format!("`{sign}` means nothing in a text: a backslash is written `\\\\`, a quote `\\\"`")
        }
        LexError::MalformedNumber(number) => {
            format!("`{number}` is no whole number from -9223372036854775808 to 9223372036854775807")
        }
        LexError::MalformedChar(_) => "between `'` and `'` stands one letter: write a text as \"...\"".to_string(),
        LexError::MalformedIdentifier(name) => {
            format!("`{name}` is no name: one has letters a to z, digits and `_`, and at least one letter first")
        }
        LexError::StringTooLong(_) => "a text may be 4096 bytes long and no longer".to_string(),
        LexError::ImproperSymbol(sign, _) if sign == "=" => "`=` sets a variable: to compare, write `==`".to_string(),
        LexError::ImproperSymbol(sign, _) => foreign(sign),
        other => format!("the script cannot be read from here on: {other}"),
    }
}

/// A word or a sign that rules do not have.
fn foreign(sign: &str) -> String {
    match (is_word(sign), hint(sign)) {
        (true, None) => kept(sign),
        (false, None) => format!("rules have no sign `{sign}`: take it away, or write another"),
        (true, Some(hint)) => format!("rules have no `{sign}`: {hint}"),
        (false, Some(hint)) => format!("rules have no sign `{sign}`: {hint}"),
    }
}

fn kept(word: &str) -> String {
    format!("`{word}` is a word that the language keeps for itself: take another name")
}

fn is_word(sign: &str) -> bool {
    sign.chars().all(|letter| letter.is_alphanumeric() || letter == '_')
}

/// A text that no quote ends.
fn unclosed_text(error: &LexError, text: &str, line: usize) -> Option<Mistake> {
    let LexError::UnterminatedString = error else { return None };
    let own = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
    let quote = if own.contains('"') { '"' } else { '`' };
    Some((
        line,
        format!("a text begins on this line and is not closed: a `{quote}` is missing").replace("```", "backtick"),
    ))
}

/// A letter that no text has.
fn unprintable(text: &str) -> Option<Mistake> {
    let is_odd = |letter: char| letter.is_control() && !matches!(letter, '\n' | '\r' | '\t' | '\u{c}');
    let (index, letter) = text.char_indices().find(|(_, letter)| is_odd(*letter))?;
    let line = text[..index].matches('\n').count() + 1;
    let what = format!(
        "here stands the character U+{:04X}, which no script has: save the file as plain text (UTF-8)",
        u32::from(letter)
    );
    Some((line, what))
}

/// Rhai's word for a type in a person's.
fn plain_type(word: &str) -> String {
    match word {
        "a floating-point number" | "an integer number" | "i64" => "a whole number".to_string(),
        "a string" | "a character" => "a text".to_string(),
        other => other.to_string(),
    }
}
