//! Names with which a script compares what it is told, and names in what it hands to the game's functions.

use super::facts::{Call, Comparison, Facts};
use super::remark::{Remark, line_of};
use super::words::{Told, Words};
use crate::rules::host_lamps::{check_color, effect};
use crate::rules::literal_names;
use crate::rules::names::Names;
use crate::rules::switches::BUTTONS;
use crate::spelling;
use physics::Kind;

/// What is wrong with the names of a script.
pub fn remarks(facts: &Facts, names: &Names, script: &str) -> Vec<Remark> {
    let optional = facts.given("exists", 0);
    let started = facts.given("after", 1);
    let compared = facts.comparisons.iter().filter_map(|one| comparison(one, names, &started, &optional, script));
    let handed = facts.calls.iter().flat_map(|call| arguments(call, names, &optional));
    compared.chain(handed).collect()
}

/// What is wrong with a comparison of an event's name.
fn comparison(one: &Comparison, names: &Names, started: &Words, optional: &Words, script: &str) -> Option<Remark> {
    let Comparison { words, text, .. } = one;
    let is_event = !words.others && !words.told.is_empty();
    if !is_event || words.literals.contains(text) || text.is_empty() {
        return None;
    }
    let what = words.told.iter().map(|told| impossible(*told, text, names, started, optional));
    let reasons = what.collect::<Option<Vec<String>>>()?;
    let line = line_of(text, script, one.line);
    let what = reasons.join(", and ");
    // An array may name other things for something else, and a timer may be for a rule that is still to be written.
    let is_doubtful = one.is_item || words.told.contains(&Told::Timer) || names.part(text).is_ok();
    Some(if is_doubtful { Remark::warning(line, what) } else { Remark::error(line, what) })
}

/// Why no event has this name.
fn impossible(told: Told, text: &str, names: &Names, started: &Words, optional: &Words) -> Option<String> {
    match told {
        Told::Part => match names.part(text) {
            Ok(part) => {
                let silent = matches!(names.kind(part), Some(Kind::Wall(_) | Kind::Flipper(_) | Kind::Plunger(_)));
                silent.then(|| format!("\"{text}\" has no switch, so no event is ever about it"))
            }
            Err(_) if optional.others || optional.literals.contains(text) => None,
            Err(_) if names.lamps(text).is_ok() => {
                Some(format!("\"{text}\" is a lamp, and no event is ever about a lamp; name a part"))
            }
            Err(what) => Some(what),
        },
        Told::Button => {
            let buttons = BUTTONS.iter().map(|(_, name)| *name);
            let is_known = buttons.clone().any(|name| name == text);
            let meant = spelling::near(text, buttons.clone());
            let meant = meant.map_or_else(String::new, |meant| format!("; did you mean \"{meant}\"?"));
            let all = buttons.collect::<Vec<_>>().join(", ");
            (!is_known).then(|| format!("there is no button called \"{text}\"{meant} (there are {all})"))
        }
        Told::Timer => {
            let by_part = started.told.contains(&Told::Part) && names.part(text).is_ok();
            let is_started = started.others || started.literals.contains(text) || by_part;
            let meant = spelling::near(text, started.literals.iter().map(|word| &**word));
            let meant = meant.map_or_else(String::new, |meant| format!("; did you mean \"{meant}\"?"));
            (!is_started).then(|| format!("no timer is called \"{text}\": nothing starts it with `after`{meant}"))
        }
    }
}

/// What is wrong with what a function of the game is given.
fn arguments(call: &Call, names: &Names, optional: &Words) -> Vec<Remark> {
    let mut found = Vec::new();
    let name = call.function.name;
    let mut look = |place: usize, check: &dyn Fn(&str) -> Result<(), String>| {
        let words = call.words.get(place).map_or_else(Default::default, |words| words.literals.clone());
        found.extend(words.iter().filter_map(|word| check(word).err()));
    };
    let may_lack = |word: &str| optional.others || optional.literals.contains(word);
    look(0, &|word: &str| if may_lack(word) { Ok(()) } else { literal_names::check(name, word, names) });
    match name {
        "lamp" => look(1, &mode),
        "show" => {
            look(1, &mode);
            look(5, &check_color);
        }
        "lamp_color" => look(1, &check_color),
        "flash" => look(2, &check_color),
        _ => {}
    }
    found.into_iter().map(|what| Remark::error(call.line as usize, what)).collect()
}

fn mode(word: &str) -> Result<(), String> {
    effect(word, None, 0).map(|_| ())
}
