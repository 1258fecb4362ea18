//! What a person is told of a failure. A script that catches it gets the text that it always had: what that does is part
//! of games that were recorded.

use super::data::Data;
use super::interpreter::Frame;
use super::node::{Chain, Kind, Node, Root, StepKind};
use super::stop::{Failed, FailureKind, Stop};
use crate::spelling;
use std::sync::Arc;

/// Entries among which one is sought that is like the one that is not there.
const MAX_ENTRIES: usize = 256;

/// Rhai's words for what values are, as they stand in sentences, and a person's.
const TYPES: [(&str, &str); 9] = [
    ("()", "nothing"),
    ("i64", "a whole number"),
    ("bool", "true or false"),
    ("string", "a text"),
    ("array", "an array"),
    ("map", "a map"),
    ("Fn", "a function"),
    ("range=", "a range"),
    ("range", "a range"),
];

/// The failure of a node, with the entry of `this` that it needs and that is not there.
pub fn with_unset(mut stop: Stop, node: &Node, frame: &Frame) -> Stop {
    if let Stop::Failed(failed) = &mut stop
        && failed.unset.is_none()
    {
        let is_own = failed.kind == FailureKind::Catchable;
        let found = frame.this.as_deref().filter(|_| is_own).and_then(|this| unset(node, this));
        failed.unset = Some(found.unwrap_or_default());
    }
    stop
}

/// The entry of `this` that a node uses and that holds nothing.
fn unset(node: &Node, this: &Data) -> Option<Vec<Arc<str>>> {
    let own = match &node.kind {
        Kind::Chain(chain) => unset_step(chain, this),
        Kind::Assign(assign) => unset_step(&assign.place, this),
        _ => None,
    };
    let mut found = own;
    node.for_each_child(&mut |child| {
        if let (None, Kind::Chain(chain)) = (&found, &child.kind) {
            found = unset_step(chain, this);
        }
    });
    found
}

fn unset_step(chain: &Chain, this: &Data) -> Option<Vec<Arc<str>>> {
    let Root::This = chain.root else { return None };
    let mut place = this;
    let mut path = Vec::new();
    for step in &chain.steps {
        let (StepKind::Property(name), Data::Map(entries)) = (&step.kind, place) else { return None };
        path.push(name.clone());
        match entries.get(name) {
            None | Some(Data::Unit) => return Some(path),
            Some(entry) => place = entry,
        }
    }
    None
}

impl Failed {
    /// What has failed as the script would catch it.
    pub fn sentence(&self, spent: &str) -> String {
        match (&self.what, self.kind) {
            (_, FailureKind::Spent) => spent.to_string(),
            (Data::Text(text), _) => text.to_string(),
            (Data::Int(number), _) => number.to_string(),
            (other, _) => format!("the script has thrown a {}", other.type_name()),
        }
    }

    /// What has failed as a person is told it, with what the script remembers.
    pub fn told(&self, spent: &str, this: &Data) -> String {
        let sentence = self.sentence(spent);
        if self.kind != FailureKind::Catchable {
            return match (&self.what, self.kind) {
                (_, FailureKind::Spent) | (Data::Text(_) | Data::Int(_), _) => sentence,
                (other, _) => format!("the script has thrown {}", plain_type(other.type_name())),
            };
        }
        let sentence = in_plain_words(&sentence);
        match self.unset.as_deref() {
            Some([way @ .., last]) => {
                let path = |name: &str| -> String {
                    way.iter()
                        .map(|name| &**name)
                        .chain([name])
                        .fold("this".to_string(), |path, name| path + "." + name)
                };
                let place = way.iter().try_fold(this, |place, name| match place {
                    Data::Map(entries) => entries.get(name),
                    _ => None,
                });
                let set = match place {
                    Some(Data::Map(entries)) => entries.iter().filter(|(_, value)| !matches!(value, Data::Unit)),
                    _ => return format!("{sentence}: {} was never set", path(last)),
                };
                let meant = spelling::near(last, set.take(MAX_ENTRIES).map(|(name, _)| &**name));
                let meant = meant.map_or_else(String::new, |meant| format!("; did you mean {}?", path(meant)));
                format!("{sentence}: {} was never set{meant}", path(last))
            }
            _ => sentence,
        }
    }
}

/// A person's words for what a value is.
fn plain_type(own: &str) -> &str {
    TYPES.iter().find(|(word, _)| *word == own).map_or(own, |found| found.1)
}

/// A sentence with a person's words for what values are.
fn in_plain_words(sentence: &str) -> String {
    let mut plain = sentence.to_string();
    if ["size", "length", "count"].iter().any(|name| sentence.ends_with(&format!(" has no property \"{name}\""))) {
        plain.push_str("; `len()` counts what is in it");
    }
    if sentence == "append takes a list" {
        return "append takes an array; `push` adds one value".to_string();
    }
    if let Some((before, types)) = sentence.split_once(" cannot be called with (")
        && let Some(types) = types.strip_suffix(')')
    {
        let types: Vec<&str> = types.split(", ").map(plain_type).collect();
        let why = match (before, &*types.join(", ")) {
            ("split", "a text, a text") => ": its mark has no letter; `chars` gives each letter by itself",
            ("pad", "a text, a whole number, a text") => ": the text to fill up with has no letter",
            _ => "",
        };
        return format!("{before} cannot be called with {}{why}", types.join(", "));
    }
    for (word, own) in TYPES {
        for beginning in [" a ", " not "] {
            let end = if beginning == " a " { own.to_string() } else { format!("not {own}") };
            plain = plain.replace(&format!("{beginning}{word}"), &format!(" {end}"));
        }
        if let Some(rest) = plain.strip_prefix(&format!("a {word} ")) {
            plain = format!("{own} {rest}");
        }
    }
    plain
}
