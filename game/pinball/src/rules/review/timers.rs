//! Timers that a script starts and nothing hears, and those that it stops or asks about and nothing starts.

use super::facts::{Call, Facts};
use super::remark::{Remark, line_of};
use super::words::{Told, Words};
use crate::rules::script::{Function, Kind, Node, Operator, Pattern, Root, Script, Switch};
use crate::spelling;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What is said of timers; `told` are those of [`silent`] that another remark names.
pub fn remarks(facts: &Facts, script: &Script, text: &str, told: &[Silent]) -> Vec<Remark> {
    let started = facts.given("after", 1);
    let unstarted = unstarted(facts, &started);
    let vain = unstarted.iter().map(|(call, timer)| vain(call, timer, &started, text));
    let hears = script.functions().any(|function| function.name == "on_timer");
    let what = if hears { "`on_timer` does nothing for it" } else { "there is no `on_timer(name)`" };
    let silent = silent(facts, script, text).into_iter().filter(|one| !told.contains(one));
    vain.chain(silent.map(|Silent { timer, line }| {
        Remark::warning(line, format!("the timer \"{timer}\" is started for nothing: {what}"))
    }))
    .collect()
}

/// A timer that no rule does anything for and nobody asks about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Silent {
    pub timer: Arc<str>,
    /// Where it is first started.
    pub line: usize,
}

/// The timers that are started for nothing, each once.
pub fn silent(facts: &Facts, script: &Script, text: &str) -> Vec<Silent> {
    let asked = [facts.given("running", 0), facts.given("time_left", 0)];
    let is_asked = |timer: &str| asked.iter().any(|words| words.others || words.literals.contains(timer));
    let hears = script.functions().find(|function| function.name == "on_timer");
    let started = facts.given("after", 1);
    // A timer that `on_timer` looks for and nothing starts is told as such, with this one beside it.
    let sought = facts.comparisons.iter().filter(|one| one.words.told.contains(&Told::Timer));
    let mut sought: Vec<&str> = sought.map(|one| &*one.text).filter(|text| !started.literals.contains(*text)).collect();
    let unstarted = unstarted(facts, &started);
    sought.extend(unstarted.iter().map(|(_, timer)| &***timer));
    let mut found: BTreeMap<&Arc<str>, usize> = BTreeMap::new();
    for call in facts.calls_of("after") {
        let Some(words) = call.words.get(1) else { continue };
        let silent =
            words.literals.iter().filter(|timer| !is_asked(timer) && !hears.is_some_and(|one| does(one, timer)));
        for timer in silent.filter(|timer| spelling::near(timer, sought.iter().copied()).is_none()) {
            let line = line_of(timer, text, call.line);
            found.entry(timer).and_modify(|first| *first = line.min(*first)).or_insert(line);
        }
    }
    found.into_iter().map(|(timer, line)| Silent { timer: timer.clone(), line }).collect()
}

/// The calls that stop a timer or ask about one which nothing starts, each with that timer.
fn unstarted<'a>(facts: &'a Facts, started: &Words) -> Vec<(&'a Call<'a>, &'a Arc<str>)> {
    // Of a timer whose name cannot be followed any may be started.
    if started.others || !started.told.is_empty() {
        return Vec::new();
    }
    let calls = ["cancel", "running", "time_left"].into_iter().flat_map(|function| facts.calls_of(function));
    let named = calls.flat_map(|call| {
        call.words.first().into_iter().flat_map(move |words| words.literals.iter().map(move |timer| (call, timer)))
    });
    named.filter(|(_, timer)| !started.literals.contains(*timer)).collect()
}

/// What to say of such a call.
fn vain(call: &Call, timer: &str, started: &Words, text: &str) -> Remark {
    let so = match call.function.name {
        "cancel" => "stops nothing",
        "running" => "is always false",
        _ => "is always 0",
    };
    let meant = spelling::near(timer, started.literals.iter().map(|word| &**word));
    let meant = meant.map_or_else(String::new, |meant| format!("; did you mean \"{meant}\"?"));
    let function = call.function.name;
    let what = format!("`{function}(\"{timer}\")` {so}: nothing starts that timer with `after`{meant}");
    Remark::warning(line_of(timer, text, call.line), what)
}

