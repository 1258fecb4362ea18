//! The functions that every script can call, by the names that they have in Rhai: own ones, because Rhai's do work
//! that nobody counts, and fail in ways that nobody can catch.
//!
//! Each function takes its steps before it does the work that they stand for.

mod list;
pub mod list_order;
mod list_search;
mod map;
mod number;
mod text;

pub use text::replaced;

use super::data::Data;
use super::interpreter::Interpreter;
use super::stop::{Answer, Stop, fail};

/// A function that has a subject, the value that it is called on, and takes other values.
#[derive(Debug)]
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// How many values it takes at least.
    pub least: usize,
    /// How many values it takes at most.
    pub most: usize,
    /// What it does.
    pub body: Body,
}

/// What a function does.
#[derive(Clone, Copy, Debug)]
pub enum Body {
    /// It looks at its subject.
    Read(fn(&mut Interpreter, &Data, Vec<Data>) -> Answer),
    /// It changes its subject.
    Change(fn(&mut Interpreter, &mut Data, Vec<Data>) -> Answer),
}

impl Function {
    /// Calls it.
    ///
    /// # Errors
    /// A sentence.
    pub fn call(&self, interpreter: &mut Interpreter, subject: &mut Data, arguments: Vec<Data>) -> Answer {
        interpreter.meter.charge(1)?;
        let answer = match self.body {
            Body::Read(body) => body(interpreter, subject, arguments)?,
            Body::Change(body) => body(interpreter, subject, arguments)?,
        };
        answer.check_depth(interpreter.meter)?;
        Ok(answer)
    }

    /// Calls it on what must stay as it is.
    ///
    /// # Errors
    /// A sentence, also if it would change it.
    pub fn call_on_constant(&self, interpreter: &mut Interpreter, subject: &Data, arguments: Vec<Data>) -> Answer {
        interpreter.meter.charge(1)?;
        let Body::Read(body) = self.body else {
            return Err(fail(format!("{} changes what it is called on, and this is a constant", self.name)));
        };
        let answer = body(interpreter, subject, arguments)?;
        answer.check_depth(interpreter.meter)?;
        Ok(answer)
    }

    /// Whether it changes its subject.
    pub fn changes(&self) -> bool {
        matches!(self.body, Body::Change(_))
    }

    /// Whether it can be called with so many values beside its subject.
    pub fn takes(&self, count: usize) -> bool {
        (self.least..=self.most).contains(&count)
    }
}

/// The function of this name.
pub fn named(name: &str) -> Option<&'static Function> {
    all().find(|function| function.name == name)
}

/// Every function.
pub fn all() -> impl Iterator<Item = &'static Function> {
    [&VALUES[..], &number::FUNCTIONS, &text::FUNCTIONS, &list::FUNCTIONS, &list_search::FUNCTIONS, &map::FUNCTIONS]
        .into_iter()
        .flatten()
}

/// A function that looks at its subject.
const fn read(
    name: &'static str,
    least: usize,
    most: usize,
    body: fn(&mut Interpreter, &Data, Vec<Data>) -> Answer,
) -> Function {
    Function { name, least, most, body: Body::Read(body) }
}

/// A function that changes its subject.
const fn change(
    name: &'static str,
    least: usize,
    most: usize,
    body: fn(&mut Interpreter, &mut Data, Vec<Data>) -> Answer,
) -> Function {
    Function { name, least, most, body: Body::Change(body) }
}

/// The function cannot be called with these.
fn unfit(name: &str, subject: &Data, arguments: &[Data]) -> Stop {
    let types: Vec<&str> = std::iter::once(subject).chain(arguments).map(Data::type_name).collect();
    fail(format!("{name} cannot be called with ({})", types.join(", ")))
}

