//! Script memory: what a script remembers, with its bytes: every tick is hashed, and a script is called a few times a
//! second.

use super::value::Value;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A value that knows its own bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Memory {
    value: Value,
    /// What postcard makes of the value.
    bytes: Vec<u8>,
}

impl Memory {
    /// Remembers this.
    pub fn new(value: Value) -> Memory {
        let bytes = encode(&value);
        Memory { value, bytes }
    }

    /// Remembers this instead.
    pub fn set(&mut self, value: Value) {
        *self = Memory::new(value);
    }

    /// What is remembered.
    pub fn value(&self) -> &Value {
        &self.value
    }

    /// The value as bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

fn encode(value: &Value) -> Vec<u8> {
    // Into memory, of types that postcard knows: it has no way to fail.
    postcard::to_stdvec(value).unwrap_or_default()
}

impl Serialize for Memory {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Memory {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Memory, D::Error> {
        Value::deserialize(deserializer).map(Memory::new)
    }
}
