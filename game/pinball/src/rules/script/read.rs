//! Reads a script: Rhai's parser makes a syntax tree of the text, and this makes nodes of that, with every name looked
//! up. What does not exist is a mistake with its line, before anybody plays.

use super::data::{Data, Range};
use super::foreign;
use super::library;
use super::node::{Assign, Branch, Case, For, Kind, Node, Pattern, Switch, Try};
use super::operators;
use super::syntax::SyntaxTree;
use rhai::{ASTFlags, Expr, FlowControl, Position, RangeCase, Stmt, StmtBlock, SwitchCasesCollection};
use std::collections::BTreeMap;

/// Most variables of one function.
const MAX_LOCALS: usize = 256;

/// A mistake: its line and a sentence.
pub type Mistake = (usize, String);

/// Something that was read, or the mistake in it.
pub type Reading<T> = Result<T, Mistake>;

/// Reads one function, or what stands outside of functions.
pub struct Reader<'a> {
    /// The functions of the script: name and number of parameters, and their numbers.
    pub functions: &'a BTreeMap<(String, usize), u16>,
    /// The constants of the script by number.
    pub constants: Vec<String>,
    /// Variables that are made outside of functions, and that no function sees.
    pub outside: Vec<String>,
    /// The variables that are known here.
    scope: Vec<Variable>,
    /// Most variables that are known at once.
    pub locals: usize,
    /// What is wrong.
    pub mistakes: Vec<Mistake>,
}

/// A variable of a function.
struct Variable {
    name: String,
    constant: bool,
}

impl<'a> Reader<'a> {
    /// A reader of a function with these parameters.
    pub fn new(functions: &'a BTreeMap<(String, usize), u16>, constants: &[String], parameters: &[String]) -> Self {
        let variable = |name: &String| Variable { name: name.clone(), constant: false };
        Reader {
            functions,
            constants: constants.to_vec(),
            outside: Vec::new(),
            scope: parameters.iter().map(variable).collect(),
            locals: parameters.len(),
            mistakes: Vec::new(),
        }
    }

    /// The statements of a function; the mistakes stand beside them.
    pub fn body(&mut self, tree: &SyntaxTree) -> Node {
        let mut nodes = Vec::new();
        let walked = tree.for_each_statement(|statement| nodes.extend(self.statement_or_mistake(statement)));
        self.mistakes.extend(walked.err());
        Node { line: nodes.first().map_or(0, |node| node.line), kind: Kind::Block(nodes) }
    }

    /// A statement; nothing if it does nothing or is wrong.
    pub fn statement_or_mistake(&mut self, statement: &Stmt) -> Option<Node> {
        if matches!(statement, Stmt::Noop(_)) {
            return None;
        }
        self.statement(statement).map_err(|mistake| self.mistakes.push(mistake)).ok()
    }

    fn statement(&mut self, statement: &Stmt) -> Reading<Node> {
        let line = line(statement.position());
        let kind = match statement {
            Stmt::Noop(_) => Kind::Unit,
            Stmt::Expr(expression) => return self.expression(expression),
            Stmt::FnCall(call, position) => return self.call(call, *position),
            Stmt::Block(block) => return self.block(block),
            Stmt::If(parts, _) => {
                let FlowControl { expr, body, branch } = &**parts;
                Kind::If(Box::new([self.expression(expr)?, self.block(body)?, self.block(branch)?]))
            }
            Stmt::Switch(parts, _) => Kind::Switch(Box::new(self.switch(&parts.0, &parts.1)?)),
            Stmt::While(parts, position) => {
                let condition = match &parts.expr {
                    Expr::Unit(_) => node(*position, Kind::Bool(true)),
                    condition => self.expression(condition)?,
                };
                Kind::While(Box::new([condition, self.block(&parts.body)?]))
            }
            Stmt::Do(parts, flags, _) => {
                let body = self.block(&parts.body)?;
                Kind::Do(Box::new([body, self.expression(&parts.expr)?]), !flags.contains(ASTFlags::NEGATED))
            }
            Stmt::For(parts, _) => {
                let counter = parts.1.as_ref().map(|counter| counter.name.as_str());
                self.in_scope(|reader| reader.each(&parts.0.name, counter, &parts.2))?
            }
            Stmt::Var(parts, flags, position) => {
                let value = Box::new(self.expression(&parts.1)?);
                Kind::Let(self.declare(&parts.0.name, flags.contains(ASTFlags::CONSTANT), *position)?, value)
            }
            Stmt::Assignment(parts) => self.assignment(&parts.1.lhs, parts.0.get_op_assignment_info(), &parts.1.rhs)?,
            Stmt::TryCatch(parts, _) => self.attempt(parts)?,
            Stmt::BreakLoop(value, flags, position) => match flags.contains(ASTFlags::BREAK) {
                true => Kind::Break(Box::new(self.optional(value.as_deref(), *position)?)),
                false => Kind::Continue,
            },
            Stmt::Return(value, flags, position) => {
                let value = Box::new(self.optional(value.as_deref(), *position)?);
                if flags.contains(ASTFlags::BREAK) { Kind::Throw(value) } else { Kind::Return(value) }
            }
            other => return Err(mistake(other.position(), "rules have no such statement")),
        };
        Ok(Node { line, kind })
    }

