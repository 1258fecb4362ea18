//! Unused values: calls that only ask, as statements. `score();` gives no points.

use super::remark::Remark;
use crate::rules::handlers;
use crate::rules::script::{Kind, Node, Script};

/// Functions of the game that do nothing but answer.
const ASKS: [&str; 14] = [
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
    "balls_in_play",
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
        Kind::While(parts) => {
            look(&parts[0], false, found);
            look(&parts[1], true, found);
        }
        Kind::Do(parts, _) => {
            look(&parts[0], true, found);
            look(&parts[1], false, found);
        }
        Kind::For(parts) => {
            look(&parts.subject, false, found);
            look(&parts.body, true, found);
        }
        Kind::Try(parts) => [&parts.body, &parts.handler].into_iter().for_each(|part| look(part, is_statement, found)),
        Kind::Switch(switch) => {
            switch.branches.iter().for_each(|branch| look(&branch.body, is_statement, found));
        }
        _ => node.for_each_child(&mut |child| look(child, false, found)),
    }
}

fn asks(name: &str, values: usize) -> bool {
    ASKS.contains(&name) && (name != "score" || values == 0)
}
