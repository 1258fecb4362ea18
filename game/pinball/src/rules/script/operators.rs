//! What stands between two values: whole numbers are checked, texts grow, lists and maps join.

use super::data::{Data, Entries, Range};
use super::meter::{self, Meter};
use super::node::Operator;
use super::stop::{Answer, Stop, fail};
use super::text;
use std::cmp::Ordering;
use std::sync::Arc;

/// Left and right as one.
///
/// # Errors
/// If the two have nothing to do with each other, or a number would be too large.
pub fn apply(operator: Operator, left: Data, right: Data, meter: &mut Meter) -> Answer {
    match operator {
        Operator::Equal => Ok(Data::Bool(left.same(&right, meter)?)),
        Operator::NotEqual => Ok(Data::Bool(!left.same(&right, meter)?)),
        Operator::Less | Operator::LessOrEqual | Operator::Greater | Operator::GreaterOrEqual => {
            match left.order(&right, meter)? {
                Some(order) => Ok(Data::Bool(holds(operator, order))),
                // Values of two types are neither, nor is nothing; those of one type that has no order cannot be asked.
                None if left.type_name() != right.type_name() => Ok(Data::Bool(false)),
                None if matches!(left, Data::Unit) => Ok(Data::Bool(false)),
                None => Err(unfit(operator, &left, &right)),
            }
        }
        _ => match (left, right) {
            (Data::Int(left), Data::Int(right)) => number(operator, left, right),
            (Data::Bool(left), Data::Bool(right)) => flag(operator, left, right),
            (Data::Int(first), Data::Unit) if is_range(operator) => number(operator, first, i64::MAX),
            (Data::Unit, Data::Int(end)) if is_range(operator) => number(operator, 0, end),
            (Data::Text(whole), Data::Text(part)) if operator == Operator::Subtract => without(whole, &part, meter),
            (left, right) if operator == Operator::Add => joined(left, right, meter),
            (left, right) => Err(unfit(operator, &left, &right)),
        },
    }
}

/// Changes a value: a list or a map grows where it stands.
///
/// # Errors
/// If the two have nothing to do with each other; then the value is as before.
pub fn assign(operator: Operator, place: &mut Data, value: Data, meter: &mut Meter) -> Result<(), Stop> {
    match (place, value) {
        (Data::List(items), Data::List(more)) if operator == Operator::Add => append(items, more, meter),
        (Data::List(items), value) if operator == Operator::Add => {
            meter::check_items(items.len() + 1)?;
            items.push(value);
            Ok(())
        }
        (Data::Map(entries), Data::Map(more)) if operator == Operator::Add => insert_all(entries, more, meter),
        (place, value) => {
            let old = place.copy(meter)?;
            *place = apply(operator, old, value, meter)?;
            Ok(())
        }
    }
}

fn append(items: &mut Vec<Data>, more: Vec<Data>, meter: &mut Meter) -> Result<(), Stop> {
    meter::check_items(items.len() + more.len())?;
    meter.values(more.len())?;
    items.extend(more);
    Ok(())
}

fn insert_all(entries: &mut Entries, more: Entries, meter: &mut Meter) -> Result<(), Stop> {
    for (key, value) in more {
        meter.charge(1 + meter::text_steps(key.len()) * 12)?;
        entries.insert(key, value);
        meter::check_items(entries.len())?;
    }
    Ok(())
}

/// The number below 0 that is as far from it.
///
/// # Errors
/// If it is no number, or has no opposite.
pub fn negative(value: &Data) -> Answer {
    match value {
        Data::Int(number) => number.checked_neg().map(Data::Int).ok_or_else(|| fail("the number is too large")),
        other => Err(fail(format!("a {} has no opposite", other.type_name()))),
    }
}

fn is_range(operator: Operator) -> bool {
    matches!(operator, Operator::Range | Operator::InclusiveRange)
}

fn holds(operator: Operator, order: Ordering) -> bool {
    match operator {
        Operator::Less => order.is_lt(),
        Operator::LessOrEqual => order.is_le(),
        Operator::Greater => order.is_gt(),
        _ => order.is_ge(),
    }
}

