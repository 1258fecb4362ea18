//! Values as texts, and the letters of texts.

use super::data::Data;
use super::meter::{self, Meter, text_steps};
use super::stop::{Answer, Stop};
use std::fmt::Write as _;

/// Writes a value behind a text, as a person reads it.
///
/// # Errors
/// If the text becomes too long, or the steps are spent.
pub fn write(value: &Data, text: &mut String, meter: &mut Meter) -> Result<(), Stop> {
    match value {
        Data::Text(part) => append(text, part, meter),
        // Nothing by itself is nothing to read.
        Data::Unit => Ok(()),
        other => write_quoted(other, text, meter),
    }
}

/// Writes a value as it stands in a list: texts in quotes.
fn write_quoted(value: &Data, text: &mut String, meter: &mut Meter) -> Result<(), Stop> {
    meter.charge(1)?;
    match value {
        Data::Unit => append(text, "()", meter),
        Data::Bool(flag) => append(text, if *flag { "true" } else { "false" }, meter),
        Data::Int(number) => append(text, &number.to_string(), meter),
        Data::Text(part) => append_quoted(text, part, meter),
        Data::List(items) => {
            append(text, "[", meter)?;
            for (index, item) in items.iter().enumerate() {
                append(text, if index == 0 { "" } else { ", " }, meter)?;
                write_quoted(item, text, meter)?;
            }
            append(text, "]", meter)
        }
        Data::Map(entries) => {
            append(text, "#{", meter)?;
            for (index, (key, value)) in entries.iter().enumerate() {
                append(text, if index == 0 { "" } else { ", " }, meter)?;
                append_quoted(text, key, meter)?;
                append(text, ": ", meter)?;
                write_quoted(value, text, meter)?;
            }
            append(text, "}", meter)
        }
        Data::Range(range) if range.inclusive => {
            append(text, &format!("{}..={}", range.first, range.end.saturating_sub(1)), meter)
        }
        Data::Range(range) => append(text, &format!("{}..{}", range.first, range.end), meter),
        Data::Function(_) => append(text, "Fn", meter),
    }
}

/// Appends a text in quotes, with what cannot stand in them behind a backslash.
fn append_quoted(text: &mut String, part: &str, meter: &mut Meter) -> Result<(), Stop> {
    // Letter by letter: slower than a copy.
    meter.values(part.len() / 4)?;
    append(text, &format!("{part:?}"), meter)
}

/// Appends a text, if there is room for it.
fn append(text: &mut String, part: &str, meter: &mut Meter) -> Result<(), Stop> {
    meter::check_text(text.len() + part.len())?;
    meter.charge(text_steps(part.len()))?;
    // Into memory: it has no way to fail.
    let _ = text.write_str(part);
    Ok(())
}

/// A value as a text.
///
/// # Errors
/// If it would be too long, or the steps are spent.
pub fn of(value: &Data, meter: &mut Meter) -> Answer {
    let mut text = String::new();
    write(value, &mut text, meter)?;
    Ok(Data::text(text))
}

/// A text that is as long as a text may be, and paid for.
///
/// # Errors
/// If it is too long, or the steps are spent.
pub fn made(text: String, meter: &mut Meter) -> Answer {
    meter::check_text(text.len())?;
    meter.bytes(text.len())?;
    Ok(Data::Text(text.into()))
}

/// The letters of a text, each a text.
pub fn letters(text: &str) -> impl Iterator<Item = Data> {
    text.chars().map(|letter| Data::text(letter.encode_utf8(&mut [0; 4])))
}

/// The letter of a text at this index from the front, or (below 0) from the back.
///
/// # Errors
/// If there is none.
pub fn letter(text: &str, index: i64, meter: &mut Meter) -> Answer {
    meter.bytes(2 * text.len())?;
    let position = super::position::position(index, text.chars().count())?;
    let letter = text.chars().nth(position).unwrap_or_default();
    Ok(Data::text(letter.encode_utf8(&mut [0; 4])))
}
