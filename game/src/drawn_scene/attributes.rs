//! The `data-` attributes of a shape: read by name in their ranges, and known afterwards which were read.

use pinball::table::DrawnShape;
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// The attributes of one shape.
pub struct Attributes<'a> {
    shape: &'a DrawnShape,
    read: RefCell<BTreeSet<&'static str>>,
}

impl<'a> Attributes<'a> {
    pub fn new(shape: &'a DrawnShape) -> Attributes<'a> {
        Attributes { shape, read: RefCell::default() }
    }

    /// The text of an attribute.
    pub fn text(&self, name: &'static str) -> Option<&'a str> {
        self.read.borrow_mut().insert(name);
        self.shape.data.get(name).map(|text| text.trim())
    }

    /// A number in its range, if it is given.
    pub fn number(&self, name: &'static str, range: RangeInclusive<f64>) -> Result<Option<f64>, String> {
        let Some(text) = self.text(name) else { return Ok(None) };
        match text.parse::<f64>() {
            Ok(number) if range.contains(&number) => Ok(Some(number)),
            _ => {
                Err(format!("its `data-{name}` is `{text}`; write a number from {} to {}", range.start(), range.end()))
            }
        }
    }

    /// Two numbers in their range, the first below the second, if they are given.
    pub fn interval(&self, name: &'static str, range: RangeInclusive<f64>) -> Result<Option<[f64; 2]>, String> {
        let Some(text) = self.text(name) else { return Ok(None) };
        let numbers: Vec<f64> = text.split_whitespace().flat_map(str::parse).collect();
        match numbers[..] {
            [from, to] if from < to && range.contains(&from) && range.contains(&to) => Ok(Some([from, to])),
            _ => Err(format!(
                "its `data-{name}` is `{text}`; write two numbers from {} to {}, the smaller one first",
                range.start(),
                range.end()
            )),
        }
    }

    /// Whether something is so.
    pub fn flag(&self, name: &'static str) -> Result<bool, String> {
        match self.text(name) {
            None | Some("no") => Ok(false),
            Some("yes") => Ok(true),
            Some(text) => Err(format!("its `data-{name}` is `{text}`; write `yes` or `no`")),
        }
    }

    /// The names of the shape's own attributes that nobody has read.
    pub fn unread(&self) -> Vec<&'a str> {
        let read = self.read.borrow();
        self.shape.own_data.iter().map(String::as_str).filter(|name| !read.contains(name)).collect()
    }

    /// The names that were asked for.
    pub fn known(&self) -> Vec<&'static str> {
        self.read.borrow().iter().copied().collect()
    }
}
