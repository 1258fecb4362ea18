//! Failure: what went wrong, as a sentence for a person.

use std::{error, fmt};

/// Plain sentences, usually one: what went wrong, where, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure(Vec<String>);

impl Failure {
    /// The failure that this sentence tells.
    pub fn new(sentence: impl Into<String>) -> Failure {
        Failure(vec![sentence.into()])
    }

    /// All of `failures` as one, in their order.
    pub fn of_many(failures: Vec<Failure>) -> Failure {
        Failure(failures.into_iter().flat_map(|failure| failure.0).collect())
    }

    /// The same failure, with the name of the file that it is about before it.
    pub fn in_file(mut self, file: impl fmt::Display) -> Failure {
        if let Some(first) = self.0.first_mut() {
            *first = format!("{file}: {first}");
        }
        self
    }

    /// The sentences, each of which is told in a line of its own. What they quote may itself hold line breaks.
    pub fn sentences(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(String::as_str)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0.join("\n"))
    }
}

impl error::Error for Failure {}
