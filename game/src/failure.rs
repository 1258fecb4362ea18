//! What went wrong, as one sentence for a person.

use std::fmt;

/// One plain sentence: what went wrong, where, and what to do. Printed to standard error with exit code 1.
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
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl std::error::Error for Failure {}
