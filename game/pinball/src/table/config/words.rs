//! Words of `table.toml`: those that stand at its head, those of brackets, and what is told of others.

use crate::spelling;
use crate::table::svg::element_class::{ElementClass, Parameter};

/// The words at the head of the file.
pub(super) const TOP: [&str; 6] = ["name", "slope_deg", "playfield_friction", "ambient", "ambient_power", "relief_mm"];
/// The words in brackets.
pub(super) const TABLES: [&str; 5] = ["relief", "material", "finish", "class", "part"];

/// ` (did you mean ...?)` if a known word is like this one.
pub(super) fn meant<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    spelling::near(word, known).map_or_else(String::new, |meant| format!(" (did you mean `{meant}`?)"))
}

/// What is told of a word below a table in brackets, which knows these.
pub(super) fn unknown(word: &str, is_dotted: bool, known: &str) -> String {
    if is_dotted && TABLES.contains(&word) {
        return format!(
            "`{word}` stands below a [TABLE], and so belongs to that; write it in brackets of its own, as [{word}.NAME]"
        );
    }
    if TOP.contains(&word) {
        return format!("`{word}` stands below a [TABLE], and so belongs to that; put it above the first one");
    }
    match known {
        "" => format!("`{word}` is not known here, and nothing is: take it out"),
        _ => {
            let are = if known.contains(", ") { "there are" } else { "there is" };
            format!("`{word}` is not known here{}; {are} {known}", meant(word, known.split(", ")))
        }
    }
}

/// What can be said of a thing of this class.
pub(super) fn setting_words(class: ElementClass) -> String {
    let mut words: Vec<&str> = Vec::new();
    if class.has_material() {
        words.push("material");
    }
    if class.has_finish() {
        words.extend(["finish", "shadow"]);
    }
    words.extend(class.parameters().iter().map(|Parameter { name, .. }| *name));
    words.join(", ")
}
