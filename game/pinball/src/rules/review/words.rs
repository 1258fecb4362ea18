//! Words: which texts an expression of a script can be, as far as that can be known without play.

use std::collections::BTreeSet;
use std::sync::Arc;

/// Texts that are told apart; of more nothing is known.
const MAX_WORDS: usize = 256;

/// Where a name comes from that a script is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Told {
    /// The game, for a part's switch that closes.
    Part,
    /// The game, for a part's switch that opens.
    Opened,
    /// The game, for a button.
    Button,
    /// The script itself, for its timer.
    Timer,
}

/// The texts that an expression can be.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Words {
    /// Texts that stand in the script.
    pub literals: BTreeSet<Arc<str>>,
    /// Names that an event has.
    pub told: BTreeSet<Told>,
    /// It can be something else too.
    pub others: bool,
}

impl Words {
    /// Nothing is known.
    pub fn unknown() -> Words {
        Words { others: true, ..Words::default() }
    }

    /// This text.
    pub fn literal(text: &Arc<str>) -> Words {
        Words { literals: BTreeSet::from([text.clone()]), ..Words::default() }
    }

    /// What an event is told.
    pub fn told(by: Told) -> Words {
        Words { told: BTreeSet::from([by]), ..Words::default() }
    }

    /// The one text that it is, if it is one.
    pub fn only(&self) -> Option<&Arc<str>> {
        let one = self.literals.len() == 1 && self.told.is_empty() && !self.others;
        self.literals.first().filter(|_| one)
    }

    /// It can be any of those too.
    pub fn add(&mut self, more: &Words) {
        self.literals.extend(more.literals.iter().cloned());
        self.told.extend(&more.told);
        self.others |= more.others;
        if self.literals.len() > MAX_WORDS {
            *self = Words::unknown();
        }
    }

    /// Any of several.
    pub fn any(all: impl IntoIterator<Item = Words>) -> Words {
        let mut any = Words::default();
        all.into_iter().for_each(|words| any.add(&words));
        any
    }

    /// One behind the other.
    pub fn joined(&self, next: &Words) -> Words {
        let is_known = |words: &Words| words.told.is_empty() && !words.others;
        let few = self.literals.len() * next.literals.len() <= MAX_WORDS;
        if !(is_known(self) && is_known(next) && few) {
            return Words::unknown();
        }
        let pairs = self.literals.iter().flat_map(|first| next.literals.iter().map(move |second| (first, second)));
        Words { literals: pairs.map(|(first, second)| format!("{first}{second}").into()).collect(), ..Words::default() }
    }
}
