//! Evaluates nodes: each takes a step, and each value that is copied on the way takes its own.

use super::data::{Data, Entries};
use super::meter::{self, Meter};
use super::node::{Assign, Chain, For, Kind, Node, Pattern, Root, Switch, Try};
use super::operators;
use super::stop::{Answer, FailureKind, Stop, fail};
use super::{Script, text, told};
use crate::rules::host_function::{HostFunction, ScriptContext};

/// Deepest nesting of calls.
pub const MAX_CALLS: usize = 24;

/// What runs a script's nodes.
pub struct Interpreter<'a> {
    /// The script.
    pub script: &'a Script,
    /// The steps that are left.
    pub meter: &'a mut Meter,
    /// What the game's functions work on; nothing while the script is read.
    pub context: Option<&'a mut ScriptContext>,
    /// Calls that are open.
    pub calls: usize,
}

/// The variables of one call.
pub struct Frame<'a> {
    /// By number.
    pub locals: Vec<Data>,
    /// What the call is for.
    pub this: Option<&'a mut Data>,
}

impl Frame<'_> {
    /// A frame with room for so many variables, without `this`.
    pub fn new(locals: usize) -> Frame<'static> {
        let locals = std::iter::repeat_with(Data::default).take(locals).collect();
        Frame { locals, this: None }
    }
}

