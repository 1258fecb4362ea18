//! Handlers: the functions of a script that are called when something happens.

use super::script::{Mistake, Script, unknown_name};
use crate::spelling;

/// What a script may define to be told of what happens, and what each is told.
const HANDLERS: [(&str, &str); 10] = [
    ("on_start", ""),
    ("on_switch", "name"),
    ("on_open", "name"),
    ("on_button", "name"),
    ("on_release", "name"),
    ("on_timer", "name"),
    ("on_launch", ""),
    ("on_feed", ""),
    ("on_bob", ""),
    ("on_slam", ""),
];

/// Every handler's name.
pub fn names() -> impl Iterator<Item = &'static str> {
    HANDLERS.iter().map(|(name, _)| *name)
}

/// Whether a function of this name is called when something happens.
pub fn is_handler(name: &str) -> bool {
    names().any(|own| own == name)
}

/// The handler that a function's name means but for case, underscores and a letter.
pub fn meant(function: &str) -> Option<&'static str> {
    let plain = |name: &str| name.replace('_', "").to_ascii_lowercase();
    let own = plain(function);
    let begins = own.starts_with("on") && !is_handler(function);
    let same = names().find(|name| plain(name) == own);
    same.or_else(|| spelling::near(&function.to_ascii_lowercase(), names())).filter(|_| begins)
}

/// Tells functions that look as if they were to be called when something happens, but never will be, and those that are
/// told something else than they take. That such a one lacks what it is told is no mistake of its own.
pub fn tell(script: &Script, text: &str, mistakes: &mut Vec<Mistake>) {
    for function in script.functions().filter(|function| function.name.starts_with("on_")) {
        let what = match HANDLERS.iter().find(|(name, _)| *name == function.name) {
            Some((_, told)) if usize::from(!told.is_empty()) == function.parameters => continue,
            Some((name, "")) => format!("{name} is told nothing: write `fn {name}()`"),
            Some((name, told)) => {
                let lacking = unknown_name(told);
                mistakes.retain(|(_, what)| function.parameters > 0 || *what != lacking);
                format!("{name} is told one value: write `fn {name}({told})`")
            }
            None => {
                let meant = meant(&function.name);
                let meant = meant.map_or_else(String::new, |meant| format!("; did you mean `{meant}`?"));
                let names: Vec<&str> = names().collect();
                format!("nothing calls {}{meant} (there are {})", function.name, names.join(", "))
            }
        };
        mistakes.push((line_of_function(&function.name, text), what));
    }
}

/// The line on which a function begins.
pub fn line_of_function(function: &str, text: &str) -> usize {
    let begin = format!("fn {function}(");
    text.lines().position(|line| line.contains(&begin)).map_or(1, |index| index + 1)
}
