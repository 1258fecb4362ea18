//! Entry values: conditions on entries of `this` that no rule ever makes true.

use super::comparison::Comparison;
use super::literal::{literal, same, shown};
use super::memory::foreign_functions;
use super::remark::Remark;
use crate::rules::script::{Chain, Data, Kind, Node, Operator, Root, Script, StepKind};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What an entry is set to, over all rules.
#[derive(Default)]
struct Values {
    /// Values that stand in the script.
    plain: Vec<Data>,
    /// It is set to something else too.
    others: bool,
}

/// What a condition asks of an entry.
struct Question {
    name: Arc<str>,
    line: u32,
    asked: Asked,
}

/// What an entry must be.
enum Asked {
    True,
    Value(Data),
    Number(Comparison),
}

/// The conditions that are never true.
pub fn remarks(script: &Script) -> Vec<Remark> {
    let Some(foreign) = foreign_functions(script) else { return Vec::new() };
    let mut values = BTreeMap::new();
    let mut questions = Vec::new();
    for (function, number) in script.functions().zip(0..) {
        collect_values(&function.body, script, &mut values);
        if !foreign.contains(&number) {
            collect_questions(&function.body, script, &mut questions);
        }
    }
    questions.iter().filter_map(|question| answer(question, values.get(&question.name)?)).collect()
}

/// What is told of a question whose answer is known.
fn answer(question: &Question, values: &Values) -> Option<Remark> {
    let Question { name, line, asked } = question;
    if values.others {
        return None;
    }
    let line = *line as usize;
    let set_to = || {
        let mut own: Vec<String> = values.plain.iter().map(shown).collect();
        own.sort();
        own.dedup();
        format!("rules set it to {} and to nothing else", own.join(" or "))
    };
    match asked {
        Asked::True => {
            // One that is only ever set to true is asked before it is set: that may be meant.
            let is_never = values.plain.iter().all(|value| matches!(value, Data::Bool(false)));
            let what = format!("this.{name} is asked here and is always false: no rule ever sets it to true");
            is_never.then(|| Remark::warning(line, what))
        }
        Asked::Value(value) => {
            let is_known = values.plain.iter().any(|own| same(own, value));
            let what = || format!("this.{name} is compared with {} here, and {}", shown(value), set_to());
            (!is_known).then(|| Remark::warning(line, what()))
        }
        Asked::Number(comparison) => {
            // What is no whole number is compared otherwise.
            let holds = |value: &Data| !matches!(value, Data::Int(own) if !comparison.holds(*own));
            let what = || format!("`this.{name} {}` is never true here: {}", comparison.shown(), set_to());
            (!values.plain.iter().any(holds)).then(|| Remark::warning(line, what()))
        }
    }
}

fn collect_values(node: &Node, script: &Script, values: &mut BTreeMap<Arc<str>, Values>) {
    match &node.kind {
        Kind::Assign(assign) => {
            if let Some((name, is_whole)) = entry(&assign.place) {
                let own = values.entry(name).or_default();
                match literal(&assign.value, script).filter(|_| is_whole && assign.operator.is_none()) {
                    Some(value) => own.plain.push(value),
                    None => own.others = true,
                }
            }
        }
        // A function of the library may change what it is called on, and a script's own function its `this`.
        Kind::Chain(chain) if chain.steps.len() > 1 => {
            let is_call = |kind: &StepKind| !matches!(kind, StepKind::Property(_) | StepKind::Index(_));
            if let Some((name, _)) = entry(chain).filter(|_| chain.steps.iter().any(|step| is_call(&step.kind))) {
                values.entry(name).or_default().others = true;
            }
        }
        _ => {}
    }
    node.for_each_child(&mut |child| collect_values(child, script, values));
}

/// The entry of `this` at which a chain begins, and whether the chain is that and no more.
fn entry(chain: &Chain) -> Option<(Arc<str>, bool)> {
    let (Root::This, [first, rest @ ..]) = (&chain.root, chain.steps.as_slice()) else { return None };
    match &first.kind {
        StepKind::Property(name) => Some((name.clone(), rest.is_empty())),
        StepKind::Index(Node { kind: Kind::Text(name), .. }) => Some((name.clone(), rest.is_empty())),
        _ => None,
    }
}

fn collect_questions(node: &Node, script: &Script, questions: &mut Vec<Question>) {
    let asked: Vec<&Node> = match &node.kind {
        Kind::If(parts) => vec![&parts[0]],
        Kind::While(parts) => vec![&parts[0]],
        Kind::And(parts) | Kind::Or(parts) => parts.iter().collect(),
        Kind::Not(other) => vec![&**other],
        _ => Vec::new(),
    };
    questions.extend(asked.into_iter().filter_map(asked_whole).map(|(name, line)| Question {
        name,
        line,
        asked: Asked::True,
    }));
    let number = Comparison::of(node, script).map(|comparison| (comparison.name.clone(), comparison));
    questions.extend(number.map(|(name, comparison)| Question {
        name,
        line: comparison.line,
        asked: Asked::Number(comparison),
    }));
    if let Kind::Binary(Operator::Equal, sides) = &node.kind {
        let [left, right] = &**sides;
        let pair = |place: &Node, value: &Node| asked_whole(place).zip(literal(value, script));
        let pair = pair(left, right).or_else(|| pair(right, left));
        let pair = pair.filter(|(_, value)| !matches!(value, Data::Unit));
        questions.extend(pair.map(|((name, line), value)| Question { name, line, asked: Asked::Value(value) }));
    }
    node.for_each_child(&mut |child| collect_questions(child, script, questions));
}

/// The entry of `this` that a node is, and its line.
pub fn asked_whole(node: &Node) -> Option<(Arc<str>, u32)> {
    let Kind::Chain(chain) = &node.kind else { return None };
    entry(chain).filter(|(_, is_whole)| *is_whole).map(|(name, _)| (name, node.line))
}
