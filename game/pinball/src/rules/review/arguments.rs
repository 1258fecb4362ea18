//! Arguments: what the game's functions are given that they do not take, where it stands in the script.

use super::facts::{Call, Facts};
use super::given::Given;
use super::literal::{plain, shown};
use super::remark::Remark;
use crate::rules::host_function::ScriptContext;
use crate::rules::script::{Data, Kind, Script};
use crate::rules::script_state::ScriptState;
use crate::rules::signatures::{self, Signature, Type};
use std::sync::Arc;

/// What the functions of the game do not take.
pub fn remarks(facts: &Facts, script: &Script, context: &mut ScriptContext) -> Vec<Remark> {
    let mut found = Vec::new();
    for call in &facts.calls {
        let given = given(call, script);
        let wrong = mistyped(call, &given).or_else(|| refused(call, &given, context));
        found.extend(wrong.map(|what| Remark::error(call.line as usize, what)));
        found.extend(idle(call, &given).map(|what| Remark::warning(call.line as usize, what)));
    }
    found
}

/// What is known of each value.
fn given(call: &Call, script: &Script) -> Vec<Option<Given>> {
    // What a chain stands at is given first, and is no argument.
    let nodes = std::iter::repeat_n(None, call.words.len() - call.arguments.len());
    let nodes = nodes.chain(call.arguments.iter().map(Some));
    nodes.zip(&call.words).map(|(node, words)| Given::of(node, words, script)).collect()
}

/// The parameter that cannot be what it is given.
fn misfit(signature: Signature, given: &[Option<Given>]) -> Option<(&'static str, &Given)> {
    let pairs = signature.parameters().zip(given).filter_map(|(name, given)| Some((name, given.as_ref()?)));
    pairs.into_iter().find(|(name, given)| given.is != Some(signatures::type_of(name)))
}

/// A value of the wrong type, or too few of them.
fn mistyped(call: &Call, given: &[Option<Given>]) -> Option<String> {
    let name = call.function.name;
    let own = || signatures::of(name).filter(|one| one.parameters().count() == given.len());
    if own().any(|signature| misfit(signature, given).is_none()) {
        return None;
    }
    let ways = signatures::written(own());
    let Some((parameter, wrong)) = own().next().and_then(|signature| misfit(signature, given)) else {
        let count = if given.len() == 1 { "one value".to_string() } else { format!("{} values", given.len()) };
        return Some(format!("{name} cannot be called with {count}: it is {}", signatures::all_of(name)));
    };
    if let Some(turned) = turned(own(), given) {
        return Some(format!("{ways} is given its values in the wrong order: write `{turned}`"));
    }
    let (needed, shown) = (signatures::type_of(parameter), wrong.value.as_ref().map(shown));
    let hint = hint(needed, wrong);
    let it = shown.map_or_else(|| wrong.word.to_string(), |shown| format!("{} ({shown})", wrong.word));
    Some(format!("{ways} takes {} as `{parameter}`, not {it}{hint}", needed.word()))
}

/// The call with two neighbours exchanged, if that is one.
fn turned(own: impl Iterator<Item = Signature>, given: &[Option<Given>]) -> Option<String> {
    let signature = own.into_iter().next()?;
    let types: Vec<Type> = signature.parameters().map(signatures::type_of).collect();
    let values: Vec<&Given> = given.iter().flatten().filter(|one| one.value.is_some()).collect();
    if values.len() != types.len() {
        return None;
    }
    let turned = (1..values.len()).find_map(|place| {
        let mut turned = values.clone();
        turned.swap(place - 1, place);
        turned.iter().zip(&types).all(|(given, needed)| given.is == Some(*needed)).then_some(turned)
    })?;
    let shown: Vec<String> = turned.iter().filter_map(|given| given.value.as_ref().map(shown)).collect();
    Some(format!("{}({})", signature.function, shown.join(", ")))
}

/// What to write instead.
fn hint(needed: Type, wrong: &Given) -> String {
    match (needed, &wrong.value) {
        (Type::Number, Some(Data::Text(text))) if text.parse::<i64>().is_ok() => {
            format!("; write {text} without quotes")
        }
        (Type::Flag, Some(Data::Text(text))) if matches!(&**text, "true" | "false") => {
            format!("; write {text} without quotes")
        }
        (Type::Flag, Some(Data::Int(0))) => "; write false".to_string(),
        (Type::Flag, Some(Data::Int(1))) => "; write true".to_string(),
        (Type::Text, Some(Data::Int(_))) => "; a text stands in quotes".to_string(),
        _ => String::new(),
    }
}

/// Why the function refuses a number or a text that stands there: it is asked itself.
fn refused(call: &Call, given: &[Option<Given>], context: &mut ScriptContext) -> Option<String> {
    let signature = signatures::of(call.function.name)
        .find(|one| one.parameters().count() == given.len() && misfit(*one, given).is_none())?;
    let mut asked = false;
    let mut values = Vec::new();
    for (parameter, given) in signature.parameters().zip(given) {
        let own = given.as_ref().and_then(|given| given.value.as_ref()).and_then(plain);
        let is_kept = matches!(parameter, "timer" | "line") || parameter == "name" && is_free(call);
        let own = own.filter(|_| is_kept || signatures::type_of(parameter) == Type::Number);
        asked |= own.is_some();
        values.push(own.unwrap_or(sample(parameter, call, context)?));
    }
    context.script = ScriptState::new(0);
    asked.then(|| call.function.call(context, &values).err()).flatten()
}

/// Whether its first value names nothing of the drawing.
fn is_free(call: &Call) -> bool {
    call.function.name == "progress"
}

/// Something that a parameter can be.
fn sample(parameter: &str, call: &Call, context: &ScriptContext) -> Option<Data> {
    Some(match (signatures::type_of(parameter), parameter) {
        (Type::Number, _) => Data::Int(1),
        (Type::Flag, _) => Data::Bool(true),
        (Type::Text, "mode") => Data::Text(Arc::from("on")),
        (Type::Text, "color") => Data::Text(Arc::from("#ffffff")),
        (Type::Text, "name") if !is_free(call) => context.names.any_lamp().map(|name| Data::Text(Arc::from(name)))?,
        (Type::Text, _) => Data::Text(Arc::from("x")),
    })
}

/// What is taken and does nothing, or something else than it says.
fn idle(call: &Call, given: &[Option<Given>]) -> Option<String> {
    let number = |place: usize| match given.get(place)?.as_ref()?.value {
        Some(Data::Int(number)) => Some(number),
        _ => None,
    };
    match (call.function.name, given.len()) {
        // A constant that is 0 may be set to something else some day.
        ("score", 1) if call.arguments.first().is_some_and(|node| matches!(node.kind, Kind::Int(0))) => {
            Some("`score(0)` gives no points".to_string())
        }
        ("score", 1) => number(0).filter(|points| *points < 0).map(|points| {
            format!(
                "`score({points})` takes points from the player; write {} if it is to give them",
                points.unsigned_abs()
            )
        }),
        ("lamp", 3 | 4) | ("show", _) if number(2) == Some(0) => {
            let mode = call.words.get(1)?.only().filter(|mode| !matches!(&***mode, "on" | "off" | "dim"))?;
            Some(format!("a lamp cannot \"{mode}\" in 0 ms: name the time from one to the next, as 400"))
        }
        _ => None,
    }
}
