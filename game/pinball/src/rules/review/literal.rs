//! Literals: values that stand in a script, or in one of its constants, and hold no others.

use crate::rules::script::{Data, Kind, Node, Script};

/// The value of an expression, if it is a literal.
pub fn literal(node: &Node, script: &Script) -> Option<Data> {
    match &node.kind {
        Kind::Text(text) => Some(Data::Text(text.clone())),
        Kind::Int(number) => Some(Data::Int(*number)),
        Kind::Bool(flag) => Some(Data::Bool(*flag)),
        Kind::Unit => Some(Data::Unit),
        Kind::Constant(number) => plain(script.constant_value(*number)?),
        _ => None,
    }
}

/// The same value, if it holds no others.
pub fn plain(value: &Data) -> Option<Data> {
    match value {
        Data::Text(text) => Some(Data::Text(text.clone())),
        Data::Int(number) => Some(Data::Int(*number)),
        Data::Bool(flag) => Some(Data::Bool(*flag)),
        Data::Unit => Some(Data::Unit),
        _ => None,
    }
}

/// Whether both are the same literal.
pub fn same(one: &Data, two: &Data) -> bool {
    match (one, two) {
        (Data::Text(one), Data::Text(two)) => one == two,
        (Data::Int(one), Data::Int(two)) => one == two,
        (Data::Bool(one), Data::Bool(two)) => one == two,
        (Data::Unit, Data::Unit) => true,
        _ => false,
    }
}

/// A literal as it stands in a script.
pub fn shown(value: &Data) -> String {
    match value {
        Data::Text(text) => format!("\"{text}\""),
        Data::Int(number) => number.to_string(),
        Data::Bool(flag) => flag.to_string(),
        _ => "()".to_string(),
    }
}
