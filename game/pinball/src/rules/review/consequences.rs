//! Consequences: which functions of the game an event can come to.
//!
//! What cannot be decided before play is taken both ways: what is not found here cannot happen.

use super::facts::Facts;
use super::known::{Frame, Known};
use super::words::Words;
use crate::rules::script::{Chain, Kind, Node, Pattern, Script, Step, StepKind, Switch};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Calls of the script's own functions with different values that are followed.
const MAX_CALLS: usize = 4096;
/// Calls in each other on the way to the beginning of a game.
const MAX_ROUNDS: usize = 8;

/// What a call of `flippers` that may switch them on is called here.
pub const FLIPPERS_ON: &str = "flippers(true)";

/// What events can come to.
pub struct Consequences<'a> {
    script: &'a Script,
    /// Its calls, with the texts that they can be given.
    facts: &'a Facts<'a>,
    /// The timers that can run at all.
    running: &'a Words,
    /// Blocks that begin a game are left out, but for the timers that they start.
    leaves_beginnings: bool,
    /// In such a block.
    in_beginning: bool,
    /// The functions that begin a game.
    beginners: BTreeSet<u16>,
    /// Functions that are called, with what, and whether where a game begins.
    called: BTreeSet<(u16, Vec<Known>, bool)>,
    waiting: Vec<(u16, Vec<Known>, bool)>,
    /// The functions of the game that can be called.
    calls: BTreeSet<&'static str>,
    /// The timers that can be started.
    pub timers: Words,
}

/// Whether what stands behind a statement comes next.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Flow {
    /// It may.
    Goes,
    /// It never does.
    Ends,
}

impl<'a> Consequences<'a> {
    /// Nothing has happened yet; only these timers can run.
    pub fn new(script: &'a Script, facts: &'a Facts<'a>, running: &'a Words) -> Self {
        Consequences {
            script,
            facts,
            running,
            leaves_beginnings: false,
            in_beginning: false,
            beginners: BTreeSet::new(),
            called: BTreeSet::new(),
            waiting: Vec::new(),
            calls: BTreeSet::new(),
            timers: Words::default(),
        }
    }

    /// The same event, where the script hears it with a name of which this is known.
    pub fn hear(&mut self, function: &str, name: &Known) {
        let found = self.script.functions().zip(0..).find(|(own, _)| own.name == function);
        if let Some((own, number)) = found {
            self.call(number, vec![name.clone(); own.parameters]);
        }
        self.follow();
    }

    /// The same, but what is done where a game begins does not count.
    pub fn hear_in_play(&mut self, function: &str) {
        self.leaves_beginnings = true;
        self.beginners = beginners(self.script);
        self.hear(function, &Known::Nothing);
        self.leaves_beginnings = false;
    }

    /// Every timer that can run ends.
    pub fn hear_timers(&mut self) {
        let running = self.running;
        if running.others || !running.told.is_empty() {
            self.hear("on_timer", &Known::Nothing);
        } else {
            running.literals.iter().for_each(|timer| self.hear("on_timer", &Known::Text(timer.clone())));
        }
    }

    /// Whether one of these can be called; of a script that is too long to be followed everything can.
    pub fn can_call(&self, functions: &[&str]) -> bool {
        self.called.len() >= MAX_CALLS || functions.iter().any(|function| self.calls.contains(function))
    }

    fn call(&mut self, number: u16, values: Vec<Known>) {
        let call = (number, values, self.in_beginning);
        if self.called.len() < MAX_CALLS && self.called.insert(call.clone()) {
            self.waiting.push(call);
        }
    }

    /// Follows the calls that wait.
    fn follow(&mut self) {
        let before = self.in_beginning;
        while let Some((number, values, in_beginning)) = self.waiting.pop() {
            let script = self.script;
            let Some(function) = script.functions().nth(usize::from(number)) else { continue };
            self.in_beginning = in_beginning;
            self.walk(&function.body, &mut Frame::new(function, values));
        }
        self.in_beginning = before;
    }

    fn walk(&mut self, node: &'a Node, frame: &mut Frame) -> Flow {
        match &node.kind {
            Kind::Block(nodes) => return self.block(nodes, frame),
            Kind::If(parts) => return self.choice(parts, frame),
            Kind::Switch(switch) => return self.switch(switch, frame),
            Kind::And(parts) | Kind::Or(parts) => {
                let ends_at = matches!(node.kind, Kind::Or(_));
                for part in parts {
                    self.walk(part, frame);
                    if frame.decided(part, self.script, self.running) == Some(ends_at) {
                        break;
                    }
                }
            }
            Kind::Let(slot, value) => {
                self.walk(value, frame);
                let known = frame.known(value, self.script);
                frame.set(*slot, known);
            }
            Kind::For(parts) => {
                self.walk(&parts.subject, frame);
                [Some(parts.item), parts.count].into_iter().flatten().for_each(|slot| frame.set(slot, Known::Nothing));
                self.walk(&parts.body, frame);
            }
            Kind::Try(parts) => {
                self.walk(&parts.body, frame);
                parts.variable.iter().for_each(|slot| frame.set(*slot, Known::Nothing));
                self.walk(&parts.handler, frame);
            }
            Kind::Return(value) | Kind::Throw(value) | Kind::Break(value) => {
                self.walk(value, frame);
                return Flow::Ends;
            }
            Kind::Continue => return Flow::Ends,
            Kind::Function(number) => self.call(*number, self.unknown(*number)),
            other => {
                node.for_each_child(&mut |child| {
                    self.walk(child, frame);
                });
                self.calls_of(other, frame);
            }
        }
        Flow::Goes
    }

