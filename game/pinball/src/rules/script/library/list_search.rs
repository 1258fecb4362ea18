//! Lists, gone through: searched, chosen from, made into others.

use super::{Function, change, list, read, unfit};
use crate::rules::script::Interpreter;
use crate::rules::script::data::Data;
use crate::rules::script::meter::{self, Meter};
use crate::rules::script::stop::{Answer, Stop, fail};

pub static FUNCTIONS: [Function; 11] = [
    read("index_of", 1, 2, index_of),
    read("find", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("find", subject, &arguments)?;
        match first(interpreter, items, function, true)? {
            Some(index) => items[index].copy(interpreter.meter),
            None => Ok(Data::Unit),
        }
    }),
    read("some", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("some", subject, &arguments)?;
        Ok(Data::Bool(first(interpreter, items, function, true)?.is_some()))
    }),
    read("all", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("all", subject, &arguments)?;
        Ok(Data::Bool(first(interpreter, items, function, false)?.is_none()))
    }),
    read("map", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("map", subject, &arguments)?;
        let items = items.iter().enumerate().map(|(index, item)| call(interpreter, function, item, index));
        Ok(Data::List(items.collect::<Result<_, _>>()?))
    }),
    read("filter", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("filter", subject, &arguments)?;
        let mut chosen = Vec::new();
        for (index, item) in items.iter().enumerate() {
            if call(interpreter, function, item, index)?.condition()? {
                chosen.push(item.copy(interpreter.meter)?);
            }
        }
        Ok(Data::List(chosen))
    }),
    read("for_each", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("for_each", subject, &arguments)?;
        items.iter().enumerate().try_for_each(|(index, item)| call(interpreter, function, item, index).map(|_| ()))?;
        Ok(Data::Unit)
    }),
    read("reduce", 1, 2, reduce),
    read("zip", 2, 2, zip),
    change("retain", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("retain", subject, &arguments)?;
        let kept = items.iter().enumerate().map(|(index, item)| call(interpreter, function, item, index)?.condition());
        let mut kept = kept.collect::<Result<Vec<bool>, Stop>>()?.into_iter();
        list::of("retain", subject, &arguments)?.retain(|_| kept.next() == Some(true));
        Ok(Data::Unit)
    }),
    change("dedup", 0, 0, |interpreter, subject, arguments| {
        let items = list::of("dedup", subject, &arguments)?;
        let pairs = items.windows(2).map(|pair| pair[0].same(&pair[1], interpreter.meter));
        let mut again = std::iter::once(Ok(false)).chain(pairs).collect::<Result<Vec<bool>, Stop>>()?.into_iter();
        items.retain(|_| again.next() == Some(false));
        Ok(Data::Unit)
    }),
];

/// Where an item stands in a list, from a position on.
pub fn position(items: &[Data], item: &Data, from: usize, meter: &mut Meter) -> Result<Option<usize>, Stop> {
    for (index, other) in items.iter().enumerate().skip(from) {
        if other.same(item, meter)? {
            return Ok(Some(index));
        }
    }
    Ok(None)
}

/// Where something stands: an item or what a function says in a list, a text in a text; -1 if nowhere.
fn index_of(interpreter: &mut Interpreter, subject: &Data, arguments: Vec<Data>) -> Answer {
    let from = match arguments.get(1) {
        None => 0,
        Some(Data::Int(from)) => usize::try_from(*from).unwrap_or(0),
        Some(_) => return Err(unfit("index_of", subject, &arguments)),
    };
    let found = match (subject, &arguments[0]) {
        (Data::List(items), function @ Data::Function(_)) => {
            let rest = items.get(from..).unwrap_or_default();
            first(interpreter, rest, function, true)?.map(|index| index + from)
        }
        (Data::List(items), item) => position(items, item, from, interpreter.meter)?,
        (Data::Text(text), Data::Text(part)) => {
            interpreter.meter.charge(2 * super::text::search_steps(text, part))?;
            let start = text.char_indices().nth(from).map_or(text.len(), |(byte, _)| byte);
            text[start..].find(&**part).map(|byte| text[..start + byte].chars().count())
        }
        (other, _) => return Err(unfit("index_of", other, &arguments)),
    };
    Ok(found.map_or(Data::Int(-1), Data::count))
}

/// A list and the function that it is gone through with.
fn parts<'a>(name: &str, subject: &'a Data, arguments: &'a [Data]) -> Result<(&'a [Data], &'a Data), Stop> {
    match (subject, arguments) {
        (Data::List(items), [function @ Data::Function(_)]) => Ok((items, function)),
        (other, arguments) => Err(unfit(name, other, arguments)),
    }
}

/// The first item of which a function says this.
fn first(interpreter: &mut Interpreter, items: &[Data], function: &Data, wanted: bool) -> Result<Option<usize>, Stop> {
    for (index, item) in items.iter().enumerate() {
        if call(interpreter, function, item, index)?.condition()? == wanted {
            return Ok(Some(index));
        }
    }
    Ok(None)
}

/// Calls a function with an item: as its first value (the second is the item's number), or as `this` if it takes none.
fn call(interpreter: &mut Interpreter, function: &Data, item: &Data, index: usize) -> Answer {
    interpreter.meter.charge(1)?;
    let mut item = item.copy(interpreter.meter)?;
    let Data::Function(number) = function else { return Err(fail("this takes a function")) };
    match interpreter.script.function(*number).parameters {
        0 => interpreter.call(*number, Vec::new(), Some(&mut item)),
        1 => interpreter.call(*number, vec![item], None),
        _ => interpreter.call(*number, vec![item, Data::count(index)], None),
    }
}

/// One value from all items: each is given with the value so far to a function that gives the next.
fn reduce(interpreter: &mut Interpreter, subject: &Data, mut arguments: Vec<Data>) -> Answer {
    let mut value = if arguments.len() == 2 { arguments.remove(1) } else { Data::Unit };
    let (items, function) = parts("reduce", subject, &arguments)?;
    let Data::Function(number) = function else { return Err(fail("reduce takes a function")) };
    for item in items {
        let item = item.copy(interpreter.meter)?;
        value = interpreter.call(*number, vec![value, item], None)?;
    }
    Ok(value)
}

/// What a function makes of the items of two lists that stand at the same place.
fn zip(interpreter: &mut Interpreter, subject: &Data, arguments: Vec<Data>) -> Answer {
    let (Data::List(left), [Data::List(right), Data::Function(number)]) = (subject, arguments.as_slice()) else {
        return Err(unfit("zip", subject, &arguments));
    };
    meter::check_items(left.len().min(right.len()))?;
    let mut zipped = Vec::new();
    for (a, b) in left.iter().zip(right) {
        let pair = vec![a.copy(interpreter.meter)?, b.copy(interpreter.meter)?];
        zipped.push(interpreter.call(*number, pair, None)?);
    }
    Ok(Data::List(zipped))
}
