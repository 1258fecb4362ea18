//! Undone: calls of `lamp` that the next ones take back at once, because those are for the same lamps and more.

use super::remark::Remark;
use crate::rules::script::{Kind, Node, Script};

/// A call of `lamp` with a name that stands there.
struct Call<'a> {
    line: u32,
    name: &'a str,
    mode: &'a str,
}

/// What is taken back before anybody sees it: between two statements of a block no time passes.
pub fn remarks(script: &Script) -> Vec<Remark> {
    let mut found = Vec::new();
    script.functions().for_each(|function| look(&function.body, &mut found));
    found
}

fn look(node: &Node, found: &mut Vec<Remark>) {
    if let Kind::Block(nodes) = &node.kind {
        block(nodes, found);
    }
    node.for_each_child(&mut |child| look(child, found));
}

fn block(nodes: &[Node], found: &mut Vec<Remark>) {
    let mut before: Vec<Call> = Vec::new();
    for node in nodes {
        let Some(call) = call(node) else {
            before.clear();
            continue;
        };
        for undone in before.extract_if(.., |one| covers(call.name, one.name)) {
            if undone.mode != call.mode {
                let what = format!(
                    "`lamp(\"{}\", \"{}\")` is taken back at once by `lamp(\"{}\", \"{}\")` of line {}; write it behind that",
                    undone.name, undone.mode, call.name, call.mode, call.line
                );
                found.push(Remark::warning(undone.line as usize, what));
            }
        }
        before.push(call);
    }
}

/// The call of `lamp` that a statement is, if all of it stands there.
fn call(node: &Node) -> Option<Call<'_>> {
    let Kind::Host(function, values) = &node.kind else { return None };
    let (Kind::Text(name), Kind::Text(mode)) = (&values.first()?.kind, &values.get(1)?.kind) else { return None };
    (function.name == "lamp").then_some(Call { line: node.line, name, mode })
}

/// Whether a name, or a start that ends in `*`, means every lamp that another means.
fn covers(name: &str, other: &str) -> bool {
    name.strip_suffix('*').map_or(name == other, |start| other.starts_with(start))
}
