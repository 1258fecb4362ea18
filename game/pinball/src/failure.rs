//! Failure: what went wrong, as a sentence for a person.

use std::{error, fmt};

/// Plain sentences, usually one: what went wrong, where, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure(Vec<Sentence>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Sentence {
    text: String,
    is_warning: bool,
}

impl Failure {
    /// The failure that this sentence tells.
    pub fn new(sentence: impl Into<String>) -> Failure {
        Failure(vec![Sentence { text: sentence.into(), is_warning: false }])
    }

    /// The warning that this sentence tells: something is odd, and nothing has failed.
    pub fn warning(sentence: impl Into<String>) -> Failure {
        Failure(vec![Sentence { text: sentence.into(), is_warning: true }])
    }

    /// Whether nothing has failed.
    pub fn is_warning(&self) -> bool {
        self.0.iter().all(|sentence| sentence.is_warning)
    }

    /// All of `failures` as one, in their order.
    pub fn of_many(failures: Vec<Failure>) -> Failure {
        Failure(failures.into_iter().flat_map(|failure| failure.0).collect())
    }

    /// The same failure, with the name of the file that it is about before it.
    pub fn in_file(mut self, file: impl fmt::Display) -> Failure {
        if let Some(Sentence { text, .. }) = self.0.first_mut() {
            *text = format!("{file}: {text}");
        }
        self
    }

    /// The sentences, each of which is told in a line of its own. What they quote may itself hold line breaks.
    pub fn sentences(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(Sentence::to_string)
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if self.is_warning { "warning: " } else { "" };
        write!(formatter, "{kind}{}", self.text)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.sentences().collect::<Vec<_>>().join("\n"))
    }
}

impl error::Error for Failure {}