    /// What a node calls itself.
    fn calls_of(&mut self, kind: &'a Kind, frame: &Frame) {
        match kind {
            Kind::Script(number, values) => self.call_with(*number, values, frame),
            Kind::Host(function, values) => self.host(function.name, values, values.get(1), frame),
            Kind::Chain(chain) => self.chain(chain, frame),
            _ => {}
        }
    }

    fn chain(&mut self, chain: &'a Chain, frame: &Frame) {
        for step in &chain.steps {
            match &step.kind {
                StepKind::Script(number, values) => self.call_with(*number, values, frame),
                // What the chain stands at is the first value.
                StepKind::Host(function, values) => self.host(function.name, values, values.first(), frame),
                _ => {}
            }
        }
    }

    fn call_with(&mut self, number: u16, values: &'a [Node], frame: &Frame) {
        let known = values.iter().map(|value| frame.known(value, self.script)).collect();
        self.call(number, known);
    }

    fn unknown(&self, number: u16) -> Vec<Known> {
        let function = self.script.functions().nth(usize::from(number));
        vec![Known::Nothing; function.map_or(0, |function| function.parameters)]
    }

    /// A function of the game is called; its second value is a timer, if it starts one.
    fn host(&mut self, name: &'static str, values: &'a [Node], second: Option<&'a Node>, frame: &Frame) {
        if !self.in_beginning {
            self.calls.insert(name);
            let is_off = matches!(values.first().map(|node| &node.kind), Some(Kind::Bool(false)));
            if name == "flippers" && !is_off {
                self.calls.insert(FLIPPERS_ON);
            }
        }
        if name == "after" {
            let timer = second.map_or(Known::Nothing, |second| frame.known(second, self.script));
            self.timers.add(&match timer {
                Known::Text(text) => Words::literal(&text),
                _ => self.words_of(values),
            });
        }
    }

    /// The texts that the second value of this call can be, wherever it comes from.
    fn words_of(&self, values: &[Node]) -> Words {
        let own = self.facts.calls_of("after").find(|call| std::ptr::eq(call.arguments, values));
        own.and_then(|call| call.words.get(1).cloned()).unwrap_or_else(Words::unknown)
    }

    fn block(&mut self, nodes: &'a [Node], frame: &mut Frame) -> Flow {
        let before = self.in_beginning;
        self.in_beginning |= self.leaves_beginnings && nodes.iter().any(|node| begins(node, &self.beginners));
        let ends = nodes.iter().any(|node| self.walk(node, frame) == Flow::Ends);
        self.in_beginning = before;
        if ends { Flow::Ends } else { Flow::Goes }
    }

    fn choice(&mut self, parts: &'a [Node; 3], frame: &mut Frame) -> Flow {
        self.walk(&parts[0], frame);
        match frame.decided(&parts[0], self.script, self.running) {
            Some(true) => self.walk(&parts[1], frame),
            Some(false) => self.walk(&parts[2], frame),
            None => match [self.walk(&parts[1], frame), self.walk(&parts[2], frame)] {
                [Flow::Ends, Flow::Ends] => Flow::Ends,
                _ => Flow::Goes,
            },
        }
    }

    fn switch(&mut self, switch: &'a Switch, frame: &mut Frame) -> Flow {
        self.walk(&switch.subject, frame);
        let subject = frame.known(&switch.subject, self.script);
        for case in &switch.cases {
            let fits = match &case.pattern {
                Pattern::Any => Some(true),
                Pattern::Value(value) => subject.is(value),
                Pattern::Range(_) if subject == Known::Nothing => None,
                Pattern::Range(_) => Some(false),
            };
            let branch = &switch.branches[case.branch];
            if fits == Some(false) {
                continue;
            }
            let condition = branch.condition.as_ref().map_or(Some(true), |condition| {
                self.walk(condition, frame);
                frame.decided(condition, self.script, self.running)
            });
            if condition == Some(false) {
                continue;
            }
            let flow = self.walk(&branch.body, frame);
            if fits == Some(true) && condition == Some(true) && matches!(subject, Known::Text(_)) {
                return flow;
            }
        }
        Flow::Goes
    }
}

/// The functions that begin a game whatever their conditions are.
fn beginners(script: &Script) -> BTreeSet<u16> {
    let mut found = BTreeSet::new();
    for _ in 0..MAX_ROUNDS {
        let own = script.functions().zip(0..).filter(|(function, _)| begins(&function.body, &found));
        let more: BTreeSet<u16> = own.map(|(_, number)| number).collect();
        if more == found {
            break;
        }
        found = more;
    }
    found
}

/// Whether a statement begins a game whatever its conditions are, where these functions do.
fn begins(node: &Node, beginners: &BTreeSet<u16>) -> bool {
    match &node.kind {
        Kind::Host(function, _) => function.name == "start_game",
        Kind::Script(number, _) => beginners.contains(number),
        Kind::Block(nodes) => nodes.iter().any(|node| begins(node, beginners)),
        Kind::Let(_, value) | Kind::Return(value) => begins(value, beginners),
        Kind::Chain(chain) => {
            let calls = |step: &Step| matches!(step.kind, StepKind::Script(number, _) if beginners.contains(&number));
            chain.steps.iter().any(calls)
        }
        _ => false,
    }
}

/// The text of an event.
pub fn text(name: &str) -> Known {
    Known::Text(Arc::from(name))
}
