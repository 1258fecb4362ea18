//! The names that a script may use: the parts and lamps of its table.

use super::part_commands::PartCommand;
use crate::{Table, spelling};
use physics::{Kind, PartId};
use std::collections::BTreeMap;

/// The parts and lamps of a table by name.
#[derive(Clone, Debug, Default)]
pub struct Names {
    parts: BTreeMap<String, PartId>,
    kinds: Vec<(String, Kind)>,
    /// See [`Table::part_lines`].
    lines: Vec<usize>,
    lamps: BTreeMap<String, usize>,
    /// See [`Table::art_ids`].
    art: BTreeMap<String, String>,
}

impl Names {
    /// The names of a table.
    pub fn new(table: &Table) -> Names {
        let parts = table.layout.parts.iter().enumerate();
        let lamps = table.lamps.iter().enumerate();
        Names {
            parts: parts
                .filter(|(_, part)| !part.name.is_empty())
                .map(|(index, part)| (part.name.clone(), PartId(index as u16)))
                .collect(),
            kinds: table.layout.parts.iter().map(|part| (part.name.clone(), part.kind.clone())).collect(),
            lines: table.part_lines.clone(),
            lamps: lamps
                .filter(|(_, lamp)| !lamp.name.is_empty())
                .map(|(index, lamp)| (lamp.name.clone(), index))
                .collect(),
            art: table.art_ids.clone(),
        }
    }

    /// How many names there are.
    pub fn count(&self) -> usize {
        self.parts.len() + self.lamps.len()
    }

    /// A part's name, if the drawing gives it one.
    pub fn part_name(&self, part: PartId) -> Option<&str> {
        self.kinds.get(usize::from(part.0)).map(|(name, _)| name.as_str()).filter(|name| !name.is_empty())
    }

    /// What a part is.
    pub fn kind(&self, part: PartId) -> Option<&Kind> {
        self.kinds.get(usize::from(part.0)).map(|(_, kind)| kind)
    }

    /// Every part, in the table's order.
    pub fn parts(&self) -> impl Iterator<Item = (PartId, &Kind)> {
        self.kinds.iter().enumerate().map(|(index, (_, kind))| (PartId(index as u16), kind))
    }

    /// The names of all lamps, in their order.
    pub fn lamp_names(&self) -> impl Iterator<Item = &str> {
        self.lamps.keys().map(String::as_str)
    }

    /// The name of a lamp, if there is one.
    pub fn any_lamp(&self) -> Option<&str> {
        self.lamps.keys().next().map(String::as_str)
    }

    /// What is told of a name that no thing has before anybody plays, with why none has it: what a script catches has
    /// always been the sentence alone.
    pub fn told(&self, name: &str, sentence: String) -> String {
        match (self.art.get(name), sentence.split_once(" in the drawing")) {
            (Some(why), Some((begin, _))) => format!("{begin}: {why}"),
            (None, Some(_)) => match (self.nameless(name), self.meant_by_start(name)) {
                // What it is called for want of an id is not what was meant.
                (Some(why), _) => format!("{}; {why}", sentence.split("; did you mean").next().unwrap_or_default()),
                // The lamp that is nearest to a start is none.
                (None, Some(meant)) => {
                    let begin = sentence.split("; did you mean").next().unwrap_or_default();
                    format!("{begin}; did you mean \"{meant}\"?")
                }
                (None, None) => sentence,
            },
            _ => sentence,
        }
    }

    /// The start of lamps' names that was meant by one with which none begins: `gi-*` by `gl-*`.
    fn meant_by_start(&self, name: &str) -> Option<String> {
        let start = name.strip_suffix('*')?;
        let starts =
            || self.lamps.keys().flat_map(|lamp| lamp.match_indices('-').map(|(at, dash)| &lamp[..at + dash.len()]));
        // Letters that have changed places are a likelier slip than one too many.
        let letters = |word: &str| {
            let mut letters: Vec<char> = word.chars().collect();
            letters.sort_unstable();
            letters
        };
        let meant = starts().find(|other| letters(other) == letters(start));
        meant.or_else(|| spelling::near_name(start, starts())).map(|meant| format!("{meant}*"))
    }

    /// What to say of the first part without an id of which this is the word: nobody has given it the name that stands beside
    /// every drain.
    fn nameless(&self, name: &str) -> Option<String> {
        let word = name.trim_end_matches(|letter: char| letter.is_ascii_digit() || letter == '-').to_ascii_lowercase();
        let is_it = |(own, _): &(String, Kind)| own.split_once('#').is_some_and(|(class, _)| class == word);
        let (at, _) = self.kinds.iter().enumerate().find(|(_, part)| is_it(part))?;
        let line = self.lines.get(at)?;
        Some(format!("the {word} of line {line} has no id; give it id=\"{name}\""))
    }

    /// Whether a part or a lamp has this name.
    pub fn exists(&self, name: &str) -> bool {
        self.parts.contains_key(name) || self.lamps.contains_key(name)
    }

    /// The part with this name.
    ///
    /// # Errors
    /// A sentence if there is none.
    pub fn part(&self, name: &str) -> Result<PartId, String> {
        let unknown = || format!("there is no part called \"{name}\" in the drawing{}", near(name, self.parts.keys()));
        self.parts.get(name).copied().ok_or_else(unknown)
    }

    /// The part with this name that a command is for.
    ///
    /// # Errors
    /// A sentence if there is none, or it is something else.
    pub fn part_for(&self, command: &PartCommand, name: &str) -> Result<PartId, String> {
        let part = self.part(name)?;
        match self.kind(part) {
            Some(kind) if (command.is)(kind) => Ok(part),
            _ => Err(format!("\"{name}\" is not {}", command.what)),
        }
    }

    /// The lamp with this name; or, if it ends in `*`, every lamp whose name begins so, in the order of their names.
    ///
    /// # Errors
    /// A sentence if there is none.
    pub fn lamps(&self, name: &str) -> Result<Vec<usize>, String> {
        let found: Vec<usize> = match name.strip_suffix('*') {
            Some(start) => {
                self.lamps.iter().filter(|(name, _)| name.starts_with(start)).map(|(_, lamp)| *lamp).collect()
            }
            None => self.lamps.get(name).copied().into_iter().collect(),
        };
        if found.is_empty() {
            return Err(format!("there is no lamp called \"{name}\" in the drawing{}", near(name, self.lamps.keys())));
        }
        Ok(found)
    }
}

/// `; did you mean "..."?` if a name differs by little.
fn near<'a>(name: &str, names: impl Iterator<Item = &'a String>) -> String {
    let meant = spelling::near_name(name, names.map(String::as_str));
    meant.map_or_else(String::new, |meant| format!("; did you mean \"{meant}\"?"))
}
