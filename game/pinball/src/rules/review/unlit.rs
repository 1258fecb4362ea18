//! Unlit: lamps that no rule ever switches on. Every lamp is dark until a rule speaks of it.

use super::facts::{Call, Facts};
use super::remark::Remark;
use crate::rules::names::Names;
use crate::rules::script::{Kind, Node, Script};
use std::collections::BTreeSet;

/// Lamps that are named; of more only their number is told.
const MAX_NAMED: usize = 3;

/// What is said of lamps that stay dark, in rules that begin a game. Where a name is put together in play, a lamp is not
/// told if it holds any text of the script; nor is one whose name stands anywhere in the script.
pub fn remark(facts: &Facts, names: &Names, script: &Script, rules: &str) -> Option<Remark> {
    facts.calls_of("start_game").next()?;
    let lighting: Vec<&Call> = ["lamp", "flash", "show"]
        .into_iter()
        .flat_map(|name| facts.calls_of(name))
        .filter(|call| !is_off(call))
        .collect();
    let is_open = |call: &&Call| call.words.first().is_none_or(|words| words.others || !words.told.is_empty());
    let pieces = if lighting.iter().any(is_open) { texts(script) } else { BTreeSet::new() };
    let literals = || lighting.iter().filter_map(|call| call.words.first()).flat_map(|words| &words.literals);
    let is_lit = |lamp: &str| {
        literals().any(|literal| fits(literal, lamp))
            || rules.contains(lamp)
            || pieces.iter().any(|text| lamp.contains(text))
    };
    let dark: Vec<&str> = names.lamp_names().filter(|lamp| !is_lit(lamp)).collect();
    let first = dark.first()?;
    let named = dark.iter().take(MAX_NAMED).map(|lamp| format!("\"{lamp}\"")).collect::<Vec<_>>().join(", ");
    let more = dark.len().saturating_sub(MAX_NAMED);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let (lamps, stay) = if dark.len() == 1 { ("lamp", "stays") } else { ("lamps", "stay") };
    let what = format!("the {lamps} {named}{more} {stay} dark: no rule calls `lamp(\"{first}\", \"on\")`");
    Some(Remark::warning(0, what))
}

/// Whether a name, or all names with the start that ends in `*`, is this lamp's.
fn fits(literal: &str, lamp: &str) -> bool {
    literal.strip_suffix('*').map_or(literal == lamp, |start| lamp.starts_with(start))
}

/// Whether a call of `lamp` can only switch off.
fn is_off(call: &Call) -> bool {
    call.function.name == "lamp"
        && match call.arguments.get(1).map(|node| &node.kind) {
            Some(Kind::Text(mode)) => &**mode == "off",
            Some(Kind::Int(level)) => *level == 0,
            _ => false,
        }
}

/// Every text that stands in a script and may be a piece of a name.
fn texts(script: &Script) -> BTreeSet<&str> {
    fn collect<'a>(node: &'a Node, all: &mut BTreeSet<&'a str>) {
        if let Kind::Text(text) = &node.kind {
            all.insert(text.trim_end_matches('*'));
        }
        node.for_each_child(&mut |child| collect(child, all));
    }
    let mut all = BTreeSet::new();
    script.functions().for_each(|function| collect(&function.body, &mut all));
    all.remove("");
    all
}
