//! Reads expressions: literals, operators, calls and chains.

use super::foreign;
use super::node::{Chain, Kind, Node, Operator, Root, Step, StepKind};
use super::operators;
use super::read::{Reader, Reading, line, mistake, node, unknown_operator};
use crate::rules::{host, signatures};
use crate::spelling;
use rhai::{ASTFlags, Expr, FnCallExpr, FnPtr, Position};

/// Longest chain.
const MAX_STEPS: usize = 16;

impl Reader<'_> {
    /// Reads an expression.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn expression(&mut self, expression: &Expr) -> Reading<Node> {
        let position = expression.start_position();
        let kind = match expression {
            Expr::Unit(_) => Kind::Unit,
            Expr::BoolConstant(flag, _) => Kind::Bool(*flag),
            Expr::IntegerConstant(number, _) => Kind::Int(*number),
            Expr::CharConstant(letter, _) => Kind::Text(letter.to_string().into()),
            Expr::StringConstant(text, _) => Kind::Text(text.as_str().into()),
            Expr::DynamicConstant(value, _) => {
                let function = (**value).clone().try_cast::<FnPtr>();
                let number = function.and_then(|function| self.anonymous(function.fn_name()));
                Kind::Function(number.ok_or_else(|| mistake(position, "rules have no such value"))?)
            }
            Expr::InterpolatedString(parts, _) => Kind::Joined(self.expressions(parts)?),
            Expr::Array(items, _) => Kind::List(self.expressions(items)?),
            Expr::Map(entries, _) => {
                let entry =
                    |(key, value): &(rhai::Ident, Expr)| Ok((key.name.as_str().into(), self.expression(value)?));
                Kind::Map(entries.0.iter().map(entry).collect::<Reading<_>>()?)
            }
            Expr::Variable(name, _, _) => self.variable(&name.1, position)?,
            Expr::ThisPtr(_) => Kind::This,
            Expr::Stmt(block) => return self.block(block),
            Expr::FnCall(call, position) => return self.call(call, *position),
            Expr::Dot(..) | Expr::Index(..) => Kind::Chain(Box::new(self.chain(expression)?)),
            Expr::And(parts, _) => Kind::And(self.expressions(parts)?),
            Expr::Or(parts, _) => Kind::Or(self.expressions(parts)?),
            Expr::Coalesce(parts, _) => Kind::Coalesce(self.expressions(parts)?),
            other => return Err(mistake(other.start_position(), "rules have no such expression")),
        };
        Ok(node(position, kind))
    }

    fn expressions(&mut self, expressions: &[Expr]) -> Reading<Vec<Node>> {
        expressions.iter().map(|expression| self.expression(expression)).collect()
    }

    /// The number of a function that has no name of its own.
    fn anonymous(&self, name: &str) -> Option<u16> {
        self.functions.iter().find(|((other, _), _)| other == name).map(|(_, number)| *number)
    }

    /// Reads `name(...)`, or an operator, which Rhai's parser takes for a call.
    ///
    /// # Errors
    /// If there is nothing of this name.
    pub fn call(&mut self, call: &FnCallExpr, position: Position) -> Reading<Node> {
        let name = call.name.as_str();
        let count = call.args.len();
        if name != "contains"
            && let Some(operator) = self.operator(call, position)?
        {
            return Ok(node(position, operator));
        }
        if let Some(number) = self.functions.get(&(name.to_string(), count)) {
            return Ok(node(position, Kind::Script(*number, self.expressions(&call.args)?)));
        }
        if let Some(function) = host::named(name).filter(|function| function.takes(count)) {
            return Ok(node(position, Kind::Host(function, self.expressions(&call.args)?)));
        }
        let Some(function) = self.library_function(name, count.wrapping_sub(1)) else {
            return Err(self.unknown(name, count, position));
        };
        let arguments = self.expressions(&call.args[1..])?;
        Ok(match self.root(&call.args[0])? {
            // What it is called on has a place: it is looked at and changed there.
            root @ (Root::Local(_) | Root::Constant(_) | Root::This) => {
                self.check_change(&root, function, position)?;
                let step =
                    Step { line: line(position), stops_at_unit: false, kind: StepKind::Library(function, arguments) };
                node(position, Kind::Chain(Box::new(Chain { root, steps: vec![step] })))
            }
            Root::Value(subject) => {
                let values = std::iter::once(subject).chain(arguments).collect();
                node(position, Kind::Library(function, values))
            }
        })
    }

    fn operator(&mut self, call: &FnCallExpr, position: Position) -> Reading<Option<Kind>> {
        let sign = call.name.as_str();
        let named = operators::named(sign);
        Ok(match (named, call.args.as_slice()) {
            (Some(Operator::Subtract), [value]) => Some(match self.expression(value)?.kind {
                Kind::Int(number) => Kind::Int(number.wrapping_neg()),
                kind => Kind::Negative(Box::new(node(position, kind))),
            }),
            (Some(Operator::Add), [value]) => Some(self.expression(value)?.kind),
            (None, [value]) if sign == "!" => Some(Kind::Not(Box::new(self.expression(value)?))),
            (Some(operator), [left, right]) => {
                let sides = [self.expression(left)?, self.expression(right)?];
                Some(Kind::Binary(operator, Box::new(sides)))
            }
            _ if sign.chars().any(|letter| letter.is_alphanumeric() || letter == '_') => None,
            _ => return Err(unknown_operator(position, sign)),
        })
    }

    fn unknown(&self, name: &str, count: usize, position: Position) -> (usize, String) {
        let known = host::named(name).is_some()
            || super::library::named(name).is_some()
            || self.functions.keys().any(|(other, _)| other == name);
        let ways = host::named(name).map_or_else(String::new, |_| format!(": it is {}", signatures::all_of(name)));
        let what = match (known, count) {
            (false, _) => format!("there is no function called {name}{}", self.meant(name)),
            (true, 1) => format!("{name} cannot be called with one value{ways}"),
            (true, count) => format!("{name} cannot be called with {count} values{ways}"),
        };
        mistake(position, what)
    }

    /// `; did you mean ...?` if a function's name is like this one.
    fn meant(&self, name: &str) -> String {
        if let Some(own) = foreign::function(name) {
            return format!("; write {own}");
        }
        let own = self.functions.keys().map(|(name, _)| name.as_str());
        let known =
            host::all().map(|function| function.name).chain(super::library::all().map(|function| function.name));
        let meant = spelling::near(name, known.chain(own));
        meant.map_or_else(String::new, |meant| format!("; did you mean {meant}?"))
    }

    fn root(&mut self, expression: &Expr) -> Reading<Root> {
        let read = self.expression(expression)?;
        Ok(match read.kind {
            Kind::Local(slot) => Root::Local(slot),
            Kind::Constant(number) => Root::Constant(number),
            Kind::This => Root::This,
            _ => Root::Value(read),
        })
    }

    /// Reads what is assigned to.
    ///
    /// # Errors
    /// If it is constant, or no place.
    pub fn place(&mut self, expression: &Expr) -> Reading<Chain> {
        let chain = match expression {
            Expr::Dot(..) | Expr::Index(..) => self.chain(expression)?,
            other => Chain { root: self.root(other)?, steps: Vec::new() },
        };
        match &chain.root {
            Root::This => Ok(chain),
            Root::Local(slot) if !self.is_constant(*slot) => Ok(chain),
            Root::Local(_) | Root::Constant(_) => {
                Err(mistake(expression.start_position(), "a constant cannot be changed"))
            }
            Root::Value(_) => {
                Err(mistake(expression.start_position(), "only a variable or a part of one can be changed"))
            }
        }
    }

    fn chain(&mut self, expression: &Expr) -> Reading<Chain> {
        let (Expr::Dot(parts, flags, position) | Expr::Index(parts, flags, position)) = expression else {
            return Err(mistake(expression.start_position(), "rules have no such expression"));
        };
        let root = self.root(&parts.lhs)?;
        let mut steps = Vec::new();
        self.steps(matches!(expression, Expr::Dot(..)), &parts.rhs, *flags, &mut steps)?;
        if steps.len() > MAX_STEPS {
            return Err(mistake(*position, format!("this is more than {MAX_STEPS} steps long")));
        }
        for step in &steps {
            if let StepKind::Library(function, _) = &step.kind {
                self.check_change(&root, function, *position)?;
            }
        }
        Ok(Chain { root, steps })
    }

    /// A constant of a function is not to be changed; that of the script is asked when it is met.
    fn check_change(&self, root: &Root, function: &super::library::Function, position: Position) -> Reading<()> {
        match root {
            Root::Local(slot) if self.is_constant(*slot) && function.changes() => Err(mistake(
                position,
                format!("{} changes what it is called on, and this is a constant", function.name),
            )),
            _ => Ok(()),
        }
    }

    /// Reads the steps of a chain, which Rhai's parser nests to the right.
    fn steps(&mut self, is_dot: bool, rest: &Expr, flags: ASTFlags, steps: &mut Vec<Step>) -> Reading<()> {
        let stops_at_unit = flags.contains(ASTFlags::NEGATED);
        match rest {
            Expr::Dot(parts, next, _) | Expr::Index(parts, next, _) if !flags.contains(ASTFlags::BREAK) => {
                steps.push(self.step(is_dot, stops_at_unit, &parts.lhs)?);
                self.steps(matches!(rest, Expr::Dot(..)), &parts.rhs, *next, steps)
            }
            last => {
                steps.push(self.step(is_dot, stops_at_unit, last)?);
                Ok(())
            }
        }
    }

    fn step(&mut self, is_dot: bool, stops_at_unit: bool, expression: &Expr) -> Reading<Step> {
        let position = expression.start_position();
        let kind = match expression {
            Expr::Property(name, _) if is_dot => StepKind::Property(name.2.as_str().into()),
            Expr::MethodCall(call, _) if is_dot => self.method(call, position)?,
            index => StepKind::Index(self.expression(index)?),
        };
        Ok(Step { line: line(position), stops_at_unit, kind })
    }

    fn method(&mut self, call: &FnCallExpr, position: Position) -> Reading<StepKind> {
        let (name, count) = (call.name.as_str(), call.args.len());
        let arguments = self.expressions(&call.args)?;
        if let Some(number) = self.functions.get(&(name.to_string(), count)) {
            return Ok(StepKind::Script(*number, arguments));
        }
        if let Some(function) = self.library_function(name, count) {
            return Ok(StepKind::Library(function, arguments));
        }
        if let Some(function) = host::named(name).filter(|function| function.takes(count + 1)) {
            return Ok(StepKind::Host(function, arguments));
        }
        match name {
            "call" => Ok(StepKind::Call(arguments)),
            _ if host::named(name).is_some_and(|function| function.takes(count)) => {
                let own = signatures::of(name).filter(|one| one.parameters().count() == count);
                let ways = signatures::written(own);
                Err(mistake(position, format!("nothing stands before {name}, no `this.` either: write {ways}")))
            }
            _ => Err(self.unknown(name, count, position)),
        }
    }
}
