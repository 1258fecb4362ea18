//! A script as the interpreter runs it: a tree in which every name is already the number of what it names.

use super::library::Function as LibraryFunction;
use crate::rules::host_function::HostFunction;
use std::sync::Arc;

/// One expression or statement; a statement is an expression whose value is `()`.
#[derive(Debug)]
pub struct Node {
    /// Where it stands, from 1.
    pub line: u32,
    /// What it is.
    pub kind: Kind,
}

/// What a node is.
#[derive(Debug)]
pub enum Kind {
    /// `()`.
    Unit,
    /// `true`, `false`.
    Bool(bool),
    /// A number.
    Int(i64),
    /// A text.
    Text(Arc<str>),
    /// A function as a value.
    Function(u16),
    /// Values written one after the other: `` `${a} of ${b}` ``.
    Joined(Vec<Node>),
    /// `[a, b]`.
    List(Vec<Node>),
    /// `#{ a: b }`.
    Map(Vec<(Arc<str>, Node)>),
    /// A variable.
    Local(u16),
    /// A constant of the script.
    Constant(u16),
    /// `this`.
    This,
    /// A value and the way from it.
    Chain(Box<Chain>),
    /// `a + b`.
    Binary(Operator, Box<[Node; 2]>),
    /// `!a`.
    Not(Box<Node>),
    /// `-a`.
    Negative(Box<Node>),
    /// `a && b`.
    And(Vec<Node>),
    /// `a || b`.
    Or(Vec<Node>),
    /// `a ?? b`: the first that is not `()`.
    Coalesce(Vec<Node>),
    /// A call of a function of the script, without `this`.
    Script(u16, Vec<Node>),
    /// A call of a function of the library; the first value is its subject.
    Library(&'static LibraryFunction, Vec<Node>),
    /// A call of a function of the game.
    Host(&'static HostFunction, Vec<Node>),
    /// `{ a; b }`.
    Block(Vec<Node>),
    /// `if a { b } else { c }`.
    If(Box<[Node; 3]>),
    /// `switch`.
    Switch(Box<Switch>),
    /// `while a { b }`.
    While(Box<[Node; 2]>),
    /// `do { a } while b`; the flag is what `b` must be to go on.
    Do(Box<[Node; 2]>, bool),
    /// `for`.
    For(Box<For>),
    /// `let a = b`.
    Let(u16, Box<Node>),
    /// `a = b`, `a += b`.
    Assign(Box<Assign>),
    /// `return a`.
    Return(Box<Node>),
    /// `throw a`.
    Throw(Box<Node>),
    /// `break a`.
    Break(Box<Node>),
    /// `continue`.
    Continue,
    /// `try { a } catch (b) { c }`.
    Try(Box<Try>),
}

/// What stands between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,
    Power,
    ShiftLeft,
    ShiftRight,
    BitAnd,
    BitOr,
    BitXor,
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Range,
    InclusiveRange,
}

impl Operator {
    /// Whether it gives what one value is to another: the same, more, less.
    pub fn compares(self) -> bool {
        use Operator::{Equal, Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
        matches!(self, Equal | NotEqual | Less | LessOrEqual | Greater | GreaterOrEqual)
    }
}

/// A value and the way from it: `a.b[c].d(e)`.
#[derive(Debug)]
pub struct Chain {
    /// Where it begins.
    pub root: Root,
    /// The way.
    pub steps: Vec<Step>,
}

/// Where a chain begins.
#[derive(Debug)]
pub enum Root {
    /// At a variable.
    Local(u16),
    /// At a constant.
    Constant(u16),
    /// At `this`.
    This,
    /// At a value that has no place.
    Value(Node),
}

/// One step of a chain.
#[derive(Debug)]
pub struct Step {
    /// Where it stands.
    pub line: u32,
    /// `?.` and `?[`: from `()` the whole chain is `()`.
    pub stops_at_unit: bool,
    /// What it is.
    pub kind: StepKind,
}

/// What a step is.
#[derive(Debug)]
pub enum StepKind {
    /// `.name`.
    Property(Arc<str>),
    /// `[a]`.
    Index(Node),
    /// `.name(...)`: a function of the script that gets the value as `this`.
    Script(u16, Vec<Node>),
    /// `.name(...)`: a function of the library.
    Library(&'static LibraryFunction, Vec<Node>),
    /// `.name(...)`: a function of the game that gets the value first.
    Host(&'static HostFunction, Vec<Node>),
    /// `.call(...)`: the value is a function.
    Call(Vec<Node>),
}

/// `switch`: the first case that fits.
#[derive(Debug)]
pub struct Switch {
    /// What is looked at.
    pub subject: Node,
    /// The cases in the order of the script, the one for everything else last.
    pub cases: Vec<Case>,
    /// What the cases do: several may do the same.
    pub branches: Vec<Branch>,
}

/// One case.
#[derive(Debug)]
pub struct Case {
    /// What the subject must be.
    pub pattern: Pattern,
    /// Which branch it leads to.
    pub branch: usize,
}

/// What a case does.
#[derive(Debug)]
pub struct Branch {
    /// What else must be true.
    pub condition: Option<Node>,
    /// What is done then.
    pub body: Node,
}

/// What a case's subject must be.
#[derive(Debug)]
pub enum Pattern {
    /// This.
    Value(super::data::Data),
    /// A number in here.
    Range(super::data::Range),
    /// Anything.
    Any,
}

/// `for (item, count) in subject { body }`.
#[derive(Debug)]
pub struct For {
    /// The variable for the item.
    pub item: u16,
    /// The variable for its number, from 0.
    pub count: Option<u16>,
    /// What is gone through.
    pub subject: Node,
    /// What is done each time.
    pub body: Node,
}

/// `place = value`.
#[derive(Debug)]
pub struct Assign {
    /// Where the value goes; its steps are properties and indices.
    pub place: Chain,
    /// What is done with the old value and the new one, if not only replaced.
    pub operator: Option<Operator>,
    /// The value.
    pub value: Node,
}

/// `try { body } catch (variable) { handler }`.
#[derive(Debug)]
pub struct Try {
    /// What may fail.
    pub body: Node,
    /// The variable for what has failed.
    pub variable: Option<u16>,
    /// What is done then.
    pub handler: Node,
}

impl Node {
    /// Whether it is there already: nothing has to be done for it.
    pub fn is_plain(&self) -> bool {
        use Kind::{Bool, Constant, Int, Local, Text, Unit};
        matches!(self.kind, Unit | Bool(_) | Int(_) | Text(_) | Local(_) | Constant(_))
    }

    /// Calls `each` with every node that stands directly in this one, in the order of the script.
    pub fn for_each_child<'a>(&'a self, each: &mut dyn FnMut(&'a Node)) {
        match &self.kind {
            Kind::Joined(nodes)
            | Kind::List(nodes)
            | Kind::And(nodes)
            | Kind::Or(nodes)
            | Kind::Coalesce(nodes)
            | Kind::Script(_, nodes)
            | Kind::Library(_, nodes)
            | Kind::Host(_, nodes)
            | Kind::Block(nodes) => nodes.iter().for_each(each),
            Kind::Map(entries) => entries.iter().for_each(|(_, node)| each(node)),
            Kind::Binary(_, nodes) | Kind::While(nodes) | Kind::Do(nodes, _) => nodes.iter().for_each(each),
            Kind::If(nodes) => nodes.iter().for_each(each),
            Kind::Not(node)
            | Kind::Negative(node)
            | Kind::Let(_, node)
            | Kind::Return(node)
            | Kind::Throw(node)
            | Kind::Break(node) => each(node),
            Kind::Chain(chain) => chain.for_each_child(each),
            Kind::Switch(switch) => switch.for_each_child(each),
            Kind::For(parts) => [&parts.subject, &parts.body].into_iter().for_each(each),
            Kind::Assign(assign) => {
                assign.place.for_each_child(each);
                each(&assign.value);
            }
            Kind::Try(parts) => [&parts.body, &parts.handler].into_iter().for_each(each),
            Kind::Unit
            | Kind::Bool(_)
            | Kind::Int(_)
            | Kind::Text(_)
            | Kind::Function(_)
            | Kind::Local(_)
            | Kind::Constant(_)
            | Kind::This
            | Kind::Continue => {}
        }
    }
}

impl Chain {
    fn for_each_child<'a>(&'a self, each: &mut dyn FnMut(&'a Node)) {
        if let Root::Value(node) = &self.root {
            each(node);
        }
        for step in &self.steps {
            match &step.kind {
                StepKind::Property(_) => {}
                StepKind::Index(node) => each(node),
                StepKind::Script(_, nodes)
                | StepKind::Library(_, nodes)
                | StepKind::Host(_, nodes)
                | StepKind::Call(nodes) => nodes.iter().for_each(&mut *each),
            }
        }
    }
}

impl Switch {
    fn for_each_child<'a>(&'a self, each: &mut dyn FnMut(&'a Node)) {
        each(&self.subject);
        for branch in &self.branches {
            branch.condition.iter().for_each(&mut *each);
            each(&branch.body);
        }
    }
}
