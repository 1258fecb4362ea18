//! Given: what is known before play of the type of a value.

use super::literal::plain;
use super::words::Words;
use crate::rules::script::{Data, Kind, Node, Script};
use crate::rules::signatures::Type;

/// What is known of a value.
pub struct Given {
    /// Its type; none of the three for an array, a map or nothing.
    pub is: Option<Type>,
    /// What it is, for a sentence.
    pub word: &'static str,
    /// The value, if it stands there.
    pub value: Option<Data>,
}

impl Given {
    /// What is known of a node, or else of the texts that it can be.
    pub fn of(node: Option<&Node>, words: &Words, script: &Script) -> Option<Given> {
        node.and_then(|node| of_node(node, script)).or(of_words(words))
    }
}

fn of_node(node: &Node, script: &Script) -> Option<Given> {
    let flag = |value| Some(Given { is: Some(Type::Flag), word: "true or false", value });
    let other = |word| Some(Given { is: None, word, value: None });
    match &node.kind {
        Kind::Text(text) => of_value(&Data::Text(text.clone())),
        Kind::Int(number) => of_value(&Data::Int(*number)),
        Kind::Bool(value) => flag(Some(Data::Bool(*value))),
        Kind::Constant(number) => of_value(script.constant_value(*number)?),
        Kind::Joined(_) => Some(Given { is: Some(Type::Text), word: "a text", value: None }),
        Kind::Not(_) | Kind::And(_) | Kind::Or(_) => flag(None),
        Kind::Binary(operator, _) if operator.compares() => flag(None),
        Kind::Host(function, values) => of_call(function.name, values.len()),
        Kind::List(_) => other("an array"),
        Kind::Map(_) => other("a map"),
        Kind::Unit => other("nothing"),
        Kind::Function(_) => other("a function"),
        _ => None,
    }
}

/// What a value is that stands in the script.
pub fn of_value(value: &Data) -> Option<Given> {
    let (is, word) = match value {
        Data::Text(_) => (Some(Type::Text), "a text"),
        Data::Int(_) => (Some(Type::Number), "a whole number"),
        Data::Bool(_) => (Some(Type::Flag), "true or false"),
        Data::List(_) => (None, "an array"),
        Data::Map(_) => (None, "a map"),
        _ => return None,
    };
    Some(Given { is, word, value: plain(value) })
}

/// What a function of the game gives.
fn of_call(function: &str, count: usize) -> Option<Given> {
    let (is, word) = match (function, count) {
        ("score", 0)
        | ("player" | "players" | "ball" | "now" | "random" | "time_left" | "balls_in_play" | "max_players", _) => {
            (Some(Type::Number), "a whole number")
        }
        ("playing" | "tilted" | "running" | "exists" | "closed" | "add_player" | "next_player", _) => {
            (Some(Type::Flag), "true or false")
        }
        ("scores", _) => (None, "an array"),
        _ => return None,
    };
    Some(Given { is, word, value: None })
}

/// A text that comes from elsewhere.
fn of_words(words: &Words) -> Option<Given> {
    let is_nothing = words.literals.is_empty() && words.told.is_empty();
    let value = words.only().map(|text| Data::Text(text.clone()));
    (!words.others && !is_nothing).then_some(Given { is: Some(Type::Text), word: "a text", value })
}
