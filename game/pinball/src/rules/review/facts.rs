//! Facts of a script: which texts it hands to the game's functions, and with which it compares the names that it is told.
//!
//! What a function is given is collected over all its calls, again and again until nothing is new; what cannot be followed
//! is unknown, and nothing is said of it.

use super::words::{Told, Words};
use crate::rules::host_function::HostFunction;
use crate::rules::script::{Chain, Data, Kind, Node, Operator, Pattern, Root, Script, StepKind, Switch};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Rounds after which nothing is new in any script that a person writes.
const MAX_ROUNDS: usize = 32;

/// A call of a function of the game.
pub struct Call<'a> {
    /// The line.
    pub line: u32,
    /// The function.
    pub function: &'static HostFunction,
    /// What it is given.
    pub arguments: &'a [Node],
    /// Which texts that can be.
    pub words: Vec<Words>,
}

/// A comparison of something with a text.
pub struct Comparison {
    /// The line.
    pub line: u32,
    /// What is compared.
    pub words: Words,
    /// With what.
    pub text: Arc<str>,
    /// The text stands in an array with others.
    pub is_item: bool,
}

/// Two values that are compared.
pub struct Compared<'a> {
    /// The line.
    pub line: u32,
    /// How.
    pub operator: Operator,
    /// Both.
    pub sides: [&'a Node; 2],
    /// Which texts each can be.
    pub words: [Words; 2],
}

/// What a script does with texts.
#[derive(Default)]
pub struct Facts<'a> {
    /// In the order of the functions' names.
    pub calls: Vec<Call<'a>>,
    /// In the same order.
    pub comparisons: Vec<Comparison>,
    /// In the same order.
    pub compared: Vec<Compared<'a>>,
    /// Every `switch`, and which texts its subject can be.
    pub switches: Vec<(&'a Switch, Words)>,
}

