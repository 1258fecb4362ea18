//! The fields of an object in a scene's JSON: read by name, with what was expected, and known afterwards which were read.

use geometry::DVec2;
use serde_json::{Map, Value};
use std::cell::RefCell;
use std::collections::BTreeSet;

/// Coordinates and other numbers are at most this large.
const LARGEST: f64 = 1e9;

/// An object of a scene.
pub struct Fields<'a> {
    map: &'a Map<String, Value>,
    read: RefCell<BTreeSet<&'static str>>,
}

impl<'a> Fields<'a> {
    pub fn new(map: &'a Map<String, Value>) -> Fields<'a> {
        Fields { map, read: RefCell::default() }
    }

    fn get(&self, name: &'static str) -> Option<&'a Value> {
        self.read.borrow_mut().insert(name);
        self.map.get(name)
    }

    /// A number; `default` if there is none.
    pub fn number(&self, name: &'static str, default: f64) -> Result<f64, String> {
        match self.get(name) {
            None => Ok(default),
            Some(value) => number(value).ok_or_else(|| format!("\"{name}\" must be a number between -1e9 and 1e9")),
        }
    }

    /// Whether something is so; `default` if nothing is said.
    pub fn flag(&self, name: &'static str, default: bool) -> Result<bool, String> {
        match self.get(name) {
            None => Ok(default),
            Some(value) => value.as_bool().ok_or_else(|| format!("\"{name}\" must be true or false")),
        }
    }

    /// A text; `None` if there is none.
    pub fn text(&self, name: &'static str) -> Result<Option<&'a str>, String> {
        match self.get(name) {
            None => Ok(None),
            Some(value) => value.as_str().map(Some).ok_or_else(|| format!("\"{name}\" must be a text")),
        }
    }

    /// A point, which must be there.
    pub fn point(&self, name: &'static str) -> Result<DVec2, String> {
        let value = self.get(name).ok_or_else(|| format!("\"{name}\" is missing: a point {{\"x\": .., \"y\": ..}}"))?;
        point(value).ok_or_else(|| format!("\"{name}\" must be a point {{\"x\": .., \"y\": ..}}"))
    }

    /// A list, which must be there.
    pub fn list(&self, name: &'static str) -> Result<&'a [Value], String> {
        let list = self.get(name).and_then(Value::as_array);
        list.map(Vec::as_slice).ok_or_else(|| format!("\"{name}\" must be a list"))
    }

    /// Fields that matter to nothing but the editor's picture.
    pub fn ignore(&self, names: &[&'static str]) {
        self.read.borrow_mut().extend(names);
    }

    /// The names of fields that nobody has read.
    pub fn unread(&self) -> Vec<&'a str> {
        let read = self.read.borrow();
        self.map.keys().map(String::as_str).filter(|name| !read.contains(name)).collect()
    }
}

/// A number of the right size.
pub fn number(value: &Value) -> Option<f64> {
    value.as_f64().filter(|number| number.abs() <= LARGEST)
}

/// A point.
pub fn point(value: &Value) -> Option<DVec2> {
    let coordinate = |name: &str| value.get(name).and_then(number);
    Some(DVec2::new(coordinate("x")?, coordinate("y")?))
}
