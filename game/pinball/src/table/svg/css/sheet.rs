//! Style sheets: the rules of a drawing's `<style>` elements.

use super::declarations::{self, Declaration, Unread};
use super::selector::{self, Selectors};
use super::{brackets, check, spelling};
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::page::SVG;
use cssparser::{AtRuleParser, CowRcStr, ParseError, Parser, ParserState, QualifiedRuleParser, StyleSheetParser};
use roxmltree::{Document, Node};

/// All sheets of a drawing together, bytes.
const MAX_BYTES: usize = 256 << 10;
/// Brackets that may lie inside each other.
const MAX_DEPTH: usize = 24;

/// A rule: which elements it means, and what it declares for them.
pub(super) struct Rule {
    pub selectors: Selectors,
    pub declarations: Vec<Declaration>,
    /// What between its braces is no declaration.
    pub unread: Vec<Unread>,
    /// The line that it begins in: of its sheet from 0, and of the file when the sheet has been read.
    pub line: usize,
    /// Which of its selectors have meant an element.
    pub used: Vec<bool>,
}

/// Whether an element is a sheet: a `<style>` of no other kind than CSS.
pub(super) fn is_sheet(node: Node) -> bool {
    let css = |kind: &str| kind.is_empty() || kind.eq_ignore_ascii_case("text/css");
    node.has_tag_name((SVG, "style")) && node.attribute("type").is_none_or(css)
}

/// The sheets of a drawing.
pub(super) fn elements<'a, 'i>(document: &'a Document<'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    document.descendants().filter(|node| is_sheet(*node))
}

/// The text of a `<style>` element.
pub(super) fn text(node: Node) -> String {
    node.children().filter_map(|child| child.text().filter(|_| child.is_text())).collect()
}

/// Adds the rules of a sheet, in their order, and a warning for each that cannot be read.
pub(super) fn read(source: &Source, node: Node, rules: &mut Vec<Rule>, diagnostics: &mut Vec<Diagnostic>) {
    let text = text(node);
    if holds(node.attribute("media").unwrap_or("")) != Some(true) {
        return;
    }
    let mut input = Parser::new(&text);
    let first = first_line(source, node);
    let mut parser = SheetParser::default();
    for rule in StyleSheetParser::new(&mut input, &mut parser) {
        match rule {
            Ok(mut read) => {
                for declaration in read.iter_mut().flat_map(|rule| &mut rule.declarations) {
                    let line = first + declaration.line;
                    declaration.sheet_line = Some(line);
                    diagnostics.extend(check::warning(source, line, declaration));
                }
                let declared = read.iter().flat_map(|rule| &rule.declarations);
                diagnostics.extend(declared.filter_map(|one| misspelt(source, first + one.line, &one.name)));
                let unread = read.iter().flat_map(|rule| &rule.unread);
                diagnostics.extend(unread.map(|unread| no_declaration(source, first + unread.line, &unread.begin)));
                rules.extend(read.into_iter().map(|rule| Rule { line: first + rule.line, ..rule }));
            }
            Err((_, rule, place)) => diagnostics.push(unread(source, first + place.line as usize, rule)),
        }
    }
    let inner = parser.unread.into_iter();
    diagnostics.extend(inner.map(|(rule, line)| unread(source, first + line as usize, &rule)));
}

/// A warning of a rule that is not read.
fn unread(source: &Source, line: usize, rule: &str) -> Diagnostic {
    let begin: String = rule.trim().chars().take_while(|&c| c != '{' && c != '\n').take(40).collect();
    let begin = begin.trim_end();
    let is_media = begin.to_ascii_lowercase().starts_with("@media");
    let why = if is_media { ": a table has no window of a known size; write what is in it without it" } else { "" };
    source.diagnostic_in_line(line, format!("the rule `{begin}` of this sheet is not read{why}")).into_warning()
}

/// Warns of the sheets that are of another language than CSS, or for other windows than a table's.
pub(super) fn foreign(source: &Source, document: &Document) -> Vec<Diagnostic> {
    let styles = document.descendants().filter(|node| node.has_tag_name((SVG, "style")));
    let told = styles.filter_map(|node| {
        let media = node.attribute("media").unwrap_or("");
        let what = match node.attribute("type") {
            Some(kind) if !is_sheet(node) => {
                format!("this sheet is of the type `{kind}`, so nobody reads it; write CSS, and type=\"text/css\" or none")
            }
            _ if holds(media).is_none() => {
                format!("this sheet is for the media `{media}` and is not read: a table has no window of a known size; take `media` out")
            }
            _ => return None,
        };
        Some(source.diagnostic(node.range().start, what).into_warning())
    });
    told.collect()
}

/// The line in which the text of a sheet begins.
fn first_line(source: &Source, node: Node) -> usize {
    source.line(node.first_child().map_or(node.range().start, |child| child.range().start))
}

/// A warning of a property that is none, and nearly one.
pub(super) fn misspelt(source: &Source, line: usize, name: &str) -> Option<Diagnostic> {
    let meant = spelling::meant(name)?;
    let what = format!("the property `{name}` means nothing; did you mean `{meant}`?");
    Some(source.diagnostic_in_line(line, what).into_warning())
}

