//! Unused values: calls that only ask, as statements. `score();` gives no points.

use super::remark::Remark;
use crate::rules::handlers;
use crate::rules::script::{Kind, Node, Script};

/// Functions of the game that do nothing but answer.
const ASKS: [&str; 13] = [
    "score",
    "scores",
    "player",
    "players",
    "ball",
    "playing",
    "tilted",
    "max_players",
    "running",
    "time_left",
    "now",
    "exists",
    "closed",
];

/// Answers that nobody takes.
pub fn remarks(script: &Script) -> Vec<Remark> {
    let mut found = Vec::new();
    for function in script.functions() {
        // What a function of an event gives is taken by nobody.
        let is_event = handlers::is_handler(&function.name);
        look(&function.body, is_event, &mut found);
    }
    found
}

/// `is_statement`: the value of the node is taken by nobody.
fn look(node: &Node, is_statement: bool, found: &mut Vec<Remark>) {
    match &node.kind {
        Kind::Host(function, values) if is_statement && asks(function.name, values.len()) => {
            let hint = match function.name {
                "score" => "`score(100)` gives points".to_string(),
                name => format!("ask it in a condition, as `if {name}(..)`, or take it out"),
            };
            let what = format!("the answer of `{}` is used by nothing; {hint}", function.name);
            found.push(Remark::warning(node.line as usize, what));
        }
        Kind::Block(nodes) => {
            let last = nodes.len().saturating_sub(1);
            nodes.iter().enumerate().for_each(|(at, node)| look(node, is_statement || at < last, found));
        }
        Kind::If(parts) => {
            look(&parts[0], false, found);
            parts[1..].iter().for_each(|branch| look(branch, is_statement, found));
        }
        Kind::While(parts) | Kind::Do(parts, _) => parts.iter().for_each(|part| look(part, false, found)),
        Kind::Switch(switch) => {
            switch.branches.iter().for_each(|branch| look(&branch.body, is_statement, found));
        }
        _ => node.for_each_child(&mut |child| look(child, false, found)),
    }
}

fn asks(name: &str, values: usize) -> bool {
    ASKS.contains(&name) && (name != "score" || values == 0)
}
