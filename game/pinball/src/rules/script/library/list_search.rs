//! Lists, gone through: searched, chosen from, made into others.

use super::{Function, change, list, read, unfit};
use crate::rules::script::Interpreter;
use crate::rules::script::data::Data;
use crate::rules::script::meter::{self, Meter};
use crate::rules::script::position::offset;
use crate::rules::script::stop::{Answer, Stop, fail};

pub static FUNCTIONS: [Function; 11] = [
    read("index_of", 1, 2, index_of),
    read("find", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("find", subject, &arguments)?;
        match first(interpreter, items, 0, function, true)? {
            Some(index) => items[index].copy(interpreter.meter),
            None => Ok(Data::Unit),
        }
    }),
    read("some", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("some", subject, &arguments)?;
        Ok(Data::Bool(first(interpreter, items, 0, function, true)?.is_some()))
    }),
    read("all", 1, 1, |interpreter, subject, arguments| {
        let (items, function) = parts("all", subject, &arguments)?;
        Ok(Data::Bool(first(interpreter, items, 0, function, false)?.is_none()))
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
            if says_yes(&call(interpreter, function, item, index)?) {
                chosen.push(item.copy(interpreter.meter)?);
            }
        }
        Ok(Data::List(chosen))
    }),
    change("for_each", 1, 1, |interpreter, subject, arguments| {
        parts("for_each", subject, &arguments)?;
        let items = list::of("for_each", subject, &arguments)?;
        items
            .iter_mut()
            .enumerate()
            .try_for_each(|(index, item)| change_item(interpreter, &arguments[0], item, index))?;
        Ok(Data::Unit)
    }),
    read("reduce", 1, 2, reduce),
    read("zip", 2, 2, zip),
    change("retain", 1, 1, retain),
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
        Some(Data::Int(from)) => *from,
        Some(_) => return Err(unfit("index_of", subject, &arguments)),
    };
    let found = match (subject, &arguments[0]) {
        (Data::List(items), function @ Data::Function(_)) => {
            let from = offset(from, items.len());
            first(interpreter, &items[from..], from, function, true)?
        }
        (Data::List(items), item) => position(items, item, offset(from, items.len()), interpreter.meter)?,
        (Data::Text(text), Data::Text(part)) => {
            interpreter.meter.charge(4 * super::text::search_steps(text, part))?;
            let from = offset(from, text.chars().count());
            // At its end a text holds nothing, not even an empty text.
            let start = text.char_indices().nth(from).map(|(byte, _)| byte);
            let byte = start.and_then(|start| text[start..].find(&**part).map(|byte| start + byte));
            byte.map(|byte| text[..byte].chars().count())
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

/// Keeps the items of which a function says `true`; gives the others.
fn retain(interpreter: &mut Interpreter, subject: &mut Data, arguments: Vec<Data>) -> Answer {
    let (items, function) = parts("retain", subject, &arguments)?;
    let answers = items.iter().enumerate().map(|(index, item)| call(interpreter, function, item, index));
    let kept = answers.map(|answer| Ok(says_yes(&answer?))).collect::<Result<Vec<bool>, Stop>>()?;
    let items = list::of("retain", subject, &arguments)?;
    let (mut left, mut taken) = (Vec::new(), Vec::new());
    for (item, kept) in items.drain(..).zip(kept) {
        if kept { left.push(item) } else { taken.push(item) }
    }
    *items = left;
    Ok(Data::List(taken))
}

/// Whether a function has said `true` of an item: anything else is a no.
fn says_yes(answer: &Data) -> bool {
    matches!(answer, Data::Bool(true))
}

/// The first item of which a function says this.
fn first(
    interpreter: &mut Interpreter,
    items: &[Data],
    from: usize,
    function: &Data,
    wanted: bool,
) -> Result<Option<usize>, Stop> {
    for (item, index) in items.iter().zip(from..) {
        if says_yes(&call(interpreter, function, item, index)?) == wanted {
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

/// Calls a function with an item as `this`, which it may change, and with the item's number if it takes one value.
fn change_item(interpreter: &mut Interpreter, function: &Data, item: &mut Data, index: usize) -> Result<(), Stop> {
    interpreter.meter.charge(1)?;
    let Data::Function(number) = function else { return Err(fail("this takes a function")) };
    let numbers = match interpreter.script.function(*number).parameters {
        0 => Vec::new(),
        _ => vec![Data::count(index)],
    };
    interpreter.call(*number, numbers, Some(item)).map(|_| ())
}

/// One value from all items: each is given with the value so far to a function that gives the next.
fn reduce(interpreter: &mut Interpreter, subject: &Data, mut arguments: Vec<Data>) -> Answer {
    let mut value = if arguments.len() == 2 { arguments.remove(1) } else { Data::Unit };
    let (items, function) = parts("reduce", subject, &arguments)?;
    let Data::Function(number) = function else { return Err(fail("reduce takes a function")) };
    for (index, item) in items.iter().enumerate() {
        let mut item = item.copy(interpreter.meter)?;
        value = match interpreter.script.function(*number).parameters {
            1 => interpreter.call(*number, vec![value], Some(&mut item))?,
            _ => call_with_two(interpreter, *number, [value, item], index)?,
        };
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
    for (index, (a, b)) in left.iter().zip(right).enumerate() {
        let pair = [a.copy(interpreter.meter)?, b.copy(interpreter.meter)?];
        zipped.push(call_with_two(interpreter, *number, pair, index)?);
    }
    Ok(Data::List(zipped))
}

/// Calls a function with two values, and with an item's number if it takes three.
fn call_with_two(interpreter: &mut Interpreter, number: u16, pair: [Data; 2], index: usize) -> Answer {
    let mut arguments = Vec::from(pair);
    if interpreter.script.function(number).parameters == 3 {
        arguments.push(Data::count(index));
    }
    interpreter.call(number, arguments, None)
}
