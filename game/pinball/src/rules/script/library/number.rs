//! Whole numbers: every function takes the same time whatever the number.

use super::{Function, read, unfit};
use crate::rules::script::data::{Data, Range};
use crate::rules::script::stop::{Answer, fail};

pub static FUNCTIONS: [Function; 10] = [
    read("abs", 0, 0, |_, subject, _| one("abs", subject, i64::checked_abs)),
    read("sign", 0, 0, |_, subject, _| one("sign", subject, |number| Some(number.signum()))),
    read("min", 1, 1, |_, subject, arguments| two("min", subject, &arguments, i64::min)),
    read("max", 1, 1, |_, subject, arguments| two("max", subject, &arguments, i64::max)),
    read("is_odd", 0, 0, |_, subject, _| ask("is_odd", subject, |number| number % 2 != 0)),
    read("is_even", 0, 0, |_, subject, _| ask("is_even", subject, |number| number % 2 == 0)),
    read("is_zero", 0, 0, |_, subject, _| ask("is_zero", subject, |number| number == 0)),
    read("parse_int", 0, 0, |interpreter, subject, arguments| match subject {
        Data::Text(text) => {
            interpreter.meter.bytes(text.len())?;
            text.trim().parse().map(Data::Int).map_err(|_| fail("this text is no whole number"))
        }
        other => Err(unfit("parse_int", other, &arguments)),
    }),
    read("range", 1, 2, |_, subject, arguments| match (subject, arguments.as_slice()) {
        (Data::Int(first), [Data::Int(end)]) => Ok(Data::Range(Range::exclusive(*first, *end))),
        (Data::Int(_), [Data::Int(_), Data::Int(0)]) => Err(fail("a range's step must not be 0")),
        (Data::Int(first), [Data::Int(end), Data::Int(step)]) => {
            Ok(Data::Range(Range { step: *step, ..Range::exclusive(*first, *end) }))
        }
        (other, arguments) => Err(unfit("range", other, arguments)),
    }),
    read("to_int", 0, 0, |_, subject, _| one("to_int", subject, Some)),
];

fn one(name: &str, subject: &Data, of: fn(i64) -> Option<i64>) -> Answer {
    match subject {
        Data::Int(number) => of(*number).map(Data::Int).ok_or_else(|| fail(format!("{name}: the number is too large"))),
        other => Err(unfit(name, other, &[])),
    }
}

fn two(name: &str, subject: &Data, arguments: &[Data], of: fn(i64, i64) -> i64) -> Answer {
    match (subject, arguments) {
        (Data::Int(one), [Data::Int(other)]) => Ok(Data::Int(of(*one, *other))),
        (other, arguments) => Err(unfit(name, other, arguments)),
    }
}

fn ask(name: &str, subject: &Data, of: fn(i64) -> bool) -> Answer {
    match subject {
        Data::Int(number) => Ok(Data::Bool(of(*number))),
        other => Err(unfit(name, other, &[])),
    }
}
