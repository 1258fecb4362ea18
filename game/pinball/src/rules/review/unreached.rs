//! Unreached: cases and conditions that another before them has taken, and conditions that contradict themselves.

use super::literal::{literal, same, shown};
use super::remark::{Remark, line_of};
use crate::rules::script::{Chain, Data, Kind, Node, Operator, Pattern, Root, Script, StepKind, Switch};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What is compared: a variable, or an entry of `this` by its path.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    Local(u16),
    This(Vec<Arc<str>>),
}

/// Something compared with a value that stands in the script.
struct Comparison {
    place: Place,
    value: Data,
}

/// What is never reached, and what is never or always true.
pub fn remarks(script: &Script, rules: &str) -> Vec<Remark> {
    let mut look = Look { script, rules, found: Vec::new() };
    script.functions().for_each(|function| look.look(&function.body, true));
    look.found
}

struct Look<'a> {
    script: &'a Script,
    rules: &'a str,
    found: Vec<Remark>,
}

impl Look<'_> {
    /// Looks at a node; `is_first` if it is no `else if`, which is looked at with its `if`.
    fn look(&mut self, node: &Node, is_first: bool) {
        match &node.kind {
            Kind::Switch(switch) => self.switch(switch),
            Kind::If(parts) => {
                if is_first {
                    self.conditions(node);
                }
                self.look(&parts[0], true);
                self.look(&parts[1], true);
                match next_if(&parts[2]) {
                    Some(next) => self.look(next, false),
                    None => self.look(&parts[2], true),
                }
                return;
            }
            Kind::And(parts) => self.contradiction(node.line, parts, Operator::Equal),
            Kind::Or(parts) => self.contradiction(node.line, parts, Operator::NotEqual),
            _ => {}
        }
        node.for_each_child(&mut |child| self.look(child, true));
    }

    fn switch(&mut self, switch: &Switch) {
        let mut taken: BTreeSet<String> = BTreeSet::new();
        for case in &switch.cases {
            let Pattern::Value(value) = &case.pattern else { continue };
            let branch = &switch.branches[case.branch];
            if taken.contains(&shown(value)) {
                let line = match value {
                    Data::Text(text) => line_of(text, self.rules, branch.body.line),
                    _ => branch.body.line as usize,
                };
                let what = format!(
                    "this case is never reached: {} has a case before it; take one of them away, or join them",
                    shown(value)
                );
                self.found.push(Remark::error(line, what));
            } else if branch.condition.is_none() {
                taken.insert(shown(value));
            }
        }
    }

    /// The conditions of an `if` and of all that follow with `else if`.
    fn conditions(&mut self, first: &Node) {
        let mut taken: Vec<(Comparison, u32)> = Vec::new();
        let mut next = Some(first);
        while let Some(Node { line, kind: Kind::If(parts) }) = next {
            let condition = &parts[0];
            // What a function changes may be something else than it was in the condition before.
            if !is_still(condition) {
                taken.retain(|(one, _)| matches!(one.place, Place::Local(_)));
            }
            let is_taken = |one: &Comparison| {
                taken.iter().find(|(other, _)| other.place == one.place && same(&other.value, &one.value))
            };
            let again = requirements(condition).into_iter().find_map(|part| {
                let alternatives = self.alternatives(part)?;
                let all: Option<Vec<_>> = alternatives.iter().map(is_taken).collect();
                all.and_then(|all| all.first().map(|(one, line)| (shown(&one.value), *line)))
            });
            if let Some((value, before)) = again {
                let what = format!(
                    "this `else if` is never true: the condition on line {before} has already taken {value}; take one of them \
                     away, or join them"
                );
                self.found.push(Remark::error(condition.line.max(*line) as usize, what));
            }
            taken.extend(self.alternatives(condition).unwrap_or_default().into_iter().map(|one| (one, condition.line)));
            next = next_if(&parts[2]);
        }
    }

    /// The comparisons of which a condition is true if one is, if it has nothing else.
    fn alternatives(&self, node: &Node) -> Option<Vec<Comparison>> {
        match &node.kind {
            Kind::Or(parts) => {
                let parts: Option<Vec<Vec<Comparison>>> = parts.iter().map(|part| self.alternatives(part)).collect();
                parts.map(|parts| parts.into_iter().flatten().collect())
            }
            _ => self.comparison(node, Operator::Equal).map(|one| vec![one]),
        }
    }

    fn comparison(&self, node: &Node, wanted: Operator) -> Option<Comparison> {
        let Kind::Binary(operator, sides) = &node.kind else { return None };
        if *operator != wanted {
            return None;
        }
        let [left, right] = &**sides;
        let value = |node: &Node| literal(node, self.script);
        let pair = place(left).zip(value(right)).or_else(|| place(right).zip(value(left)));
        pair.map(|(place, value)| Comparison { place, value })
    }

    /// `a == 1 && a == 2` is never true, `a != 1 || a != 2` always.
    fn contradiction(&mut self, line: u32, parts: &[Node], operator: Operator) {
        let mut known: BTreeMap<Place, Data> = BTreeMap::new();
        for part in parts {
            if !is_still(part) {
                return;
            }
            let Some(Comparison { place, value }) = self.comparison(part, operator) else { continue };
            let Some(other) = known.get(&place) else {
                known.insert(place, value);
                continue;
            };
            // What is no number may be one: `1 == "1"` is false, and so are both.
            if same(other, &value) {
                continue;
            }
            let (one, two) = (shown(other), shown(&value));
            let what = match operator {
                Operator::Equal => {
                    format!("this is never true: nothing is {one} and {two} at once; write `||` for `&&`")
                }
                _ => format!("this is always true: whatever is {one} is not {two}; write `&&` for `||`"),
            };
            self.found.push(Remark::error(part.line.max(line) as usize, what));
            return;
        }
    }
}

/// The `if` that an `else` consists of.
fn next_if(other: &Node) -> Option<&Node> {
    match &other.kind {
        Kind::If(_) => Some(other),
        Kind::Block(nodes) => match nodes.as_slice() {
            [only @ Node { kind: Kind::If(_), .. }] => Some(only),
            _ => None,
        },
        _ => None,
    }
}

/// What must all be true for a condition to be.
fn requirements(condition: &Node) -> Vec<&Node> {
    match &condition.kind {
        Kind::And(parts) => parts.iter().collect(),
        _ => vec![condition],
    }
}

fn place(node: &Node) -> Option<Place> {
    match &node.kind {
        Kind::Local(slot) => Some(Place::Local(*slot)),
        Kind::Chain(chain) => this_place(chain),
        _ => None,
    }
}

fn this_place(chain: &Chain) -> Option<Place> {
    let Root::This = chain.root else { return None };
    let name = |kind: &StepKind| match kind {
        StepKind::Property(name) => Some(name.clone()),
        _ => None,
    };
    chain.steps.iter().map(|step| name(&step.kind)).collect::<Option<Vec<_>>>().map(Place::This)
}

/// Whether looking at it changes nothing: no function is called.
pub fn is_still(node: &Node) -> bool {
    let own = match &node.kind {
        Kind::Script(..) | Kind::Host(..) | Kind::Assign(_) => false,
        Kind::Chain(chain) => {
            chain.steps.iter().all(|step| matches!(step.kind, StepKind::Property(_) | StepKind::Index(_)))
        }
        _ => true,
    };
    let mut all = own;
    node.for_each_child(&mut |child| all &= is_still(child));
    all
}