    fn optional(&mut self, value: Option<&Expr>, position: Position) -> Reading<Node> {
        value.map_or(Ok(node(position, Kind::Unit)), |value| self.expression(value))
    }

    /// A block; what it declares is forgotten behind it.
    pub fn block(&mut self, block: &StmtBlock) -> Reading<Node> {
        let read = |reader: &mut Self| block.iter().filter_map(|one| reader.statement_or_mistake(one)).collect();
        let nodes = self.in_scope(|reader| Ok(read(reader)))?;
        Ok(node(block.position(), Kind::Block(nodes)))
    }

    /// Reads something whose variables are forgotten behind it.
    fn in_scope<T>(&mut self, read: impl FnOnce(&mut Self) -> Reading<T>) -> Reading<T> {
        let known = self.scope.len();
        let answer = read(self);
        self.scope.truncate(known);
        answer
    }

    fn declare(&mut self, name: &str, constant: bool, position: Position) -> Reading<u16> {
        self.scope.push(Variable { name: name.to_string(), constant });
        self.locals = self.locals.max(self.scope.len());
        if self.scope.len() > MAX_LOCALS {
            return Err(mistake(position, format!("a function has at most {MAX_LOCALS} variables")));
        }
        Ok((self.scope.len() - 1) as u16)
    }

    fn each(&mut self, item: &str, counter: Option<&str>, parts: &FlowControl) -> Reading<Kind> {
        let position = parts.expr.start_position();
        let subject = self.expression(&parts.expr)?;
        let count = counter.map(|counter| self.declare(counter, false, position)).transpose()?;
        let item = self.declare(item, false, position)?;
        let body = self.block(&parts.body)?;
        Ok(Kind::For(Box::new(For { item, count, subject, body })))
    }

    fn attempt(&mut self, parts: &FlowControl) -> Reading<Kind> {
        let body = self.block(&parts.body)?;
        self.in_scope(|reader| {
            let variable = match &parts.expr {
                Expr::Variable(name, _, position) => Some(reader.declare(&name.1, false, *position)?),
                _ => None,
            };
            let handler = reader.block(&parts.branch)?;
            Ok(Kind::Try(Box::new(Try { body, variable, handler })))
        })
    }

