//! Known: what is known before play of the values in a function that is called with known texts.

use super::facts::assignments;
use super::words::Words;
use crate::rules::script::{Chain, Data, Function, Kind, Node, Operator, Root, Script, StepKind};
use std::collections::BTreeSet;
use std::sync::Arc;

/// What is known of a value.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Known {
    /// Nothing.
    Nothing,
    /// It is this text.
    Text(Arc<str>),
    /// It is a text, and none of these.
    Other(BTreeSet<Arc<str>>),
}

impl Known {
    /// Whether it is this value, if that is known.
    pub fn is(&self, value: &Data) -> Option<bool> {
        match (self, value) {
            (Known::Nothing, _) => None,
            (Known::Text(own), Data::Text(text)) => Some(own == text),
            (Known::Other(none), Data::Text(text)) => none.contains(text).then_some(false),
            _ => Some(false),
        }
    }

    /// Whether both are the same, if that is known.
    fn equals(&self, other: &Known) -> Option<bool> {
        match (self, other) {
            (Known::Text(text), known) | (known, Known::Text(text)) => known.is(&Data::Text(text.clone())),
            _ => None,
        }
    }
}

/// The variables of a function that is called.
pub struct Frame {
    locals: Vec<Known>,
    /// Variables that are changed somewhere: nothing is known of them.
    assigned: BTreeSet<u16>,
}

impl Frame {
    /// The variables at the beginning of a function that is called with these values.
    pub fn new(function: &Function, values: Vec<Known>) -> Frame {
        let mut assigned = BTreeSet::new();
        assignments(&function.body, &mut assigned);
        let mut locals = values;
        locals.resize(function.locals.max(locals.len()), Known::Nothing);
        assigned.iter().for_each(|slot| locals[usize::from(*slot)] = Known::Nothing);
        Frame { locals, assigned }
    }

    /// A variable gets a value.
    pub fn set(&mut self, slot: u16, known: Known) {
        if !self.assigned.contains(&slot) {
            self.locals[usize::from(slot)] = known;
        }
    }

    /// What is known of a value.
    pub fn known(&self, node: &Node, script: &Script) -> Known {
        match &node.kind {
            Kind::Text(text) => Known::Text(text.clone()),
            Kind::Local(slot) => self.locals[usize::from(*slot)].clone(),
            Kind::Constant(number) => match script.constant_value(*number) {
                Some(Data::Text(text)) => Known::Text(text.clone()),
                _ => Known::Nothing,
            },
            Kind::Block(nodes) if nodes.len() == 1 => self.known(&nodes[0], script),
            _ => Known::Nothing,
        }
    }

    /// Whether a condition holds, if that is known, where only these timers can run.
    pub fn decided(&self, node: &Node, script: &Script, running: &Words) -> Option<bool> {
        let decided = |node: &Node| self.decided(node, script, running);
        match &node.kind {
            Kind::Bool(flag) => Some(*flag),
            Kind::Not(other) => decided(other).map(|flag| !flag),
            Kind::Block(nodes) if nodes.len() == 1 => decided(&nodes[0]),
            Kind::And(parts) => either(parts.iter().map(decided), false),
            Kind::Or(parts) => either(parts.iter().map(decided), true),
            Kind::Constant(number) => match script.constant_value(*number)? {
                Data::Bool(flag) => Some(*flag),
                _ => None,
            },
            Kind::Binary(operator @ (Operator::Equal | Operator::NotEqual), sides) => {
                let [left, right] = [self.known(&sides[0], script), self.known(&sides[1], script)];
                left.equals(&right).map(|same| same == (*operator == Operator::Equal))
            }
            Kind::Library(function, values) if function.name == "contains" => {
                among(&self.known(&values[1], script), &self.items(&values[0], script)?)
            }
            Kind::Host(function, values) if function.name == "running" => match self.known(values.first()?, script) {
                Known::Text(timer) if !running.others && running.told.is_empty() => {
                    (!running.literals.contains(&timer)).then_some(false)
                }
                _ => None,
            },
            Kind::Chain(chain) => self.decided_chain(chain, script),
            _ => None,
        }
    }

    fn decided_chain(&self, chain: &Chain, script: &Script) -> Option<bool> {
        let [step] = chain.steps.as_slice() else { return None };
        let StepKind::Library(function, values) = &step.kind else { return None };
        let value = values.first().map(|value| self.known(value, script))?;
        if function.name == "contains"
            && let Some(items) = match &chain.root {
                Root::Constant(number) => script.constant_value(*number).and_then(texts),
                Root::Value(node) => self.items(node, script),
                Root::Local(_) | Root::This => None,
            }
        {
            return among(&value, &items);
        }
        let Root::Local(slot) = chain.root else { return None };
        let (Known::Text(own), Known::Text(part)) = (&self.locals[usize::from(slot)], &value) else { return None };
        match function.name {
            "contains" => Some(own.contains(&**part)),
            "starts_with" => Some(own.starts_with(&**part)),
            "ends_with" => Some(own.ends_with(&**part)),
            _ => None,
        }
    }

    /// The texts of an array, if it has nothing else and all are known.
    fn items(&self, node: &Node, script: &Script) -> Option<Vec<Arc<str>>> {
        match &node.kind {
            Kind::Constant(number) => texts(script.constant_value(*number)?),
            Kind::List(nodes) => nodes
                .iter()
                .map(|node| match self.known(node, script) {
                    Known::Text(text) => Some(text),
                    _ => None,
                })
                .collect(),
            _ => None,
        }
    }
}

/// Whether something is among texts, if that is known.
fn among(value: &Known, items: &[Arc<str>]) -> Option<bool> {
    either(items.iter().map(|item| value.is(&Data::Text(item.clone()))), true)
}

/// `decisive` if one is that, the opposite if all are, and else nothing.
fn either(parts: impl Iterator<Item = Option<bool>>, decisive: bool) -> Option<bool> {
    let parts: Vec<Option<bool>> = parts.collect();
    match parts.contains(&Some(decisive)) {
        true => Some(decisive),
        false => parts.iter().all(Option::is_some).then_some(!decisive),
    }
}

/// The texts that a constant array has, if it has nothing else.
fn texts(value: &Data) -> Option<Vec<Arc<str>>> {
    let Data::List(items) = value else { return None };
    let text = |item: &Data| match item {
        Data::Text(text) => Some(text.clone()),
        _ => None,
    };
    items.iter().map(text).collect()
}
