//! A script's values while it runs.
//!
//! Nothing is shared but the bytes of texts, which nobody can change: a value is a tree, and what it costs is its size.

use super::meter::{Meter, text_steps};
use super::stop::{Answer, Stop, fail};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Deepest nesting of lists and maps in a value that is copied, stored or remembered.
pub const MAX_DEPTH: usize = 16;

/// A map's values by key.
pub type Entries = BTreeMap<Arc<str>, Data>;

/// A value.
#[derive(Debug, Default)]
pub enum Data {
    /// Nothing: `()`.
    #[default]
    Unit,
    /// `true` or `false`.
    Bool(bool),
    /// A whole number.
    Int(i64),
    /// A text; a letter is a text too.
    Text(Arc<str>),
    /// An array.
    List(Vec<Data>),
    /// An object map.
    Map(Entries),
    /// Whole numbers that follow each other.
    Range(Range),
    /// A function of the script, by its number.
    Function(u16),
}

/// Whole numbers from `first` on in steps, before `end`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// The first.
    pub first: i64,
    /// None reaches it.
    pub end: i64,
    /// From one to the next; not 0.
    pub step: i64,
    /// It was written with its last number: `first..=last`.
    pub inclusive: bool,
}

impl Range {
    /// `first..end`.
    pub fn exclusive(first: i64, end: i64) -> Range {
        Range { first, end, step: 1, inclusive: false }
    }

    /// `first..=last`.
    pub fn inclusive(first: i64, last: i64) -> Range {
        Range { first, end: last.saturating_add(1), step: 1, inclusive: true }
    }

    /// Whether it has this number.
    pub fn contains(&self, number: i64) -> bool {
        let inside = if self.step > 0 { (self.first..self.end).contains(&number) } else { false };
        let below = self.step < 0 && number <= self.first && number > self.end;
        (inside || below) && (i128::from(number) - i128::from(self.first)) % i128::from(self.step) == 0
    }
}

impl Iterator for Range {
    type Item = i64;

    fn next(&mut self) -> Option<i64> {
        let number = self.first;
        let inside = if self.step > 0 { number < self.end } else { number > self.end };
        self.first = number.saturating_add(self.step);
        inside.then_some(number)
    }
}

impl Data {
    /// A text.
    pub fn text(text: impl AsRef<str>) -> Data {
        Data::Text(text.as_ref().into())
    }

    /// A number for a count.
    pub fn count(count: usize) -> Data {
        Data::Int(count as i64)
    }

    /// The whole number that it is, if it is one.
    pub fn number(&self) -> Option<i64> {
        match self {
            Data::Int(number) => Some(*number),
            _ => None,
        }
    }

    /// Whether it is this text.
    pub fn is_text(&self, text: &str) -> bool {
        matches!(self, Data::Text(own) if **own == *text)
    }