impl<'a> Facts<'a> {
    /// The facts of a script.
    pub fn new(script: &'a Script) -> Facts<'a> {
        let mut given: Vec<Vec<Words>> =
            script.functions().map(|function| told(&function.name, function.parameters)).collect();
        for _ in 0..MAX_ROUNDS {
            let mut more = given.clone();
            let facts = Facts::found(script, &mut more);
            if more == given {
                return facts;
            }
            given = more;
        }
        Facts::default()
    }

    /// The facts, where functions are given this; what else they are given is added.
    fn found(script: &'a Script, given: &mut [Vec<Words>]) -> Facts<'a> {
        let mut facts = Facts::default();
        for (number, function) in script.functions().enumerate() {
            let mut assigned = BTreeSet::new();
            assignments(&function.body, &mut assigned);
            let mut locals = given[number].clone();
            locals.resize_with(function.locals, Words::unknown);
            for slot in &assigned {
                locals[usize::from(*slot)] = Words::unknown();
            }
            let mut walker = Walker { script, given, locals, assigned, facts };
            walker.walk(&function.body);
            facts = walker.facts;
        }
        facts
    }

    /// The texts that one argument of a function can be, over all its calls.
    pub fn given(&self, function: &str, place: usize) -> Words {
        let calls = self.calls.iter().filter(|call| call.function.name == function);
        Words::any(calls.filter_map(|call| call.words.get(place)).cloned())
    }

    /// The calls of a function.
    pub fn calls_of(&self, function: &str) -> impl Iterator<Item = &Call<'a>> {
        self.calls.iter().filter(move |call| call.function.name == function)
    }
}

/// What the game tells a function of this name.
fn told(name: &str, parameters: usize) -> Vec<Words> {
    let by = match name {
        "on_switch" => Some(Told::Part),
        "on_open" => Some(Told::Opened),
        "on_button" | "on_release" => Some(Told::Button),
        "on_timer" => Some(Told::Timer),
        _ => None,
    };
    let first = by.map_or_else(Words::default, Words::told);
    std::iter::once(first).chain(std::iter::repeat_with(Words::default)).take(parameters).collect()
}

/// The variables that something changes after they were made.
pub fn assignments(node: &Node, found: &mut BTreeSet<u16>) {
    match &node.kind {
        Kind::Assign(assign) => found.extend(root(&assign.place)),
        Kind::Chain(chain)
            if chain.steps.iter().any(|step| matches!(&step.kind, StepKind::Library(one, _) if one.changes())) =>
        {
            found.extend(root(chain));
        }
        _ => {}
    }
    node.for_each_child(&mut |child| assignments(child, found));
}

fn root(chain: &Chain) -> Option<u16> {
    match chain.root {
        Root::Local(slot) => Some(slot),
        _ => None,
    }
}

struct Walker<'a, 'b> {
    script: &'a Script,
    /// What each function is given.
    given: &'b mut [Vec<Words>],
    /// What the variables are.
    locals: Vec<Words>,
    /// Variables that are changed somewhere: nothing is known of them.
    assigned: BTreeSet<u16>,
    facts: Facts<'a>,
}

impl<'a> Walker<'a, '_> {
    fn walk(&mut self, node: &'a Node) {
        let line = node.line;
        match &node.kind {
            Kind::Let(slot, value) => {
                self.walk(value);
                let words = self.words(value);
                return self.set(*slot, words);
            }
            Kind::For(parts) => {
                self.walk(&parts.subject);
                let items = self.items(&parts.subject);
                self.set(parts.item, items.unwrap_or_else(Words::unknown));
                parts.count.iter().for_each(|slot| self.set(*slot, Words::unknown()));
                return self.walk(&parts.body);
            }
            Kind::Try(parts) => parts.variable.iter().for_each(|slot| self.set(*slot, Words::unknown())),
            Kind::Switch(switch) => {
                let words = self.words(&switch.subject);
                self.facts.switches.push((switch, words.clone()));
                for case in &switch.cases {
                    if let Pattern::Value(Data::Text(text)) = &case.pattern {
                        self.compare(switch.branches[case.branch].body.line, &words, text, false);
                    }
                }
            }
            Kind::Binary(operator, sides) if operator.compares() => {
                let [left, right] = [self.words(&sides[0]), self.words(&sides[1])];
                let (sides, words) = ([&sides[0], &sides[1]], [left.clone(), right.clone()]);
                self.facts.compared.push(Compared { line, operator: *operator, sides, words });
                let is_equality = matches!(operator, Operator::Equal | Operator::NotEqual);
                for (words, other) in [(&left, &right), (&right, &left)] {
                    if let Some(text) = other.only().filter(|_| is_equality) {
                        self.compare(line, words, text, false);
                    }
                }
            }
            Kind::Library(function, values) if function.name == "contains" => {
                self.compare_items(line, self.items(&values[0]), &values[1])
            }
            Kind::Script(number, values) => self.give(*number, values),
            Kind::Host(function, values) => {
                let words = values.iter().map(|value| self.words(value)).collect();
                self.facts.calls.push(Call { line, function, arguments: values, words });
            }
            Kind::Function(number) => self.given[usize::from(*number)].fill(Words::unknown()),
            Kind::Chain(chain) => self.chain(chain),
            _ => {}
        }
        node.for_each_child(&mut |child| self.walk(child));
    }

    fn chain(&mut self, chain: &'a Chain) {
        for (index, step) in chain.steps.iter().enumerate() {
            match &step.kind {
                StepKind::Script(number, values) => self.give(*number, values),
                StepKind::Host(function, values) => {
                    let subject = if index == 0 { self.root_words(&chain.root) } else { Words::unknown() };
                    let words = std::iter::once(subject).chain(values.iter().map(|value| self.words(value))).collect();
                    self.facts.calls.push(Call { line: step.line, function, arguments: values, words });
                }
                StepKind::Library(function, values) if function.name == "contains" && index == 0 => {
                    let items = match &chain.root {
                        Root::Constant(number) => self.script.constant_value(*number).map(items_of),
                        Root::Value(node) => self.items(node),
                        Root::Local(_) | Root::This => None,
                    };
                    self.compare_items(step.line, items, &values[0]);
                }
                _ => {}
            }
        }
    }

