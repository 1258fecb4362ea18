//! Declarations, `property: value`, of a `style` attribute or of a rule, with CSS's comments, case and recovery from
//! mistakes.

use super::value;
use cssparser::{
    AtRuleParser, CowRcStr, DeclarationParser, ParseError, Parser, ParserState, QualifiedRuleParser,
    RuleBodyItemParser, RuleBodyParser, ToCss, Token, parse_important,
};
use std::borrow::Cow;

/// Brackets that may lie inside each other in a value.
const MAX_DEPTH: usize = 16;

/// What is declared of one property.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Declaration {
    pub name: String,
    /// In plain words, or as it is written if it is no value of this property.
    pub value: String,
    /// It is a value of this property, as far as is known.
    pub is_valid: bool,
    pub is_important: bool,
    /// The line that it begins in, from 0.
    pub line: usize,
    /// The line of the file, if it stands in a sheet.
    pub sheet_line: Option<usize>,
}

/// What stands where a declaration should, and is none.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Unread {
    /// How it begins.
    pub begin: String,
    /// The line that it begins in, from 0.
    pub line: usize,
}

/// The declarations of a `style` attribute, in their order.
pub(super) fn of_attribute(text: &str) -> Vec<Declaration> {
    of_block(&mut Parser::new(text)).0
}

/// What in a `style` attribute is no declaration.
pub(super) fn unread_in_attribute(text: &str) -> Vec<Unread> {
    of_block(&mut Parser::new(text)).1
}

/// The declarations between a rule's braces, in their order, and what there is none, which CSS leaves out.
pub(super) fn of_block(input: &mut Parser) -> (Vec<Declaration>, Vec<Unread>) {
    let (mut declarations, mut unread) = (Vec::new(), Vec::new());
    for read in RuleBodyParser::new(input, &mut Block) {
        match read {
            Ok(declaration) => declarations.push(declaration),
            Err((_, written, place)) => {
                let begin: String = written.trim().chars().take_while(|&c| c != '\n').take(40).collect();
                unread
                    .push(Unread { begin: begin.trim_end_matches([';', ' ']).to_string(), line: place.line as usize });
            }
        }
    }
    (declarations, unread)
}

struct Block;

impl<'i> DeclarationParser<'i> for Block {
    type Declaration = Declaration;
    type Error = ();

    fn parse_value(
        &mut self,
        name: CowRcStr<'i>,
        input: &mut Parser<'i>,
        start: &ParserState,
    ) -> Result<Declaration, ParseError<()>> {
        let name = if name.starts_with("--") { name.to_string() } else { name.to_ascii_lowercase() };
        let mut written = String::new();
        let is_important = read_value(input, &mut written, 0)?;
        let written = written.trim().to_string();
        let plain = value::plain(&name, &written);
        let line = start.source_location().line as usize;
        let (is_valid, value) = (plain.is_some(), plain.unwrap_or(written));
        Ok(Declaration { name, is_valid, value, is_important, line, sheet_line: None })
    }
}

impl<'i> AtRuleParser<'i> for Block {
    type Prelude = ();
    type AtRule = Declaration;
    type Error = ();
}

impl<'i> QualifiedRuleParser<'i> for Block {
    type Prelude = ();
    type QualifiedRule = Declaration;
    type Error = ();
}

impl RuleBodyItemParser<'_, Declaration, ()> for Block {
    fn parse_declarations(&self) -> bool {
        true
    }

    fn parse_qualified(&self) -> bool {
        false
    }
}

/// Adds a value to `written` without its comments; whether `!important` ends it.
fn read_value(input: &mut Parser, written: &mut String, depth: usize) -> Result<bool, ParseError<()>> {
    loop {
        if depth == 0 && input.try_parse(parse_important).is_ok() {
            return input.expect_exhausted().map(|()| true).map_err(ParseError::from);
        }
        let start = input.position();
        let Ok(token) = input.next_including_whitespace_and_comments() else { return Ok(false) };
        let token = token.clone();
        match token {
            Token::Comment(_) => written.push(' '),
            token if token.is_parse_error() || depth == MAX_DEPTH => return Err(ParseError::custom(())),
            token => {
                written.push_str(&closed(&token, input.slice_from(start)));
                let Some(end) = closing(&token) else { continue };
                input.parse_nested_block(|input| read_value(input, written, depth + 1))?;
                written.push(end);
            }
        }
    }
}

/// A token as it is written, with the quote that a text lacks which the end of the style has cut off.
fn closed<'a>(token: &Token, written: &'a str) -> Cow<'a, str> {
    let is_inside = |inside: &str| !inside.is_empty() && !inside.ends_with('\\');
    match (token, written.chars().next()) {
        (Token::QuotedString(_), Some(quote)) if !written.strip_suffix(quote).is_some_and(is_inside) => {
            Cow::Owned(token.to_css_string())
        }
        _ => Cow::Borrowed(written),
    }
}

/// What closes a bracket.
fn closing(token: &Token) -> Option<char> {
    match token {
        Token::Function(_) | Token::ParenthesisBlock => Some(')'),
        Token::SquareBracketBlock => Some(']'),
        Token::CurlyBracketBlock => Some('}'),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<(String, String, bool)> {
        of_attribute(text).into_iter().map(|d| (d.name, d.value, d.is_important)).collect()
    }

    fn one(text: &str) -> (String, String, bool) {
        let [declaration] = &read(text)[..] else { panic!("{:?}", read(text)) };
        declaration.clone()
    }

    fn is(name: &str, value: &str, important: bool) -> (String, String, bool) {
        (name.to_string(), value.to_string(), important)
    }

    #[test]
    fn case_comments_and_escapes_are_read_as_css() {
        assert_eq!(one("FILL:/* a; b */Red"), is("fill", "Red", false));
        assert_eq!(one("stroke-width : 4PX ! Important ;"), is("stroke-width", "4PX", true));
        assert_eq!(one(r"f\69ll: #ff0"), is("fill", "#ff0", false));
        assert_eq!(one("fill: rgb(255/*,*/, 0, 0)"), is("fill", "#ff0000", false));
        assert_eq!(one("--Own: A"), is("--Own", "A", false));
    }

    #[test]
    fn a_mistake_costs_one_declaration() {
        assert_eq!(one("fill red; stroke: blue"), is("stroke", "blue", false));
        assert_eq!(one("fill: ) ; stroke: blue"), is("stroke", "blue", false));
        assert_eq!(one("stroke: blue; fill: red !important twice"), is("stroke", "blue", false));
        assert!(read(&format!("fill: {}", "(".repeat(100_000))).is_empty());
    }

    #[test]
    fn semicolons_in_texts_and_addresses_end_nothing() {
        let declarations = read("font-family: 'a;b'; fill: url(#c) ; stroke: red");
        assert_eq!(declarations.len(), 3, "{declarations:?}");
        assert_eq!(declarations[0], is("font-family", "'a;b'", false));
        assert_eq!(one("font-family: 'a;b"), is("font-family", "\"a;b\"", false));
    }
}
