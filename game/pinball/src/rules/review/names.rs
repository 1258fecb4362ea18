//! Names with which a script compares what it is told, and names in what it hands to the game's functions.

use super::facts::{Call, Comparison, Facts};
use super::remark::{Remark, line_of, written_line};
use super::words::{Told, Words};
use crate::rules::host_lamps::{check_color, effect};
use crate::rules::literal_names;
use crate::rules::names::Names;
use crate::rules::switches::BUTTONS;
use crate::spelling;
use physics::{Kind, Switch};

/// What is wrong with the names of a script.
pub fn remarks(facts: &Facts, names: &Names, script: &str) -> Vec<Remark> {
    let optional = facts.given("exists", 0);
    let started = facts.given("after", 1);
    let compared = facts.comparisons.iter().filter_map(|one| comparison(one, names, &started, &optional, script));
    let handed = facts.calls.iter().flat_map(|call| arguments(call, names, &optional, script));
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
        Told::Part | Told::Opened => match names.part(text) {
            Ok(part) => match names.kind(part).map(Kind::switch) {
                Some(Switch::None) => Some(format!("\"{text}\" has no switch, so no event is ever about it")),
                Some(Switch::Momentary) if told == Told::Opened => Some(format!(
                    "the switch of \"{text}\" closes for a moment and is never told to open: hear it in `on_switch`"
                )),
                _ => None,
            },
            Err(_) if optional.others || optional.literals.contains(text) => None,
            Err(_) if names.lamps(text).is_ok() => {
                Some(format!("\"{text}\" is a lamp, and no event is ever about a lamp; name a part"))
            }
            Err(what) => Some(names.told(text, what)),
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
            let is_of_part = [Told::Part, Told::Opened].iter().any(|told| started.told.contains(told));
            let by_part = is_of_part && names.part(text).is_ok();
            let is_started = started.others || started.literals.contains(text) || by_part;
            let meant = spelling::near(text, started.literals.iter().map(|word| &**word));
            let meant = meant.map_or_else(String::new, |meant| format!("; did you mean \"{meant}\"?"));
            (!is_started).then(|| format!("no timer is called \"{text}\": nothing starts it with `after`{meant}"))
        }
    }
}

/// What is wrong with what a function of the game is given.
fn arguments(call: &Call, names: &Names, optional: &Words, script: &str) -> Vec<Remark> {
    let line = call.line as usize;
    let mut found = Vec::new();
    let name = call.function.name;
    let mut look = |place: usize, check: &dyn Fn(&str) -> Result<(), String>| {
        let words = call.words.get(place).map_or_else(Default::default, |words| words.literals.clone());
        let wrong = words.iter().filter_map(|word| Some((word, check(word).err()?)));
        found.extend(wrong.map(|(word, what)| Remark::error(written_line(word, script, line), what)));
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
    let asked = if name == "closed" { closed(call, names) } else { Vec::new() };
    found.into_iter().chain(asked).collect()
}

/// What `closed` is asked that it cannot answer.
fn closed(call: &Call, names: &Names) -> Vec<Remark> {
    let Some(words) = call.words.first() else { return Vec::new() };
    let line = call.line as usize;
    let told = words.literals.iter().filter_map(|name| {
        let kind = names.part(name).ok().and_then(|part| names.kind(part))?;
        match kind.switch() {
            Switch::None => {
                let what = format!("`closed(\"{name}\")` is always false: \"{name}\" has no switch");
                // An array may name other things for something else.
                Some(if words.only().is_some() { Remark::error(line, what) } else { Remark::warning(line, what) })
            }
            Switch::Momentary => Some(Remark::warning(
                line,
                format!(
                    "`closed(\"{name}\")` is true for good once a ball has been there: its switch closes for a moment and \
                     is never told to open; hear it in `on_switch`, and keep in `this` what is to be known later"
                ),
            )),
            Switch::Maintained => None,
        }
    });
    told.collect()
}

fn mode(word: &str) -> Result<(), String> {
    effect(word, None, 0).map(|_| ())
}
