//! What a script remembers: entries of `this` that it reads and never sets.

use super::remark::Remark;
use crate::rules::script::{Chain, Kind, Node, Operator, Root, Script, Step, StepKind};
use crate::spelling;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What is read of `this` and what is set, in one function or in all.
#[derive(Default)]
struct Use {
    /// Names and the lines where they are read.
    read: BTreeMap<Arc<str>, u32>,
    set: BTreeSet<Arc<str>>,
    /// Entries are set whose names are not known before play.
    sets_others: bool,
    /// Functions that are called with the same `this`.
    calls: Vec<u16>,
    /// Functions that are called with another one.
    calls_on_others: Vec<u16>,
}

/// The functions whose `this` may be something else than what the script remembers; nothing where entries are set whose
/// names are not known before play.
pub fn foreign_functions(script: &Script) -> Option<BTreeSet<u16>> {
    uses(script).map(|uses| foreign(&uses))
}

fn uses(script: &Script) -> Option<Vec<Use>> {
    let uses: Vec<Use> = script.functions().map(|function| Use::of(&function.body)).collect();
    (!uses.iter().any(|one| one.sets_others)).then_some(uses)
}

/// The entries of `this` that are read and never set.
pub fn remarks(script: &Script) -> Vec<Remark> {
    let Some(uses) = uses(script) else { return Vec::new() };
    let foreign = foreign(&uses);
    let set: BTreeSet<&Arc<str>> = uses.iter().flat_map(|one| &one.set).collect();
    let own = uses.iter().zip(0..).filter(|(_, number)| !foreign.contains(number));
    let mut unset: BTreeMap<&Arc<str>, Vec<u32>> = BTreeMap::new();
    for (name, line) in own.flat_map(|(one, _)| &one.read).filter(|(name, _)| !set.contains(name)) {
        unset.entry(name).or_default().push(*line);
    }
    let told = unset.into_iter().map(|(name, mut lines)| {
        lines.sort_unstable();
        let (first, more) = (lines[0], &lines[1..]);
        let more: Vec<String> = more.iter().filter(|line| **line != first).map(u32::to_string).collect();
        let also = match more.len() {
            0 => String::new(),
            1 => format!(" (and in line {})", more[0]),
            _ => format!(" (and in lines {})", more.join(", ")),
        };
        let meant = spelling::near(name, set.iter().map(|name| &***name));
        let meant = meant.map_or_else(String::new, |meant| format!("; did you mean this.{meant}?"));
        Remark::warning(first as usize, format!("this.{name} is read here{also}, and no rule ever sets it{meant}"))
    });
    told.collect()
}

/// The functions whose `this` may be something else than what the script remembers.
fn foreign(uses: &[Use]) -> BTreeSet<u16> {
    let mut found: BTreeSet<u16> = uses.iter().flat_map(|one| one.calls_on_others.iter().copied()).collect();
    let mut left: Vec<u16> = found.iter().copied().collect();
    while let Some(number) = left.pop() {
        left.extend(uses[usize::from(number)].calls.iter().copied().filter(|called| found.insert(*called)));
    }
    found
}

impl Use {
    fn of(body: &Node) -> Use {
        let mut found = Use::default();
        found.look(body);
        found
    }

    fn look(&mut self, node: &Node) {
        match &node.kind {
            Kind::Chain(chain) => self.chain(chain),
            Kind::Assign(assign) => self.assign(&assign.place, assign.operator.is_none()),
            Kind::Function(number) => self.calls_on_others.push(*number),
            Kind::Binary(Operator::Equal | Operator::NotEqual, sides)
                if sides.iter().any(|side| matches!(side.kind, Kind::Unit)) =>
            {
                return; // whether it is set is what is asked
            }
            Kind::Coalesce(_) => return,
            Kind::Library(function, _) if function.name == "type_of" => return,
            _ => {}
        }
        node.for_each_child(&mut |child| self.look(child));
    }

    fn chain(&mut self, chain: &Chain) {
        let is_this = matches!(chain.root, Root::This);
        for (index, step) in chain.steps.iter().enumerate() {
            if let StepKind::Script(number, _) = step.kind {
                let calls = if is_this && index == 0 { &mut self.calls } else { &mut self.calls_on_others };
                calls.push(number);
            }
        }
        match chain.steps.first() {
            Some(Step { kind: StepKind::Property(name), line, stops_at_unit: false }) if is_this && !asks(chain) => {
                self.read.entry(name.clone()).or_insert(*line);
            }
            Some(Step { kind: StepKind::Library(function, _), .. }) if is_this => {
                self.sets_others |= function.changes()
            }
            _ => {}
        }
    }

    fn assign(&mut self, place: &Chain, replaces: bool) {
        if !matches!(place.root, Root::This) {
            return;
        }
        match place.steps.as_slice() {
            [Step { kind: StepKind::Property(name), .. }] if replaces => {
                self.set.insert(name.clone());
            }
            [Step { kind: StepKind::Property(name), line, .. }, ..] => {
                self.read.entry(name.clone()).or_insert(*line);
            }
            [Step { kind: StepKind::Index(index), .. }, rest @ ..] => match &index.kind {
                Kind::Text(name) if rest.is_empty() && replaces => {
                    self.set.insert(name.clone());
                }
                Kind::Text(_) => {}
                _ => self.sets_others = true,
            },
            _ => self.sets_others = true,
        }
    }
}

/// Whether the chain asks what something is, or stops where nothing is.
fn asks(chain: &Chain) -> bool {
    chain.steps.iter().skip(1).take(1).any(|step| {
        step.stops_at_unit || matches!(&step.kind, StepKind::Library(function, _) if function.name == "type_of")
    })
}
