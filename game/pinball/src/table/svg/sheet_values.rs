//! Values that sheets give to things: what is wrong with one is told once, in the sheet's line, and not of every thing.

use super::style;
use crate::table::source::{Diagnostic, Source};
use roxmltree::Node;
use std::collections::BTreeMap;

/// The properties that a thing is read from and that a sheet may give.
pub(in crate::table) const READ: [&str; 3] = ["fill", "stroke", "stroke-width"];

/// The line of a sheet that gives a property this value, by the line of the element that it is given to.
pub(in crate::table) type SheetLines = BTreeMap<(usize, String, String), usize>;

/// Mistakes of things whose cause is a sheet's.
#[derive(Debug, Default)]
pub(super) struct SheetMistakes {
    /// By the sheet's line: the first thing, and how many more there are.
    found: BTreeMap<(usize, String), (String, usize)>,
}

impl SheetMistakes {
    /// Takes what is wrong with a thing if a sheet's value is.
    pub fn take(&mut self, lines: &SheetLines, source: &Source, (node, name): (Node, &str), why: &str) -> bool {
        let Some(property) = READ.into_iter().find(|property| why.starts_with(&format!("its {property} `"))) else {
            return false;
        };
        let given = node.ancestors().find_map(|node| {
            let value = style::own_property(node, property).filter(|value| *value != "inherit")?;
            Some((source.line(node.range().start), property.to_string(), value.to_string()))
        });
        let Some(line) = given.and_then(|given| lines.get(&given)) else { return false };
        let what = why.replacen("its", "this", 1);
        let first = || (format!("{name} of line {}", source.line(node.range().start)), 0);
        self.found.entry((*line, what)).and_modify(|(_, more)| *more += 1).or_insert_with(first);
        true
    }

    /// The mistakes, in place of what was warned of the same values.
    pub fn tell(self, source: &Source, diagnostics: &mut Vec<Diagnostic>) {
        for ((line, what), (first, more)) in self.found {
            let more = if more == 0 { String::new() } else { format!(", and to {more} more") };
            let mistake = source.diagnostic_in_line(line, format!("{what} (the sheet gives it to {first}{more})"));
            diagnostics.retain(|warning| !mistake.says_more_than(warning));
            diagnostics.push(mistake);
        }
    }
}
