//! Values that a sheet gives and that are none, told where the sheet gives them: a browser passes over them in silence.

use super::declarations::Declaration;
use super::value;
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::class_typo;
use crate::table::svg::element_class::ElementClass;

/// Properties that are a number, with or without a unit.
const NUMBERS: [&str; 5] = ["opacity", "fill-opacity", "stroke-opacity", "stop-opacity", "stroke-width"];
/// Units of CSS.
const UNITS: [&str; 12] = ["", "%", "px", "mm", "cm", "in", "pt", "pc", "q", "em", "ex", "rem"];
/// Words of `table.toml` for any thing.
const SETTINGS: [&str; 3] = ["material", "finish", "shadow"];

/// What is wrong with a declaration, as a warning in this line.
pub(super) fn warning(source: &Source, line: usize, declaration: &Declaration) -> Option<Diagnostic> {
    let Declaration { name, value, is_valid, .. } = declaration;
    let what = match &**name {
        _ if is_setting(name) => {
            format!("`{name}` is no property of a drawing: write it into table.toml, below the thing's [class.NAME]")
        }
        _ if !is_valid && value::is_colored(name) => format!("this {name} {}", no_color(value)),
        _ if NUMBERS.contains(&&**name) && !is_number(value) => format!("this {name} `{value}` is not a plain number"),
        "display" => nearly(name, value, &["none"])?,
        "visibility" => nearly(name, value, &["hidden", "collapse", "visible"])?,
        _ => return None,
    };
    Some(source.diagnostic_in_line(line, what).into_warning())
}

/// The sentence of what is no colour, as for a thing.
fn no_color(value: &str) -> String {
    format!("`{value}` is not a colour; write it as \"#rrggbb\"")
}

fn nearly(name: &str, value: &str, known: &[&'static str]) -> Option<String> {
    let meant = class_typo::nearest(value, known.iter().copied()).filter(|meant| *meant != value)?;
    Some(format!("this {name} `{value}` means nothing; did you mean `{meant}`?"))
}

/// Whether a value is a number with a unit of CSS, or a word or a function that stands for one.
fn is_number(value: &str) -> bool {
    let lower = value.to_ascii_lowercase();
    let is_of_number = |letter: char| letter.is_ascii_digit() || matches!(letter, '+' | '-' | '.');
    let (number, unit) = lower.split_at(lower.find(|letter| !is_of_number(letter)).unwrap_or(lower.len()));
    let words = ["inherit", "initial", "unset", "revert", "revert-layer", "thin", "medium", "thick"];
    lower.contains('(')
        || words.contains(&&*lower)
        || lower.parse::<f64>().is_ok_and(f64::is_finite)
        || (number.parse::<f64>().is_ok() && UNITS.contains(&unit))
}

fn is_setting(name: &str) -> bool {
    let is_parameter = |class: &ElementClass| class.parameters().iter().any(|known| known.name == name);
    SETTINGS.contains(&name) || name.contains('_') && ElementClass::ALL.iter().any(is_parameter)
}
