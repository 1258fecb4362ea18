//! Comparisons of entries of `this` with whole numbers that stand in the script.

use super::entry_values::asked_whole;
use super::literal::literal;
use super::remark::Remark;
use super::unreached::is_still;
use crate::rules::script::{Data, Kind, Node, Operator, Script};
use std::sync::Arc;

/// A comparison: the entry stands on the left.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The entry's name.
    pub name: Arc<str>,
    /// Where it stands.
    pub line: u32,
    /// `<`, `<=`, `>` or `>=`.
    pub operator: Operator,
    /// What it is compared with.
    pub number: i64,
}

impl Comparison {
    /// The comparison that a node is.
    pub fn of(node: &Node, script: &Script) -> Option<Comparison> {
        let Kind::Binary(operator, sides) = &node.kind else { return None };
        let [left, right] = &**sides;
        let pair = |place: &Node, value: &Node| match (asked_whole(place)?, literal(value, script)?) {
            ((name, line), Data::Int(number)) => Some((name, line, number)),
            _ => None,
        };
        let (turned, (name, line, number)) =
            pair(left, right).map(|pair| (false, pair)).or_else(|| Some((true, pair(right, left)?)))?;
        let operator = match (operator, turned) {
            (Operator::Less, false) | (Operator::Greater, true) => Operator::Less,
            (Operator::LessOrEqual, false) | (Operator::GreaterOrEqual, true) => Operator::LessOrEqual,
            (Operator::Greater, false) | (Operator::Less, true) => Operator::Greater,
            (Operator::GreaterOrEqual, false) | (Operator::LessOrEqual, true) => Operator::GreaterOrEqual,
            _ => return None,
        };
        Some(Comparison { name, line, operator, number })
    }

    /// Whether it is true of a number.
    pub fn holds(&self, own: i64) -> bool {
        match self.operator {
            Operator::Less => own < self.number,
            Operator::LessOrEqual => own <= self.number,
            Operator::Greater => own > self.number,
            _ => own >= self.number,
        }
    }

    /// The sign with what it is compared with.
    pub fn shown(&self) -> String {
        let sign = match self.operator {
            Operator::Less => "<",
            Operator::LessOrEqual => "<=",
            Operator::Greater => ">",
            _ => ">=",
        };
        format!("{sign} {}", self.number)
    }

    /// Whether this asks for no less than a number, and the other for no more than a smaller one.
    fn excludes(&self, other: &Comparison) -> bool {
        let is_low = matches!(self.operator, Operator::Greater | Operator::GreaterOrEqual);
        let is_high = matches!(other.operator, Operator::Less | Operator::LessOrEqual);
        // With numbers that are equal, both must take them.
        let both = self.operator == Operator::GreaterOrEqual && other.operator == Operator::LessOrEqual;
        is_low && is_high && (self.number > other.number || self.number == other.number && !both)
    }
}

/// Conditions of which two parts exclude each other, whatever the entry is.
pub fn remarks(script: &Script) -> Vec<Remark> {
    let mut found = Vec::new();
    script.functions().for_each(|function| look(&function.body, script, &mut found));
    found
}

fn look(node: &Node, script: &Script, found: &mut Vec<Remark>) {
    if let Kind::And(parts) = &node.kind {
        // What a function changes may be something else behind it.
        let parts = parts.iter().take_while(|part| is_still(part));
        let asked: Vec<Comparison> = parts.filter_map(|part| Comparison::of(part, script)).collect();
        let excluded = asked.iter().find_map(|one| {
            let other = asked.iter().find(|other| other.name == one.name && one.excludes(other))?;
            let (name, low, high) = (&one.name, one.shown(), other.shown());
            Some((one.line, format!("`this.{name} {low}` and `this.{name} {high}` are never true together")))
        });
        found.extend(excluded.map(|(line, what)| Remark::warning(line as usize, what)));
    }
    node.for_each_child(&mut |child| look(child, script, found));
}
