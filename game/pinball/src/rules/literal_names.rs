//! Names that stand in a script as literals, checked before anyone plays: `lamp("insert-rde", "on")` is found even
//! where play seldom comes.

use super::names::Names;
use super::part_commands::PART_COMMANDS;
use super::script::{Kind, Mistake, Node, Script};
use std::collections::BTreeSet;

/// A call of a function of the game whose first argument is a literal.
struct Call<'a> {
    line: usize,
    function: &'static str,
    argument: &'a str,
}

/// Line and sentence for every literal name that the drawing does not have. A name that the script also asks
/// `exists(...)` about may be absent.
pub fn unknown_names(script: &Script, names: &Names) -> Vec<Mistake> {
    let mut calls = Vec::new();
    script.functions().for_each(|function| collect(&function.body, &mut calls));
    let optional: BTreeSet<&str> =
        calls.iter().filter(|call| call.function == "exists").map(|call| call.argument).collect();
    let mandatory = calls.iter().filter(|call| !optional.contains(call.argument));
    mandatory.filter_map(|call| Some((call.line, check(call.function, call.argument, names).err()?))).collect()
}

/// Whether a function of the game can be called with this name.
///
/// # Errors
/// A sentence if not.
pub fn check(function: &str, name: &str, names: &Names) -> Result<(), String> {
    let checked = match function {
        "lamp" | "lamp_color" | "flash" | "show" => names.lamps(name).map(|_| ()),
        "closed" => names.part(name).map(|_| ()),
        word => match PART_COMMANDS.iter().find(|command| command.word == word) {
            Some(command) => names.part_for(command, name).map(|_| ()),
            None => Ok(()),
        },
    };
    checked.map_err(|what| names.told(name, what))
}

fn collect<'a>(node: &'a Node, calls: &mut Vec<Call<'a>>) {
    if let Kind::Host(function, values) = &node.kind
        && let Some(Node { line, kind: Kind::Text(argument) }) = values.first()
    {
        calls.push(Call { line: *line as usize, function: function.name, argument });
    }
    node.for_each_child(&mut |child| collect(child, calls));
}