/// A warning of what stands where a declaration should.
pub(super) fn no_declaration(source: &Source, line: usize, begin: &str) -> Diagnostic {
    let what = match begin.split_once('{') {
        Some((selector, _)) => {
            let selector = selector.trim_end();
            format!("the rule `{selector}` inside another is not read: write it behind that, with its whole selector")
        }
        None => format!("`{begin}` says nothing: write `property: value;`, with a `:` between the two"),
    };
    source.diagnostic_in_line(line, what).into_warning()
}

/// The first bracket of a drawing's sheets that is never closed, as a mistake.
pub(super) fn unclosed(source: &Source, document: &Document) -> Option<Diagnostic> {
    let mut all = elements(document).map(|node| (node, text(node)));
    all.find_map(|(node, text)| {
        let (at, bracket) = brackets::unclosed(&text)?;
        let line = first_line(source, node) + text[..at].matches('\n').count();
        let what = format!("this `{bracket}` is never closed, so the sheet swallows all that follows it; close it");
        Some(source.diagnostic_in_line(line, what))
    })
}

/// What of a drawing's sheets could take too long to read.
///
/// # Errors
/// If they are too long, or nest too deep.
pub(super) fn check(document: &Document) -> Result<(), (usize, String)> {
    let mut bytes = 0;
    for node in elements(document) {
        let text = text(node);
        bytes += text.len();
        if bytes > MAX_BYTES {
            return Err((node.range().start, format!("the sheets have more than {} kB", MAX_BYTES >> 10)));
        }
        if deepest(&text) > MAX_DEPTH {
            let why = format!("more than {MAX_DEPTH} brackets lie inside each other in this sheet");
            return Err((node.range().start, why));
        }
    }
    Ok(())
}

fn deepest(text: &str) -> usize {
    let (mut depth, mut deepest) = (0_usize, 0);
    for byte in text.bytes() {
        match byte {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    deepest
}

/// Whether a list of media holds for a table, which is shown on a screen; unknown where it asks for more than that: a table is
/// no page and has no window of a known size.
fn holds(media: &str) -> Option<bool> {
    let query = |query: &str| match query.trim().to_ascii_lowercase().as_str() {
        "" | "all" | "screen" | "only screen" | "not print" | "not speech" => Some(true),
        "not all" | "not screen" => Some(false),
        other if other.split([' ', '(']).next().is_some_and(|first| OTHER_MEDIA.contains(&first)) => Some(false),
        _ => None,
    };
    let all: Vec<Option<bool>> = media.split(',').map(query).collect();
    if all.contains(&Some(true)) {
        return Some(true);
    }
    if all.contains(&None) { None } else { Some(false) }
}

/// Media that are no screen.
const OTHER_MEDIA: [&str; 9] =
    ["print", "speech", "aural", "braille", "embossed", "handheld", "projection", "tty", "tv"];

/// Reads rules.
#[derive(Default)]
struct SheetParser {
    /// How rules inside of others begin that are not read, and the lines from 0.
    unread: Vec<(String, u32)>,
}

impl<'i> QualifiedRuleParser<'i> for SheetParser {
    type Prelude = Selectors;
    type QualifiedRule = Vec<Rule>;
    type Error = ();

    fn parse_prelude(&mut self, input: &mut Parser<'i>) -> Result<Selectors, ParseError<()>> {
        selector::read(input)
    }

    fn parse_block(
        &mut self,
        selectors: Selectors,
        start: &ParserState,
        input: &mut Parser<'i>,
    ) -> Result<Vec<Rule>, ParseError<()>> {
        let used = vec![false; selectors.slice().len()];
        let line = start.source_location().line as usize;
        let (declarations, unread) = declarations::of_block(input);
        Ok(vec![Rule { selectors, declarations, unread, line, used }])
    }
}

impl<'i> AtRuleParser<'i> for SheetParser {
    /// Whether the rules in it hold.
    type Prelude = bool;
    type AtRule = Vec<Rule>;
    type Error = ();

    fn parse_prelude(&mut self, name: CowRcStr<'i>, input: &mut Parser<'i>) -> Result<bool, ParseError<()>> {
        let start = input.position();
        while input.next().is_ok() {}
        match name.to_ascii_lowercase().as_str() {
            "media" => holds(input.slice_from(start)).ok_or_else(|| ParseError::custom(())),
            // Of no use to a drawing whose fonts are built in and which does not move.
            "font-face" | "keyframes" | "page" | "namespace" | "charset" => Ok(false),
            _ => Err(ParseError::custom(())),
        }
    }

    fn rule_without_block(&mut self, _holds: bool, _start: &ParserState) -> Result<Vec<Rule>, ()> {
        Ok(Vec::new())
    }

    fn parse_block(
        &mut self,
        holds: bool,
        _start: &ParserState,
        input: &mut Parser<'i>,
    ) -> Result<Vec<Rule>, ParseError<()>> {
        if !holds {
            while input.next().is_ok() {}
            return Ok(Vec::new());
        }
        let mut inner = SheetParser::default();
        let (mut rules, mut unread) = (Vec::new(), Vec::new());
        for rule in StyleSheetParser::new(input, &mut inner) {
            match rule {
                Ok(read) => rules.extend(read),
                Err((_, rule, place)) => unread.push((rule.to_string(), place.line)),
            }
        }
        self.unread.extend(unread);
        self.unread.append(&mut inner.unread);
        Ok(rules)
    }
}
