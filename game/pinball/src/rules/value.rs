//! Values: what the rules remember: plain data with one order, so that it can be saved, hashed and cloned.
//!
//! A script's own values may be functions or ranges; none of that survives an event. What does is this.

use super::script::Data;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Deepest nesting of lists and maps.
const MAX_DEPTH: usize = 16;
/// Most values in all.
const MAX_VALUES: usize = 20_000;
/// Most text in all, bytes.
const MAX_TEXT: usize = 262_144;

/// Plain data.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Value {
    /// Nothing: `()`.
    Unit,
    /// `true` or `false`.
    Bool(bool),
    /// A whole number.
    Int(i64),
    /// A text.
    Text(String),
    /// An array.
    List(Vec<Value>),
    /// An object map, by key.
    Map(BTreeMap<String, Value>),
}

/// The room that is left for what is remembered.
struct Room {
    values: usize,
    text: usize,
}

impl Value {
    /// An empty map: what a machine that has just been switched on remembers.
    pub fn empty_map() -> Value {
        Value::Map(BTreeMap::new())
    }

    /// The script's value as plain data.
    ///
    /// # Errors
    /// One clause that says what cannot be remembered: a function, a range, or too much of anything.
    pub fn from_script(value: Data) -> Result<Value, String> {
        Room { values: MAX_VALUES, text: MAX_TEXT }.convert(value, MAX_DEPTH)
    }

    /// The value as the script sees it.
    pub fn to_script(&self) -> Data {
        match self {
            Value::Unit => Data::Unit,
            Value::Bool(value) => Data::Bool(*value),
            Value::Int(value) => Data::Int(*value),
            Value::Text(text) => Data::text(text),
            Value::List(values) => Data::List(values.iter().map(Value::to_script).collect()),
            Value::Map(values) => {
                Data::Map(values.iter().map(|(key, value)| (key.as_str().into(), value.to_script())).collect())
            }
        }
    }
}

impl Room {
    fn convert(&mut self, value: Data, depth: usize) -> Result<Value, String> {
        self.values = self.values.checked_sub(1).ok_or_else(|| format!("more than {MAX_VALUES} values"))?;
        match value {
            Data::Unit => Ok(Value::Unit),
            Data::Bool(flag) => Ok(Value::Bool(flag)),
            Data::Int(number) => Ok(Value::Int(number)),
            Data::Text(text) => Ok(Value::Text(self.text(&text)?)),
            Data::List(_) | Data::Map(_) if depth == 0 => {
                Err(format!("lists and maps nested more than {MAX_DEPTH} deep"))
            }
            Data::List(values) => {
                let values = values.into_iter().map(|value| self.convert(value, depth - 1));
                Ok(Value::List(values.collect::<Result<_, _>>()?))
            }
            Data::Map(values) => {
                let entry =
                    |(key, value): (std::sync::Arc<str>, Data)| Ok((self.text(&key)?, self.convert(value, depth - 1)?));
                Ok(Value::Map(values.into_iter().map(entry).collect::<Result<_, String>>()?))
            }
            other => Err(format!("a value of the type {}", other.type_name())),
        }
    }

    fn text(&mut self, text: &str) -> Result<String, String> {
        let left = self.text.checked_sub(text.len());
        self.text = left.ok_or_else(|| format!("more than {MAX_TEXT} bytes of text"))?;
        Ok(text.to_string())
    }
}
