//! Lists, changed where they stand.

use super::{Function, change, read, unfit};
use crate::rules::script::data::Data;
use crate::rules::script::meter::{self, Meter};
use crate::rules::script::position::{offset, position};
use crate::rules::script::stop::{Answer, Stop, fail};

pub static FUNCTIONS: [Function; 11] = [
    change("push", 1, 1, |_, subject, mut arguments| {
        let items = of("push", subject, &arguments)?;
        meter::check_items(items.len() + 1)?;
        items.push(arguments.remove(0));
        Ok(Data::Unit)
    }),
    change("append", 1, 1, |interpreter, subject, mut arguments| {
        let items = of("append", subject, &arguments)?;
        let Data::List(more) = arguments.remove(0) else { return Err(fail("append takes a list")) };
        meter::check_items(items.len() + more.len())?;
        interpreter.meter.values(more.len())?;
        items.extend(more);
        Ok(Data::Unit)
    }),
    change("insert", 2, 2, |interpreter, subject, mut arguments| {
        let items = of("insert", subject, &arguments)?;
        let Data::Int(index) = arguments.remove(0) else { return Err(fail("insert takes a position and a value")) };
        meter::check_items(items.len() + 1)?;
        moved(items.len(), interpreter.meter)?;
        items.insert(offset(index, items.len()), arguments.remove(0));
        Ok(Data::Unit)
    }),
    change("pop", 0, 0, |_, subject, arguments| Ok(of("pop", subject, &arguments)?.pop().unwrap_or_default())),
    change("shift", 0, 0, |interpreter, subject, arguments| {
        let items = of("shift", subject, &arguments)?;
        moved(items.len(), interpreter.meter)?;
        Ok(if items.is_empty() { Data::Unit } else { items.remove(0) })
    }),
    change("reverse", 0, 0, |interpreter, subject, arguments| {
        let items = of("reverse", subject, &arguments)?;
        interpreter.meter.values(items.len())?;
        items.reverse();
        Ok(Data::Unit)
    }),
    change("truncate", 1, 1, |_, subject, arguments| {
        let count = size("truncate", &arguments)?;
        of("truncate", subject, &arguments)?.truncate(count);
        Ok(Data::Unit)
    }),
    change("chop", 1, 1, |interpreter, subject, arguments| {
        let count = size("chop", &arguments)?;
        let items = of("chop", subject, &arguments)?;
        moved(items.len(), interpreter.meter)?;
        items.drain(..items.len().saturating_sub(count));
        Ok(Data::Unit)
    }),
    change("pad", 2, 2, pad),
    read("extract", 1, 2, |interpreter, subject, arguments| match (subject, arguments.as_slice()) {
        (Data::List(items), [Data::Int(first)]) => extract(items, *first, i64::MAX, interpreter.meter),
        (Data::List(items), [Data::Int(first), Data::Int(length)]) => {
            extract(items, *first, *length, interpreter.meter)
        }
        (other, arguments) => Err(unfit("extract", other, arguments)),
    }),
    change("sort", 0, 1, |interpreter, subject, arguments| match (subject, arguments.as_slice()) {
        (Data::List(items), [] | [Data::Function(_)]) => {
            super::list_order::sort(interpreter, items, arguments.first())?;
            Ok(Data::Unit)
        }
        (other, arguments) => Err(unfit("sort", other, arguments)),
    }),
];

/// The subject's items.
pub fn of<'a>(name: &str, subject: &'a mut Data, arguments: &[Data]) -> Result<&'a mut Vec<Data>, Stop> {
    match subject {
        Data::List(items) => Ok(items),
        other => Err(unfit(name, other, arguments)),
    }
}

/// Takes the item at an index out.
pub fn remove(items: &mut Vec<Data>, index: i64, meter: &mut Meter) -> Answer {
    moved(items.len(), meter)?;
    Ok(position(index, items.len()).map_or(Data::Unit, |position| items.remove(position)))
}

/// The steps of moving items along, which is a copy of their bytes: two items are as long as four steps of text.
fn moved(count: usize, meter: &mut Meter) -> Result<(), Stop> {
    meter.values(count / 4)
}

fn size(name: &str, arguments: &[Data]) -> Result<usize, Stop> {
    match arguments.first() {
        Some(Data::Int(count)) => Ok(usize::try_from(*count).unwrap_or(0)),
        _ => Err(fail(format!("{name} takes a whole number"))),
    }
}

/// Makes a list or a text so long with copies of a value.
fn pad(interpreter: &mut crate::rules::script::Interpreter, subject: &mut Data, arguments: Vec<Data>) -> Answer {
    let length = size("pad", &arguments)?;
    let meter = &mut *interpreter.meter;
    match (subject, &arguments[1]) {
        (Data::List(items), value) => {
            meter::check_items(length)?;
            while items.len() < length {
                meter.charge(1)?;
                items.push(value.copy(meter)?);
            }
        }
        (Data::Text(text), Data::Text(part)) if !part.is_empty() => {
            meter.bytes(text.len())?;
            let (mut padded, mut count) = (text.to_string(), text.chars().count());
            while count < length {
                meter::check_text(padded.len() + part.len())?;
                meter.charge(1 + meter::text_steps(part.len()) * 2)?;
                padded.push_str(part);
                count += part.chars().count();
            }
            *text = padded.into();
        }
        (other, _) => return Err(unfit("pad", other, &arguments)),
    }
    Ok(Data::Unit)
}

/// Copies of so many items from this one on; below 0 it is counted from the end.
fn extract(items: &[Data], first: i64, length: i64, meter: &mut Meter) -> Answer {
    let first = offset(first, items.len());
    let count = usize::try_from(length).unwrap_or(0).min(items.len() - first);
    let part = &items[first..first + count];
    meter.values(part.len())?;
    Ok(Data::List(part.iter().map(|item| item.copy(meter)).collect::<Result<_, _>>()?))
}
