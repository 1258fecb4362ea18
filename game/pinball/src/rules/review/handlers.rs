//! Functions that are nearly called like a handler, and that nothing calls.

use super::remark::Remark;
use crate::rules::handlers;
use crate::rules::handlers::line_of_function;
use crate::rules::script::{Chain, Kind, Node, Script, StepKind};
use std::collections::BTreeSet;

/// The functions whose name is a handler's but for case, underscores or a letter.
pub fn misspelt(script: &Script, rules: &str) -> Vec<Remark> {
    let mut called = BTreeSet::new();
    script.functions().for_each(|function| calls(&function.body, &mut called));
    let uncalled = script.functions().zip(0..).filter(|(_, number)| !called.contains(number));
    let told = uncalled.filter_map(|(function, _)| {
        let meant = handlers::meant(&function.name)?;
        let what = format!("nothing calls {}; did you mean `{meant}`?", function.name);
        Some(Remark::error(line_of_function(&function.name, rules), what))
    });
    told.collect()
}

/// The functions that are called in a node, or used as values.
fn calls(node: &Node, called: &mut BTreeSet<u16>) {
    match &node.kind {
        Kind::Script(number, _) | Kind::Function(number) => {
            called.insert(*number);
        }
        Kind::Chain(chain) => in_chain(chain, called),
        Kind::Assign(assign) => in_chain(&assign.place, called),
        _ => {}
    }
    node.for_each_child(&mut |child| calls(child, called));
}

fn in_chain(chain: &Chain, called: &mut BTreeSet<u16>) {
    called.extend(chain.steps.iter().filter_map(|step| match step.kind {
        StepKind::Script(number, _) => Some(number),
        _ => None,
    }));
}
