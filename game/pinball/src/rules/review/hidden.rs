//! Functions of a script that hide one of the game: what the game's were to do is never done.

use super::remark::Remark;
use crate::rules::handlers::line_of_function;
use crate::rules::script::Script;
use crate::rules::signatures::{self, written};

/// The functions that are called as one of the game with as many values.
pub fn remarks(script: &Script, rules: &str) -> Vec<Remark> {
    let told = script.functions().filter_map(|function| {
        let own = |one: &signatures::Signature| one.parameters().count() == function.parameters;
        let hidden: Vec<_> = signatures::of(&function.name).filter(own).collect();
        let name = &function.name;
        let hidden = (!hidden.is_empty()).then(|| written(hidden.into_iter()))?;
        let what =
            format!("the rules' own `{name}` hides the game's {hidden}, which is never called then; name it otherwise");
        Some(Remark::warning(line_of_function(name, rules), what))
    });
    told.collect()
}
