//! Where a part of a value stands: a map's entry, a list's item.

use super::data::Data;
use super::meter::{self, Meter};
use super::position::position;
use super::stop::{Stop, fail};
use super::text;
use std::sync::Arc;

/// What leads from a value to a part of it.
#[derive(Debug)]
pub enum Key {
    /// `.name`.
    Property(Arc<str>),
    /// `[index]`.
    Index(Data),
}

/// What a key leads to.
pub enum Found<P> {
    /// A part that stands in the value.
    Place(P),
    /// Something that is made from it: a text's letter, a length.
    Value(Data),
}

/// The part of a value that a key leads to.
///
/// # Errors
/// If the value has no such part.
pub fn enter<'a>(value: &'a Data, key: &Key, meter: &mut Meter) -> Result<Found<&'a Data>, Stop> {
    Ok(match (value, key) {
        (Data::Map(entries), _) => match entries.get(&**name(key, meter)?) {
            Some(entry) => Found::Place(entry),
            None => Found::Value(Data::Unit),
        },
        (Data::List(items), Key::Index(Data::Int(index))) => Found::Place(&items[position(*index, items.len())?]),
        (value, key) => Found::Value(made(value, key, meter)?),
    })
}

/// The same in a value that may be changed there.
///
/// # Errors
/// If the value has no such part.
pub fn enter_mut<'a>(value: &'a mut Data, key: &Key, meter: &mut Meter) -> Result<Found<&'a mut Data>, Stop> {
    Ok(match (value, key) {
        (Data::Map(entries), _) => match entries.get_mut(&**name(key, meter)?) {
            Some(entry) => Found::Place(entry),
            None => Found::Value(Data::Unit),
        },
        (Data::List(items), Key::Index(Data::Int(index))) => {
            let index = position(*index, items.len())?;
            Found::Place(&mut items[index])
        }
        (value, key) => Found::Value(made(value, key, meter)?),
    })
}

/// The place that keys lead to; a map gets an entry for the last one if it has none.
///
/// # Errors
/// If there is no such place.
pub fn follow<'a>(value: &'a mut Data, keys: &[Key], meter: &mut Meter) -> Result<&'a mut Data, Stop> {
    let Some((last, way)) = keys.split_last() else { return Ok(value) };
    let mut place = value;
    for key in way {
        place = existing(enter_mut(place, key, meter)?)?;
    }
    if let Data::Map(entries) = place {
        let key = name(last, meter)?;
        if !entries.contains_key(&**key) {
            meter::check_items(entries.len() + 1)?;
        }
        return Ok(entries.entry(key.clone()).or_default());
    }
    existing(enter_mut(place, last, meter)?)
}

fn existing(found: Found<&mut Data>) -> Result<&mut Data, Stop> {
    match found {
        Found::Place(place) => Ok(place),
        Found::Value(Data::Unit) => Err(fail("the map has no such entry to change a part of")),
        Found::Value(_) => Err(fail("this is a part of a text or a length, which cannot be changed")),
    }
}

/// What is made from a value, where nothing of it stands.
fn made(value: &Data, key: &Key, meter: &mut Meter) -> Result<Data, Stop> {
    match (value, key) {
        (Data::List(items), Key::Property(name)) if &**name == "len" => Ok(Data::count(items.len())),
        (Data::List(items), Key::Property(name)) if &**name == "is_empty" => Ok(Data::Bool(items.is_empty())),
        (Data::Text(whole), Key::Property(name)) if &**name == "len" => {
            meter.bytes(whole.len())?;
            Ok(Data::count(whole.chars().count()))
        }
        (Data::Text(whole), Key::Property(name)) if &**name == "is_empty" => Ok(Data::Bool(whole.is_empty())),
        (Data::Text(whole), Key::Index(Data::Int(index))) => text::letter(whole, *index, meter),
        (value, Key::Property(name)) => Err(fail(format!("a {} has no property \"{name}\"", value.type_name()))),
        (value, Key::Index(index)) => {
            Err(fail(format!("a {} cannot be indexed with a {}", value.type_name(), index.type_name())))
        }
    }
}

/// The name of a map's entry.
fn name<'a>(key: &'a Key, meter: &mut Meter) -> Result<&'a Arc<str>, Stop> {
    let (Key::Property(name) | Key::Index(Data::Text(name))) = key else {
        return Err(fail("a map's entries are named by texts"));
    };
    // A map finds an entry with a dozen comparisons, four of which are a step.
    meter.charge(1 + meter::text_steps(name.len()) * 3)?;
    Ok(name)
}
