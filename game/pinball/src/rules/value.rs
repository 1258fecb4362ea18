//! Values: what the rules remember: plain data with one order, so that it can be saved, hashed and cloned.
//!
//! A script's own values may be shared, or be functions; none of that survives an event. What does is this.

use rhai::{Array, Dynamic, Map};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Deepest nesting of lists and maps.
const MAX_DEPTH: usize = 16;
/// Most values in all.
const MAX_VALUES: usize = 20_000;

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

impl Value {
    /// An empty map: what a machine that has just been switched on remembers.
    pub fn empty_map() -> Value {
        Value::Map(BTreeMap::new())
    }

    /// The script's value as plain data.
    ///
    /// # Errors
    /// One clause that says what cannot be remembered: a function, a range, or too much of anything.
    pub fn from_script(value: Dynamic) -> Result<Value, String> {
        convert(value, MAX_DEPTH, &mut MAX_VALUES.clone())
    }

    /// The value as the script sees it.
    pub fn to_script(&self) -> Dynamic {
        match self {
            Value::Unit => Dynamic::UNIT,
            Value::Bool(value) => (*value).into(),
            Value::Int(value) => (*value).into(),
            Value::Text(text) => text.as_str().into(),
            Value::List(values) => Dynamic::from_array(values.iter().map(Value::to_script).collect()),
            Value::Map(values) => {
                Dynamic::from_map(values.iter().map(|(key, value)| (key.as_str().into(), value.to_script())).collect())
            }
        }
    }
}

fn convert(value: Dynamic, depth: usize, left: &mut usize) -> Result<Value, String> {
    let value = value.flatten();
    *left = left.checked_sub(1).ok_or_else(|| format!("more than {MAX_VALUES} values"))?;
    if value.is_unit() {
        Ok(Value::Unit)
    } else if let Ok(flag) = value.as_bool() {
        Ok(Value::Bool(flag))
    } else if let Ok(number) = value.as_int() {
        Ok(Value::Int(number))
    } else if value.is_char() || value.is_string() {
        Ok(Value::Text(value.to_string()))
    } else if depth == 0 {
        Err(format!("lists and maps nested more than {MAX_DEPTH} deep"))
    } else if value.is_array() {
        let values = value.try_cast::<Array>().unwrap_or_default();
        Ok(Value::List(values.into_iter().map(|value| convert(value, depth - 1, left)).collect::<Result<_, _>>()?))
    } else if value.is_map() {
        let values = value.try_cast::<Map>().unwrap_or_default();
        let mut map = BTreeMap::new();
        for (key, value) in values {
            map.insert(key.to_string(), convert(value, depth - 1, left)?);
        }
        Ok(Value::Map(map))
    } else {
        Err(format!("a value of the type {}", value.type_name()))
    }
}