impl Interpreter<'_> {
    /// The value of a node.
    ///
    /// # Errors
    /// Why it has none.
    pub fn eval(&mut self, node: &Node, frame: &mut Frame) -> Answer {
        self.meter.charge(1).map_err(|stop| stop.at(node.line))?;
        self.eval_kind(node, frame).map_err(|stop| told::with_unset(stop.at(node.line), node, frame))
    }

    fn eval_kind(&mut self, node: &Node, frame: &mut Frame) -> Answer {
        match &node.kind {
            Kind::Unit => Ok(Data::Unit),
            Kind::Bool(flag) => Ok(Data::Bool(*flag)),
            Kind::Int(number) => Ok(Data::Int(*number)),
            Kind::Text(text) => Ok(Data::Text(text.clone())),
            Kind::Function(number) => Ok(Data::Function(*number)),
            Kind::Local(slot) => frame.locals[usize::from(*slot)].copy(self.meter),
            Kind::Constant(number) => self.script.constant(*number)?.copy(self.meter),
            Kind::This => this(frame)?.copy(self.meter),
            Kind::Chain(chain) => self.chain(chain, frame),
            Kind::Joined(parts) => self.joined(parts, frame),
            Kind::List(items) => self.list(items, frame),
            Kind::Map(entries) => self.map(entries, frame),
            Kind::Binary(operator, sides) => {
                let left = self.eval(&sides[0], frame)?;
                let right = self.eval(&sides[1], frame)?;
                operators::apply(*operator, left, right, self.meter)
            }
            Kind::Not(value) => Ok(Data::Bool(!self.eval(value, frame)?.condition()?)),
            Kind::Negative(value) => operators::negative(&self.eval(value, frame)?),
            Kind::And(_) | Kind::Or(_) | Kind::Coalesce(_) => self.until_decided(&node.kind, frame),
            Kind::Script(number, arguments) => {
                let arguments = self.values(arguments, frame)?;
                self.call(*number, arguments, None)
            }
            Kind::Library(function, arguments) => {
                let mut arguments = self.values(arguments, frame)?;
                let mut subject = arguments.remove(0);
                function.call(self, &mut subject, arguments)
            }
            Kind::Host(function, arguments) => {
                let arguments = self.values(arguments, frame)?;
                self.call_host(function, &arguments)
            }
            _ => self.statement(node, frame),
        }
    }

    fn statement(&mut self, node: &Node, frame: &mut Frame) -> Answer {
        match &node.kind {
            Kind::Block(nodes) => self.block(nodes, frame),
            Kind::If(parts) => {
                let chosen = if self.eval(&parts[0], frame)?.condition()? { &parts[1] } else { &parts[2] };
                self.eval(chosen, frame)
            }
            Kind::Switch(switch) => self.switch(switch, frame),
            Kind::While(parts) => self.repeat(Some((&parts[0], true)), None, &parts[1], frame),
            Kind::Do(parts, go_on) => self.repeat(None, Some((&parts[1], *go_on)), &parts[0], frame),
            Kind::For(parts) => self.go_through(parts, frame),
            Kind::Let(slot, value) => {
                frame.locals[usize::from(*slot)] = self.eval(value, frame)?;
                Ok(Data::Unit)
            }
            Kind::Assign(assign) => self.assign(assign, frame),
            Kind::Return(value) => Err(Stop::Return(self.eval(value, frame)?)),
            Kind::Throw(value) => Err(Stop::thrown(self.eval(value, frame)?)),
            Kind::Break(value) => Err(Stop::Break(self.eval(value, frame)?)),
            Kind::Continue => Err(Stop::Continue),
            Kind::Try(parts) => self.attempt(parts, frame),
            _ => Ok(Data::Unit),
        }
    }

    /// The values of several nodes, in order.
    pub fn values(&mut self, nodes: &[Node], frame: &mut Frame) -> Result<Vec<Data>, Stop> {
        nodes.iter().map(|node| self.eval(node, frame)).collect()
    }

    /// The value of the last one.
    fn block(&mut self, nodes: &[Node], frame: &mut Frame) -> Answer {
        let mut value = Data::Unit;
        for node in nodes {
            value = self.eval(node, frame)?;
        }
        Ok(value)
    }

    fn joined(&mut self, parts: &[Node], frame: &mut Frame) -> Answer {
        let mut joined = String::new();
        for part in parts {
            let value = self.eval(part, frame)?;
            text::write(&value, &mut joined, self.meter)?;
        }
        self.meter.bytes(joined.len())?;
        Ok(Data::text(joined))
    }

    fn list(&mut self, items: &[Node], frame: &mut Frame) -> Answer {
        meter::check_items(items.len())?;
        let items = Data::List(self.values(items, frame)?);
        items.check_depth(self.meter)?;
        Ok(items)
    }

    fn map(&mut self, entries: &[(std::sync::Arc<str>, Node)], frame: &mut Frame) -> Answer {
        meter::check_items(entries.len())?;
        let mut map = Entries::new();
        for (key, value) in entries {
            let value = self.eval(value, frame)?;
            self.meter.bytes(key.len())?;
            map.insert(key.clone(), value);
        }
        let map = Data::Map(map);
        map.check_depth(self.meter)?;
        Ok(map)
    }

    /// `&&`, `||`, `??`: no further than needed.
    fn until_decided(&mut self, kind: &Kind, frame: &mut Frame) -> Answer {
        let (Kind::And(nodes) | Kind::Or(nodes) | Kind::Coalesce(nodes)) = kind else { return Ok(Data::Unit) };
        for node in nodes {
            let value = self.eval(node, frame)?;
            match kind {
                Kind::Coalesce(_) if matches!(value, Data::Unit) => {}
                Kind::Coalesce(_) => return Ok(value),
                kind => {
                    let decides = matches!(kind, Kind::Or(_));
                    if value.condition().map_err(|stop| stop.at(node.line))? == decides {
                        return Ok(Data::Bool(decides));
                    }
                }
            }
        }
        Ok(match kind {
            Kind::And(_) => Data::Bool(true),
            Kind::Or(_) => Data::Bool(false),
            _ => Data::Unit,
        })
    }

    fn switch(&mut self, switch: &Switch, frame: &mut Frame) -> Answer {
        let subject = self.eval(&switch.subject, frame)?;
        for case in &switch.cases {
            let branch = &switch.branches[case.branch];
            if self.fits(&case.pattern, branch.condition.as_ref(), &subject, frame)? {
                return self.eval(&branch.body, frame);
            }
        }
        Ok(Data::Unit)
    }

    fn fits(
        &mut self,
        pattern: &Pattern,
        condition: Option<&Node>,
        subject: &Data,
        frame: &mut Frame,
    ) -> Result<bool, Stop> {
        self.meter.charge(1)?;
        let fits = match (pattern, subject) {
            (Pattern::Any, _) => true,
            (Pattern::Value(value), subject) => value.same(subject, self.meter)?,
            (Pattern::Range(range), Data::Int(number)) => range.contains(*number),
            (Pattern::Range(_), _) => false,
        };
        match condition {
            Some(condition) if fits => self.eval(condition, frame)?.condition(),
            _ => Ok(fits),
        }
    }

    /// `loop`, `while` and `do`: conditions before and after the body, and what they must be to go on.
    fn repeat(
        &mut self,
        before: Option<(&Node, bool)>,
        after: Option<(&Node, bool)>,
        body: &Node,
        frame: &mut Frame,
    ) -> Answer {
        loop {
            if let Some((condition, go_on)) = before
                && self.eval(condition, frame)?.condition()? != go_on
            {
                return Ok(Data::Unit);
            }
            match self.eval(body, frame) {
                Ok(_) | Err(Stop::Continue) => {}
                Err(Stop::Break(value)) => return Ok(value),
                Err(stop) => return Err(stop),
            }
            if let Some((condition, go_on)) = after
                && self.eval(condition, frame)?.condition()? != go_on
            {
                return Ok(Data::Unit);
            }
        }
    }

    fn go_through(&mut self, parts: &For, frame: &mut Frame) -> Answer {
        match self.eval(&parts.subject, frame)? {
            Data::List(items) => self.each(parts, items.into_iter(), frame),
            Data::Range(range) => self.each(parts, range.map(Data::Int), frame),
            Data::Text(whole) => self.each(parts, text::letters(&whole), frame),
            other => Err(fail(format!("`for` goes through a list, a text or a range, not a {}", other.type_name()))),
        }
    }

    fn each(&mut self, parts: &For, items: impl Iterator<Item = Data>, frame: &mut Frame) -> Answer {
        for (index, item) in items.enumerate() {
            self.meter.charge(1)?;
            frame.locals[usize::from(parts.item)] = item;
            if let Some(count) = parts.count {
                frame.locals[usize::from(count)] = Data::count(index);
            }
            match self.eval(&parts.body, frame) {
                Ok(_) | Err(Stop::Continue) => {}
                Err(Stop::Break(value)) => return Ok(value),
                Err(stop) => return Err(stop),
            }
        }
        Ok(Data::Unit)
    }

    fn assign(&mut self, assign: &Assign, frame: &mut Frame) -> Answer {
        let value = self.eval(&assign.value, frame)?;
        let keys = self.keys(&assign.place.steps, frame)?;
        let place = match &assign.place.root {
            Root::Local(slot) => &mut frame.locals[usize::from(*slot)],
            Root::This => this(frame)?,
            Root::Constant(_) | Root::Value(_) => return Err(fail("only a variable or a part of one can be changed")),
        };
        let place = super::place::follow(place, &keys, self.meter)?;
        match assign.operator {
            None => *place = value,
            Some(operator) => operators::assign(operator, place, value, self.meter)?,
        }
        Ok(Data::Unit)
    }

    fn attempt(&mut self, parts: &Try, frame: &mut Frame) -> Answer {
        let answer = match self.eval(&parts.body, frame) {
            Err(Stop::Failed(failed)) if matches!(failed.kind, FailureKind::Catchable | FailureKind::Thrown) => {
                if let Some(slot) = parts.variable {
                    frame.locals[usize::from(slot)] = failed.what;
                }
                self.eval(&parts.handler, frame)
            }
            answer => answer,
        };
        // Whichever of the two it was: its value is nothing.
        answer.map(|_| Data::Unit)
    }

    /// Calls a function of the script.
    ///
    /// # Errors
    /// Why it has no value.
    pub fn call(&mut self, number: u16, arguments: Vec<Data>, this: Option<&mut Data>) -> Answer {
        let script = self.script;
        let function = script.function(number);
        if function.parameters != arguments.len() {
            return Err(fail(format!("this function takes {} values, not {}", function.parameters, arguments.len())));
        }
        if self.calls == MAX_CALLS {
            return Err(Stop::last(&format!("stack overflow: calls are nested more than {MAX_CALLS} deep")));
        }
        self.meter.values(function.locals)?;
        let mut frame = Frame { locals: arguments, this };
        frame.locals.resize_with(function.locals, Data::default);
        self.calls += 1;
        let answer = self.eval(&function.body, &mut frame);
        self.calls -= 1;
        match answer {
            Err(Stop::Return(value)) => Ok(value),
            Err(Stop::Break(_) | Stop::Continue) => Err(fail("there is no loop to leave here")),
            answer => answer,
        }
    }

    /// Calls a function of the game.
    ///
    /// # Errors
    /// A sentence.
    pub fn call_host(&mut self, function: &HostFunction, arguments: &[Data]) -> Answer {
        let Some(context) = self.context.as_deref_mut() else {
            return Err(fail("this can only be called when something has happened, not while the script is read"));
        };
        self.meter.charge(function.steps(context, arguments))?;
        let answer = function.call(context, arguments);
        if answer.is_err() {
            self.meter.charge(context.failure_steps())?;
        }
        answer.map_err(fail)
    }

    /// The value at the end of a chain.
    fn chain(&mut self, chain: &Chain, frame: &mut Frame) -> Answer {
        let given = self.given(&chain.steps, frame)?;
        match &chain.root {
            Root::Local(slot) => self.follow(&mut frame.locals[usize::from(*slot)], &chain.steps, given),
            Root::This => self.follow(this(frame)?, &chain.steps, given),
            Root::Constant(number) => self.follow_constant(self.script.constant(*number)?, &chain.steps, given),
            Root::Value(node) => {
                let value = self.eval(node, frame)?;
                self.follow_value(value, &chain.steps, given)
            }
        }
    }
}

/// `this`, where there is one.
fn this<'a>(frame: &'a mut Frame) -> Result<&'a mut Data, Stop> {
    let missing = "`this` is not known here: call the function as `this.name(...)`";
    frame.this.as_deref_mut().ok_or_else(|| fail(missing))
}