    fn assignment<'t>(
        &mut self,
        place: &Expr,
        operator: Option<(u64, u64, &rhai::Token, &'t str, &rhai::Token, &'t str)>,
        value: &Expr,
    ) -> Reading<Kind> {
        let position = place.start_position();
        let operator = match operator {
            Some((.., sign)) => Some(operators::named(sign).ok_or_else(|| unknown_operator(position, sign))?),
            None => None,
        };
        let value = self.expression(value)?;
        let place = self.place(place)?;
        Ok(Kind::Assign(Box::new(Assign { place, operator, value })))
    }

    fn switch(&mut self, subject: &Expr, parts: &SwitchCasesCollection) -> Reading<Switch> {
        let mut found: Vec<(usize, Pattern)> = Vec::new();
        // Rhai's parser puts ranges here too, but they are looked up among the ranges.
        for case in parts.cases.values().filter(|case| !is_range(&case.value)) {
            let value = constant(&case.value, subject.start_position())?;
            for block in &case.blocks {
                found.push((*block, Pattern::Value(copy(&value))));
            }
        }
        found.sort_by_key(|(block, _)| *block);
        found.extend(parts.ranges.iter().map(|range| (range.index(), Pattern::Range(numbers(range)))));
        found.extend(parts.def_case.map(|block| (block, Pattern::Any)));
        let subject = self.expression(subject)?;
        let cases = found.into_iter().map(|(branch, pattern)| Case { pattern, branch }).collect();
        // Each is read once, however many cases lead to it: branches nest.
        let branches = parts.expressions.iter().map(|branch| {
            let condition = match &branch.lhs {
                Expr::BoolConstant(true, _) => None,
                condition => Some(self.expression(condition)?),
            };
            Ok(Branch { condition, body: self.expression(&branch.rhs)? })
        });
        let branches = branches.collect::<Reading<_>>()?;
        Ok(Switch { subject, cases, branches })
    }

    /// The variable or constant of this name.
    pub fn variable(&self, name: &str, position: Position) -> Reading<Kind> {
        if let Some(slot) = self.scope.iter().rposition(|variable| variable.name == name) {
            return Ok(Kind::Local(slot as u16));
        }
        match self.constants.iter().rposition(|constant| constant == name) {
            Some(number) => Ok(Kind::Constant(number as u16)),
            None if self.outside.iter().any(|outside| outside == name) => {
                let what = format!(
                    "{name} is made with `let` outside of functions, and no function sees it: write `const`, or keep it in \
                     `this.{name}` if it changes"
                );
                Err(mistake(position, what))
            }
            None => Err(mistake(position, foreign::unknown_name(name))),
        }
    }

    /// The variables that are known here.
    pub fn known(&self) -> Vec<String> {
        self.scope.iter().map(|variable| variable.name.clone()).collect()
    }

    /// Whether the variable may only be read.
    pub fn is_constant(&self, slot: u16) -> bool {
        self.scope[usize::from(slot)].constant
    }

    /// What a name that is called means.
    pub fn library_function(&self, name: &str, count: usize) -> Option<&'static library::Function> {
        library::named(name).filter(|function| function.takes(count))
    }
}

/// A node that stands here.
pub fn node(position: Position, kind: Kind) -> Node {
    Node { line: line(position), kind }
}

/// The line of a position.
pub fn line(position: Position) -> u32 {
    position.line().unwrap_or(0) as u32
}

/// A mistake that stands here.
pub fn mistake(position: Position, what: impl Into<String>) -> Mistake {
    (position.line().unwrap_or(1), what.into())
}

/// There is no such operator.
pub fn unknown_operator(position: Position, sign: &str) -> Mistake {
    mistake(position, format!("rules have no operator `{sign}`"))
}

/// A constant of Rhai's.
fn constant(value: &rhai::Dynamic, position: Position) -> Reading<Data> {
    if value.is_unit() {
        Ok(Data::Unit)
    } else if let Ok(flag) = value.as_bool() {
        Ok(Data::Bool(flag))
    } else if let Ok(number) = value.as_int() {
        Ok(Data::Int(number))
    } else if value.is_string() || value.is_char() {
        Ok(Data::text(value.to_string()))
    } else {
        let what =
            format!("a case is a number, a range of numbers, a text, true, false or (), and this is none: {value}");
        Err(mistake(position, what))
    }
}

/// A constant again: none holds others.
fn copy(value: &Data) -> Data {
    match value {
        Data::Bool(flag) => Data::Bool(*flag),
        Data::Int(number) => Data::Int(*number),
        Data::Text(text) => Data::Text(text.clone()),
        _ => Data::Unit,
    }
}

fn is_range(value: &rhai::Dynamic) -> bool {
    value.is::<std::ops::Range<i64>>() || value.is::<std::ops::RangeInclusive<i64>>()
}

fn numbers(range: &RangeCase) -> Range {
    match range {
        RangeCase::ExclusiveInt(range, _) => Range::exclusive(range.start, range.end),
        RangeCase::InclusiveInt(range, _) => Range::inclusive(*range.start(), *range.end()),
    }
}
