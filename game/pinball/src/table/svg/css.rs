//! The cascade: what a drawing's sheets, `style` attributes and presentation attributes together say of an element, as
//! a browser finds it.
//!
//! Parsed and matched by the crates that Firefox does it with. The art's rasteriser has a cascade of its own, which
//! knows less; it gets the result instead of the sheets, so that things and art cannot disagree.

mod brackets;
mod check;
mod declarations;
mod grammar;
mod placement;
mod selector;
mod sheet;
mod spelling;
mod unused;
mod value;
mod value_words;

pub(in crate::table) use selector::Instance;

use super::sheet_values::{READ, SheetLines};
use crate::table::source::{Diagnostic, Source};
use declarations::Declaration;
use placement::Placements;
use roxmltree::{Document, Node};
use selectors::matching::SelectorCaches;
use sheet::Rule;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// Comparisons of a selector's words with elements that a drawing may take: a second or two.
const MAX_COMPARISONS: usize = 20_000_000;

/// What sheets may say of all elements together, bytes.
const MAX_BYTES: usize = 32 << 20;

/// The sheets of a drawing.
pub(in crate::table) struct Cascade {
    rules: Vec<Rule>,
    caches: SelectorCaches,
    /// Bytes of styles so far.
    written: usize,
    /// See [`SheetLines`]; by the byte at which an element begins.
    pub lines: SheetLines,
    /// What sheets and styles say of where art is.
    placements: Placements,
    /// Every class that a sheet names, and perhaps other words.
    pub classes: BTreeSet<String>,
}

/// How strongly something is declared (CSS Cascade 5, 6.1): important, in a `style` attribute, by how specific a
/// selector, how late.
type Strength = (bool, bool, u32, usize);