/// What more than one type of value has.
static VALUES: [Function; 9] = [
    read("type_of", 0, 0, |_, subject, _| Ok(Data::text(subject.type_name()))),
    read("to_string", 0, 0, |interpreter, subject, _| super::text::of(subject, interpreter.meter)),
    read("len", 0, 0, |interpreter, subject, arguments| match subject {
        Data::List(items) => Ok(Data::count(items.len())),
        Data::Map(entries) => Ok(Data::count(entries.len())),
        Data::Text(text) => {
            interpreter.meter.bytes(text.len())?;
            Ok(Data::count(text.chars().count()))
        }
        other => Err(unfit("len", other, &arguments)),
    }),
    read("is_empty", 0, 0, |_, subject, arguments| match subject {
        Data::List(items) => Ok(Data::Bool(items.is_empty())),
        Data::Map(entries) => Ok(Data::Bool(entries.is_empty())),
        Data::Text(text) => Ok(Data::Bool(text.is_empty())),
        Data::Range(range) => Ok(Data::Bool({ *range }.next().is_none())),
        other => Err(unfit("is_empty", other, &arguments)),
    }),
    read("contains", 1, 1, contains),
    change("clear", 0, 0, |_, subject, arguments| {
        match subject {
            Data::List(items) => items.clear(),
            Data::Map(entries) => entries.clear(),
            Data::Text(text) => *text = "".into(),
            other => return Err(unfit("clear", other, &arguments)),
        }
        Ok(Data::Unit)
    }),
    read("get", 1, 1, |interpreter, subject, mut arguments| match (subject, arguments.remove(0)) {
        (Data::List(items), Data::Int(index)) => match items.get(super::position::offset(index, items.len())) {
            Some(item) => item.copy(interpreter.meter),
            None => Ok(Data::Unit),
        },
        (Data::Map(_), key @ Data::Text(_)) => {
            match super::place::enter(subject, &super::place::Key::Index(key), interpreter.meter)? {
                super::place::Found::Place(value) => value.copy(interpreter.meter),
                super::place::Found::Value(value) => Ok(value),
            }
        }
        (other, key) => Err(unfit("get", other, &[key])),
    }),
    change("set", 2, 2, |interpreter, subject, mut arguments| {
        let key = arguments.remove(0);
        if let (Data::List(items), Data::Int(index)) = (&mut *subject, &key) {
            let position = super::position::offset(*index, items.len());
            // Where there is no item, none is set.
            if let Some(item) = items.get_mut(position) {
                *item = arguments.remove(0);
            }
            return Ok(Data::Unit);
        }
        let place = super::place::follow(subject, &[super::place::Key::Index(key)], interpreter.meter)?;
        *place = arguments.remove(0);
        Ok(Data::Unit)
    }),
    change("remove", 1, 1, |interpreter, subject, mut arguments| match (subject, arguments.remove(0)) {
        (Data::List(items), Data::Int(index)) => list::remove(items, index, interpreter.meter),
        (Data::Map(entries), Data::Text(key)) => map::remove(entries, &key, interpreter.meter),
        (other, key) => Err(unfit("remove", other, &[key])),
    }),
];

/// Whether a value stands in another: an item in a list, a text in a text, a key in a map, a number in a range.
fn contains(interpreter: &mut Interpreter, subject: &Data, arguments: Vec<Data>) -> Answer {
    let meter = &mut *interpreter.meter;
    let found = match (subject, &arguments[0]) {
        (Data::List(items), item) => list_search::position(items, item, 0, meter)?.is_some(),
        (Data::Text(text), Data::Text(part)) => {
            meter.charge(text::search_steps(text, part))?;
            text.contains(&**part)
        }
        (Data::Map(entries), Data::Text(key)) => {
            meter.charge(super::meter::text_steps(key.len()) * 12)?;
            entries.contains_key(&**key)
        }
        (Data::Range(range), Data::Int(number)) => range.contains(*number),
        (other, _) => return Err(unfit("contains", other, &arguments)),
    };
    Ok(Data::Bool(found))
}
