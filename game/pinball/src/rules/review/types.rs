//! Types: comparisons of values of which one can never be what the other is.

use super::facts::{Compared, Facts};
use super::given::{Given, of_value};
use super::literal::shown;
use super::remark::{Remark, line_of};
use super::words::Words;
use crate::rules::script::{Data, Node, Operator, Pattern, Script, Switch};
use crate::rules::signatures::Type;

/// What is never true for the types of what is compared, or always.
pub fn remarks(facts: &Facts, script: &Script, rules: &str) -> Vec<Remark> {
    let compared = facts.compared.iter().filter_map(|one| comparison(one, script));
    let cases = facts.switches.iter().flat_map(|(switch, words)| cases(switch, words, script, rules));
    compared.chain(cases).collect()
}

fn comparison(one: &Compared, script: &Script) -> Option<Remark> {
    let side = |at: usize| known(one.sides[at], &one.words[at], script);
    let (left, right) = (side(0)?, side(1)?);
    let so = if one.operator == Operator::NotEqual { "always" } else { "never" };
    mixed(&left, &right).map(|what| Remark::error(one.line as usize, format!("this is {so} true: {what}")))
}

/// The cases that a `switch` never comes to.
fn cases(switch: &Switch, words: &Words, script: &Script, rules: &str) -> Vec<Remark> {
    let Some(subject) = known(&switch.subject, words, script) else { return Vec::new() };
    let told = switch.cases.iter().filter_map(|case| {
        let Pattern::Value(value) = &case.pattern else { return None };
        let what = mixed(&subject, &of_value(value)?)?;
        let near = switch.branches[case.branch].body.line;
        let line = match value {
            Data::Text(text) => line_of(text, rules, near),
            _ => near as usize,
        };
        Some(Remark::error(line, format!("this case is never reached: {what}")))
    });
    told.collect()
}

/// What is known of a value, if it is something: whether there is anything can be asked of everything.
fn known(node: &Node, words: &Words, script: &Script) -> Option<Given> {
    Given::of(Some(node), words, script).filter(|given| !matches!(given.word, "nothing" | "a function"))
}

/// What to say of values that have two types.
fn mixed(left: &Given, right: &Given) -> Option<String> {
    if left.word == right.word {
        return None;
    }
    let called = |given: &Given| match &given.value {
        Some(value) => format!("{} ({})", given.word, shown(value)),
        None => given.word.to_string(),
    };
    let is_of_array = [left, right].iter().any(|one| one.word == "an array");
    let hint = match [left, right].into_iter().find_map(quoted) {
        Some(plain) => format!("; write {plain} without quotes"),
        None if is_of_array => "; whether it is in an array, `in` asks".to_string(),
        None => String::new(),
    };
    Some(format!("{} is compared with {}{hint}", called(left), called(right)))
}

/// What stands in quotes and is no text.
fn quoted(given: &Given) -> Option<&str> {
    match &given.value {
        Some(Data::Text(text)) if given.is == Some(Type::Text) => {
            (text.parse::<i64>().is_ok() || matches!(&**text, "true" | "false")).then_some(text)
        }
        _ => None,
    }
}