impl Cascade {
    /// Reads the sheets. What is wrong with one is a warning, because a browser would say nothing at all.
    pub fn read(
        source: &Source,
        document: &Document,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Result<Cascade, Diagnostic> {
        sheet::check(document).map_err(|(at, why)| source.diagnostic(at, format!("{why}; style it more simply")))?;
        sheet::unclosed(source, document).map_or(Ok(()), Err)?;
        let mut rules = Vec::new();
        let mut classes = BTreeSet::new();
        for node in sheet::elements(document) {
            sheet::read(source, node, &mut rules, diagnostics);
            classes.extend(class_words(&sheet::text(node)));
        }
        diagnostics.extend(sheet::foreign(source, document));
        let lines = SheetLines::new();
        let (caches, placements) = (SelectorCaches::default(), Placements::default());
        let cascade = Cascade { rules, caches, written: 0, lines, placements, classes };
        let comparisons = cascade.comparisons(document);
        if comparisons > MAX_COMPARISONS {
            let why = format!(
                "its sheets and its elements are too many for each other: {comparisons} comparisons, and at most \
                 {MAX_COMPARISONS} are made; style it more simply"
            );
            return Err(Diagnostic::of_file(&source.path, why));
        }
        Ok(cascade)
    }

    /// How many comparisons it takes at most to find which rules mean which elements.
    fn comparisons(&self, document: &Document) -> usize {
        let elements = || document.descendants().filter(Node::is_element);
        let most_children = elements().map(|node| node.children().count()).max().unwrap_or(0).max(1);
        let deepest = elements().map(|node| node.ancestors().count()).max().unwrap_or(0);
        let around = selector::Around { beside: most_children, above: deepest };
        let selectors = self.rules.iter().flat_map(|rule| rule.selectors.slice());
        let each = selectors.map(|selector| selector::comparisons(selector, around));
        each.fold(0, usize::saturating_add).saturating_mul(elements().count())
    }

    /// Whether what the sheets say of all elements together can be written down.
    pub fn check(&self, source: &Source) -> Result<(), Diagnostic> {
        if self.written <= MAX_BYTES {
            return Ok(());
        }
        let why = format!("its sheets say more than {} MB of its elements; style it more simply", MAX_BYTES >> 20);
        Err(Diagnostic::of_file(&source.path, why))
    }

    /// Warns of selectors that have meant no element of the drawing.
    pub fn unused(&self, source: &Source, document: &Document) -> Vec<Diagnostic> {
        unused::warnings(source, document, &self.rules)
    }

    /// Warns of what places art and is not obeyed.
    pub fn misplaced(&self, source: &Source) -> Vec<Diagnostic> {
        self.placements.warnings(source)
    }

    /// What is declared for an element, the weaker before the stronger, as a `style` attribute that every reader
    /// understands; nothing if its own attribute is that already.
    pub fn style(&mut self, element: Instance) -> Option<String> {
        let own = element.node.attribute("style");
        let is_silent = self.rules.is_empty() && own.is_none();
        if is_silent || self.written > MAX_BYTES {
            return None;
        }
        let declared = strongest(self.declared(element), element.node);
        if element.root.is_none() {
            self.placements.look(element.node, &declared);
        }
        for Declaration { name, value, sheet_line, .. } in declared.iter().filter(|one| READ.contains(&&*one.name)) {
            let at = element.node.range().start;
            self.lines.extend(sheet_line.map(|line| ((at, name.clone(), value.clone()), line)));
        }
        let written: Vec<(&str, &str)> = declared.iter().map(|d| (d.name.as_str(), d.value.as_str())).collect();
        let is_plain = written == style_declarations(own.unwrap_or("")).collect::<Vec<_>>();
        let style: Vec<String> = written.iter().map(|(name, value)| format!("{name}:{value}")).collect();
        let style = style.join(";");
        self.written += style.len();
        (!is_plain).then_some(style)
    }

    /// Everything that is declared for an element, the strongest last.
    fn declared(&mut self, element: Instance) -> Vec<Declaration> {
        let mut declared: Vec<(Strength, Declaration)> = Vec::new();
        for (order, rule) in self.rules.iter_mut().enumerate() {
            let Rule { selectors, used, .. } = rule;
            if let Some(specificity) = selector::specificity(selectors, element, &mut self.caches, used) {
                let strength = |declaration: &Declaration| (declaration.is_important, false, specificity, order);
                declared.extend(rule.declarations.iter().map(|one| (strength(one), one.clone())));
            }
        }
        let own = declarations::of_attribute(element.node.attribute("style").unwrap_or(""));
        declared.extend(own.into_iter().map(|one| ((one.is_important, true, 0, 0), one)));
        // Stable: of equals the later wins.
        declared.sort_by_key(|(strength, _)| *strength);
        declared.into_iter().map(|(_, declaration)| declaration).collect()
    }
}

/// Each property once, as it is declared most strongly. What is no value of its property counts only where nothing else
/// is said, so that a thing's maker hears of it.
fn strongest(declared: Vec<Declaration>, node: Node) -> Vec<Declaration> {
    let (mut known, mut said) = (BTreeSet::new(), BTreeSet::new());
    let mut kept: Vec<Declaration> = Vec::new();
    for declaration in declared.iter().rev().filter(|declaration| declaration.is_valid) {
        if known.insert(declaration.name.as_str()) {
            kept.push(declaration.clone());
        }
    }
    kept.reverse();
    let unsaid = |name: &str| !known.contains(name) && !node.has_attribute(name);
    let wrong = declared.iter().rev().filter(|one| !one.is_valid && unsaid(&one.name));
    kept.extend(wrong.filter(|one| said.insert(one.name.as_str())).cloned());
    kept
}

/// The declarations of a `style` attribute that is written out, property and value: what a reader finds that knows nothing
/// of comments, case and `!important`.
pub fn style_declarations(style: &str) -> impl DoubleEndedIterator<Item = (&str, &str)> {
    let (mut quote, mut brackets, mut is_escaped) = (None, 0_usize, false);
    let ends = |c: char| {
        match c {
            _ if is_escaped => {
                is_escaped = false;
                return false;
            }
            '\\' => is_escaped = true,
            '"' | '\'' if quote.is_none() => quote = Some(c),
            _ if quote.is_some() => quote = quote.filter(|open| *open != c),
            '(' => brackets += 1,
            ')' => brackets = brackets.saturating_sub(1),
            _ => {}
        }
        c == ';' && quote.is_none() && brackets == 0
    };
    let written: Vec<&str> = style.split(ends).collect();
    let declarations = written.into_iter().filter_map(|declaration| declaration.split_once(':'));
    declarations.map(|(name, value)| (name.trim(), value.trim()))
}

/// Whether an element is a sheet.
pub(in crate::table) fn is_sheet(node: Node) -> bool {
    sheet::is_sheet(node)
}

/// The properties that an element declares itself: in its `style`, and as attributes.
pub(in crate::table) fn own_properties<'a>(node: Node<'a, '_>) -> impl Iterator<Item = Cow<'a, str>> {
    let own = node.attributes().filter(|attribute| attribute.namespace().is_none());
    own.flat_map(|attribute| match attribute.name() {
        "style" => declarations::of_attribute(attribute.value()).into_iter().map(|one| Cow::Owned(one.name)).collect(),
        name => vec![Cow::Borrowed(name)],
    })
}

/// The colours of an element that are none, with their properties: in its `style`, and as attributes. Of what stands for
/// another value nothing is known.
pub(in crate::table) fn wrong_colors(node: Node) -> Vec<(String, String)> {
    let is_known = |value: &str| !value.is_empty() && !value.to_ascii_lowercase().contains("var(");
    let own = node.attributes().filter(|one| one.namespace().is_none() && value::is_colored(one.name()));
    let attributes = own.filter(|one| value::plain(one.name(), one.value()).is_none());
    let attributes = attributes.map(|one| (one.name().to_string(), one.value().trim().to_string()));
    let declared = declarations::of_attribute(node.attribute("style").unwrap_or(""));
    let declared = declared.into_iter().filter(|one| !one.is_valid && value::is_colored(&one.name));
    let all = attributes.chain(declared.map(|one| (one.name, one.value)));
    all.filter(|(_, value)| is_known(value)).collect()
}

/// What of an element has a value that nobody reads, with what to do: in its `style`, and as attributes.
pub(in crate::table) fn unread_values(node: Node) -> Vec<(String, String, String)> {
    let own = node.attributes().filter(|one| one.namespace().is_none());
    let attributes = own.map(|one| (one.name().to_string(), one.value().trim().to_string()));
    let declared = declarations::of_attribute(node.attribute("style").unwrap_or(""));
    let all = attributes.chain(declared.into_iter().map(|one| (one.name, one.value)));
    all.filter_map(|(name, value)| grammar::mistake(&name, &value).map(|hint| (name, value, hint))).collect()
}

/// Whether an element says a property once, so that what it says is what a reader finds.
pub(in crate::table) fn is_read_alone(node: Node, property: &str) -> bool {
    own_properties(node).filter(|own| own.as_ref() == property).count() == 1
}

/// What in an element's `style` attribute is no declaration: how it begins, and a warning.
pub(in crate::table) fn unread_style(source: &Source, node: Node) -> Vec<(String, Diagnostic)> {
    let unread = declarations::unread_in_attribute(node.attribute("style").unwrap_or(""));
    let line = source.line(node.range().start);
    unread.into_iter().map(|one| (one.begin.clone(), sheet::no_declaration(source, line, &one.begin))).collect()
}

/// A warning of a property that is none, and nearly one.
pub(in crate::table) fn misspelt(source: &Source, line: usize, name: &str) -> Option<Diagnostic> {
    sheet::misspelt(source, line, name)
}

/// The value of a presentation attribute in plain words, if it is written otherwise.
pub(in crate::table) fn plain_attribute(name: &str, value: &str) -> Option<String> {
    let plain = value::plain(name, value).filter(|_| value::is_colored(name))?;
    (plain != value.trim()).then_some(plain)
}

/// What stands behind the full stops of a sheet.
fn class_words(sheet: &str) -> impl Iterator<Item = String> {
    let in_name = |c: &char| c.is_alphanumeric() || matches!(c, '-' | '_');
    sheet.split('.').skip(1).map(move |rest| rest.chars().take_while(in_name).collect())
}

#[cfg(test)]
mod tests {
    use super::style_declarations;

    #[test]
    fn semicolons_in_texts_and_addresses_end_no_declaration() {
        let style = "fill : red;font-family:'a;fill:b\\';';mask:url(#c;d);; stroke:\"";
        let read: Vec<(&str, &str)> = style_declarations(style).collect();
        let font = ("font-family", "'a;fill:b\\';'");
        assert_eq!(read, [("fill", "red"), font, ("mask", "url(#c;d)"), ("stroke", "\"")]);
    }
}