/// What comes of a statement for one timer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    /// Nothing, and what stands behind it comes next.
    Nothing,
    /// Nothing, and nothing stands behind it.
    Ends,
    /// It may do something.
    Does,
}

/// Whether `on_timer` may do something for this timer.
fn does(on_timer: &Function, timer: &Arc<str>) -> bool {
    on_timer.parameters == 1 && outcome(&on_timer.body, timer) == Outcome::Does
}

fn outcome(node: &Node, timer: &Arc<str>) -> Outcome {
    match &node.kind {
        Kind::Unit => Outcome::Nothing,
        Kind::Let(_, value) if value.is_plain() => Outcome::Nothing,
        Kind::Return(value) if value.is_plain() => Outcome::Ends,
        Kind::Block(nodes) => {
            let outcomes = nodes.iter().map(|node| outcome(node, timer));
            outcomes.into_iter().find(|one| *one != Outcome::Nothing).unwrap_or(Outcome::Nothing)
        }
        Kind::If(parts) => match decided(&parts[0], timer) {
            Some(true) => outcome(&parts[1], timer),
            Some(false) => outcome(&parts[2], timer),
            None => either([outcome(&parts[1], timer), outcome(&parts[2], timer)]),
        },
        Kind::Switch(switch) if is_timer(&switch.subject) => chosen(switch, timer),
        Kind::Switch(switch) => either(switch.branches.iter().map(|branch| outcome(&branch.body, timer))),
        _ => Outcome::Does,
    }
}

/// What one of several may do.
fn either(outcomes: impl IntoIterator<Item = Outcome>) -> Outcome {
    if outcomes.into_iter().any(|one| one == Outcome::Does) { Outcome::Does } else { Outcome::Nothing }
}

/// What a switch over the timer does for this one.
fn chosen(switch: &Switch, timer: &Arc<str>) -> Outcome {
    for case in &switch.cases {
        let fits = match &case.pattern {
            Pattern::Any => true,
            Pattern::Value(value) => value.is_text(timer),
            Pattern::Range(_) => false,
        };
        let branch = &switch.branches[case.branch];
        match outcome(&branch.body, timer) {
            Outcome::Does if fits => return Outcome::Does,
            other if fits && branch.condition.is_none() => return other,
            _ => {}
        }
    }
    Outcome::Nothing
}

/// What a condition about the timer's name is for this one, if it is about nothing else.
fn decided(condition: &Node, timer: &Arc<str>) -> Option<bool> {
    match &condition.kind {
        Kind::Not(other) => Some(!decided(other, timer)?),
        Kind::Binary(operator @ (Operator::Equal | Operator::NotEqual), sides) => {
            let text = match (&sides[0].kind, &sides[1].kind) {
                (_, Kind::Text(text)) if is_timer(&sides[0]) => text,
                (Kind::Text(text), _) if is_timer(&sides[1]) => text,
                _ => return None,
            };
            Some((text == timer) == (*operator == Operator::Equal))
        }
        Kind::And(parts) => parts.iter().any(|part| decided(part, timer) == Some(false)).then_some(false),
        Kind::Or(parts) => {
            let parts: Option<Vec<bool>> = parts.iter().map(|part| decided(part, timer)).collect();
            parts.map(|parts| parts.contains(&true))
        }
        _ => None,
    }
}

/// Whether this is the name that `on_timer` is told: its first variable.
fn is_timer(node: &Node) -> bool {
    match &node.kind {
        Kind::Local(0) => true,
        Kind::Chain(chain) => chain.steps.is_empty() && matches!(chain.root, Root::Local(0)),
        _ => false,
    }
}