    fn set(&mut self, slot: u16, words: Words) {
        if !self.assigned.contains(&slot) {
            self.locals[usize::from(slot)] = words;
        }
    }

    /// A function of the script is given these.
    fn give(&mut self, number: u16, values: &[Node]) {
        let words: Vec<Words> = values.iter().map(|value| self.words(value)).collect();
        self.given[usize::from(number)].iter_mut().zip(&words).for_each(|(known, more)| known.add(more));
    }

    fn compare(&mut self, line: u32, words: &Words, text: &Arc<str>, is_item: bool) {
        self.facts.comparisons.push(Comparison { line, words: words.clone(), text: text.clone(), is_item });
    }

    fn compare_items(&mut self, line: u32, items: Option<Words>, with: &Node) {
        let words = self.words(with);
        for text in items.unwrap_or_default().literals {
            self.compare(line, &words, &text, true);
        }
    }

    /// The texts that a value can be.
    fn words(&self, node: &Node) -> Words {
        match &node.kind {
            Kind::Text(text) => Words::literal(text),
            Kind::Local(slot) => self.locals[usize::from(*slot)].clone(),
            Kind::Constant(number) => self.script.constant_value(*number).map_or_else(Words::unknown, words_of),
            Kind::If(parts) => Words::any([self.words(&parts[1]), self.words(&parts[2])]),
            Kind::Block(nodes) if nodes.len() == 1 => self.words(&nodes[0]),
            Kind::Switch(switch) => Words::any(switch.branches.iter().map(|branch| self.words(&branch.body))),
            Kind::Coalesce(nodes) => Words::any(nodes.iter().map(|node| self.words(node))),
            Kind::Binary(Operator::Add, sides) => self.words(&sides[0]).joined(&self.words(&sides[1])),
            Kind::Joined(parts) => {
                let nothing = Words::literal(&"".into());
                parts.iter().fold(nothing, |all, part| all.joined(&self.words(part)))
            }
            Kind::Chain(chain) => self.part_of_constant(chain).unwrap_or_else(Words::unknown),
            _ => Words::unknown(),
        }
    }

    fn root_words(&self, root: &Root) -> Words {
        match root {
            Root::Local(slot) => self.locals[usize::from(*slot)].clone(),
            Root::Constant(number) => self.script.constant_value(*number).map_or_else(Words::unknown, words_of),
            Root::Value(node) => self.words(node),
            Root::This => Words::unknown(),
        }
    }

    /// The texts in an array that stands in the script.
    fn items(&self, node: &Node) -> Option<Words> {
        match &node.kind {
            Kind::List(nodes) => Some(Words::any(nodes.iter().map(|node| self.words(node)))),
            Kind::Constant(number) => self.script.constant_value(*number).map(items_of),
            _ => None,
        }
    }

    /// The texts at the end of a chain that begins at a constant and has known keys.
    fn part_of_constant(&self, chain: &Chain) -> Option<Words> {
        let Root::Constant(number) = chain.root else { return None };
        let mut parts = vec![self.script.constant_value(number)?];
        for step in &chain.steps {
            let keys = match &step.kind {
                StepKind::Property(name) => Words::literal(name),
                StepKind::Index(index) => self.words(index),
                _ => return None,
            };
            if keys.others || !keys.told.is_empty() {
                return None;
            }
            let entry = |part: &&'a Data, key: &Arc<str>| match part {
                Data::Map(entries) => entries.get(key),
                _ => None,
            };
            parts =
                parts.iter().flat_map(|part| keys.literals.iter().filter_map(move |key| entry(part, key))).collect();
        }
        Some(Words::any(parts.into_iter().map(words_of)))
    }
}

/// The text that a constant is.
fn words_of(value: &Data) -> Words {
    match value {
        Data::Text(text) => Words::literal(text),
        _ => Words::unknown(),
    }
}

/// The texts in an array.
fn items_of(value: &Data) -> Words {
    match value {
        Data::List(items) => Words::any(items.iter().map(words_of)),
        _ => Words::unknown(),
    }
}