fn number(operator: Operator, left: i64, right: i64) -> Answer {
    let zero = || fail(format!("{left} cannot be divided by 0"));
    let value = match operator {
        Operator::Add => left.checked_add(right),
        Operator::Subtract => left.checked_sub(right),
        Operator::Multiply => left.checked_mul(right),
        Operator::Divide | Operator::Remainder if right == 0 => return Err(zero()),
        Operator::Divide => left.checked_div(right),
        Operator::Remainder => left.checked_rem(right),
        Operator::Power => u32::try_from(right).ok().and_then(|power| left.checked_pow(power)),
        Operator::ShiftLeft => Some(shifted(left, right)),
        Operator::ShiftRight => Some(shifted(left, right.saturating_neg())),
        Operator::BitAnd => Some(left & right),
        Operator::BitOr => Some(left | right),
        Operator::BitXor => Some(left ^ right),
        Operator::Range => return Ok(Data::Range(Range::exclusive(left, right))),
        Operator::InclusiveRange => return Ok(Data::Range(Range::inclusive(left, right))),
        _ => None,
    };
    value.map(Data::Int).ok_or_else(|| fail(format!("{left} {} {right} is no whole number of 64 bits", sign(operator))))
}

/// Shifted to the left, or (by a number below 0) to the right; what goes over the edge is gone.
fn shifted(number: i64, left: i64) -> i64 {
    match u32::try_from(left.unsigned_abs()) {
        Ok(bits) if left >= 0 => number.checked_shl(bits).unwrap_or(0),
        Ok(bits) => number >> bits.min(i64::BITS - 1),
        Err(_) if left >= 0 => 0,
        Err(_) => number >> (i64::BITS - 1),
    }
}

fn flag(operator: Operator, left: bool, right: bool) -> Answer {
    match operator {
        Operator::BitAnd => Ok(Data::Bool(left & right)),
        Operator::BitOr => Ok(Data::Bool(left | right)),
        Operator::BitXor => Ok(Data::Bool(left ^ right)),
        _ => Err(unfit(operator, &Data::Bool(left), &Data::Bool(right))),
    }
}

/// `+` of what is not two numbers: a list or a map grows; where one side is a text the other is written.
fn joined(left: Data, right: Data, meter: &mut Meter) -> Answer {
    match (left, right) {
        (Data::List(mut items), Data::List(more)) => {
            append(&mut items, more, meter)?;
            Ok(Data::List(items))
        }
        (Data::Map(mut entries), Data::Map(more)) => {
            insert_all(&mut entries, more, meter)?;
            Ok(Data::Map(entries))
        }
        (left, right) if matches!(left, Data::Text(_)) || matches!(right, Data::Text(_)) => {
            let mut whole = String::new();
            text::write(&left, &mut whole, meter)?;
            text::write(&right, &mut whole, meter)?;
            meter.bytes(whole.len())?;
            Ok(Data::text(whole))
        }
        (left, right) => Err(unfit(Operator::Add, &left, &right)),
    }
}

/// `-` of two texts: the first without the second, wherever it stands.
fn without(whole: Arc<str>, part: &str, meter: &mut Meter) -> Answer {
    if part.is_empty() {
        return Ok(Data::Text(whole));
    }
    Ok(Data::Text(super::library::replaced(&whole, part, "", meter)?))
}

fn unfit(operator: Operator, left: &Data, right: &Data) -> Stop {
    let (left, right) = (left.type_name(), right.type_name());
    fail(format!("`{}` does not go between a {left} and a {right}", sign(operator)))
}

/// Every operator as it is written.
const SIGNS: [(&str, Operator); 19] = [
    ("+", Operator::Add),
    ("-", Operator::Subtract),
    ("*", Operator::Multiply),
    ("/", Operator::Divide),
    ("%", Operator::Remainder),
    ("**", Operator::Power),
    ("<<", Operator::ShiftLeft),
    (">>", Operator::ShiftRight),
    ("&", Operator::BitAnd),
    ("|", Operator::BitOr),
    ("^", Operator::BitXor),
    ("==", Operator::Equal),
    ("!=", Operator::NotEqual),
    ("<", Operator::Less),
    ("<=", Operator::LessOrEqual),
    (">", Operator::Greater),
    (">=", Operator::GreaterOrEqual),
    ("..", Operator::Range),
    ("..=", Operator::InclusiveRange),
];

fn sign(operator: Operator) -> &'static str {
    SIGNS.iter().find(|(_, other)| *other == operator).map_or("", |(sign, _)| sign)
}

/// The operator that is written so.
pub fn named(sign: &str) -> Option<Operator> {
    SIGNS.iter().find(|(name, _)| *name == sign).map(|(_, operator)| *operator)
}
