//! Texts: at most 4096 bytes, so that a search through one is bounded too.

use super::{Function, change, read, unfit};
use crate::rules::script::data::Data;
use crate::rules::script::meter::{self, Meter, text_steps};
use crate::rules::script::stop::{Answer, Stop, fail};
use crate::rules::script::text::{letters, made};
use std::sync::Arc;

pub static FUNCTIONS: [Function; 9] = [
    read("starts_with", 1, 1, |interpreter, subject, arguments| {
        compare("starts_with", subject, &arguments, interpreter.meter, |text, part| text.starts_with(part))
    }),
    read("ends_with", 1, 1, |interpreter, subject, arguments| {
        compare("ends_with", subject, &arguments, interpreter.meter, |text, part| text.ends_with(part))
    }),
    read("to_upper", 0, 0, |interpreter, subject, _| {
        rewritten("to_upper", subject, interpreter.meter, |text| text.to_uppercase())
    }),
    read("to_lower", 0, 0, |interpreter, subject, _| {
        rewritten("to_lower", subject, interpreter.meter, |text| text.to_lowercase())
    }),
    change("trim", 0, 0, |interpreter, subject, _| {
        *subject = rewritten("trim", subject, interpreter.meter, |text| text.trim().to_string())?;
        Ok(Data::Unit)
    }),
    read("sub_string", 1, 2, |interpreter, subject, arguments| match (subject, arguments.as_slice()) {
        (Data::Text(text), [Data::Int(first)]) => part(text, *first, i64::MAX, interpreter.meter),
        (Data::Text(text), [Data::Int(first), Data::Int(length)]) => part(text, *first, *length, interpreter.meter),
        (other, arguments) => Err(unfit("sub_string", other, arguments)),
    }),
    change("replace", 2, 2, |interpreter, subject, arguments| match (subject, arguments.as_slice()) {
        (Data::Text(text), [Data::Text(old), Data::Text(new)]) => {
            *text = replaced(text, old, new, interpreter.meter)?;
            Ok(Data::Unit)
        }
        (other, arguments) => Err(unfit("replace", other, arguments)),
    }),
    read("split", 0, 1, |interpreter, subject, arguments| match (subject, arguments.as_slice()) {
        (Data::Text(text), []) if text.is_empty() => pieces(text, std::iter::once(""), interpreter.meter),
        (Data::Text(text), []) => pieces(text, text.split_whitespace(), interpreter.meter),
        (Data::Text(text), [Data::Text(mark)]) if !mark.is_empty() => {
            interpreter.meter.charge(search_steps(text, mark))?;
            pieces(text, text.split(&**mark), interpreter.meter)
        }
        (other, arguments) => Err(unfit("split", other, arguments)),
    }),
    read("chars", 0, 0, |interpreter, subject, arguments| match subject {
        Data::Text(text) => {
            interpreter.meter.values(2 * text.len())?;
            Ok(Data::List(letters(text).collect()))
        }
        other => Err(unfit("chars", other, &arguments)),
    }),
];

/// The steps of looking for a part in a text: the search is linear in both.
pub fn search_steps(text: &str, part: &str) -> u64 {
    8 + 2 * (text_steps(text.len()) + text_steps(part.len()))
}

fn compare(name: &str, subject: &Data, arguments: &[Data], meter: &mut Meter, of: fn(&str, &str) -> bool) -> Answer {
    match (subject, arguments) {
        (Data::Text(text), [Data::Text(part)]) => {
            meter.bytes(part.len())?;
            Ok(Data::Bool(of(text, part)))
        }
        (other, arguments) => Err(unfit(name, other, arguments)),
    }
}

fn rewritten(name: &str, subject: &Data, meter: &mut Meter, of: fn(&str) -> String) -> Answer {
    match subject {
        Data::Text(text) => {
            // Letter by letter: slower than a copy.
            meter.values(text.len() / 4)?;
            made(of(text), meter)
        }
        other => Err(unfit(name, other, &[])),
    }
}

/// So many letters from this one on; below 0 it is counted from the end.
fn part(text: &str, first: i64, length: i64, meter: &mut Meter) -> Answer {
    meter.values(text.len() / 4)?;
    let count = text.chars().count() as i64;
    let first = if first < 0 { (count.saturating_add(first)).max(0) } else { first };
    let skipped = usize::try_from(first).unwrap_or(0);
    let taken = usize::try_from(length).unwrap_or(0);
    made(text.chars().skip(skipped).take(taken).collect(), meter)
}

/// The text with every `old` made `new`, whose length is known before it is written.
///
/// # Errors
/// If there is nothing to replace, the text would become too long, or the steps are spent.
pub fn replaced(text: &str, old: &str, new: &str, meter: &mut Meter) -> Result<Arc<str>, Stop> {
    if old.is_empty() {
        return Err(fail("there must be something to replace"));
    }
    meter.charge(2 * search_steps(text, old))?;
    let times = text.matches(old).count();
    let length = text.len() - times * old.len() + times * new.len();
    meter::check_text(length)?;
    meter.charge(text_steps(length) + times as u64)?;
    Ok(text.replace(old, new).into())
}

/// Parts of a text as a list.
fn pieces<'a>(text: &str, parts: impl Iterator<Item = &'a str>, meter: &mut Meter) -> Answer {
    meter.values(text.len() / 4)?;
    let mut list = Vec::new();
    for part in parts {
        meter.charge(2 + text_steps(part.len()))?;
        list.push(Data::text(part));
    }
    meter::check_items(list.len())?;
    Ok(Data::List(list))
}
