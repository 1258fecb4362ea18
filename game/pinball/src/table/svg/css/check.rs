//! Values that a sheet gives and that are none, told where the sheet gives them: a browser passes over them in silence.

use super::declarations::Declaration;
use super::{grammar, value};
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::element_class::ElementClass;

/// Properties that are a number, with or without a unit, and are told as that of a thing is.
const NUMBERS: [&str; 5] = ["opacity", "fill-opacity", "stroke-opacity", "stop-opacity", "stroke-width"];
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
        _ if NUMBERS.contains(&&**name) && grammar::mistake(name, value).is_some() => {
            format!("this {name} `{value}` is not a plain number")
        }
        _ => format!("this {name} `{value}` means nothing; {}", grammar::mistake(name, value)?),
    };
    Some(source.diagnostic_in_line(line, what).into_warning())
}

/// The sentence of what is no colour, as for a thing.
fn no_color(value: &str) -> String {
    format!("`{value}` is not a colour; write it as \"#rrggbb\"")
}

fn is_setting(name: &str) -> bool {
    let is_parameter = |class: &ElementClass| class.parameters().iter().any(|known| known.name == name);
    SETTINGS.contains(&name) || name.contains('_') && ElementClass::ALL.iter().any(is_parameter)
}