    /// What it is, in Rhai's words.
    pub fn type_name(&self) -> &'static str {
        match self {
            Data::Unit => "()",
            Data::Bool(_) => "bool",
            Data::Int(_) => "i64",
            Data::Text(_) => "string",
            Data::List(_) => "array",
            Data::Map(_) => "map",
            Data::Range(Range { inclusive: true, .. }) => "range=",
            Data::Range(_) => "range",
            Data::Function(_) => "Fn",
        }
    }

    /// The same value again.
    ///
    /// # Errors
    /// If the steps are spent, or it is nested too deep.
    pub fn copy(&self, meter: &mut Meter) -> Answer {
        self.copy_below(MAX_DEPTH, meter)
    }

    fn copy_below(&self, depth: usize, meter: &mut Meter) -> Answer {
        Ok(match self {
            Data::Unit => Data::Unit,
            Data::Bool(flag) => Data::Bool(*flag),
            Data::Int(number) => Data::Int(*number),
            Data::Text(text) => Data::Text(text.clone()),
            Data::Range(range) => Data::Range(*range),
            Data::Function(number) => Data::Function(*number),
            Data::List(items) => {
                let below = deeper(depth)?;
                meter.values(items.len())?;
                Data::List(items.iter().map(|item| item.copy_below(below, meter)).collect::<Result<_, _>>()?)
            }
            Data::Map(entries) => {
                let below = deeper(depth)?;
                meter.values(2 * entries.len())?;
                let copied = entries.iter().map(|(key, value)| Ok((key.clone(), value.copy_below(below, meter)?)));
                Data::Map(copied.collect::<Result<_, Stop>>()?)
            }
        })
    }

    /// Checks that a value that goes into another is not nested too deep.
    ///
    /// # Errors
    /// If it is, or the steps are spent.
    pub fn check_depth(&self, meter: &mut Meter) -> Result<(), Stop> {
        self.check_below(MAX_DEPTH, meter)
    }

    fn check_below(&self, depth: usize, meter: &mut Meter) -> Result<(), Stop> {
        match self {
            Data::List(items) => {
                let below = deeper(depth)?;
                meter.values(items.len())?;
                items.iter().try_for_each(|item| item.check_below(below, meter))
            }
            Data::Map(entries) => {
                let below = deeper(depth)?;
                meter.values(entries.len())?;
                entries.values().try_for_each(|value| value.check_below(below, meter))
            }
            _ => Ok(()),
        }
    }

    /// Whether both are the same; of two types they never are.
    ///
    /// # Errors
    /// If the steps are spent.
    pub fn same(&self, other: &Data, meter: &mut Meter) -> Result<bool, Stop> {
        meter.charge(1)?;
        match (self, other) {
            (Data::Unit, Data::Unit) => Ok(true),
            (Data::Bool(a), Data::Bool(b)) => Ok(a == b),
            (Data::Int(a), Data::Int(b)) => Ok(a == b),
            (Data::Range(a), Data::Range(b)) => Ok(a == b),
            (Data::Function(a), Data::Function(b)) => Ok(a == b),
            (Data::Text(a), Data::Text(b)) => same_text(a, b, meter),
            (Data::List(a), Data::List(b)) if a.len() == b.len() => all_same(a.iter().zip(b), meter),
            (Data::Map(a), Data::Map(b)) if a.len() == b.len() => {
                for (one, two) in a.keys().zip(b.keys()) {
                    if !same_text(one, two, meter)? {
                        return Ok(false);
                    }
                }
                all_same(a.values().zip(b.values()), meter)
            }
            _ => Ok(false),
        }
    }

    /// Their order, where they have one: numbers and texts.
    ///
    /// # Errors
    /// If the steps are spent.
    pub fn order(&self, other: &Data, meter: &mut Meter) -> Result<Option<Ordering>, Stop> {
        meter.charge(1)?;
        Ok(match (self, other) {
            (Data::Int(a), Data::Int(b)) => Some(a.cmp(b)),
            (Data::Bool(a), Data::Bool(b)) => Some(a.cmp(b)),
            (Data::Text(a), Data::Text(b)) => {
                meter.charge(text_steps(a.len().min(b.len())))?;
                Some(a.cmp(b))
            }
            _ => None,
        })
    }

    /// As a condition.
    ///
    /// # Errors
    /// If it is not `true` or `false`.
    pub fn condition(&self) -> Result<bool, Stop> {
        match self {
            Data::Bool(flag) => Ok(*flag),
            other => Err(fail(format!("a condition must be true or false, not {}", other.type_name()))),
        }
    }
}

fn deeper(depth: usize) -> Result<usize, Stop> {
    depth.checked_sub(1).ok_or_else(|| fail(format!("lists and maps may be nested {MAX_DEPTH} deep and no deeper")))
}

fn same_text(a: &Arc<str>, b: &Arc<str>, meter: &mut Meter) -> Result<bool, Stop> {
    if a.len() != b.len() {
        return Ok(false);
    }
    meter.bytes(a.len())?;
    Ok(a == b)
}

fn all_same<'a>(pairs: impl Iterator<Item = (&'a Data, &'a Data)>, meter: &mut Meter) -> Result<bool, Stop> {
    for (a, b) in pairs {
        if !a.same(b, meter)? {
            return Ok(false);
        }
    }
    Ok(true)
}
