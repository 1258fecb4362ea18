//! Failure: what went wrong, as one sentence for a person.

use std::{error, fmt};

/// One plain sentence: what went wrong, where, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure(String);

impl Failure {
    /// The failure that this sentence tells.
    pub fn new(sentence: impl Into<String>) -> Failure {
        Failure(sentence.into())
    }

    /// All of `failures` as one, a line each.
    pub fn of_many(failures: Vec<Failure>) -> Failure {
        Failure(failures.into_iter().map(|failure| failure.0).collect::<Vec<_>>().join("\n"))
    }

    /// The same failure, with the name of the file that it is about before it.
    pub fn in_file(self, file: impl fmt::Display) -> Failure {
        Failure(format!("{file}: {}", self.0))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl error::Error for Failure {}
