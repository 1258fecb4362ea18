//! Hidden things: what a sheet takes off the table, far from where it is drawn.

use super::clones::Holders;
use super::drawing::is_thing;
use super::{css, style};
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};

/// Warns of the first element with things in it of which a sheet says `display: none`. Where the element itself says so it
/// is meant.
pub(super) fn warning<'d>(
    source: &Source,
    document: &Document,
    holders: &Holders,
    style_of: impl Fn(Node) -> Option<&'d str>,
) -> Option<Diagnostic> {
    let is_none = |style: &str| {
        css::style_declarations(style)
            .rev()
            .find(|(name, _)| *name == "display")
            .is_some_and(|(_, value)| value == "none")
    };
    let by_sheet = |node: &Node| {
        let own = style::own_property(*node, "display") == Some("none");
        holders.has(*node) && !own && style_of(*node).is_some_and(is_none)
    };
    let mut hidden = document.descendants().filter(by_sheet);
    let first = hidden.next()?;
    let name = first.tag_name().name();
    let what = match first.descendants().filter(|node| is_thing(*node)).count() {
        _ if is_thing(first) => "it is not on the table".to_string(),
        0 | 1 => "what is in it is not on the table".to_string(),
        things => format!("the {things} things in it are not on the table"),
    };
    let more = match hidden.count() {
        0 => String::new(),
        more => format!(" (so it is with {more} more)"),
    };
    let what = format!("a sheet says `display: none` of this {name}, so {what}{more}");
    Some(source.diagnostic(first.range().start, what).into_warning())
}
