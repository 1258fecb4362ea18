//! Selectors that mean no element of the drawing: what was meant by those that are nearly one that does.

use super::selector::{self, Words};
use super::sheet::Rule;
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::element_class::ElementClass;
use crate::table::svg::{class_typo, shape_typo};
use cssparser::ToCss;
use roxmltree::{Document, Node};
use std::collections::BTreeSet;

/// Warns of them: each that is nearly another, and of all others the first.
pub(super) fn warnings(source: &Source, document: &Document, rules: &[Rule]) -> Vec<Diagnostic> {
    let named = Named::of(document);
    let (mut told, mut others, mut found) = (BTreeSet::new(), Vec::new(), Vec::new());
    for rule in rules {
        let unused = rule.selectors.slice().iter().zip(&rule.used).filter(|(_, used)| !**used);
        for (selector, _) in unused {
            let words = selector::words(selector);
            let written = selector.to_css_string();
            match named.meant(&words) {
                Meaning::Another(meant) if told.insert(written.clone()) => {
                    let what =
                        format!("`{written}` of this sheet means nothing in the drawing; did you mean `{meant}`?");
                    found.push(source.diagnostic_in_line(rule.line, what));
                }
                Meaning::Nobody if told.insert(written.clone()) => others.push((rule.line, written)),
                _ => {}
            }
        }
    }
    if let Some((line, written)) = others.first() {
        let more = match others.len() - 1 {
            0 => String::new(),
            more => format!(" (so it is with {more} more)"),
        };
        let what = format!("`{written}` of this sheet means nothing in the drawing{more}");
        found.push(source.diagnostic_in_line(*line, what));
    }
    found.into_iter().map(Diagnostic::into_warning).collect()
}

/// What a selector means that means nothing.
enum Meaning {
    /// A word of this page, of which the drawing has nothing.
    Known,
    /// Nearly this one.
    Another(String),
    /// Nothing that is known.
    Nobody,
}

/// The names in a drawing.
struct Named<'a> {
    classes: BTreeSet<&'a str>,
    ids: BTreeSet<&'a str>,
    elements: BTreeSet<&'a str>,
}

impl<'a> Named<'a> {
    fn of(document: &'a Document) -> Named<'a> {
        let elements = || document.descendants().filter(Node::is_element);
        let classes = elements().flat_map(|node| node.attribute("class").unwrap_or("").split_ascii_whitespace());
        Named {
            classes: classes.collect(),
            ids: elements().filter_map(|node| node.attribute("id")).collect(),
            elements: elements().map(|node| node.tag_name().name()).collect(),
        }
    }

    fn meant(&self, words: &Words) -> Meaning {
        let own = ElementClass::ALL.map(ElementClass::word).into_iter().chain(class_typo::ART);
        let is_own = |word: &&String| own.clone().any(|own| own == word.as_str());
        let unknown = words.classes.iter().filter(|word| !self.classes.contains(word.as_str()) && !is_own(word));
        let class = unknown.clone().find_map(|word| near(word, own.clone().chain(self.classes.iter().copied())));
        if let Some(class) = class {
            return Meaning::Another(format!(".{class}"));
        }
        let ids = words.ids.iter().filter(|id| !self.ids.contains(id.as_str()));
        if let Some(id) = ids.clone().find_map(|id| near(id, self.ids.iter().copied())) {
            return Meaning::Another(format!("#{id}"));
        }
        if let Some(element) = words.elements.iter().find_map(|name| shape_typo::meant_element(name)) {
            return Meaning::Another(element.to_string());
        }
        // A class whose point was forgotten.
        let is_class =
            |name: &&String| own.clone().any(|own| own == name.as_str()) || self.classes.contains(name.as_str());
        let absent = || words.elements.iter().filter(|name| !self.elements.contains(name.as_str()));
        if let Some(class) = absent().find(is_class) {
            return Meaning::Another(format!(".{class}"));
        }
        if unknown.count() + ids.count() > 0 { Meaning::Nobody } else { Meaning::Known }
    }
}

/// The name that was meant; those that programs number are all alike.
fn near<'k>(word: &str, known: impl Iterator<Item = &'k str>) -> Option<&'k str> {
    let is_numbered = |word: &str| word.contains(|letter: char| letter.is_ascii_digit());
    class_typo::nearest(word, known.filter(|known| !(is_numbered(word) && is_numbered(known))))
}
