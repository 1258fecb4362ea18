//! Maps, in the order of their keys.

use super::{Function, change, read, unfit};
use crate::rules::script::data::{Data, Entries};
use crate::rules::script::meter::{self, Meter, text_steps};
use crate::rules::script::stop::{Answer, fail};

pub static FUNCTIONS: [Function; 4] = [
    read("keys", 0, 0, |interpreter, subject, arguments| match subject {
        Data::Map(entries) => {
            interpreter.meter.values(entries.len())?;
            Ok(Data::List(entries.keys().map(|key| Data::Text(key.clone())).collect()))
        }
        other => Err(unfit("keys", other, &arguments)),
    }),
    read("values", 0, 0, |interpreter, subject, arguments| match subject {
        Data::Map(entries) => {
            interpreter.meter.values(entries.len())?;
            let values = entries.values().map(|value| value.copy(interpreter.meter));
            Ok(Data::List(values.collect::<Result<_, _>>()?))
        }
        other => Err(unfit("values", other, &arguments)),
    }),
    change("mixin", 1, 1, |interpreter, subject, arguments| add("mixin", subject, arguments, true, interpreter.meter)),
    change("fill_with", 1, 1, |interpreter, subject, arguments| {
        add("fill_with", subject, arguments, false, interpreter.meter)
    }),
];

/// Takes the entry with a key out.
pub fn remove(entries: &mut Entries, key: &str, meter: &mut Meter) -> Answer {
    meter.charge(text_steps(key.len()) * 12)?;
    Ok(entries.remove(key).unwrap_or_default())
}

/// Puts the entries of another map in, over those that are there or beside them.
fn add(name: &str, subject: &mut Data, mut arguments: Vec<Data>, over: bool, meter: &mut Meter) -> Answer {
    let Data::Map(entries) = subject else { return Err(unfit(name, subject, &arguments)) };
    let Data::Map(more) = arguments.remove(0) else { return Err(fail(format!("{name} takes a map"))) };
    for (key, value) in more {
        meter.charge(1 + text_steps(key.len()) * 12)?;
        if over || !entries.contains_key(&key) {
            entries.insert(key, value);
        }
        meter::check_items(entries.len())?;
    }
    Ok(Data::Unit)
}
